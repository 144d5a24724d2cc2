// Handles of B-functions and effects: dragged, pressed, clicked, they set what a field sets.
#include "app/hit.hpp"
#include "support/playground.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace knotwork::app {
namespace {

constexpr double pi = 3.141592653589793;

std::string blendWith(const std::string& function) {
    return R"({"knotwork":1,"view":{"panes":["curve","bFunction"]},"objects":[
        {"id":"b","type":"blending-curve","bFunction":)" + function + R"(,
         "model":{"type":"parametric-curve","name":"circle"},"locals":{"count":4},
         "form":"closed","show":{"handles":true}}]})";
}

std::string circleWith(const std::string& effect) {
    return R"({"knotwork":1,"view":{"panes":["curve"]},"objects":[
        {"id":"b","type":"blending-curve","bFunction":{"family":"expo-rational"},
         "model":{"type":"parametric-curve","name":"circle"},"locals":{"count":4},
         "form":"closed","show":{"handles":true}}],"effects":[)" + effect + "]}";
}

constexpr const char* move = R"({"target":"b","kind":"translate","by":[0.5,0.25,0]})";
constexpr const char* turn = R"({"target":"b","kind":"rotate","angle":1,"center":[0.5,0,0]})";
constexpr const char* grow = R"({"target":"b","kind":"scale","factor":1.5})";
constexpr const char* dance = R"({"target":"b","kind":"simulate","translate":[0.25,0.5,0],
    "rotate":{"axis":[0,0,1],"angle":0.5}})";

const Sight& sightOfPane(Playground& play, Pane pane) {
    return play.view.figure()->find(pane)->sight;
}

Json lastCommand(Playground& play) {
    const Json events = *scene::parseJson(play.view.editor().takeEvents());
    if (events.empty()) return nullptr;
    Json command = events.back()["command"];
    command.erase("gesture");
    return command;
}

double numberAt(Playground& play, const std::string& path) {
    return play.at(path.c_str()).get<double>();
}

const BFunction& blendOf(Playground& play) {
    return play.scene->state().objects[0]->body.as<BlendingCurve>()->blend();
}

/// Drags a handle in its pane to a place of that pane's plane.
void dragTo(Playground& play, const std::string& path, const Vec3& to, int modifiers = 0) {
    const Pixel from = play.pixelOf(path);
    const Pixel end = sightOfPane(play, play.view.selected()->pane).toPixels(to);
    play.event("down", from, 1);
    play.event("move", {(from.x + end.x) / 2, (from.y + end.y) / 2}, 1, modifiers);
    play.event("move", end, 1, modifiers);
    play.event("up", end, 0, modifiers);
}

TEST(FunctionHandles, StandOnTheGraph) {
    for (const char* function :
         {R"({"family":"trigonometric","order":3})", R"({"family":"polynomial","p":2,"q":4})",
          R"({"family":"rational","m":3,"c":2})", R"({"family":"expo-rational","lambda":0.3})",
          R"({"family":"logistic","c":2})", R"({"family":"tabulated","values":[0,0.2,0.7,1]})",
          R"({"family":"mixed","of":[{"family":"linear"},{"family":"trigonometric"}],
              "weight":0.25})"}) {
        Playground play(blendWith(function).c_str());
        const auto handles = functionHandles(play.scene->state());
        EXPECT_FALSE(handles.empty()) << function;
        for (const FunctionHandle& handle : handles) {
            EXPECT_NEAR(blendOf(play).value(handle.at.x), handle.at.y, 1e-9) << handle.path;
            EXPECT_EQ(numberAt(play, handle.path), handle.value) << handle.path;
            play.view.select(handle.path);
            ASSERT_TRUE(play.view.selected()) << handle.path;
            EXPECT_EQ(play.view.selected()->kind, TargetKind::parameter);
        }
    }
}

TEST(FunctionHandles, ThatAreDraggedBringTheGraphUnderThePointer) {
    struct Case {
        const char* function;
        const char* parameter;
        Vec3 to;
        double wanted;
    };
    const std::vector<Case> cases{
        {R"({"family":"rational","m":2,"c":1})", "c", {0.7, 0.5, 0}, 49.0 / 9},
        {R"({"family":"rational","m":2,"c":1})", "m", {0.75, 0.97, 0}, std::log(0.97 / 0.03) / std::log(3)},
        {R"({"family":"expo-rational"})", "lambda", {0.3, 0.5, 0}, 0.3},
        {R"({"family":"logistic","c":1})", "c", {0.75, 0.99, 0}, std::log(99) / (8.0 / 3)},
        {R"({"family":"mixed","of":[{"family":"linear"},{"family":"polynomial","p":5,"q":5}],
            "weight":0.5})", "weight", {0, 0, 0}, 0.25}};
    for (const Case& one : cases) {
        Playground play(blendWith(one.function).c_str());
        const std::string path = std::string("objects[0].bFunction.") + one.parameter;
        Vec3 to = one.to;
        if (to.x == 0) {  // where the mixture with that weight passes
            play.view.select(path);
            const auto operands = blendOf(play).operands();
            to = {play.view.selected()->at.x, 0, 0};
            to.y = 0.25 * operands[0].value(to.x) + 0.75 * operands[1].value(to.x);
        }
        dragTo(play, path, to);
        const double pixel = 0.01;  // of B; parameters have three digits
        EXPECT_NEAR(numberAt(play, path), one.wanted, 0.02 * std::max(1.0, one.wanted)) << path;
        play.view.select(path);
        EXPECT_NEAR(play.view.selected()->at.y, one.parameter == std::string("lambda")
                        ? blendOf(play).value(0.3) : to.y, pixel) << path;
        EXPECT_EQ(lastCommand(play), (Json{{"set", path}, {"value", play.at(path.c_str())}}));
        EXPECT_TRUE(play.scene->undo());
        EXPECT_FALSE(play.scene->canUndo());
    }
}

TEST(FunctionHandles, OfAnExpoRationalOneMakeItSteeper) {
    Playground play(blendWith(R"({"family":"expo-rational"})").c_str());
    const double before = blendOf(play).value(0.75);
    const double to = before + 0.05;
    dragTo(play, "objects[0].bFunction.beta", {0.75, to, 0});
    EXPECT_NEAR(blendOf(play).value(0.75), to, 0.01);
    EXPECT_GT(numberAt(play, "objects[0].bFunction.beta"), 1);
}

TEST(FunctionHandles, OfIntegersTakeTheNearest) {
    Playground play(blendWith(R"({"family":"polynomial","p":1,"q":1})").c_str());
    const BFunction wanted = *BFunction::makePolynomial(3, 1);
    dragTo(play, "objects[0].bFunction.p", {0.25, wanted.value(0.25) + 0.002, 0});
    EXPECT_EQ(play.at("objects[0].bFunction.p"), 3);
    play.view.select("objects[0].bFunction.q");
    EXPECT_TRUE(play.view.key("ArrowUp", true, 0));
    play.view.key("ArrowUp", false, 0);
    EXPECT_EQ(play.at("objects[0].bFunction.q"), 2);
}

TEST(FunctionHandles, OfATableStayBetweenTheirNeighbours) {
    Playground play(blendWith(R"({"family":"tabulated","values":[0,0.2,0.7,1]})").c_str());
    dragTo(play, "objects[0].bFunction.values[1]", {1.0 / 3, 0.9, 0});
    EXPECT_EQ(play.at("objects[0].bFunction.values[1]"), 0.7);
    dragTo(play, "objects[0].bFunction.values[2]", {2.0 / 3, 0.82, 0});
    EXPECT_NEAR(numberAt(play, "objects[0].bFunction.values[2]"), 0.82, 0.01);
}

TEST(FunctionHandles, BeyondWhatAFamilyCanDoStopAtItsEnd) {
    for (const double to : {-1.0, 2.0}) {
        Playground play(blendWith(R"({"family":"logistic","c":1})").c_str());
        dragTo(play, "objects[0].bFunction.c", {0.75, to, 0});
        const double c = numberAt(play, "objects[0].bFunction.c");
        EXPECT_TRUE(to > 1 ? c > 100 : c < 0.01) << c;
    }
}

TEST(FunctionHandles, AreTheSameByPointerKeysClicksAndCommand) {
    const std::string document = blendWith(R"({"family":"expo-rational"})");
    Playground drags(document.c_str()), keys(document.c_str()), clicks(document.c_str()),
        commands(document.c_str());
    const std::string path = "objects[0].bFunction.lambda";
    const Vec3 to{0.3, 0.9, 0};
    dragTo(drags, path, to);
    keys.view.select(path);
    keys.view.setStep(0.1);
    for (int k = 0; k < 2; ++k) keys.view.key("ArrowLeft", true, 0);
    keys.view.key("ArrowLeft", false, 0);
    const Pixel end = sightOfPane(clicks, Pane::bFunction).toPixels(to);
    clicks.view.select(path);
    EXPECT_TRUE(clicks.view.place(end, "move"));
    ASSERT_TRUE(commands.scene->execute(Json{{"set", path}, {"value", 0.3}}));
    for (Playground* play : {&drags, &keys, &clicks}) {
        EXPECT_EQ(play->scene->document(), commands.scene->document());
        EXPECT_EQ(lastCommand(*play), (Json{{"set", path}, {"value", 0.3}}));
    }
}

TEST(FunctionHandles, SayTheirNumberAndShowTheFormerGraphWhileTheyAreDragged) {
    Playground play(blendWith(R"({"family":"expo-rational"})").c_str());
    const Pixel from = play.pixelOf("objects[0].bFunction.lambda");
    play.event("down", from, 1);
    play.event("move", {from.x - 40, from.y}, 1);
    const PaneFigure* pane = play.view.figure()->find(Pane::bFunction);
    EXPECT_FALSE(pane->below.empty());
    EXPECT_FALSE(play.view.figure()->find(Pane::curve)->below.empty());
    const auto& labels = pane->plot.labels;
    EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const ui::Label& label) {
        return label.text.rfind("λ = 0.", 0) == 0;
    }));
    play.event("cancel", from, 0);
    EXPECT_FALSE(play.scene->canUndo());
}

TEST(FunctionHandles, OfAGraphInThePlaneStandOnIt) {
    Playground play(R"({"knotwork":1,"objects":[{"id":"g","type":"b-function","at":[1,2],"size":2,
        "bFunction":{"family":"polynomial","p":1,"q":3}}]})");
    const BFunction blend = *BFunction::makePolynomial(1, 3);
    play.view.select("objects[0].bFunction.p");
    ASSERT_TRUE(play.view.selected());
    EXPECT_NEAR(glm::distance(play.view.selected()->at, Vec3(1.5, 2 + 2 * blend.value(0.25), 0)), 0,
                1e-12);
}

TEST(EffectHandles, AreSeenWhereSomethingOfTheirObjectIsSelectedAndNothingMoves) {
    Playground play(circleWith(move).c_str());
    const auto seen = [&] {
        const auto& shapes = play.view.figure()->find(Pane::curve)->shapes;
        return std::any_of(shapes.begin(), shapes.end(), [](const Painted& painted) {
            return painted.shape->path == "effects[0].by";
        });
    };
    EXPECT_FALSE(seen());
    play.view.select("objects[0].poses[1]");
    EXPECT_TRUE(seen());
    play.view.clock().setPlaying(true);
    play.view.touch();
    EXPECT_FALSE(seen());
    play.view.clock().setPlaying(false);
    play.view.setReadOnly(true);
    play.view.touch();
    EXPECT_FALSE(seen());
}

TEST(EffectHandles, OfAMovementSetHowFarItGoes) {
    Playground drags(circleWith(move).c_str()), keys(circleWith(move).c_str()),
        clicks(circleWith(move).c_str());
    const std::string path = "effects[0].by";
    drags.view.select(path);
    ASSERT_TRUE(drags.view.selected());
    EXPECT_NEAR(glm::distance(drags.view.selected()->at, Vec3(0.5, 0.25, 0)), 0, 1e-6);
    dragTo(drags, path, drags.view.selected()->at + Vec3(0.2, 0, 0));
    keys.view.select(path);
    keys.view.setStep(0.1);
    for (int k = 0; k < 2; ++k) keys.view.key("ArrowRight", true, 0);
    keys.view.key("ArrowRight", false, 0);
    clicks.view.select(path);
    EXPECT_TRUE(clicks.view.place(
        sightOfPane(clicks, Pane::curve).toPixels(clicks.view.selected()->at + Vec3(0.2, 0, 0)),
        "move"));
    const Json command{{"set", path}, {"value", {0.7, 0.25, 0}}};
    for (Playground* play : {&drags, &keys, &clicks}) {
        EXPECT_EQ(play->at("effects[0].by"), command["value"]);
        EXPECT_EQ(lastCommand(*play), command);
        EXPECT_TRUE(play->scene->undo());
        EXPECT_FALSE(play->scene->canUndo());
    }
}

TEST(EffectHandles, OfATurnFollowThePointerRoundItsCentre) {
    Playground play(circleWith(turn).c_str());
    const std::string path = "effects[0].angle";
    play.view.select(path);
    ASSERT_TRUE(play.view.selected());
    const Vec3 centre(0.5, 0, 0);
    const Vec3 arm = play.view.selected()->at - centre;
    const auto turned = [&](double angle) { return centre + rotation(Vec3(0, 0, 1), angle) * arm; };
    dragTo(play, path, turned(0.6));
    EXPECT_NEAR(numberAt(play, path), 1.6, 0.02);
    play.view.select(path);
    const Pixel from = play.pixelOf(path);
    play.event("down", from, 1);
    for (int k = 1; k <= 12; ++k) {
        play.event("move", sightOfPane(play, Pane::curve).toPixels(turned(0.6 + k * pi / 6)), 1,
                   commandKey);
    }
    play.event("up", sightOfPane(play, Pane::curve).toPixels(turned(0.6)), 0, commandKey);
    EXPECT_NEAR(numberAt(play, path), pi / 12 * std::round((1.6 + 2 * pi) / (pi / 12)), 1e-12)
        << "once round, to the nearest 15 degrees";
}

TEST(EffectHandles, OfATurnsCentreAndOfAScalingSetThem) {
    Playground turns(circleWith(turn).c_str());
    dragTo(turns, "effects[0].center", {0.5, 0.5, 0}, commandKey);
    EXPECT_EQ(turns.at("effects[0].center"), (Json{0.5, 0.5, 0.0}));
    Playground grows(circleWith(grow).c_str());
    grows.view.select("effects[0].factor");
    dragTo(grows, "effects[0].factor", grows.view.selected()->at * (2 / 1.5));
    EXPECT_NEAR(numberAt(grows, "effects[0].factor"), 2, 0.02);
    dragTo(grows, "effects[0].factor", {-3, 0, 0});
    EXPECT_NEAR(numberAt(grows, "effects[0].factor"), 0.05, 1e-12) << "it does not turn over";
}

TEST(EffectHandles, OfADanceSetHowFarLocalsGoAtMost) {
    Playground play(circleWith(dance).c_str());
    play.view.select("objects[0].poses[1]");
    const Vec3 local = play.view.selected()->at;
    play.view.figure();
    play.view.select("effects[0].translate");
    EXPECT_NEAR(glm::distance(play.view.selected()->at, local + Vec3(0.25, 0.5, 0)), 0, 1e-9)
        << "it stands at the local curve that was selected";
    dragTo(play, "effects[0].translate", local + Vec3(0.5, 0.5, 0), commandKey);
    EXPECT_EQ(play.at("effects[0].translate"), (Json{0.5, 0.5, 0.0}));
    play.view.select("effects[0].rotate.angle");
    EXPECT_TRUE(play.view.key("ArrowUp", true, 0));
    play.view.key("ArrowUp", false, 0);
    EXPECT_GT(numberAt(play, "effects[0].rotate.angle"), 0.5);
}

TEST(EffectHandles, InSpaceTurnTheAxis) {
    Playground play(R"({"knotwork":1,"view":{"mode":"3d"},"objects":[{"id":"h",
        "type":"bspline-curve","degree":2,"points":[[0,0,0],[1,0,1],[1,1,2],[0,1,3]]}],
        "effects":[{"target":"h","kind":"rotate","angle":1,"axis":[0,0,2]}]})");
    play.view.select("effects[0].axis");
    ASSERT_TRUE(play.view.selected());
    const Pixel from = play.pixelOf("effects[0].axis");
    play.drag(from, {from.x + 40, from.y});
    const Json& axis = play.at("effects[0].axis");
    const Vec3 now(axis[0].get<double>(), axis[1].get<double>(), axis[2].get<double>());
    EXPECT_NEAR(glm::length(now), 2, 0.02);
    EXPECT_GT(glm::length(Vec3(now.x, now.y, 0)), 0.1);
}

TEST(KindKey, GoesFromKindToKindAndRound) {
    Playground play(circleWith(move).c_str());
    std::vector<std::string> seen;
    for (int k = 0; k < 3; ++k) {
        EXPECT_TRUE(play.view.key("k", true, 0));
        seen.push_back(play.view.selected()->path());
    }
    EXPECT_EQ(seen[0], "objects[0].poses[0]");
    EXPECT_EQ(seen.size(), 3u);
    EXPECT_NE(std::find(seen.begin(), seen.end(), "effects[0].by"), seen.end());
    EXPECT_TRUE(play.view.key("PageDown", true, 0));
}

TEST(Values, CannotBeRemovedOrGathered) {
    Playground play(circleWith(move).c_str());
    const Pixel local = play.pixelOf("objects[0].poses[1]");
    play.view.select("effects[0].by");
    const Json before = play.scene->document();
    EXPECT_FALSE(play.view.key("Delete", true, 0));
    play.view.setGathering(true);
    play.click(local);
    ASSERT_TRUE(play.view.selected());
    EXPECT_EQ(play.view.selected()->path(), "objects[0].poses[1]");
    EXPECT_EQ(play.scene->document(), before);
}

}  // namespace
}  // namespace knotwork::app
