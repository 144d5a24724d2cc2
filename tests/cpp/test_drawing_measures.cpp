#include "drawing/drawing.hpp"

#include "geometry/differential.hpp"
#include "scene/trace.hpp"
#include "support/drawings.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace knotwork::drawing {
namespace {

using namespace test;

const std::string points = R"("points": [[0,0],[1,3],[4,2],[5,-1],[7,1],[8,4]])";

std::string spline(const std::string& more) {
    return R"({"type": "bspline-curve", "degree": 3, )" + points + ", " + more + "}";
}

const Curve& curveOf(const scene::Scene& scene) { return *scene.state().objects[0]->body.curve(); }

std::vector<const Shape*> withIndex(const Drawing& drawing, Role role, int index) {
    auto found = withRole(drawing, role);
    std::erase_if(found, [index](const Shape* shape) { return shape->index != index; });
    return found;
}

TEST(Measures, TeethOfTheCombEndAtThePointLessScaledCurvatureTimesNormal) {
    const scene::Scene scene = sceneOf({spline(R"("show": {"comb": true})")});
    Options options;
    options.combScale = 0.7;
    const Drawing drawing = draw(scene.state(), options);
    const Shape& teeth = *withIndex(drawing, Role::comb, 0).at(0);
    const Shape& line = *withIndex(drawing, Role::comb, 1).at(0);
    const Interval whole = domain(curveOf(scene));
    const std::size_t count = teeth.positions.size() / 6;
    ASSERT_EQ(line.positions.size() / 3, count);
    const std::size_t each = count / 3;  // of the three spans, both ends of each included
    double turned = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Interval span{std::floor(static_cast<double>(i / each)), 1.0 + static_cast<double>(i / each)};
        const double t = uniformParameter(span, i % each, each);
        const Frame frame = frameAt(curveOf(scene), t, i % each + 1 == each ? Side::left : Side::right);
        const Vec3 tip = frame.point - 0.7 * frame.curvature * frame.normal;
        EXPECT_LT(glm::length(positionIn(teeth, 2 * i) - frame.point), 1e-12);
        EXPECT_LT(glm::length(positionIn(teeth, 2 * i + 1) - tip), 1e-12);
        EXPECT_EQ(positionIn(line, i), positionIn(teeth, 2 * i + 1));
        turned = std::max(turned, std::abs(frame.curvature));
    }
    EXPECT_EQ(whole.length(), 3);
    EXPECT_GT(turned, 0.5);
}

TEST(Measures, ACombWithoutAScaleIsAsLargeAsItsCurveAllows) {
    for (const double size : {1e-3, 1.0, 1e4}) {
        const Drawing drawing = drawn({R"({"type": "parametric-curve", "name": "circle", "parameters": {"radius": )" +
                                       std::to_string(size) + R"(}, "show": {"comb": true}})"}, size / 100);
        const Shape& teeth = *withIndex(drawing, Role::comb, 0).at(0);
        const double length = glm::length(positionIn(teeth, 1) - positionIn(teeth, 0));
        EXPECT_NEAR(length / size, 2 * std::sqrt(2.0) / 8, 1e-3);
        EXPECT_GT(glm::length(positionIn(teeth, 1)), size);  // on the outer side
    }
}

TEST(Measures, TheOsculatingCircleHasContactOfOrderTwo) {
    const scene::Scene scene = sceneOf({spline(R"("t": 0.8, "show": {"osculating": true})")});
    const Drawing drawing = draw(scene.state(), {.moment = {}, .tolerance = 1e-4});
    const auto shapes = withIndex(drawing, Role::frame, 3);
    ASSERT_EQ(shapes.size(), 3U);  // circle, radius, centre
    const Vec3 centre = positionIn(*shapes[2], 0);
    const Curve& curve = curveOf(scene);
    const double radius = glm::length(pointAt(curve, 0.8) - centre);
    for (std::size_t i = 0; i < shapes[0]->positions.size() / 3; ++i) {
        EXPECT_NEAR(glm::length(positionIn(*shapes[0], i) - centre), radius, 1e-12);
    }
    // The distance from the circle vanishes with the third power: halving h divides it by 8.
    const auto away = [&](double h) { return std::abs(glm::length(pointAt(curve, 0.8 + h) - centre) - radius); };
    EXPECT_NEAR(away(2e-2) / away(1e-2), 8, 0.5);
    EXPECT_LT(away(1e-3), 1e-7);
}

TEST(Measures, AStraightLineHasItsTangentForACircle) {
    const Drawing drawing = drawn({R"({"type": "line-curve", "from": [0,0], "to": [3,4], "show": {"osculating": true, "comb": true, "frames": true}})"});
    const Shape& tangent = *withIndex(drawing, Role::frame, 3).at(0);
    ASSERT_EQ(tangent.positions.size(), 6U);
    const Vec3 along = positionIn(tangent, 1) - positionIn(tangent, 0);
    EXPECT_NEAR(along.x * 4 - along.y * 3, 0, 1e-12);
    for (const Shape* shape : withRole(drawing, Role::frame)) {
        for (const double x : shape->positions) EXPECT_TRUE(std::isfinite(x));
    }
}

TEST(Measures, FramesAreOrthonormalInPlaneAndSpace) {
    const Drawing drawing = drawn({R"({"type": "parametric-curve", "name": "trefoil", "show": {"frames": true}})"});
    ASSERT_EQ(withRole(drawing, Role::frame).size(), 3U);
    std::array<const Shape*, 3> axes{};
    for (int k = 0; k < 3; ++k) axes[static_cast<std::size_t>(k)] = withIndex(drawing, Role::frame, k).at(0);
    const auto arrow = [&](std::size_t k, std::size_t i) {
        return positionIn(*axes[k], 2 * i + 1) - positionIn(*axes[k], 2 * i);
    };
    const double length = glm::length(arrow(0, 0));
    for (std::size_t i = 0; i < axes[0]->positions.size() / 6; ++i) {
        EXPECT_NEAR(glm::dot(arrow(0, i), arrow(1, i)), 0, 1e-12);
        EXPECT_LT(glm::length(glm::cross(arrow(0, i), arrow(1, i)) / length - arrow(2, i)), 1e-12);
        EXPECT_EQ(positionIn(*axes[0], 2 * i), positionIn(*axes[2], 2 * i));
    }
    EXPECT_EQ(withRole(drawn({spline(R"("show": {"frames": true})")}), Role::frame).size(), 2U);
}

TEST(Measures, TheHodographIsTheDerivativeInAPaneOfItsOwn) {
    const scene::Scene scene = sceneOf({spline(R"("t": 2, "show": {"hodograph": true})")});
    const Drawing drawing = draw(scene.state(), {.moment = {}, .tolerance = 1e-3});
    const auto shapes = withRole(drawing, Role::hodograph, Pane::hodograph);
    ASSERT_EQ(shapes.size(), 2U);
    const Curve& curve = curveOf(scene);
    const auto derivativeAt = [&](double t, Side side) {
        std::array<Vec3, 2> rows{};
        evaluate(curve, t, side, rows);
        return rows[1];
    };
    EXPECT_EQ(positionIn(*shapes[0], 0), derivativeAt(0, Side::right));
    EXPECT_EQ(positionIn(*shapes[0], shapes[0]->positions.size() / 3 - 1), derivativeAt(3, Side::left));
    EXPECT_EQ(positionIn(*shapes[1], 0), Vec3(0));
    EXPECT_EQ(positionIn(*shapes[1], 1), derivativeAt(2, Side::right));
    // Every derivative is close to the polyline.
    const double largest = 10;
    for (double t = 0; t <= 3; t += 0.01) {
        const Vec3 d = derivativeAt(t, Side::right);
        double away = 1e9;
        for (std::size_t i = 0; i + 1 < shapes[0]->positions.size() / 3; ++i) {
            const Vec3 a = positionIn(*shapes[0], i);
            const Vec3 ab = positionIn(*shapes[0], i + 1) - a;
            const double s = std::clamp(glm::dot(d - a, ab) / std::max(glm::dot(ab, ab), 1e-300), 0.0, 1.0);
            away = std::min(away, glm::length(d - a - s * ab));
        }
        EXPECT_LT(away, 1e-3 * largest);
    }
    Options without;
    without.panes.hodograph = false;
    EXPECT_TRUE(withRole(draw(scene.state(), without), Role::hodograph, Pane::hodograph).empty());
}

TEST(Measures, TheHullOfControlPointsIsConvexAndHoldsTheCurve) {
    const Drawing drawing = drawn({spline(R"("show": {"hull": true})")});
    const Shape& hull = *withRole(drawing, Role::hull).at(0);
    const Shape& curve = *withRole(drawing, Role::curve).at(0);
    const std::size_t count = hull.positions.size() / 3;
    EXPECT_EQ(positionIn(hull, 0), positionIn(hull, count - 1));
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const Vec3 a = positionIn(hull, i);
        const Vec3 along = positionIn(hull, i + 1) - a;
        for (std::size_t k = 0; k < curve.positions.size() / 3; ++k) {
            EXPECT_GE(glm::cross(along, positionIn(curve, k) - a).z, -1e-12);
        }
    }
    const Drawing space = drawn({R"({"type": "bspline-curve", "degree": 3, "points":
        [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], "show": {"hull": true}})"});
    EXPECT_EQ(withRole(space, Role::hull).at(0)->indices.size(), 12U);
}

TEST(Measures, TheSphereHoldsEverythingAndIsACircleInThePlane) {
    const Drawing plane = drawn({R"({"type": "parametric-curve", "name": "ellipse", "parameters": {"a": 3, "b": 1}, "show": {"sphere": true}})"});
    const auto circle = withRole(plane, Role::sphere);
    ASSERT_EQ(circle.size(), 2U);
    EXPECT_NEAR(glm::length(positionIn(*circle[0], 5)), 3, 1e-9);
    const Drawing space = drawn({R"({"type": "parametric-curve", "name": "trefoil", "show": {"sphere": true}})"});
    ASSERT_EQ(withRole(space, Role::sphere).size(), 4U);
    const Shape& centre = *withRole(space, Role::sphere)[3];
    const double radius = glm::length(positionIn(*withRole(space, Role::sphere)[0], 0) - positionIn(centre, 0));
    const Shape& curve = *withRole(space, Role::curve).at(0);
    for (std::size_t i = 0; i < curve.positions.size() / 3; ++i) {
        EXPECT_LE(glm::length(positionIn(curve, i) - positionIn(centre, 0)), radius * (1 + 1e-9));
    }
}

struct Text {
    double x, y, width;
};

TEST(Labels, NamePointsAndKnotsWithoutCoveringEachOther) {
    const Drawing drawing = drawn({spline(R"("t": 0.5, "show": {"labels": true})")});
    std::vector<std::string> texts;
    std::vector<Text> boxes;
    const double pixel = glm::length(drawing.bounds.max - drawing.bounds.min) / 740;
    for (const Shape* label : withRole(drawing, Role::label)) {
        EXPECT_EQ(label->kind, Kind::label);
        texts.push_back(label->text);
        const Vec3 at = positionIn(*label, 0);
        boxes.push_back({at.x / pixel + static_cast<double>(label->offset[0]),
                         -at.y / pixel + static_cast<double>(label->offset[1]), 7.0 * static_cast<double>(label->text.size())});
    }
    EXPECT_EQ(texts, (std::vector<std::string>{"P0", "P1", "P2", "P3", "P4", "P5", "t0–3", "t4", "t5",
                                               "t6–9", "t = 0.5"}));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const bool apart = std::abs(boxes[i].x - boxes[j].x) >= (boxes[i].width + boxes[j].width) / 2 - 8 ||
                               std::abs(boxes[i].y - boxes[j].y) >= 14;
            EXPECT_TRUE(apart) << texts[i] << ' ' << texts[j];
        }
    }
}

TEST(Traces, AFrameIsDrawnWithItsPointsEdgesAndTitle) {
    for (const int frame : {0, 2, 99}) {
        const scene::Scene scene = sceneOf({spline(
            R"("t": 1.5, "trace": {"algorithm": "de-boor", "frame": )" + std::to_string(frame) + "}")});
        const auto& object = *scene.state().objects[0];
        ASSERT_NE(object.trace, nullptr);
        const auto& shown = object.trace->frames.at(object.traceFrame);
        EXPECT_EQ(object.traceFrame, static_cast<std::size_t>(std::min(frame, 3)));
        const Drawing drawing = draw(scene.state(), {});
        const auto shapes = withRole(drawing, Role::trace);
        ASSERT_EQ(shapes.size(), shown.marked.empty() ? 3U : 4U);
        EXPECT_EQ(shapes[0]->indices.size(), 2 * shown.edges.size());
        EXPECT_EQ(shapes[1]->positions.size(), 3 * shown.points.size());
        EXPECT_EQ(shapes.back()->kind, Kind::label);
        EXPECT_EQ(shapes.back()->text, shown.title);
        if (frame != 99) continue;
        const Vec3 end = positionIn(*shapes[2], 0);
        EXPECT_LT(glm::length(end - pointAt(*object.body.curve(), 1.5)), 1e-12);
    }
}

TEST(Traces, EveryTypeHasItsAlgorithmsAndRefusesTheOthersByPath) {
    const std::string closed = R"({"type": "subdivision-curve", "scheme": ")";
    const std::string rest = R"(", "points": [[0,0],[1,0],[1,1],[0,1]], "closed": true, "levels": 2, "trace": {"algorithm": ")";
    const std::string blend = R"({"type": "blending-curve", "model": {"type": "parametric-curve", "name": "rose"}, "locals": {"count": 5, "kind": "arc"}, "bFunction": {"family": "linear"}, "trace": {"algorithm": "blend", "frame": 1}})";
    const std::string sheet = R"({"type": "blending-surface", "model": {"type": "parametric-surface", "name": "torus"}, "locals": [4, 4], "kind": "plane", "bFunction": {"family": "linear"}, "trace": {"algorithm": "blend", "u": 1}})";
    const std::string mesh = R"({"type": "subdivision-surface", "mesh": {"solid": "cube"}, "levels": 1, "trace": {"algorithm": "catmull-clark", "frame": 2}})";
    std::vector<std::string> objects{closed + "chaikin" + rest + "lane-riesenfeld\"}}",
                                     closed + "four-point" + rest + "four-point\"}}", blend, sheet, mesh};
    for (const char* algorithm : {"de-boor", "cox-de-boor", "factor-matrices", "boehm", "oslo"}) {
        objects.push_back(spline(R"("t": 1.25, "trace": {"frame": 1, "algorithm": ")" + std::string(algorithm) + "\"}"));
    }
    const Drawing drawing = drawn(objects, 0.05);
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const auto shapes = withRole(drawing, Role::trace);
        EXPECT_TRUE(std::any_of(shapes.begin(), shapes.end(), [&](const Shape* shape) {
            return shape->object == static_cast<int>(i);
        })) << objects[i];
    }
    const auto refusal = [](const std::string& object) {
        const std::string text = R"({"knotwork": 1, "objects": [)" + object + "]}";
        const auto opened = scene::Scene::open(scene::parseJson(text).value());
        EXPECT_FALSE(opened.ok()) << object;
        return opened.ok() ? std::string() : std::string(codeName(opened.error().code)) + " " + opened.error().path;
    };
    EXPECT_EQ(refusal(spline(R"("t": 3.5)")), "OUT_OF_RANGE objects[0].t");
    EXPECT_EQ(refusal(spline(R"("trace": {"algorithm": "de-boor", "t": -1})")), "OUT_OF_RANGE objects[0].trace.t");
    EXPECT_EQ(refusal(spline(R"("trace": {"algorithm": "blend"})")), "NOT_SUPPORTED objects[0].trace.algorithm");
    EXPECT_EQ(refusal(spline(R"("trace": {"algorithm": "magic"})")), "UNKNOWN_NAME objects[0].trace.algorithm");
    EXPECT_EQ(refusal(spline(R"("trace": {})")), "WRONG_TYPE objects[0].trace.algorithm");
    EXPECT_EQ(refusal(spline(R"("trace": {"algorithm": "de-boor", "frame": -1})")), "OUT_OF_RANGE objects[0].trace.frame");
    EXPECT_EQ(refusal(spline(R"("trace": {"algorithm": "boehm", "knot": 7})")), "OUT_OF_RANGE objects[0].trace.knot");
}

TEST(Traces, AParameterFollowsADomainThatShrinks) {
    scene::Scene scene = sceneOf({spline(R"("t": 2.9, "trace": {"algorithm": "de-boor", "t": 2.8})")});
    const scene::Json knots = {0, 0, 0, 0, 1, 1.5, 2, 2, 2, 2};
    ASSERT_TRUE(scene.execute({{"set", "objects[0].knots"}, {"value", knots}}).ok());
    EXPECT_EQ(scene.state().objects[0]->parameter, 2);
    EXPECT_EQ(scene.document()["objects"][0]["trace"]["t"], 2);
    ASSERT_TRUE(scene.undo());
    EXPECT_EQ(scene.state().objects[0]->parameter, 2.9);
}

TEST(Drawing, EveryShapeOfEveryObjectIsFiniteAtEveryTolerance) {
    const std::string all = R"("show": {"comb": true, "hodograph": true, "osculating": true, "hull": true, "frames": true, "sphere": true, "labels": true, "wireframe": true, "locals": true})";
    const std::vector<std::string> objects{
        spline(all),
        R"({"type": "parametric-curve", "name": "astroid", )" + all + "}",
        R"({"type": "bezier-curve", "points": [[0,0,0],[0,0,0],[1,1,1]], )" + all + "}",
        R"({"type": "bspline-curve", "degree": 1, "points": [[1,1],[1,1]], )" + all + "}",
        R"({"type": "subdivision-curve", "scheme": "chaikin", "points": [[0,0],[1,0],[1,1]], "closed": true, "levels": 3, )" + all + "}",
        R"({"type": "blending-curve", "model": {"type": "parametric-curve", "name": "helix"}, "locals": {"count": 4, "kind": "line"}, "bFunction": {"family": "expo-rational"}, )" + all + "}",
        R"({"type": "parametric-surface", "name": "cone", )" + all + "}",
        R"({"type": "bspline-surface", "degree": [1, 2], "form": ["clamped", "clamped"], "points": [[[0,0,0],[0,0,0],[0,0,0]],[[0,0,0],[0,0,0],[0,0,0]]], )" + all + "}",
        R"({"type": "subdivision-surface", "scheme": "loop", "levels": 1, "mesh": {"solid": "icosahedron"}, )" + all + "}",
        R"({"type": "point-cloud", "points": [[0,0,1],[1,0,0],[2,2,2],[2,2,2]], )" + all + "}"};
    for (const double tolerance : {1.0, 1e-2, 1e-6}) {
        const Drawing drawing = drawn(objects, tolerance);
        Bounds bounds;
        for (const Shape& shape : drawing.shapes) {
            EXPECT_EQ(shape.positions.size() % 3, 0U);
            for (const double x : shape.positions) ASSERT_TRUE(std::isfinite(x)) << shape.object << ' ' << roleName(shape.role);
            for (const double x : shape.normals) ASSERT_TRUE(std::isfinite(x));
            for (const std::uint32_t i : shape.indices) ASSERT_LT(3 * i, shape.positions.size());
            bounds.add(shape);
        }
        EXPECT_EQ(bounds.min, drawing.bounds.min);
        EXPECT_EQ(bounds.max, drawing.bounds.max);
    }
}

}  // namespace
}  // namespace knotwork::drawing
