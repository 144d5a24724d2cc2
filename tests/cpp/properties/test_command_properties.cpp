// Random commands on random documents of every type: what is undone is as it was, to the byte.
#include "properties/generators.hpp"
#include "properties/property.hpp"
#include "scene/fields.hpp"
#include "scene/path.hpp"
#include "scene/problems.hpp"
#include "scene/scene.hpp"
#include "support/json_text.hpp"

#include <string>
#include <utility>
#include <vector>

namespace knotwork::scene {
namespace {

using test::holds;
using test::json;
using test::real;
using test::whole;

// --- documents -----------------------------------------------------------------------------------

Json point(bool space) {
    Json p = Json::array({*real(5), *real(5)});
    if (space) p.push_back(*real(5));
    return p;
}

Json points(int count) {
    const bool space = *whole(0, 1) == 1;
    Json list = Json::array();
    for (int i = 0; i < count; ++i) list.push_back(point(space));
    return list;
}

Json oneOf(const std::vector<const char*>& texts) {
    return json(texts[static_cast<std::size_t>(*whole(0, static_cast<int>(texts.size()) - 1))]);
}

Json blend() {
    return oneOf({R"({"family": "linear"})", R"({"family": "expo-rational", "beta": 2})",
                  R"({"family": "polynomial", "p": 2})",
                  R"({"family": "dual", "of": {"family": "logistic", "c": 3}})"});
}

Json curveModel() {
    return oneOf({R"({"type": "parametric-curve", "name": "circle"})",
                  R"({"type": "parametric-curve", "name": "trefoil"})",
                  R"({"type": "bspline-curve", "degree": 2, "points": [[0,0],[1,2],[3,3],[5,0]]})"});
}

Json splineObject() {
    const int degree = *whole(1, 4);
    Json object{{"type", "bspline-curve"}, {"degree", degree}};
    object["form"] = oneOf({R"("clamped")", R"("open")", R"("closed")"});
    const int count = degree + *whole(1, 5);
    object["points"] = points(count);
    if (*whole(0, 2) == 0) object["weights"] = Json(Json::array_t(static_cast<std::size_t>(count), Json(1.5)));
    return object;
}

Json netObject() {
    Json net = Json::array();
    const int columns = *whole(3, 5);
    for (int i = *whole(3, 4); i > 0; --i) {
        Json row = Json::array();
        for (int j = 0; j < columns; ++j) row.push_back(point(true));
        net.push_back(std::move(row));
    }
    return {{"type", "bspline-surface"}, {"degree", {*whole(1, 2), *whole(1, 2)}},
            {"points", std::move(net)}, {"form", {"clamped", *whole(0, 1) == 0 ? "closed" : "open"}}};
}

Json anyObject() {
    switch (*whole(0, 9)) {
        case 0:
        case 1: return splineObject();
        case 2:
            return {{"type", "blending-curve"}, {"bFunction", blend()}, {"model", curveModel()},
                    {"locals", {{"count", *whole(2, 6)}, {"kind", "sub-curve"}}}};
        case 3:
            return {{"type", "blending-surface"}, {"bFunction", blend()},
                    {"model", oneOf({R"({"type": "parametric-surface", "name": "torus"})",
                                     R"({"type": "parametric-surface", "name": "plane"})"})},
                    {"locals", {*whole(2, 4), *whole(2, 4)}}};
        case 4: return netObject();
        case 5:
            return {{"type", "subdivision-surface"}, {"levels", *whole(0, 2)},
                    {"mesh", oneOf({R"({"solid": "cube"})", R"({"solid": "torus"})"})}};
        case 6: {
            Json cloud{{"type", "point-cloud"}, {"points", points(*whole(4, 8))}};
            if (*whole(0, 1) == 0) cloud["fit"] = json(R"({"degree": 2, "count": 3})");
            return cloud;
        }
        case 7: return {{"type", "bezier-curve"}, {"points", points(*whole(2, 5))}};
        case 8:
            return {{"type", "subdivision-curve"}, {"points", points(*whole(4, 6))},
                    {"scheme", oneOf({R"("lane-riesenfeld")", R"("chaikin")", R"("four-point")"})}};
        default:
            return oneOf({R"({"type": "formula-curve", "x": "t", "y": "t*t", "domain": [0, 3]})",
                          R"({"type": "line-curve", "from": [0, 0], "to": [1, 2]})",
                          R"({"type": "arc-curve", "at": 0, "point": [0,0], "first": [1,0],
                              "second": [0,1], "domain": [0, 1]})",
                          R"({"type": "parametric-surface", "name": "sphere"})",
                          R"({"type": "parametric-curve", "name": "butterfly"})"});
    }
}

Json anyEffect(const Json& objects) {
    const int i = *whole(0, static_cast<int>(objects.size()) - 1);
    Json effect{{"target", objects[static_cast<std::size_t>(i)]["id"]}};
    effect["kind"] = oneOf({R"("translate")", R"("rotate")", R"("scale")", R"("colour")"});
    if (*whole(0, 1) == 0) effect["easing"] = blend();
    return effect;
}

Json anyDocument() {
    Json document{{"knotwork", 1}, {"title", "x"}, {"objects", Json::array()},
                  {"effects", Json::array()}};
    for (int i = *whole(1, 4); i > 0; --i) {
        Json object = anyObject();
        object["id"] = "o" + std::to_string(i);
        document["objects"].push_back(std::move(object));
    }
    for (int i = *whole(0, 2); i > 0; --i) {
        document["effects"].push_back(anyEffect(document["objects"]));
    }
    return document;
}

// --- commands ------------------------------------------------------------------------------------

/// As it comes from outside: all numbers are of one kind.
Json parsed(const Json& value) { return *parseJson(dumpJson(value)); }

/// A place of the document, deep ones as likely as others of their list.
std::string anyPlace(const Json& document) {
    std::string path;
    const Json* at = &document;
    for (int depth = *whole(1, 6); depth > 0 && at->is_structured() && !at->empty(); --depth) {
        auto item = at->items().begin();
        for (int skip = *whole(0, static_cast<int>(at->size()) - 1); skip > 0; --skip) ++item;
        path = joinPath(path, at->is_array() ? '[' + item.key() + ']' : item.key());
        at = &item.value();
    }
    return path;
}

Json anyValue() {
    switch (*whole(0, 7)) {
        case 0: return *whole(-1, 9);
        case 1: return *real(9);
        case 2: return point(*whole(0, 1) == 0);
        case 3: return oneOf({R"("open")", R"("closed")", R"("clamped")", R"("loop")", R"("#00ff00")",
                              R"("torus")", R"("cube")", R"("linear")", R"("bezier")", R"("length")"});
        case 4: return anyObject();
        case 5: return blend();
        case 6: return oneOf({"null", "true", "[]", "{}", R"("x")", "1e308", "[[0,1],[1,2],[2,5]]"});
        default: {
            const auto types = objectTypes();
            return types[static_cast<std::size_t>(*whole(0, static_cast<int>(types.size()) - 1))].type;
        }
    }
}

std::string anyKnotOrPoint(const Json& document) {
    const auto i = static_cast<std::size_t>(
        *whole(0, std::max(0, static_cast<int>(document["objects"].size()) - 1)));
    const std::string object = indexed("objects", i);
    const std::string k = '[' + std::to_string(*whole(0, 6)) + ']';
    const std::string j = '[' + std::to_string(*whole(0, 3)) + ']';
    const std::vector<std::string> places{object + ".points" + k,       object + ".points" + j + k,
                                          object + ".knots" + k,        object + ".knots[0]" + k,
                                          object + ".mesh.vertices" + k, object + ".form",
                                          object + ".degree",           object + ".locals.count",
                                          object + ".locals[1]",        object + ".type"};
    return places[static_cast<std::size_t>(*whole(0, static_cast<int>(places.size()) - 1))];
}

Json anyPose(const Json& document) {
    Json pose{{"object", "o" + std::to_string(*whole(1, 4))}};
    const bool patches = *whole(0, 1) == 0;
    const auto local = [&]() -> Json {
        if (patches) return Json::array({*whole(0, 3), *whole(0, 3)});
        return *whole(0, 5);
    };
    if (*whole(0, 1) == 0) {
        pose["local"] = local();
    } else {
        pose["locals"] = Json::array({local(), local()});
    }
    const Json change{{"translate", point(true)}, {"scale", 1 + std::abs(*real(1))}};
    if (*whole(0, 1) == 0 && !document.empty()) {
        pose["by"] = change;
    } else {
        pose.update(change);
    }
    return pose;
}

Json oneCommand(const Json& document) {
    const std::string place = *whole(0, 2) == 0 ? anyPlace(document) : anyKnotOrPoint(document);
    switch (*whole(0, 10)) {
        case 0: return {{"set", place}, {"value", anyValue()}};
        case 1: return {{"set", anyKnotOrPoint(document)}, {"value", anyValue()}};
        case 2: return {{"move", place}, {"by", *whole(0, 1) == 0 ? Json(*real(1)) : point(false)}};
        case 3: return {{"move", place}, {"to", anyValue()}, {"snap", 0.5}};
        case 4: return {{"insert", place}, {"value", anyValue()}};
        case 5: return {{"remove", place}};
        case 6: return {{"add", anyObject()}};
        case 7: return {{"pose", anyPose(document)}};
        case 8:
            return {{"insertKnot", {{"object", "o" + std::to_string(*whole(1, 4))},
                                    {"at", std::abs(*real(3))}}}};
        case 9:
            return {{"move", {anyKnotOrPoint(document), anyKnotOrPoint(document)}},
                    {"by", point(false)}};
        default: return {{"move", indexed("objects", 0)}, {"to", *whole(0, 4)}};
    }
}

Json anyCommand(const Json& document) {
    Json command = oneCommand(document);
    if (*whole(0, 5) == 0) command = {{"all", {std::move(command), oneCommand(document)}}};
    if (*whole(0, 3) == 0) command["gesture"] = "g" + std::to_string(*whole(0, 1));
    if (*whole(0, 5) == 0) command["selection"] = Json::array({anyPlace(document)});
    return command;
}

// --- what holds ----------------------------------------------------------------------------------

TEST(DocumentProperty, CanonicalFormsAreTheirOwn) {
    holds(300, [] {
        const Json given = parsed(anyDocument());
        const auto problems = findProblems(given);
        const auto scene = Scene::open(given);
        RC_ASSERT(problems.empty() == scene.ok());
        if (!scene) {
            RC_ASSERT(problems.front() == scene.error());
            RC_DISCARD("refused");
        }
        const std::string canonical = dumpJson(scene->document());
        RC_ASSERT(dumpJson(Scene::open(*parseJson(canonical))->document()) == canonical);
    });
}

TEST(DocumentProperty, OfWhatIsAmissTheFirstProblemIsTheRefusal) {
    holds(600, [] {
        const auto scene = Scene::open(parsed(anyDocument()));
        if (!scene) RC_DISCARD("refused");
        Json document = scene->document();
        for (int changes = *whole(1, 3); changes > 0; --changes) {
            const auto place = parsePath(anyPlace(document));
            if (Json* at = place ? find(document, *place) : nullptr) *at = parsed(anyValue());
        }
        const auto problems = findProblems(document);
        const auto again = Scene::open(document);
        RC_ASSERT(problems.empty() == again.ok());
        if (!again) RC_ASSERT(problems.front() == again.error());
    });
}

TEST(CommandProperty, UndoneIsAsItWasAndRedoneAsItCameToBe) {
    int done = 0;
    int refused = 0;
    holds(400, [&] {
        auto scene = Scene::open(parsed(anyDocument()));
        if (!scene) RC_DISCARD("refused");
        const std::string first = dumpJson(scene->document());
        std::string last = first;
        for (int k = *whole(1, 10); k > 0; --k) {
            const Json command = parsed(anyCommand(scene->document()));
            RC_LOG() << dumpJson(command) << "\n";
            const auto revision = scene->revision();
            const bool undoable = scene->canUndo();
            const bool ok = scene->execute(command).ok();
            ++(ok ? done : refused);
            const Json document = scene->document();
            if (!ok) {
                RC_ASSERT(scene->revision() == revision);
                RC_ASSERT(scene->canUndo() == undoable);
                RC_ASSERT(dumpJson(document) == last);
                continue;
            }
            RC_ASSERT(scene->revision() == revision + 1);
            last = dumpJson(document);
            const auto again = Scene::open(*parseJson(last));
            RC_ASSERT(again.ok());
            RC_ASSERT(dumpJson(again->document()) == last);
        }
        while (scene->undo()) (void)scene->selection();
        RC_ASSERT(dumpJson(scene->document()) == first);
        while (scene->redo()) (void)scene->selection();
        RC_ASSERT(dumpJson(scene->document()) == last);
    });
    EXPECT_GT(done, 300);
    EXPECT_GT(refused, 300);
}

}  // namespace
}  // namespace knotwork::scene
