#include "geometry/schoenberg_whitney.hpp"

#include "geometry/bspline_basis.hpp"
#include "geometry/fitting.hpp"

#include "support/splines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace knotwork {
namespace {

using test::allForms;
using test::RandomSplines;

/// Which functions are not zero at u, from their values.
std::vector<std::size_t> functionsAt(const KnotVector& knots, double u) {
    std::vector<double> row(static_cast<std::size_t>(knots.pointCount()));
    const bool end = u == knots.domain().end;
    basisRows(knots, u, end ? Side::left : Side::right, 0, row);
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (row[i] != 0) found.push_back(i);
    }
    return found;
}

/// A matching by augmenting paths: how many functions get a parameter of their own.
class Matching {
public:
    Matching(const KnotVector& knots, const std::vector<double>& parameters)
        : owner_(static_cast<std::size_t>(knots.pointCount()), none) {
        const std::set<double> different(parameters.begin(), parameters.end());
        for (const double u : different) functions_.push_back(functionsAt(knots, u));
        for (std::size_t k = 0; k < functions_.size(); ++k) {
            std::set<std::size_t> seen;
            if (augment(k, seen)) ++size_;
        }
    }
    [[nodiscard]] std::size_t size() const { return size_; }

private:
    static constexpr std::size_t none = ~std::size_t{0};

    bool augment(std::size_t k, std::set<std::size_t>& seen) {
        for (const std::size_t i : functions_[k]) {
            if (!seen.insert(i).second) continue;
            if (owner_[i] == none || augment(owner_[i], seen)) {
                owner_[i] = k;
                return true;
            }
        }
        return false;
    }

    std::vector<std::vector<std::size_t>> functions_;
    std::vector<std::size_t> owner_;
    std::size_t size_ = 0;
};

TEST(SchoenbergWhitney, AgreesWithAMatchingOfRandomData) {
    RandomSplines random(71);
    int determined = 0;
    int starved = 0;
    for (int round = 0; round < 4000; ++round) {
        const Form form = allForms[round % 3];
        const KnotVector knots = random.knotVector(random.integer(1, 5), form, round % 2 == 0);
        const Interval domain = knots.domain();
        std::vector<double> ts;
        const int count = random.integer(knots.pointCount() - 1, 2 * knots.pointCount());
        // Every second one is a knot, where fewer functions live, and some come twice.
        for (int k = 0; k < count; ++k) {
            const auto all = knots.extended();
            const double knot =
                all[static_cast<std::size_t>(random.integer(0, static_cast<int>(all.size()) - 1))];
            const bool use = random.integer(0, 2) == 0 && domain.contains(knot);
            ts.push_back(use ? knot : random.real(domain.start, domain.end));
        }
        // The end of a period is its start, but on the other side of a gap.
        if (knots.closed()) std::erase(ts, domain.end);
        if (ts.empty()) continue;
        std::sort(ts.begin(), ts.end());
        const Matching matching(knots, ts);
        const auto found = starvedFunction(knots, ts);
        const bool whole = matching.size() == static_cast<std::size_t>(knots.pointCount());
        ASSERT_EQ(!found.has_value(), whole) << "round " << round;
        ++(whole ? determined : starved);
    }
    EXPECT_GT(determined, 500);
    EXPECT_GT(starved, 500);
}

TEST(SchoenbergWhitney, NamesTheFunctionThatNoParameterTouches) {
    const KnotVector knots = KnotVector::uniform(3, 12, Form::clamped).value();
    for (std::size_t starved = 0; starved < 12; ++starved) {
        std::vector<double> ts;
        const auto t = knots.extended();
        for (double u = 0.01; u < 9; u += 0.02) {
            if (!(t[starved] < u && u < t[starved + 4])) ts.push_back(u);
        }
        const auto found = starvedFunction(knots, ts);
        ASSERT_TRUE(found.has_value());
        // At an end its neighbours that live in the same spans alone are starved with it.
        EXPECT_EQ(*found, starved <= 3 ? 0 : starved);
    }
}

TEST(SchoenbergWhitney, NamesTheFunctionForWhichNothingIsLeft) {
    const KnotVector knots = KnotVector::uniform(3, 12, Form::open).value();
    std::vector<double> ts;
    for (double u = 3; u <= 12; u += 0.1) {
        if (!(5 < u && u < 10)) ts.push_back(u);
    }
    // The functions 5 and 6 live on (5, 9) and (6, 10): one parameter is not enough for both.
    ts.insert(std::upper_bound(ts.begin(), ts.end(), 7.5), 7.5);
    EXPECT_EQ(starvedFunction(knots, ts), 6U);
    ts.insert(std::upper_bound(ts.begin(), ts.end(), 7.5), 7.5);
    EXPECT_EQ(starvedFunction(knots, ts), 6U);
    ts.insert(std::upper_bound(ts.begin(), ts.end(), 7.6), 7.6);
    EXPECT_EQ(starvedFunction(knots, ts), std::nullopt);
}

TEST(SchoenbergWhitney, FitsNameTheControlPoint) {
    RandomSplines random(72);
    for (const Form form : allForms) {
        const KnotVector knots = KnotVector::uniform(2, 9, form).value();
        const double shift = form == Form::open ? 0 : -2;
        std::vector<double> ts;
        std::vector<Vec3> points;
        for (double u = knots.domain().start; u < knots.domain().end; u += 0.05) {
            if (4 + shift < u && u < 7 + shift) continue;
            ts.push_back(u);
            points.emplace_back(random.real(-1, 1), random.real(-1, 1), 0);
        }
        const auto fit = leastSquaresCurve(points, ts, knots);
        ASSERT_FALSE(fit.ok());
        EXPECT_EQ(fit.error().code, Code::rankDeficient);
        EXPECT_EQ(fit.error().path, "controlPoints[4]");
    }
}

// A periodic spline of even degree with an even number of points and data at its knots: every
// function has a parameter of its own, and still the alternating one vanishes at all of them.
TEST(SchoenbergWhitney, PeriodicSymmetryThatItDoesNotSeeIsRefusedToo) {
    const KnotVector knots = KnotVector::uniform(2, 8, Form::closed).value();
    std::vector<double> ts;
    std::vector<Vec3> points;
    for (int k = 0; k < 8; ++k) {
        ts.push_back(k);
        points.emplace_back(k, k * k, 0);
    }
    EXPECT_EQ(starvedFunction(knots, ts), std::nullopt);
    EXPECT_EQ(leastSquaresCurve(points, ts, knots).error().code, Code::rankDeficient);
}

}  // namespace
}  // namespace knotwork
