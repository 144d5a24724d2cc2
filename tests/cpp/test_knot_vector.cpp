#include "geometry/knot_vector.hpp"

#include "support/gates.hpp"
#include "support/splines.hpp"

#include "geometry/bspline_basis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace knotwork {
namespace {

using test::RandomSplines;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<double> listed(std::span<const double> values) {
    return {values.begin(), values.end()};
}

TEST(KnotVector, UniformVectorsHaveUnitSpans) {
    const auto open = KnotVector::uniform(2, 4, Form::open).value();
    EXPECT_EQ(listed(open.knots()), (std::vector<double>{0, 1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(open.domain(), (Interval{2, 4}));
    const auto clamped = KnotVector::uniform(2, 4, Form::clamped).value();
    EXPECT_EQ(listed(clamped.knots()), (std::vector<double>{0, 0, 0, 1, 2, 2, 2}));
    EXPECT_EQ(clamped.domain(), (Interval{0, 2}));
    const auto closed = KnotVector::uniform(2, 4, Form::closed).value();
    EXPECT_EQ(listed(closed.knots()), (std::vector<double>{0, 1, 2, 3, 4}));
    EXPECT_EQ(closed.domain(), (Interval{0, 4}));
}

TEST(KnotVector, ClosedVectorIsExtendedByItsPeriod) {
    const auto closed = KnotVector::make({0, 1, 3, 4}, 2, 3, Form::closed).value();
    EXPECT_EQ(listed(closed.extended()), (std::vector<double>{-3, -1, 0, 1, 3, 4, 5, 7}));
}

TEST(KnotVector, KnotsEqualToTheSeamStayEqualToItWhereThePeriodRounds) {
    const auto closed = KnotVector::make({0.1, 0.3, 0.7, 1.1, 1.1}, 3, 4, Form::closed).value();
    EXPECT_EQ(closed.extended()[2], 0.1);
    EXPECT_EQ(closed.multiplicity(0.1), 2);
    EXPECT_EQ(closed.multiplicity(1.1), 2);
}

TEST(KnotVector, FindsTheSpanOnEitherSideOfEveryKnot) {
    RandomSplines random(11);
    for (int round = 0; round < 300; ++round) {
        const KnotVector knots = random.knotVector(random.integer(1, 7), random.form());
        const auto t = knots.extended();
        const Interval domain = knots.domain();
        for (const double at : test::telltaleParameters(knots, random)) {
            const std::size_t right = knots.findSpan(at, Side::right);
            const std::size_t left = knots.findSpan(at, Side::left);
            ASSERT_LT(t[right], t[right + 1]);
            ASSERT_LT(t[left], t[left + 1]);
            ASSERT_TRUE(at == domain.end ? t[right + 1] == at
                                         : t[right] <= at && at < t[right + 1]);
            ASSERT_TRUE(at == domain.start ? t[left] == at : t[left] < at && at <= t[left + 1]);
        }
    }
}

TEST(KnotVector, BeyondTheDomainTheEndSpanIsFound) {
    const auto knots = KnotVector::uniform(2, 5, Form::open).value();
    for (const Side side : test::bothSides) {
        EXPECT_EQ(knots.findSpan(-infinity, side), 2u);
        EXPECT_EQ(knots.findSpan(1.5, side), 2u);
        EXPECT_EQ(knots.findSpan(5.5, side), 4u);
        EXPECT_EQ(knots.findSpan(infinity, side), 4u);
        EXPECT_EQ(knots.findSpan(nan, side), 2u);
    }
}

TEST(KnotVector, WrapsByWholePeriodsAndLeavesTheDomainAlone) {
    const auto closed = KnotVector::make({1, 1.5, 2.5, 3}, 2, 3, Form::closed).value();
    EXPECT_EQ(closed.wrap(2.7), 2.7);
    EXPECT_EQ(closed.wrap(1), 1);
    EXPECT_EQ(closed.wrap(3), 1);
    EXPECT_EQ(closed.wrap(3, Side::left), 3);
    EXPECT_EQ(closed.wrap(1, Side::left), 3);
    EXPECT_EQ(closed.wrap(3.5), 1.5);
    EXPECT_EQ(closed.wrap(-2.5), 1.5);
    EXPECT_EQ(closed.wrap(-1001), 1);
    EXPECT_EQ(closed.wrap(-1001, Side::left), 3);
    EXPECT_EQ(KnotVector::uniform(2, 4, Form::open).value().wrap(17), 17);
}

TEST(KnotVector, WrappedParametersLieInTheDomainHoweverFarTheyCameFrom) {
    RandomSplines random(12);
    for (int round = 0; round < 2000; ++round) {
        const KnotVector knots = random.knotVector(random.integer(1, 3), Form::closed);
        const double t = random.real(-1, 1) * std::pow(10, random.real(-18, 18));
        ASSERT_LE(knots.domain().start, knots.wrap(t, Side::right));
        ASSERT_LT(knots.wrap(t, Side::right), knots.domain().end);
        ASSERT_LT(knots.domain().start, knots.wrap(t, Side::left));
        ASSERT_LE(knots.wrap(t, Side::left), knots.domain().end);
    }
}

TEST(KnotVector, CountsMultiplicityAcrossTheSeam) {
    const auto closed = KnotVector::make({0, 0, 1, 2, 3, 3}, 3, 5, Form::closed).value();
    EXPECT_EQ(closed.multiplicity(0), 3);
    EXPECT_EQ(closed.multiplicity(3), 3);
    EXPECT_EQ(closed.multiplicity(1), 1);
    EXPECT_EQ(closed.multiplicity(4), 1);
    EXPECT_EQ(closed.multiplicity(0.5), 0);
    const auto clamped = KnotVector::make({0, 0, 0, 1, 1, 2, 2, 2}, 2, 5, Form::clamped).value();
    EXPECT_EQ(clamped.multiplicity(0), 3);
    EXPECT_EQ(clamped.multiplicity(1), 2);
    EXPECT_EQ(clamped.multiplicity(3), 0);
}

TEST(KnotVector, GrevilleAbscissaeReproduceTheParameter) {
    RandomSplines random(13);
    for (int round = 0; round < 200; ++round) {
        const Form form = round % 2 == 0 ? Form::clamped : Form::open;
        const KnotVector knots = random.knotVector(random.integer(1, 7), form);
        const auto greville = knots.grevilles();
        std::vector<double> row(greville.size());
        for (const double t : test::telltaleParameters(knots, random)) {
            basisRows(knots, t, Side::right, 0, row);
            double sum = 0;
            for (std::size_t i = 0; i < row.size(); ++i) sum += row[i] * greville[i];
            ASSERT_NEAR(sum, t, 50 * test::gates::partitionOfUnity);
        }
    }
}

TEST(KnotVector, GrevilleAbscissaeOfAClosedVectorLieInItsDomain) {
    const auto closed = KnotVector::uniform(3, 5, Form::closed).value();
    EXPECT_EQ(closed.grevilles(), (std::vector<double>{4, 0, 1, 2, 3}));
}

struct Refused {
    std::vector<double> knots;
    int degree;
    int points;
    Form form;
    Code code;
    std::string path;
};

void PrintTo(const Refused& refused, std::ostream* out) {
    *out << codeName(refused.code) << " at " << refused.path;
}

class KnotVectorRefuses : public testing::TestWithParam<Refused> {};

TEST_P(KnotVectorRefuses, WithCodeAndPath) {
    const Refused& given = GetParam();
    const auto made = KnotVector::make(given.knots, given.degree, given.points, given.form);
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(codeName(made.error().code), codeName(given.code));
    EXPECT_EQ(made.error().path, given.path);
    EXPECT_FALSE(made.error().message.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Knots, KnotVectorRefuses,
    testing::Values(
        Refused{{0, 1}, 0, 1, Form::open, Code::outOfRange, "degree"},
        Refused{{0, 1}, -3, 4, Form::open, Code::outOfRange, "degree"},
        Refused{{0, 1}, 26, 30, Form::open, Code::tooLarge, "degree"},
        Refused{{0, 1}, 3, 100'001, Form::open, Code::tooLarge, "points"},
        Refused{{0, 0, 0, 1, 1}, 2, 2, Form::clamped, Code::wrongLength, "points"},
        Refused{{0, 1, 2}, 2, 2, Form::closed, Code::wrongLength, "points"},
        Refused{{0, 1, 2}, 2, -1, Form::closed, Code::wrongLength, "points"},
        Refused{{0, 1, 2, 3, 4}, 2, 3, Form::open, Code::knotsCount, "knots"},
        Refused{{0, 1, 2, 3, 4}, 2, 3, Form::closed, Code::knotsCount, "knots"},
        Refused{{}, 1, 2, Form::clamped, Code::knotsCount, "knots"},
        Refused{{0, 1, 2, nan, 4, 5}, 2, 3, Form::open, Code::notFinite, "knots[3]"},
        Refused{{0, 1, 2, 3, 4, infinity}, 2, 3, Form::open, Code::notFinite, "knots[5]"},
        Refused{{-1.5e9, 1, 2, 3, 4, 5}, 2, 3, Form::open, Code::outOfRange, "knots[0]"},
        Refused{{0, 1, 2, 1.5, 4, 5}, 2, 3, Form::open, Code::knotsDecreasing, "knots[3]"},
        Refused{{0, 2, 1, 3}, 2, 3, Form::closed, Code::knotsDecreasing, "knots[2]"},
        Refused{{0, 1, 2, 2, 2, 3}, 1, 4, Form::open, Code::knotsMultiplicity, "knots[4]"},
        Refused{{0, 0, 0, 1, 1, 1, 1, 2, 2, 2},
                2,
                7,
                Form::clamped,
                Code::knotsMultiplicity,
                "knots[6]"},
        Refused{{0, 0, 0, 0, 1, 1, 1}, 2, 4, Form::clamped, Code::knotsMultiplicity, "knots[3]"},
        Refused{{0, 0, 1, 2, 2, 2}, 2, 3, Form::clamped, Code::knotsMultiplicity, "knots[2]"},
        Refused{{0, 0, 0, 1, 2, 2}, 2, 3, Form::clamped, Code::knotsMultiplicity, "knots[3]"},
        Refused{
            {0, 0, 0, 1, 1, 2, 2, 2, 2}, 3, 8, Form::closed, Code::knotsMultiplicity, "knots[8]"},
        Refused{{0, 1, 2, 2, 3, 4}, 2, 3, Form::open, Code::outOfRange, "knots"},
        Refused{{0, 0, 5e-7, 5e-7}, 1, 2, Form::clamped, Code::outOfRange, "knots"},
        Refused{{5e8, 5e8, 5e8 + 0.25, 5e8 + 0.25}, 1, 2, Form::clamped, Code::outOfRange, "knots"},
        Refused{{0, 1, 1 + 1e-13, 2}, 2, 3, Form::closed, Code::outOfRange, "knots[2]"},
        Refused{{0, 1, 1 + 1.1e-15, 1.001}, 2, 3, Form::closed, Code::outOfRange, "knots[2]"}));

TEST(KnotVector, LimitsThemselvesAreAllowed) {
    EXPECT_TRUE(KnotVector::uniform(25, 26, Form::clamped).ok());
    EXPECT_TRUE(KnotVector::uniform(3, 100'000, Form::closed).ok());
    EXPECT_TRUE(KnotVector::make({-1e9, -1e9, 1e9, 1e9}, 1, 2, Form::clamped).ok());
    EXPECT_TRUE(KnotVector::make({0, 0, 1e-6, 1e-6}, 1, 2, Form::clamped).ok());
    EXPECT_TRUE(KnotVector::make({0, 0, 1, 1, 2, 2}, 1, 4, Form::clamped).ok());
    EXPECT_TRUE(KnotVector::make({0, 0, 1, 2, 2}, 2, 4, Form::closed).ok());
    EXPECT_TRUE(KnotVector::make({0, 1, 1 + 3e-12, 2}, 2, 3, Form::closed).ok());
}

TEST(KnotVector, UniformRefusesSizesAsMakeDoes) {
    EXPECT_EQ(KnotVector::uniform(0, 4, Form::open).error().path, "degree");
    EXPECT_EQ(KnotVector::uniform(3, 3, Form::closed).error().code, Code::wrongLength);
    EXPECT_EQ(KnotVector::uniform(3, 200'000, Form::open).error().code, Code::tooLarge);
}

TEST(KnotVector, KnotsMayBeAsNearEachOtherAsTheirOwnSizeAllowsHoweverFarTheOthersAre) {
    const auto made = [](double gap) {
        return KnotVector::make({-1e9, 0, gap, 1, 1e9}, 1, 3, Form::open);
    };
    EXPECT_TRUE(made(1e-7).ok());
    ASSERT_FALSE(made(1e-13).ok());
    EXPECT_EQ(made(1e-13).error().path, "knots[2]");
}

TEST(KnotVector, CountMessageGivesBothNumbers) {
    const auto made = KnotVector::make({0, 1, 2, 3, 4}, 2, 3, Form::open);
    EXPECT_NE(made.error().message.find("5 knots given, 6 needed"), std::string::npos);
}

}  // namespace
}  // namespace knotwork
