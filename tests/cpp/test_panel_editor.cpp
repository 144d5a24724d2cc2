#include "scene/json.hpp"
#include "ui/panel_editor.hpp"

#include <gtest/gtest.h>

namespace knotwork::ui {
namespace {

using scene::Json;

scene::Scene openSpline() {
    const auto document = scene::parseJson(R"({"knotwork": 1, "objects": [
        {"id": "a", "type": "bspline-curve", "degree": 2,
         "points": [[0, 0], [1, 2], [3, 1], [4, 0]]},
        {"id": "b", "type": "parametric-curve", "name": "circle"}]})");
    return *scene::Scene::open(*document);
}

class PanelEditorTest : public testing::Test {
protected:
    PanelEditor editor() { return {scene, state, theme(ThemeName::light)}; }
    Json degree() const { return *scene::member(scene.state().objects[0]->spec, "degree"); }

    scene::Scene scene = openSpline();
    PanelState state;
};

TEST_F(PanelEditorTest, ADragIsOneStepOfHistory) {
    auto edit = editor();
    edit.hold("degree", "degree", 3);
    edit.hold("degree", "degree", 1);
    edit.finish(false);
    EXPECT_EQ(degree(), 1);
    ASSERT_TRUE(scene.undo());
    EXPECT_EQ(degree(), 2);
    EXPECT_FALSE(scene.canUndo());
}

TEST_F(PanelEditorTest, TwoDragsOfOneFieldAreTwoSteps) {
    auto edit = editor();
    edit.hold("degree", "degree", 3);
    edit.finish(false);
    edit.hold("degree", "degree", 1);
    edit.finish(false);
    ASSERT_TRUE(scene.undo());
    EXPECT_EQ(degree(), 3);
}

TEST_F(PanelEditorTest, ADragTellsEachInputAndOneChange) {
    auto edit = editor();
    edit.hold("degree", "degree", 3);
    edit.finish(true);
    edit.hold("degree", "degree", 1);
    edit.finish(true);
    edit.finish(false);
    ASSERT_EQ(state.events.size(), 3U);
    EXPECT_FALSE(state.events[0].final);
    EXPECT_FALSE(state.events[1].final);
    EXPECT_TRUE(state.events[2].final);
    EXPECT_EQ(state.events[2].path, "objects[0].degree");
    EXPECT_EQ(state.events[2].command, (Json{{"set", "objects[0].degree"}, {"value", 1}}));
}

TEST_F(PanelEditorTest, ARefusedEditKeepsTheValueAndSaysWhyBesideItsField) {
    auto edit = editor();
    edit.set("degree", 9);
    EXPECT_EQ(degree(), 2);
    EXPECT_FALSE(edit.changed());
    EXPECT_FALSE(edit.refusalOf("degree").empty());
    EXPECT_TRUE(edit.refusalOf("form").empty());
    EXPECT_TRUE(state.events.empty());
}

TEST_F(PanelEditorTest, ADragThatOnlyRefusesTellsNothing) {
    auto edit = editor();
    edit.hold("degree", "degree", 9);
    edit.finish(false);
    EXPECT_TRUE(state.events.empty());
    EXPECT_FALSE(scene.canUndo());
}

TEST_F(PanelEditorTest, TheNextEditTakesTheRefusalAway) {
    auto edit = editor();
    edit.set("degree", 9);
    edit.set("degree", 3);
    EXPECT_TRUE(edit.refusalOf("degree").empty());
    EXPECT_TRUE(edit.changed());
}

TEST_F(PanelEditorTest, UndoIsTold) {
    auto edit = editor();
    edit.undo();
    EXPECT_TRUE(state.events.empty());
    edit.set("degree", 3);
    state.events.clear();
    edit.undo();
    ASSERT_EQ(state.events.size(), 1U);
    EXPECT_TRUE(state.events[0].history);
    EXPECT_TRUE(state.events[0].final);
    EXPECT_EQ(degree(), 2);
}

TEST_F(PanelEditorTest, UndoInADragEndsTheDragFirst) {
    auto edit = editor();
    edit.hold("degree", "degree", 3);
    edit.undo();
    edit.hold("degree", "degree", 1);
    ASSERT_TRUE(scene.undo());
    EXPECT_EQ(degree(), 2);
}

TEST_F(PanelEditorTest, FieldsAreDescribedAnewOnlyWhenTheirObjectChanges) {
    auto edit = editor();
    const auto* first = edit.fields().data();
    EXPECT_EQ(edit.fields().data(), first);
    edit.set("degree", 3);
    const auto& after = edit.fields();
    EXPECT_EQ(after[0].path, "degree");
    EXPECT_EQ(after[0].value, 3);
}

TEST_F(PanelEditorTest, AddressesNameTheObjectThatIsShown) {
    state.object = 1;
    auto edit = editor();
    EXPECT_EQ(edit.object().id, "b");
    EXPECT_EQ(edit.address("parameters.radius"), "objects[1].parameters.radius");
    edit.set("parameters.radius", 2.5);
    EXPECT_TRUE(edit.changed());
}

}  // namespace
}  // namespace knotwork::ui
