// The tool at a selected handle: found by the pointer, dragged, undone.
#include "app/gizmo.hpp"
#include "support/playground.hpp"

#include <cmath>

namespace knotwork::app {
namespace {

constexpr double pi = 3.141592653589793;
constexpr const char* patches = R"({"knotwork":1,"view":{"mode":"3d",
    "camera":{"azimuth":-0.7853981633974483,"elevation":0.6154797086703873}},"objects":[{"id":"p",
    "type":"blending-surface","bFunction":{"family":"expo-rational"},
    "model":{"type":"parametric-surface","name":"cylinder"},"locals":[6,4],"kind":"sub-surface",
    "show":{"handles":true}}]})";

struct Workbench : Playground {
    Workbench(const char* document, const char* handle) : Playground(document) {
        view.setReadOnly(false);
        at = pixelOf(handle);
        target = *view.selected();
        const auto found = gizmoOf(scene->state(), target, {}, !view.spatial(),
                                   view.figure()->find(Pane::curve)->plot.box);
        EXPECT_TRUE(found);
        tool = *found;
    }
    const Sight& sight() { return view.figure()->find(Pane::curve)->sight; }
    Pose pose() { return posedLocal(scene->state().objects[0]->body, target.index)->pose; }

    Pixel at;
    Target target;
    Gizmo tool;
};

Workbench plane() { return {blend, "objects[0].poses[1]"}; }
Workbench space() { return {patches, "objects[0].poses[22]"}; }

/// A place on a part where no other part is near.
Pixel placeOn(Workbench& bench, const GizmoPart& part) {
    if (part.kind == GizmoKind::move) return *arrowTip(bench.tool, bench.sight(), part.axis);
    if (part.kind == GizmoKind::scale) return *boxPlace(bench.tool, bench.sight(), part.axis);
    const std::vector<Pixel> ring = ringOf(bench.tool, bench.sight(), part.axis);
    return ring[ring.size() / 3];
}

TEST(Gizmo, InAPlaneItHasTwoArrowsOneRingAndTwoBoxes) {
    Workbench bench = plane();
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(arrowTip(bench.tool, bench.sight(), axis).has_value(), axis < 2);
        EXPECT_EQ(boxPlace(bench.tool, bench.sight(), axis).has_value(), axis < 2);
        EXPECT_EQ(ringOf(bench.tool, bench.sight(), axis).empty(), axis < 2);
    }
}

TEST(Gizmo, EveryPartIsFoundAboutATargetOf24Pixels) {
    for (const auto& make : {plane, space}) {
        Workbench bench = make();
        int parts = 0;
        for (const GizmoKind kind : {GizmoKind::move, GizmoKind::turn, GizmoKind::scale}) {
            for (int axis = 0; axis < 3; ++axis) {
                const GizmoPart part{kind, axis};
                if (kind == GizmoKind::turn
                        ? ringOf(bench.tool, bench.sight(), axis).empty()
                        : !arrowTip(bench.tool, bench.sight(), axis)) {
                    continue;
                }
                const Pixel place = placeOn(bench, part);
                EXPECT_EQ(partAt(bench.tool, bench.sight(), place, 12), part);
                ++parts;
                for (const Pixel& off : {Pixel{8, 8}, Pixel{-8, 8}, Pixel{8, -8}, Pixel{-8, -8}}) {
                    EXPECT_TRUE(partAt(bench.tool, bench.sight(),
                                       {place.x + off.x, place.y + off.y}, 12));
                }
            }
        }
        EXPECT_EQ(parts, bench.view.spatial() ? 9 : 5);
    }
}

TEST(Gizmo, AnArrowMovesAlongItsAxisAlone) {
    for (const auto& make : {plane, space}) {
        Workbench bench = make();
        const Pixel from = placeOn(bench, {GizmoKind::move, 1});
        const Pixel along = bench.sight().pixelVector({0, 1, 0});
        bench.drag(from, {from.x + 0.4 * along.x - 0.1 * along.y,
                          from.y + 0.4 * along.y + 0.1 * along.x});
        EXPECT_EQ(bench.pose().translate.x, 0);
        EXPECT_EQ(bench.pose().translate.z, 0);
        EXPECT_NEAR(bench.pose().translate.y, 0.4, bench.unitsPerPixel());
        ASSERT_TRUE(bench.scene->undo());
        EXPECT_TRUE(bench.pose().isIdentity());
        EXPECT_FALSE(bench.scene->canUndo());
    }
}

TEST(Gizmo, ARingTurnsAboutItsAxisAlsoMoreThanOnceRound) {
    Workbench bench = plane();
    bench.event("down", {bench.at.x + 32, bench.at.y}, 1);
    const auto pointAt = [&](double angle) {
        return Pixel{bench.at.x + 50 * std::cos(angle), bench.at.y - 50 * std::sin(angle)};
    };
    for (double angle = 0.2; angle < 2 * pi + 0.5; angle += 0.3) {
        bench.event("move", pointAt(angle), 1);
    }
    bench.event("move", pointAt(2 * pi + 0.5), 1);
    bench.event("up", pointAt(2 * pi + 0.5), 0);
    EXPECT_NEAR(bench.pose().angle, 2 * pi + 0.5, 0.01);
    EXPECT_EQ(bench.pose().axis, Vec3(0, 0, 1));
    EXPECT_EQ(bench.pose().translate, Vec3(0.0));
}

TEST(Gizmo, InSpaceTheHandleGoesRoundWithTheRing) {
    Workbench bench = space();
    const Pixel from = placeOn(bench, {GizmoKind::turn, 2});
    const double before = angleOnRing(bench.tool, bench.sight(), 2, from);
    const double radius = 94 * bench.unitsPerPixel();
    const Vec3 there =
        bench.tool.at + radius * Vec3(std::cos(before + 1), std::sin(before + 1), 0);
    const Pixel to = bench.sight().toPixels(there);
    bench.drag(from, to);
    EXPECT_NEAR(bench.pose().angle, 1, 0.01);
    EXPECT_EQ(bench.pose().axis, Vec3(0, 0, 1));
}

TEST(Gizmo, TwoRingsMakeOneTurn) {
    Workbench bench = space();
    const auto turn = [&](int axis) {
        bench.view.select("objects[0].poses[22]");
        const Pixel from = placeOn(bench, {GizmoKind::turn, axis});
        bench.drag(from, {from.x + 12, from.y + 9}, commandKey);
    };
    turn(2);
    const Mat3 first = rotation(bench.pose().axis, bench.pose().angle);
    turn(0);
    const Mat3 both = rotation(bench.pose().axis, bench.pose().angle);
    const Mat3 second = both * glm::transpose(first);
    EXPECT_NEAR(second[0][0], 1, 1e-12);  // about x
    EXPECT_GT(std::abs(second[1][2]), 0.2);
}

TEST(Gizmo, ABoxScalesAlongAnAxisOfTheLocalAndWithShiftAlongAll) {
    Workbench bench = plane();
    const Pixel from = placeOn(bench, {GizmoKind::scale, 0});
    const Pixel twice{bench.at.x + 2 * (from.x - bench.at.x), from.y};
    bench.drag(from, twice);
    EXPECT_EQ(bench.pose().scale, Vec3(2, 1, 1));
    ASSERT_TRUE(bench.scene->undo());
    bench.drag(from, twice, shiftKey);
    EXPECT_EQ(bench.pose().scale, Vec3(2, 2, 2));
}

TEST(Gizmo, CtrlSnapsTurnsToFifteenDegrees) {
    Workbench bench = plane();
    const Pixel from{bench.at.x + 32, bench.at.y};
    bench.drag(from, {bench.at.x + 60 * std::cos(0.55), bench.at.y - 60 * std::sin(0.55)}, commandKey);
    EXPECT_NEAR(bench.pose().angle, pi / 6, 1e-12);
}

TEST(Gizmo, EscapePutsBackWhatAPartDid) {
    Workbench bench = space();
    const Json before = bench.scene->document();
    const Pixel from = placeOn(bench, {GizmoKind::scale, 2});
    bench.event("down", from, 1);
    bench.event("move", {from.x + 30, from.y - 40}, 1);
    EXPECT_NE(bench.scene->document(), before);
    EXPECT_TRUE(bench.view.key("Escape", true, 0));
    EXPECT_EQ(bench.scene->document(), before);
}

TEST(Gizmo, LeavesTheMiddleOfOtherHandlesAlone) {
    Workbench bench = plane();
    const Pixel tip = placeOn(bench, {GizmoKind::move, 0});
    bench.event("move", tip, 0);
    EXPECT_EQ(bench.view.cursor(), "grab");
    bench.view.setReadOnly(true);
    bench.event("move", {tip.x + 1, tip.y}, 0);
    EXPECT_EQ(bench.view.cursor(), "default");
}

TEST(Gizmo, StandsInThePictureWhereItIsFound) {
    Workbench bench = space();
    const PaneFigure& pane = *bench.view.figure()->find(Pane::curve);
    EXPECT_EQ(pane.tools.size(), 3u + 2 * 3u + 3u);
    for (const Shape& shape : pane.tools) {
        const Pixel p = pane.sight.toPixels(positionOf(shape, shape.positions.size() / 6));
        EXPECT_TRUE(partAt(bench.tool, pane.sight, p, 10));
    }
}

}  // namespace
}  // namespace knotwork::app
