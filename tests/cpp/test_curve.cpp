// What holds for curves of every kind.
#include "geometry/curve.hpp"

#include "support/zoo.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace knotwork::test {
namespace {

TEST(ParameterInDomain, IsTheParameterItselfOrWrappedWhereTheCurveIsClosed) {
    for (const Animal& animal : wholeZoo()) {
        const Interval whole = domain(animal.curve);
        for (const double share : {0.0, 0.25, 0.7, 1.0}) {
            const double t = share == 1 ? whole.end : whole.start + share * whole.length();
            EXPECT_EQ(parameterInDomain(animal.curve, t).value(), t) << animal.name;
        }
        const double beyond = whole.end + 2.25 * whole.length();
        const auto wrapped = parameterInDomain(animal.curve, beyond);
        ASSERT_EQ(wrapped.ok(), isClosed(animal.curve)) << animal.name;
        if (wrapped) {
            EXPECT_NEAR(*wrapped, whole.start + whole.length() / 4, 1e-14 * beyond) << animal.name;
        } else {
            EXPECT_EQ(wrapped.error().code, Code::outOfRange);
            EXPECT_EQ(wrapped.error().path, "t");
        }
    }
}

TEST(ParameterInDomain, IsAFiniteNumber) {
    for (const double t : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        const auto found = parameterInDomain(rationalCircle(), t);
        ASSERT_FALSE(found.ok());
        EXPECT_EQ(found.error().code, Code::notFinite);
        EXPECT_EQ(found.error().path, "t");
    }
}

TEST(BreakParameters, OfALocalCurveAreTheKnotsOfItsSourceWhereItTakesPart) {
    const Curve source = spline(2, Form::clamped, {0, 0, 0, 1, 2, 4, 4, 4},
                                {{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {3, 2, 0}, {4, 0, 0}});
    const auto fitted = BlendingCurve::fromLocals({source, source}, BlendForm::open, BFunction(),
                                                  {10, 12}, true, {});
    ASSERT_TRUE(fitted.ok());
    const Curve local(fitted->locals()[1].withBreaks());
    EXPECT_EQ(breakParameters(local, domain(local)), (std::vector<double>{10.5, 11}));
    EXPECT_EQ(breakParameters(local, {10.6, 12}), (std::vector<double>{11}));
}

TEST(Dimension, OfASubdivisionCurveIsThatOfItsPoints) {
    CurveSubdivision subdivision;
    subdivision.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    EXPECT_EQ(dimension(Curve(SubdivisionCurve::make(subdivision).value())), 2);
    subdivision.points[2].z = 1e-9;
    EXPECT_EQ(dimension(Curve(SubdivisionCurve::make(subdivision).value())), 3);
}

TEST(CurveSampler, ThatIsMovedSamplesTheCurveItWasMadeOf) {
    const Curve circle(make("circle"));
    CurveSampler sampler(spline(3, Form::clamped, {}, sShape()));
    sampler = CurveSampler(circle);
    std::vector<double> xyz(3 * 5);
    sampler.uniform(0, 5, 5, xyz);
    for (std::size_t i = 0; i < 5; ++i) {
        const Vec3 expected = pointAt(circle, uniformParameter(domain(circle), i, 5));
        EXPECT_EQ(Vec3(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]), expected);
    }
}

TEST(CurveSampler, OfOnePointTakesTheBeginning) {
    for (const Curve& curve : {Curve(make("circle")), spline(3, Form::clamped, {}, sShape())}) {
        std::vector<double> xyz(3, 99);
        CurveSampler(curve).uniform(0, 1, 1, xyz);
        EXPECT_EQ(Vec3(xyz[0], xyz[1], xyz[2]), pointAt(curve, domain(curve).start));
    }
}

}  // namespace
}  // namespace knotwork::test
