#include "geometry/surface.hpp"
#include "geometry/surface_differential.hpp"
#include "support/blending_gates.hpp"
#include "support/blending_surfaces.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace knotwork {
namespace {

namespace gates = test::gates;
using test::expectNear;
using test::matrixAt;

constexpr double pi = std::numbers::pi;
constexpr SurfaceOrders second{2, 2};

const BFunction cubic = BFunction::makePolynomial(1, 1).value();

BlendDirection along(std::size_t count, BlendForm form = BlendForm::open,
                     std::vector<double> knots = {}) {
    return {count, form, cubic, std::move(knots)};
}

Error refusal(const Surface& model, BlendDirection u, BlendDirection v, const PatchCut& cut = {},
              std::span<const Pose> poses = {}) {
    const auto made = BlendingSurface::make(model, std::move(u), std::move(v), cut, poses);
    return made ? Error{} : made.error();
}

TEST(BlendingSurface, HasUniformKnotsOverTheModelWhereNoneAreGiven) {
    const auto surface = BlendingSurface::make(test::model("cylinder", {{"height", 3}}),
                                               along(4, BlendForm::closed), along(4), {})
                             .value();
    EXPECT_EQ(surface.alongU().knots, (std::vector<double>{0, pi / 2, pi, 3 * pi / 2, 2 * pi}));
    EXPECT_EQ(surface.alongV().knots, (std::vector<double>{0, 1, 2, 3}));
    EXPECT_EQ(surface.domain(), (Rectangle{{0, 2 * pi}, {0, 3}}));
    EXPECT_EQ(surface.closed(), (ClosedDirections{true, false}));
}

TEST(BlendingSurface, ATangentPlaneIsThePlaneOfTheModelAtItsKnots) {
    const Surface torus = test::model("torus");
    const auto surface = BlendingSurface::make(torus, along(3, BlendForm::closed),
                                               along(5, BlendForm::closed), {PatchKind::plane})
                             .value();
    const double u0 = surface.alongU().knots[2];
    const double v0 = surface.alongV().knots[1];
    const auto model = matrixAt(torus, {u0, v0}, {1, 1});
    std::array<Vec3, second.size()> rows;
    surface.patch(2, 1, {u0 + 0.3, v0 - 0.2}, second, rows);
    expectNear(rows[0], model[0] + 0.3 * model[2] - 0.2 * model[1], gates::hermite, "the plane");
    EXPECT_EQ(rows[second.at(1, 0)], model[2]);
    EXPECT_EQ(rows[second.at(0, 1)], model[1]);
    for (const auto& [a, b] : {std::pair<std::size_t, std::size_t>{2, 0}, {1, 1}, {0, 2}}) {
        EXPECT_EQ(rows[second.at(a, b)], Vec3(0));
    }
}

TEST(BlendingSurface, ABezierPatchHasAllDerivativesOfTheModelUpToItsDegrees) {
    const Surface shell = test::model("seashell");
    const PatchCut cut{PatchKind::bezier, {4, 2}};
    const auto surface =
        BlendingSurface::make(shell, along(6), along(3, BlendForm::closed), cut).value();
    constexpr SurfaceOrders more{6, 4};
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const SurfacePlace at{surface.alongU().knots[i], surface.alongV().knots[j]};
            const auto model = matrixAt(shell, at, more);
            std::array<Vec3, more.size()> rows;
            surface.patch(i, j, at, more, rows);
            for (std::size_t a = 0; a <= 6; ++a) {
                for (std::size_t b = 0; b <= 4; ++b) {
                    const bool kept = a <= 4 && b <= 2;
                    EXPECT_EQ(rows[more.at(a, b)], kept ? model[more.at(a, b)] : Vec3(0));
                }
            }
        }
    }
}

TEST(BlendingSurface, BezierPatchesOfAPolynomialAreThatPolynomial) {
    const Surface net = test::someSurface({3, 2, Form::clamped, Form::clamped, 4, 3});
    const auto surface = test::blendOver(
        net, {5, 3, BlendForm::open, BlendForm::open, {PatchKind::bezier, {3, 2}}, cubic, {}, false});
    for (const double u : test::telling(domain(net).u, surface.alongU().knots)) {
        for (const double v : test::telling(domain(net).v, surface.alongV().knots)) {
            const auto got = matrixAt(surface, {u, v}, {1, 1});
            const auto expected = matrixAt(net, {u, v}, {1, 1});
            for (std::size_t k = 0; k < got.size(); ++k) {
                expectNear(got[k], expected[k], 10 * gates::reproduction, "the polynomial");
            }
        }
    }
}

TEST(BlendingSurface, APatchIsScaledAndTurnedAboutItsOwnPointAndThenMoved) {
    const Surface plane = test::model("plane", {{"width", 2}, {"height", 3}});
    std::vector<Pose> poses(6);
    poses[4] = {.translate = {0, 0, 5}, .axis = {0, 0, 2}, .angle = pi / 2, .scale = {2, 1, 1}};
    const auto surface = BlendingSurface::make(plane, along(2), along(3), {}, poses).value();
    std::array<Vec3, 1> point;
    surface.patch(1, 1, {2, 1.5}, {}, point);
    expectNear(point[0], {2, 1.5, 5}, gates::hermite, "its own point");
    surface.patch(1, 1, {1, 2}, {}, point);  // (-1, 0.5) from there, scaled to (-2, 0.5)
    expectNear(point[0], {1.5, -0.5, 5}, gates::hermite, "another one");
    EXPECT_EQ(surface.place(1, 1).origin(), Vec3(2, 1.5, 0));
}

TEST(BlendingSurface, BeyondOpenEndsThePatchesThereGoOn) {
    for (const auto& [name, cut] : test::allPatchCuts()) {
        const auto surface =
            test::blendOver(test::model("helicoid"), {4, 3, BlendForm::open, BlendForm::open, cut,
                                                      cubic, cubic, true});
        const Rectangle whole = surface.domain();
        const SurfacePlace before{whole.u.start - 0.4, whole.v.start - 0.2};
        const SurfacePlace after{whole.u.end + 0.4, whole.v.end + 0.2};
        std::array<Vec3, second.size()> rows;
        surface.patch(0, 0, before, second, rows);
        EXPECT_EQ(matrixAt(surface, before, second), std::vector<Vec3>(rows.begin(), rows.end()));
        surface.patch(3, 2, after, second, rows);
        EXPECT_EQ(matrixAt(surface, after, second), std::vector<Vec3>(rows.begin(), rows.end()));
    }
}

TEST(BlendingSurface, TwoEqualKnotsAreABreakBetweenTheirPatches) {
    std::vector<Pose> poses(8);
    poses[2].translate = poses[3].translate = {0, 0, 1};
    const auto surface =
        BlendingSurface::make(test::model("plane"), along(4, BlendForm::open, {0, 0.5, 0.5, 1}),
                              along(2), {}, poses)
            .value();
    EXPECT_EQ(pointAt(surface, {0.5, 0.5, Side::left}), Vec3(0.5, 0.5, 1));
    EXPECT_EQ(pointAt(surface, {0.5, 0.5, Side::right}), Vec3(0.5, 0.5, 0));
}

TEST(BlendingSurface, ItsBreaksAreItsKnotsAndThoseOfTheModelUnderSubSurfaces) {
    const BsplineSurface net =
        BsplineSurface::make(KnotVector::make({0, 1, 2, 3, 4, 5}, 2, 5, Form::closed).value(),
                             KnotVector::uniform(1, 3, Form::clamped).value(),
                             std::vector<Vec3>(15, Vec3(1)))
            .value();
    const BlendDirection u = along(2, BlendForm::closed, {0, 2.5, 5});
    const BlendDirection v = along(2);
    const auto sub = BlendingSurface::make(net, u, v, {}).value();
    EXPECT_EQ(std::vector<double>(sub.breaksU().begin(), sub.breaksU().end()),
              (std::vector<double>{0, 1, 2, 2.5, 3, 4, 5}));
    EXPECT_EQ(std::vector<double>(sub.breaksV().begin(), sub.breaksV().end()),
              (std::vector<double>{0, 1, 2}));
    const auto planes = BlendingSurface::make(net, u, v, {PatchKind::plane}).value();
    EXPECT_EQ(std::vector<double>(planes.breaksU().begin(), planes.breaksU().end()),
              (std::vector<double>{0, 2.5, 5}));
}

TEST(BlendingSurface, ItsNormalIsThatOfTheCrossProductAndALimitAtPoles) {
    for (const auto& [name, surface] : test::blendingSpecimens(cubic, cubic)) {
        const Rectangle whole = surface.domain();
        const SurfacePlace at{whole.u.start + 0.41 * whole.u.length(),
                              whole.v.start + 0.37 * whole.v.length()};
        const auto rows = matrixAt(surface, at, {1, 1});
        expectNear(unitNormal(surface, at), glm::normalize(glm::cross(rows[2], rows[1])),
                   gates::hermite, name);
    }
    const Surface sphere = test::model("sphere");
    for (const auto& [name, cut] : test::allPatchCuts()) {
        if (cut.kind == PatchKind::plane) continue;  // what is left of them at a pole is a line
        const auto surface = test::blendOver(
            sphere, {6, 4, BlendForm::closed, BlendForm::open, cut, cubic, cubic, false});
        for (const double u : {0.0, 1.0, 4.4}) {
            expectNear(unitNormal(surface, {u, pi / 2, Side::right, Side::left}), {0, 0, 1}, 1e-6,
                       name);
            expectNear(unitNormal(surface, {u, -pi / 2}), {0, 0, -1}, 1e-6, name);
        }
    }
}

TEST(BlendingSurface, ABlendOfABlendOfATorusIsTheTorus) {
    const Surface torus = test::model("torus");
    const Surface inner =
        BlendingSurface::make(torus, along(3, BlendForm::closed), along(4, BlendForm::closed), {})
            .value();
    const Surface outer =
        BlendingSurface::make(inner, along(5, BlendForm::closed), along(2, BlendForm::closed), {})
            .value();
    EXPECT_EQ(matrixAt(outer, {1, 6}, second), matrixAt(torus, {1, 6}, second));
}

TEST(BlendingSurface, RefusesWhatCannotBeBlendedWithThePlaceOfTheFault) {
    const Surface torus = test::model("torus");
    const auto closed = BlendForm::closed;
    EXPECT_EQ(refusal(torus, along(1), along(3)).path, "locals[0]");
    EXPECT_EQ(refusal(torus, along(3), along(1)).code, Code::outOfRange);
    EXPECT_EQ(refusal(torus, along(3), along(1)).path, "locals[1]");
    EXPECT_EQ(refusal(torus, along(20'000), along(3)).code, Code::tooLarge);
    EXPECT_EQ(refusal(torus, along(200), along(100)).path, "locals");
    EXPECT_EQ(refusal(torus, along(200), along(100)).code, Code::tooLarge);
    EXPECT_EQ(refusal(torus, along(3, closed, {0, 1, 2}), along(3)).code, Code::knotsCount);
    EXPECT_EQ(refusal(torus, along(3), along(3, closed, {0, 1, 2})).path, "knots[1]");
    EXPECT_EQ(refusal(torus, along(4, BlendForm::open, {0, 1, 3, 2}), along(3)).code,
              Code::knotsDecreasing);
    EXPECT_EQ(refusal(torus, along(4, BlendForm::open, {0, 1, 3, 2}), along(3)).path,
              "knots[0][3]");
    EXPECT_EQ(refusal(torus, along(3), along(4, BlendForm::open, {0, 1, 1, 1})).code,
              Code::knotsMultiplicity);
    EXPECT_EQ(refusal(torus, along(3), along(4, BlendForm::open, {0, 1, 1, 1})).path,
              "knots[1][3]");
    EXPECT_EQ(refusal(torus, along(3), along(3), {PatchKind::bezier, {0, 3}}).path, "degree[0]");
    EXPECT_EQ(refusal(torus, along(3), along(3), {PatchKind::bezier, {3, 26}}).path, "degree[1]");
    EXPECT_EQ(refusal(torus, along(90), along(90), {PatchKind::bezier, {25, 25}}).code,
              Code::tooLarge);
    std::vector<Pose> poses(9);
    poses[7].scale.y = 0;
    EXPECT_EQ(refusal(torus, along(3), along(3), {}, poses).path, "poses[7].scale");
    EXPECT_EQ(refusal(torus, along(3), along(2), {}, poses).code, Code::wrongLength);
}

TEST(BlendingSurface, RefusesNestsThatAreTooDeep) {
    Surface nested = test::model("plane");
    for (int depth = 0; depth < 8; ++depth) {
        nested = BlendingSurface::make(nested, along(2), along(2), {}).value();
    }
    const Error error = refusal(nested, along(2), along(2));
    EXPECT_EQ(error.code, Code::tooLarge);
    EXPECT_EQ(error.path, "model");
    // A Bézier patch does not ask its model again.
    EXPECT_TRUE(BlendingSurface::make(nested, along(2), along(2), {PatchKind::bezier, {3, 3}}).ok());
}

TEST(BlendingSurface, RefusesNestsOfWhichOnePointTakesTooManyOfTheModel) {
    Surface nested = test::model("plane");
    Error error;
    for (int depth = 0; depth < 12 && error.path.empty(); ++depth) {
        auto made = BlendingSurface::make(nested, along(2, BlendForm::closed, {0, 0.5, 1 + depth * 0.1}),
                                          along(2, BlendForm::closed, {0, 0.5, 1 + depth * 0.1}), {});
        if (made) {
            nested = *made;
        } else {
            error = made.error();
        }
    }
    EXPECT_EQ(error.code, Code::tooLarge);
    EXPECT_EQ(error.path, "model");
}

TEST(BlendingSurface, RefusesAModelWithoutTheDerivativesThatItsPatchesNeed) {
    // The exponential of a large growth overflows.
    const Surface shell = test::model("seashell", {{"growth", 1.5}, {"turns", 3}});
    std::vector<double> far{0, 1e6};
    const Error error = refusal(shell, along(2, BlendForm::open, far), along(2),
                                {PatchKind::bezier, {3, 3}});
    EXPECT_EQ(error.code, Code::notFinite);
    EXPECT_EQ(error.path, "model");
}

}  // namespace
}  // namespace knotwork
