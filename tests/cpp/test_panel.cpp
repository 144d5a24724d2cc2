// The panel with a real Dear ImGui and a back end that draws nothing.
#include "scene/builtin.hpp"
#include "scene/json.hpp"
#include "ui/panel.hpp"

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_impl_opengl3.h>

#include <random>

bool ImGui_ImplOpenGL3_Init(const char*) { return true; }
void ImGui_ImplOpenGL3_Shutdown() {}
void ImGui_ImplOpenGL3_NewFrame() {}
void ImGui_ImplOpenGL3_RenderDrawData(ImDrawData*) {}
bool ImGui_ImplOpenGL3_CreateFontsTexture() {
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    return pixels != nullptr;
}
void ImGui_ImplOpenGL3_DestroyFontsTexture() {}
bool ImGui_ImplOpenGL3_CreateDeviceObjects() { return ImGui_ImplOpenGL3_CreateFontsTexture(); }
void ImGui_ImplOpenGL3_DestroyDeviceObjects() {}

namespace knotwork::ui {
namespace {

scene::Scene openText(std::string_view document) {
    return *scene::Scene::open(*scene::parseJson(document));
}

constexpr std::string_view spline = R"({"knotwork": 1, "objects": [
    {"id": "a", "type": "bspline-curve", "degree": 3,
     "points": [[0, 0], [1, 2], [3, 1], [4, 0], [6, 2], [7, 0]]}]})";

class PanelTest : public testing::Test {
protected:
    PanelTest() { EXPECT_TRUE(host.start()); }

    void frame() {
        const auto pixels = [this](double css) { return static_cast<int>(css * ratio); };
        if (!host.beginFrame({pixels(800), pixels(600), ratio, 1.0 / 60})) return;
        panel(scene, state, {10, 10, 300, 580}, host.colours());
        host.render();
    }
    void frames(int count) {
        for (int i = 0; i < count; ++i) frame();
    }
    void drag(double fromX, double toX, double y, PointerKind kind = PointerKind::mouse) {
        host.pointerMove(fromX, y, kind);
        frames(2);
        host.pointerButton(0, true, kind);
        frames(2);
        host.pointerMove(toX, y, kind);
        frames(2);
        host.pointerButton(0, false, kind);
        frames(3);
    }
    /// Drags along one row after the other until something has been told.
    double dragRowsUntilTold(PointerKind kind) {
        for (double y = 50; y < 120; y += 6) {
            drag(145, 110, y, kind);
            if (!state.events.empty()) return y;
        }
        return 0;
    }

    double ratio = 1;
    scene::Scene scene = openText(spline);
    PanelState state;
    ImGuiHost host;
};

TEST_F(PanelTest, ComesToRestAndThenWantsNoFrames) {
    frames(10);
    EXPECT_FALSE(host.animating());
    EXPECT_TRUE(state.events.empty());
    EXPECT_FALSE(scene.canUndo());
}

TEST_F(PanelTest, OnlyItsWindowIsHit) {
    frames(3);
    EXPECT_TRUE(host.hits(60, 40));
    EXPECT_FALSE(host.hits(500, 40));
    EXPECT_FALSE(host.hits(5, 5));
}

TEST_F(PanelTest, CoversWhatReachesIntoItsWindow) {
    frames(3);
    EXPECT_TRUE(host.covers(300, 30, 340, 40));
    EXPECT_TRUE(host.covers(0, 0, 800, 600));
    EXPECT_FALSE(host.covers(320, 30, 340, 40));
}

TEST_F(PanelTest, APointerOverItIsItsOwn) {
    host.pointerMove(60, 40, PointerKind::mouse);
    frames(3);
    EXPECT_TRUE(host.wantsPointer());
    host.pointerMove(500, 40, PointerKind::mouse);
    EXPECT_TRUE(host.animating());
    frames(4);
    EXPECT_FALSE(host.wantsPointer());
}

TEST_F(PanelTest, DraggingASliderIsOneStepAndEndsWithAChange) {
    frames(3);
    ASSERT_GT(dragRowsUntilTold(PointerKind::mouse), 0);
    EXPECT_FALSE(state.events.front().final);
    EXPECT_TRUE(state.events.back().final);
    ASSERT_TRUE(scene.undo());
    EXPECT_FALSE(scene.canUndo());
}

TEST_F(PanelTest, AFingerDragsASliderToo) {
    frames(3);
    EXPECT_GT(dragRowsUntilTold(PointerKind::touch), 0);
    frames(4);
    EXPECT_FALSE(host.wantsPointer());
}

TEST_F(PanelTest, SlidersStandAtTheSamePlaceAtAnyPixelRatio) {
    frames(3);
    const double y = dragRowsUntilTold(PointerKind::mouse);
    state.events.clear();
    ratio = 2.5;
    frames(3);
    drag(128, 145, y);
    EXPECT_FALSE(state.events.empty());
}

TEST_F(PanelTest, NothingIsHeldOnceTheFocusIsGone) {
    host.pointerMove(60, 40, PointerKind::mouse);
    host.pointerButton(0, true, PointerKind::mouse);
    frames(3);
    host.blur();
    frames(3);
    EXPECT_FALSE(host.wantsPointer());
}

TEST_F(PanelTest, ALostContextKeepsWhatIsOpen) {
    frames(3);
    host.forget();
    EXPECT_FALSE(host.started());
    frames(2);
    EXPECT_FALSE(host.animating());
    ASSERT_TRUE(host.start());
    frames(3);
    EXPECT_TRUE(host.hits(60, 40));
}

TEST_F(PanelTest, ASceneWithoutObjectsHasNoPanel) {
    scene = openText(R"({"knotwork": 1, "objects": []})");
    frames(3);
    EXPECT_FALSE(host.hits(60, 40));
}

TEST_F(PanelTest, ARandomWalkOfThePointerLeavesEverySceneValid) {
    std::mt19937 random(20);
    std::uniform_real_distribution<double> anywhere(0, 1);
    for (const scene::BuiltinScene& builtin : scene::builtinScenes()) {
        scene = openText(builtin.document);
        state = {};
        // Where chance has changed nothing yet, it gets more of them.
        for (int i = 0; i < 200 || (!scene.canUndo() && i < 4000); ++i) {
            host.pointerMove(10 + 300 * anywhere(random), 10 + 580 * anywhere(random),
                             PointerKind::mouse);
            frame();
            host.pointerButton(0, i % 2 == 0, PointerKind::mouse);
            if (i % 7 == 0) host.wheel(0, anywhere(random) < 0.5 ? -3 : 3);
            if (i % 11 == 0) host.text("7");
            if (i % 13 == 0) host.key("Enter", true, 0);
            if (i % 13 == 1) host.key("Enter", false, 0);
            frame();
        }
        EXPECT_TRUE(scene.canUndo()) << builtin.id << " was not even touched";
        EXPECT_TRUE(scene::Scene::open(scene.document()).ok()) << builtin.id;
    }
}

TEST(PointerKindNamed, KnowsTheNamesOfTheDom) {
    EXPECT_EQ(pointerKindNamed("touch"), PointerKind::touch);
    EXPECT_EQ(pointerKindNamed("pen"), PointerKind::pen);
    EXPECT_EQ(pointerKindNamed("mouse"), PointerKind::mouse);
    EXPECT_EQ(pointerKindNamed(""), PointerKind::mouse);
}

}  // namespace
}  // namespace knotwork::ui
