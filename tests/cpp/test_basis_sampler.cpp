#include "geometry/basis_sampler.hpp"

#include "geometry/bspline_basis.hpp"
#include "support/gates.hpp"
#include "support/splines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace knotwork {
namespace {

using test::RandomSplines;

/// The active functions of one parameter put where basisRows() has them.
std::vector<double> spread(const KnotVector& knots, std::span<const double> active,
                           std::int32_t first) {
    const auto count = static_cast<std::size_t>(knots.pointCount());
    std::vector<double> row(count);
    for (std::size_t j = 0; j < active.size(); ++j) {
        row[(static_cast<std::size_t>(first) + j) % count] = active[j];
    }
    return row;
}

void expectSame(const KnotVector& knots, const std::vector<double>& ts) {
    const auto width = static_cast<std::size_t>(knots.degree()) + 1;
    std::vector<double> values(ts.size() * width);
    std::vector<std::int32_t> first(ts.size());
    activeBasis(knots, ts, values, first);
    std::vector<double> expected(static_cast<std::size_t>(knots.pointCount()));
    for (std::size_t i = 0; i < ts.size(); ++i) {
        basisRows(knots, ts[i], Side::right, 0, expected);
        const auto row = spread(knots, std::span(values).subspan(i * width, width), first[i]);
        for (std::size_t j = 0; j < row.size(); ++j) {
            ASSERT_NEAR(row[j], expected[j], test::gates::partitionOfUnity)
                << "function " << j << " at " << ts[i];
        }
    }
}

TEST(ActiveBasis, AgreesWithTheRowsOfAllFunctionsAtKnotsEndsAndBetween) {
    RandomSplines random(71);
    for (int round = 0; round < 150; ++round) {
        const KnotVector knots = random.knotVector(random.integer(1, 9), random.form());
        expectSame(knots, test::telltaleParameters(knots, random));
    }
}

TEST(ActiveBasis, TakesParametersInAnyOrder) {
    RandomSplines random(72);
    for (int round = 0; round < 30; ++round) {
        const KnotVector knots = random.knotVector(3, random.form());
        auto ts = test::telltaleParameters(knots, random);
        std::reverse(ts.begin(), ts.end());
        std::swap(ts.front(), ts[ts.size() / 2]);
        expectSame(knots, ts);
    }
}

TEST(ActiveBasis, WrapsTheParametersOfAClosedVector) {
    RandomSplines random(73);
    const KnotVector knots = random.knotVector(3, Form::closed);
    const double period = knots.period();
    const double middle = knots.domain().start + period / 3;
    expectSame(knots, {middle, middle + period, middle - 2 * period, middle});
}

TEST(ActiveBasis, OfTheHighestDegreeIsThatOfTheRecurrence) {
    RandomSplines random(74);
    const KnotVector knots = random.knotVector(maxDegree, Form::clamped);
    expectSame(knots, test::telltaleParameters(knots, random));
}

}  // namespace
}  // namespace knotwork
