// All that is wrong with a document, and documents of older versions.
#include "scene/problems.hpp"

#include "scene/document.hpp"
#include "scene/migrations.hpp"
#include "scene/validation.hpp"
#include "support/json_text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace knotwork::scene {
namespace {

using test::json;

std::vector<std::string> pathsOf(const std::vector<Error>& problems) {
    std::vector<std::string> paths;
    for (const Error& problem : problems) paths.push_back(problem.path);
    return paths;
}

std::vector<std::string> pathsIn(std::string_view document) {
    return pathsOf(findProblems(json(document)));
}

using Paths = std::vector<std::string>;

TEST(Problems, AllAreToldInTheOrderOfReading) {
    const auto problems = findProblems(json(R"({
        "knotwork": 1, "titel": "x", "title": 3, "view": {"mode": "4d", "zoom": 1},
        "objects": [
            {"type": "bspline-curve", "degree": 2.5, "points": [[0,0],[1,"a"],[2],[3,3]],
             "colour": 1, "style": {"width": 99, "colour": "red"}},
            {"type": "blending-curve", "id": "blend",
             "bFunction": {"family": "mixed", "of": [{"family": "x"}, {"family": "logistic", "c": 0}],
                           "weight": 2},
             "model": {"type": "parametric-curve", "name": "circle", "parameters": {"radius": "1"}}},
            {"type": "parametric-curve", "name": "circle", "id": "blend"},
            {"type": "bspline-curve", "degree": 2, "points": [[0,0],[1,0],[2,0]],
             "knots": [0,0,0,1,1,0]}],
        "effects": [{"target": "nobody", "kind": "rotate"},
                    {"target": "c1", "kind": "rotate", "angle": 1, "period": 0, "speed": 2}]})"));
    const Paths wanted{
        "titel", "title", "view.zoom", "view.mode",
        "objects[0].colour", "objects[0].degree", "objects[0].points[1][1]",
        "objects[0].points[2]", "objects[0].style.colour", "objects[0].style.width",
        "objects[1].bFunction.of[0].family", "objects[1].bFunction.of[1].c",
        "objects[1].bFunction.weight", "objects[1].model.parameters.radius", "objects[1].locals",
        "objects[2].id", "objects[3].knots[5]", "effects[0].target", "effects[1].speed", "effects[1].period"};
    EXPECT_EQ(pathsOf(problems), wanted);
    EXPECT_EQ(problems[1].code, Code::wrongType);
    EXPECT_EQ(problems[16].code, Code::knotsDecreasing);
}

TEST(Problems, AnEffectOnAnObjectThatCouldNotBeMadeIsNotBlamed) {
    EXPECT_EQ(pathsIn(R"({"knotwork": 1, "objects": [{"id": "a", "type": "line-curve"}],
                          "effects": [{"target": "a", "kind": "rotate"}]})"),
              (Paths{"objects[0].from", "objects[0].to"}));
}

TEST(Problems, EqualIdsAreOneEach) {
    EXPECT_EQ(pathsIn(R"({"knotwork": 1, "objects": [
        {"id": "a", "type": "parametric-curve", "name": "circle"},
        {"id": "a", "type": "parametric-curve", "name": "circle"},
        {"id": "a", "type": "parametric-curve", "name": "circle"}]})"),
              (Paths{"objects[1].id", "objects[2].id"}));
}

TEST(Problems, NoMoreThanAHundredAreTold) {
    Json document = json(R"({"knotwork": 1, "objects": [
        {"type": "bspline-curve", "degree": 1, "points": []}]})");
    for (int i = 0; i < 5000; ++i) document["objects"][0]["points"].push_back(Json::array({0, "x"}));
    const auto problems = findProblems(document);
    ASSERT_EQ(problems.size(), maximumProblems);
    EXPECT_EQ(problems[99].path, "objects[0].points[99][1]");
}

TEST(Problems, AreNoneOfWhatOpensAndTheRefusalFirstOfWhatDoesNot) {
    for (const char* text : {
             R"({"knotwork": 1})",
             R"({"knotwork": 2, "objects": 3})",
             R"({"objects": []})",
             R"([])",
             R"({"knotwork": 0})",
             R"({"knotwork": 1, "objects": {}, "effects": 3})",
             R"({"knotwork": 1, "objects": [{"type": "point-cloud", "points": [[1,2]],
                 "fit": {"degree": 3, "count": 9}}, {"type": "x"}]})",
             R"({"knotwork": 1, "objects": [{"type": "parametric-curve", "name": "circle", "id": ""}],
                 "effects": [3, {"kind": "x"}]})"}) {
        const auto problems = findProblems(json(text));
        const auto read = readDocument(json(text));
        ASSERT_EQ(problems.empty(), read.ok()) << text;
        if (!read.ok()) {
            EXPECT_EQ(problems.front(), read.error()) << text;
        }
    }
    EXPECT_EQ(pathsIn(R"({"knotwork": 1, "objects": {}, "effects": 3})"), (Paths{"objects", "effects"}));
}

// --- versions ------------------------------------------------------------------------------------

/// As if version 2 had called titles captions, and version 3 had put them into the view.
Json captioned(Json document) {
    if (Json* title = member(document, "title")) document["caption"] = *title;
    document.erase("title");
    return document;
}
Json intoView(Json document) {
    if (Json* caption = member(document, "caption")) document["view"]["caption"] = *caption;
    document.erase("caption");
    return document;
}
constexpr std::array made{Migration{1, captioned}, Migration{2, intoView}};

TEST(Migrations, LeadStepByStepToTheNewestVersion) {
    const Json first = json(R"({"knotwork": 1, "title": "x", "view": {"mode": "2d"}})");
    EXPECT_EQ(migrated(first, made), json(R"({"knotwork": 3, "view": {"mode": "2d", "caption": "x"}})"));
    const Json second = json(R"({"knotwork": 2, "caption": "y"})");
    EXPECT_EQ(migrated(second, made), json(R"({"knotwork": 3, "view": {"caption": "y"}})"));
    const Json third = json(R"({"knotwork": 3, "title": "z"})");
    EXPECT_FALSE(isOutdated(third, made));
    EXPECT_EQ(migrated(third, made), third);
}

TEST(Migrations, LeaveWhatIsNoDocumentToValidation) {
    for (const char* text : {R"([])", R"({"knotwork": "1"})", R"({"knotwork": 0})",
                             R"({"knotwork": 1.5})", R"({})"}) {
        EXPECT_FALSE(isOutdated(json(text), made)) << text;
        EXPECT_EQ(migrated(json(text), made), json(text));
    }
}

TEST(Migrations, ThereIsOneForEveryReleasedVersionButTheNewest) {
    ASSERT_EQ(migrations().size(), static_cast<std::size_t>(documentVersion - 1));
    for (std::size_t i = 0; i < migrations().size(); ++i) {
        EXPECT_EQ(migrations()[i].from, static_cast<int>(i) + 1);
    }
}

}  // namespace
}  // namespace knotwork::scene
