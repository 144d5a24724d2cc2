#include "geometry/differential.hpp"

#include "support/measure_gates.hpp"
#include "support/zoo.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace knotwork::test {
namespace {

constexpr double pi = std::numbers::pi;

Frame frame(const Curve& curve, double t, Side side = Side::right) {
    return frameAt(curve, t, side);
}

void expectNear(const Vec3& actual, const Vec3& expected, double tolerance,
                const std::string& name = {}) {
    EXPECT_LE(glm::length(actual - expected), tolerance)
        << name << " (" << actual.x << ", " << actual.y << ", " << actual.z << ") is not ("
        << expected.x << ", " << expected.y << ", " << expected.z << ")";
}

bool isFinite(const Frame& f) {
    return knotwork::isFinite(f.point) && knotwork::isFinite(f.tangent) &&
           knotwork::isFinite(f.normal) && knotwork::isFinite(f.binormal) &&
           std::isfinite(f.curvature) && std::isfinite(f.torsion);
}

void expectOrthonormal(const Frame& f, const std::string& name) {
    EXPECT_TRUE(isFinite(f)) << name;
    EXPECT_NEAR(glm::length(f.tangent), 1, gates::orthonormal) << name;
    EXPECT_NEAR(glm::length(f.normal), 1, gates::orthonormal) << name;
    EXPECT_NEAR(glm::dot(f.tangent, f.normal), 0, gates::orthonormal) << name;
    expectNear(f.binormal, glm::cross(f.tangent, f.normal), gates::orthonormal, name);
}

/// Parameters of every piece: its ends from inside, and some between.
std::vector<std::pair<double, Side>> places(const Curve& curve) {
    const Interval whole = domain(curve);
    std::vector<std::pair<double, Side>> all{{whole.start, Side::right}, {whole.end, Side::left}};
    for (const double t : breakParameters(curve, whole)) {
        all.emplace_back(t, Side::left);
        all.emplace_back(t, Side::right);
    }
    for (int i = 1; i < 24; ++i) {
        all.emplace_back(whole.start + whole.length() * i / 24, Side::right);
    }
    return all;
}

TEST(Frame, IsOrthonormalAndFiniteOnEveryCurve) {
    for (const Animal& animal : wholeZoo()) {
        for (const auto& [t, side] : places(animal.curve)) {
            const Frame f = frame(animal.curve, t, side);
            expectOrthonormal(f, animal.name + " at " + std::to_string(t));
            if (dimension(animal.curve) == 2) {
                EXPECT_EQ(f.binormal, Vec3(0, 0, 1)) << animal.name;
                EXPECT_EQ(f.torsion, 0) << animal.name;
            } else {
                EXPECT_GE(f.curvature, 0) << animal.name;
            }
        }
    }
}

TEST(Frame, OfAHelixHasItsCurvatureAndTorsion) {
    const double r = 2;
    const double c = 3 / (2 * pi);
    const Curve helix(make("helix", {{"radius", r}, {"pitch", 3.0}}));
    for (const double t : {0.0, 0.3, 2.0, 9.0}) {
        const Frame f = frame(helix, t);
        EXPECT_NEAR(f.curvature, r / (r * r + c * c), 1e-14);
        EXPECT_NEAR(f.torsion, c / (r * r + c * c), 1e-14);
        expectNear(f.normal, {-std::cos(t), -std::sin(t), 0}, 1e-14);
        expectNear(f.tangent, Vec3(-r * std::sin(t), r * std::cos(t), c) / std::hypot(r, c), 1e-14);
    }
}

TEST(Frame, CurvatureInThePlaneIsPositiveInALeftTurn) {
    const Curve left(make("circle", {{"radius", 2.0}}));
    const Curve right = spline(2, Form::clamped, {}, {{0, 0, 0}, {1, 1, 0}, {2, 0, 0}});
    EXPECT_NEAR(frame(left, 1).curvature, 0.5, 1e-14);
    EXPECT_LT(frame(right, 0.5).curvature, 0);
    for (const double t : {0.2, 3.0, 6.0}) {
        const Frame f = frame(left, t);
        expectNear(f.normal, {-std::cos(t), -std::sin(t), 0}, 1e-14);
        expectNear(centreOfCurvature(f).value(), {0, 0, 0}, 1e-14);
        expectNear(combPoint(f, 3), Vec3(std::cos(t), std::sin(t), 0) * 3.5, 1e-14);
    }
    // The centre of a right turn lies on the right.
    const Frame f = frame(right, 0.5);
    EXPECT_LT(centreOfCurvature(f)->y, f.point.y);
    EXPECT_GT(combPoint(f, 1).y, f.point.y);
}

TEST(Frame, OfVivianisCurveIsTheFormula) {
    // κ = √(13 + 3 cos t) / (a (3 + cos t)^{3/2}), τ = 6 cos(t/2) / (a (13 + 3 cos t)).
    const Curve curve(make("viviani", {{"a", 2.0}}));
    for (const double t : {0.1, 1.0, 3.0, 5.0, 7.5, 12.0}) {
        const Frame f = frame(curve, t);
        const double c = std::cos(t);
        EXPECT_NEAR(f.curvature, std::sqrt(13 + 3 * c) / (2 * std::pow(3 + c, 1.5)), 1e-13);
        EXPECT_NEAR(f.torsion, 6 * std::cos(t / 2) / (2 * (13 + 3 * c)), 1e-13);
    }
}

/// d/ds of a part of the frame, by symmetric differences that are extrapolated once.
template <class Part>
auto slope(const Curve& curve, double t, double h, Part part) {
    const auto difference = [&](double step) {
        std::array<Vec3, 2> rows;
        evaluate(curve, t, Side::right, rows);
        return (part(frame(curve, t + step)) - part(frame(curve, t - step))) *
               (1 / (2 * step * glm::length(rows[1])));
    };
    return (difference(h / 2) * 4.0 - difference(h)) * (1 / 3.0);
}

TEST(Frame, SatisfiesTheEquationsOfFrenetAndSerret) {
    for (const char* name : {"trefoil", "torus-knot", "viviani", "ellipse", "butterfly", "heart"}) {
        const Curve curve(make(name));
        const Interval whole = domain(curve);
        for (const double share : {0.113, 0.377, 0.791}) {
            const double t = whole.start + share * whole.length();
            const Frame f = frame(curve, t);
            const double size = 1 + std::abs(f.curvature) + std::abs(f.torsion);
            const auto expectSlope = [&](auto part, const Vec3& expected) {
                expectNear(slope(curve, t, 1e-3 / size, part), expected, 1e-7 * size * size, name);
            };
            expectSlope([](const Frame& at) { return at.tangent; }, f.curvature * f.normal);
            expectSlope([](const Frame& at) { return at.normal; },
                        -f.curvature * f.tangent + f.torsion * f.binormal);
            expectSlope([](const Frame& at) { return at.binormal; }, -f.torsion * f.normal);
        }
    }
}

TEST(Frame, NormalOfAPlaneCubicDoesNotFlipAtItsInflexion) {
    const Curve flat = spline(3, Form::clamped, {}, sShape());
    const Frame at = frame(flat, 0.5);
    EXPECT_EQ(at.curvature, 0);
    expectNear(at.normal, {-at.tangent.y, at.tangent.x, 0}, 1e-15);
    expectNear(frame(flat, 0.5 - 1e-6).normal, frame(flat, 0.5 + 1e-6).normal, 1e-4);
    EXPECT_LT(frame(flat, 0.4).curvature, 0);
    EXPECT_GT(frame(flat, 0.6).curvature, 0);
    EXPECT_NEAR(frame(flat, 0.4).curvature, -frame(flat, 0.6).curvature, 1e-13);
}

TEST(Frame, NormalAtAnInflexionInSpaceIsTheLimitFromItsSide) {
    const Curve curve = spline(3, Form::clamped, {}, sShape(), {}, 3);
    expectNear(frame(curve, 0.5, Side::right).normal, frame(curve, 0.5 + 1e-7).normal, 1e-5);
    expectNear(frame(curve, 0.5, Side::left).normal, frame(curve, 0.5 - 1e-7).normal, 1e-5);
    EXPECT_EQ(frame(curve, 0.5).curvature, 0);
    EXPECT_EQ(frame(curve, 0.5).torsion, 0);
}

TEST(Frame, NormalOnAStraightPartIsTheOneWithWhichTheCurveEnters) {
    const Curve curve = spline(2, Form::clamped, {0, 0, 0, 1, 2, 3, 4, 4, 4},
                               {{0, 0, 1}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {4, 1, 2}});
    const Frame entering = frame(curve, 1, Side::left);
    expectNear(entering.normal, {0, 0, 1}, 1e-14);
    for (const auto& [t, side] : std::vector<std::pair<double, Side>>{
             {1, Side::right}, {1.5, Side::right}, {2, Side::left}, {2, Side::right},
             {2.99, Side::right}, {3, Side::left}}) {
        const Frame f = frame(curve, t, side);
        EXPECT_EQ(f.curvature, 0);
        expectNear(f.normal, entering.normal, 1e-14, std::to_string(t));
    }
    EXPECT_GT(frame(curve, 3, Side::right).curvature, 0);
    // A part that nothing bent precedes takes the normal with which the curve leaves it.
    const Curve first = spline(2, Form::clamped, {0, 0, 0, 1, 2, 2, 2},
                               {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 1, 2}});
    expectNear(frame(first, 0.2).normal, frame(first, 1, Side::right).normal, 1e-14);
    EXPECT_EQ(frame(first, 0.2).curvature, 0);
    EXPECT_GT(frame(first, 1, Side::right).curvature, 0);
}

TEST(Frame, OfAPolygonInSpaceIsCarriedRoundItsCorners) {
    const Curve polygon = spline(1, Form::clamped, {}, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}});
    expectNear(frame(polygon, 0.5).normal, {0, 1, 0}, 1e-15);
    expectNear(frame(polygon, 1, Side::left).normal, {0, 1, 0}, 1e-15);
    expectNear(frame(polygon, 1, Side::right).normal, {-1, 0, 0}, 1e-15);
    expectNear(frame(polygon, 1.7).normal, {-1, 0, 0}, 1e-15);
    expectNear(frame(polygon, 2.5).normal, {-1, 0, 0}, 1e-15);
    expectNear(frame(polygon, 3).tangent, {0, 0, 1}, 1e-15);
    const Curve straight = spline(3, Form::clamped, {}, {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {5, 5, 5}});
    expectNear(frame(straight, 0.1).normal, frame(straight, 0.9).normal, 1e-15);
}

TEST(Frame, OnAStraightStartIsCarriedBackFromWhereTheCurveFirstBends) {
    // Along y, x and z, then a parabola that leaves z towards x. From z to y by way of x the normal
    // turns as it would not on the shortest way.
    const Curve curve = spline(2, Form::clamped, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4},
                               {{0, -2, 0}, {0, -1, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0},
                                {2, 0, 1}, {2, 0, 2}, {2, 0, 3}, {3, 0, 3}});
    expectNear(frame(curve, 3, Side::right).normal, {1, 0, 0}, 1e-15);
    expectNear(frame(curve, 2.3).normal, {1, 0, 0}, 1e-15);
    expectNear(frame(curve, 2, Side::left).normal, {0, 0, -1}, 1e-15);
    expectNear(frame(curve, 0.5).normal, {0, 0, -1}, 1e-15);
    expectNear(frame(curve, 0).tangent, {0, 1, 0}, 1e-15);
}

TEST(Frame, WhereAWholeSpanStandsStillTheTangentIsThatOfTheNearestOther) {
    const Curve curve = spline(2, Form::clamped, {},
                               {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 2, 0}, {2, 2, 0}});
    expectNear(frame(curve, 0.5).tangent, {0, 1, 0}, 1e-15);
    expectNear(frame(curve, 0).tangent, {0, 1, 0}, 1e-15);
}

TEST(Frame, AtACuspLooksInTheDirectionOfItsSide) {
    const Curve astroid(make("astroid"));
    expectNear(frame(astroid, 0).tangent, {-1, 0, 0}, 1e-14);
    expectNear(frame(astroid, pi / 2, Side::right).tangent, {0, -1, 0}, 1e-14);
    expectNear(frame(astroid, pi / 2, Side::left).tangent, {0, 1, 0}, 1e-14);
    EXPECT_EQ(frame(astroid, pi / 2).curvature, 0);
    const Curve cusp = spline(3, Form::clamped, {}, {{0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}});
    expectNear(frame(cusp, 0.5, Side::left).tangent, {0, 1, 0}, 1e-14);
    expectNear(frame(cusp, 0.5, Side::right).tangent, {0, -1, 0}, 1e-14);
}

TEST(Frame, WherePointsCoincideTheTangentIsTheLimit) {
    const Curve curve = spline(3, Form::clamped, {},
                               {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 2, 0}, {3, 0, 0}});
    expectNear(frame(curve, 0).tangent, frame(curve, 1e-6).tangent, 1e-5);
    const Curve end = spline(3, Form::clamped, {}, {{0, 0, 0}, {1, 2, 0}, {3, 1, 0}, {3, 1, 0}});
    expectNear(frame(end, 1).tangent, glm::normalize(Vec3(2, -1, 0)), 1e-14);
}

TEST(Frame, TheCurvatureOfACurveThatIsRunThroughSlowlyIsItsLimit) {
    // A parabola run through by u = t³: its blossom is that of x = t³, y = t⁶, degree 6.
    const Curve slow = spline(6, Form::clamped, {},
                              {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0.05, 0, 0}, {0.2, 0, 0},
                               {0.5, 0, 0}, {1, 1, 0}});
    EXPECT_NEAR(frame(slow, 0).curvature, 2, 1e-12);
    expectNear(frame(slow, 0).tangent, {1, 0, 0}, 1e-15);
}

TEST(Frame, OfASinglePointIsTheAxes) {
    for (const int dimension : {2, 3}) {
        const Curve still = spline(3, Form::clamped, {}, std::vector<Vec3>(5, Vec3(2, -1, 0)), {},
                                   dimension);
        const Frame f = frame(still, 0.3);
        expectNear(f.point, {2, -1, 0}, 1e-15);
        EXPECT_EQ(f.tangent, Vec3(1, 0, 0));
        expectNear(f.normal, {0, 1, 0}, 1e-15);
        EXPECT_EQ(f.curvature, 0);
        EXPECT_FALSE(centreOfCurvature(f));
    }
}

TEST(Frame, ScalesWithTheCurveHoweverSmallOrLargeItIs) {
    for (const double scale : {1e-9, 1e-3, 1e3, 1e9}) {
        std::vector<Vec3> points{{0, 0, 0}, {1, 2, 0}, {2, -2, 1}, {3, 0, 0}};
        const Curve unit = spline(3, Form::clamped, {}, points);
        for (Vec3& p : points) p *= scale;
        const Curve scaled = spline(3, Form::clamped, {}, points);
        for (const double t : {0.0, 0.3, 0.5, 1.0}) {
            const Frame a = frame(unit, t);
            const Frame b = frame(scaled, t);
            expectNear(b.tangent, a.tangent, 1e-14);
            expectNear(b.normal, a.normal, 1e-13);
            EXPECT_NEAR(b.curvature * scale / a.curvature, 1, 1e-12);
            EXPECT_NEAR(b.torsion * scale / a.torsion, 1, 1e-11);
        }
    }
}

TEST(Frame, OfABlendAtItsKnotsIsThatOfTheLocal) {
    for (const Animal& animal : blends()) {
        if (animal.name != "expo-rational blend of a circle") continue;
        const auto& blend = *animal.curve.as<BlendingCurve>();
        for (std::size_t j = 0; j < blend.locals().size(); ++j) {
            const Frame f = frame(animal.curve, blend.knots()[j]);
            EXPECT_NEAR(f.curvature, 1, 1e-12) << j;
        }
    }
}

}  // namespace
}  // namespace knotwork::test
