#include "geometry/curve_subdivision.hpp"

#include "geometry/knot_vector.hpp"
#include "support/gates.hpp"
#include "support/polygons.hpp"
#include "support/truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace knotwork {
namespace {

using test::chaikin;
using test::farthest;
using test::fourPoint;
using test::laneRiesenfeld;
using test::Rational;
using test::square;
using test::subdivided;
using test::wholePoints;

constexpr double rounding = 1e-13;  // of a dozen levels, coordinates up to 50

// ---- The truth ---------------------------------------------------------------------------------

TEST(CurveSubdivisionTruth, LaneRiesenfeldOfTheSquareIsExactWithoutAnyShift) {
    for (const int degree : {1, 2, 3}) {
        auto ring = test::planarPoints(test::truth("LR")["d" + std::to_string(degree) + "_k1"]);
        ASSERT_EQ(ring.front(), ring.back());
        ring.pop_back();
        EXPECT_EQ(subdivided(laneRiesenfeld(degree, square(), true, 1)), ring) << degree;
    }
}

TEST(CurveSubdivisionTruth, TheFourPointSchemeOfTheSquareIsExact) {
    EXPECT_EQ(subdivided(fourPoint(1.0 / 16, square(), true, 1)),
              test::planarPoints(test::truth("fourpoint_sq")["k1"]));
}

// ---- Counts ------------------------------------------------------------------------------------

TEST(CurveSubdivisionCounts, AClosedPolygonHasTwiceAsManyPointsALevel) {
    for (const std::size_t n : {3U, 4U, 7U, 50U}) {
        for (const int levels : {0, 1, 2, 6, 7, 9}) {
            for (const auto& s : {laneRiesenfeld(1, wholePoints(n, 1), true, levels),
                                  laneRiesenfeld(25, wholePoints(n, 1), true, levels),
                                  chaikin(wholePoints(n, 1), true, levels),
                                  fourPoint(0.1, wholePoints(n, 1), true, levels)}) {
                EXPECT_EQ(subdivided(s).size(), n << levels);
                EXPECT_EQ(subdividedCount(s), n << levels);
            }
        }
    }
}

TEST(CurveSubdivisionCounts, AnOpenPolygonHasTwiceAsManyLessTheDegree) {
    for (const int degree : {1, 2, 3, 8, 25}) {
        std::size_t count = static_cast<std::size_t>(degree) + 3;
        const auto points = wholePoints(count, 2);
        for (int levels = 0; levels < 9; ++levels) {
            const auto s = laneRiesenfeld(degree, points, false, levels);
            EXPECT_EQ(subdividedCount(s), count);
            EXPECT_EQ(subdivided(s).size(), count);
            count = 2 * count - static_cast<std::size_t>(degree);
        }
    }
}

TEST(CurveSubdivisionCounts, AnOpenFourPointPolygonGetsAPointOnEveryLeg) {
    std::size_t count = 5;
    for (int levels = 0; levels < 9; ++levels) {
        EXPECT_EQ(subdivided(fourPoint(0.06, wholePoints(5, 3), false, levels)).size(), count);
        count = 2 * count - 1;
    }
}

// ---- Refinement of the B-spline ----------------------------------------------------------------

/// The blossom of the segment over [s, s + 1] of the uniform B-spline whose points are P_i on the
/// knots i, i + 1, …, i + d + 1, taken at `arguments`.
Rational blossom(const std::vector<Rational>& p, long long s, const std::vector<Rational>& arguments) {
    const auto d = static_cast<long long>(arguments.size());
    const auto n = static_cast<long long>(p.size());
    std::vector<Rational> active;
    for (long long i = s - d; i <= s; ++i) {
        active.push_back(p[static_cast<std::size_t>((i % n + n) % n)]);
    }
    for (long long r = 1; r <= d; ++r) {
        for (long long k = 0; k + r <= d; ++k) {
            const long long i = s - d + r + k;  // of the right one of the two
            const Rational share = (arguments[static_cast<std::size_t>(r - 1)] - Rational(i)) /
                                   Rational(d + 1 - r);
            const auto at = static_cast<std::size_t>(k);
            active[at] = (Rational(1) - share) * active[at] + share * active[at + 1];
        }
    }
    return active[0];
}

/// Control point j of the same spline on the knots d/2, d/2 + 1/2, …
Rational refinedPoint(const std::vector<Rational>& p, long long degree, long long j) {
    std::vector<Rational> knots;
    for (long long k = 1; k <= degree; ++k) knots.push_back(Rational(degree + j + k, 2));
    return blossom(p, std::max(degree, (degree + j) / 2), knots);
}

class OneLevel : public testing::TestWithParam<int> {};

TEST_P(OneLevel, IsUniformRefinementOfTheClosedAndTheOpenBspline) {
    const int degree = GetParam();
    for (const bool closed : {true, false}) {
        const auto points = wholePoints(static_cast<std::size_t>(degree) + 4, 4);
        std::vector<Rational> x;
        for (const Vec3& p : points) x.emplace_back(static_cast<long long>(p.x));
        const auto found = subdivided(laneRiesenfeld(degree, points, closed, 1));
        for (std::size_t j = 0; j < found.size(); ++j) {
            const Rational expected = refinedPoint(x, degree, static_cast<long long>(j));
            EXPECT_EQ(found[j].x, expected.value()) << degree << (closed ? " closed " : " open ") << j;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Degrees, OneLevel, testing::Range(1, 10));

TEST(CurveSubdivision, ChaikinIsLaneRiesenfeldOfDegreeTwoAndCutsAtQuarters) {
    const auto points = wholePoints(9, 5);
    for (const bool closed : {true, false}) {
        EXPECT_EQ(subdivided(chaikin(points, closed, 7)),
                  subdivided(laneRiesenfeld(2, points, closed, 7)));
        const auto cut = subdivided(chaikin(points, closed, 1));
        EXPECT_EQ(cut[2], 0.75 * points[1] + 0.25 * points[2]);
        EXPECT_EQ(cut[3], 0.25 * points[1] + 0.75 * points[2]);
    }
}

// ---- The article's algorithm -------------------------------------------------------------------
//
// Doubling and averaging as the article has it, put right: a closed polygon repeats its first point
// and has one point more than intervals (E19); doubling runs down to 1 and keeps P_0 (E20); there are
// d − 1 passes, and the ring is closed again in each (E21).

std::vector<Vec3> doubledAndAveraged(int degree, std::vector<Vec3> p, bool closed, int levels) {
    if (closed) p.push_back(p.front());
    for (int level = 0; level < levels; ++level) {
        std::vector<Vec3> q{p[0]};
        for (std::size_t i = 1; i < p.size(); ++i) {
            q.push_back(0.5 * (p[i - 1] + p[i]));
            q.push_back(p[i]);
        }
        for (int pass = 1; pass < degree; ++pass) {
            for (std::size_t i = 0; i + 1 < q.size(); ++i) q[i] = 0.5 * (q[i] + q[i + 1]);
            if (closed) {
                q.back() = q.front();
            } else {
                q.pop_back();
            }
        }
        p = q;
    }
    if (closed) p.pop_back();
    return p;
}

TEST(CurveSubdivision, IsDoublingAndAveragingWordForWord) {
    for (int degree = 1; degree <= 25; degree += degree < 9 ? 1 : 8) {
        for (const bool closed : {true, false}) {
            const std::size_t fewest = closed ? 3 : static_cast<std::size_t>(degree) + 1;
            for (const std::size_t more : {0U, 1U, 34U}) {
                for (const int levels : {1, 2, 5, 6, 8}) {
                    const auto points = wholePoints(fewest + more, 6);
                    EXPECT_LE(farthest(subdivided(laneRiesenfeld(degree, points, closed, levels)),
                                       doubledAndAveraged(degree, points, closed, levels)),
                              rounding)
                        << "degree " << degree << " points " << points.size() << " levels " << levels;
                }
            }
        }
    }
}

// E19: with the number of intervals where that of points belongs, the last points stay as they were.
TEST(ArticleMistakes, TheLastPointsOfTheRingAreMadeLikeTheOthers) {
    const auto ring = subdivided(laneRiesenfeld(3, square(), true, 1));
    EXPECT_EQ(ring[6], Vec3(0, 0.5, 0));
    EXPECT_EQ(ring[7], Vec3(0.125, 0.125, 0));
    EXPECT_EQ(std::count(ring.begin(), ring.end(), Vec3(0.25, 0.5, 0)), 0);
}

// E20: doubling that goes on to i = 0 writes before the first point, and in the other order loses one.
TEST(ArticleMistakes, DoublingKeepsEveryVertexTheFirstOneToo) {
    const auto points = wholePoints(11, 7);
    for (const bool closed : {true, false}) {
        const auto doubled = subdivided(laneRiesenfeld(1, points, closed, 1));
        for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(doubled[2 * i], points[i]);
        for (std::size_t i = 1; i < points.size(); ++i) {
            EXPECT_EQ(doubled[2 * i - 1], 0.5 * (points[i - 1] + points[i]));
        }
    }
}

// E21: d passes instead of d − 1 would give the next degree.
TEST(ArticleMistakes, DegreeOneStaysOnThePolygon) {
    EXPECT_EQ(subdivided(laneRiesenfeld(1, square(), true, 2))[1], Vec3(0.25, 0, 0));
    EXPECT_EQ(subdivided(laneRiesenfeld(1, square(), true, 2))[4], Vec3(1, 0, 0));
}

// E21: a ring that is closed only after the last pass has a seam.
TEST(ArticleMistakes, AClosedPolygonHasNoSeam) {
    const auto points = wholePoints(7, 8);
    auto turned = points;
    std::rotate(turned.begin(), turned.begin() + 3, turned.end());
    for (const int degree : {2, 3, 5, 9}) {
        auto expected = subdivided(laneRiesenfeld(degree, points, true, 4));
        std::rotate(expected.begin(), expected.begin() + 3 * 16, expected.end());
        EXPECT_LE(farthest(subdivided(laneRiesenfeld(degree, turned, true, 4)), expected), rounding);
    }
}

// ---- Weights -----------------------------------------------------------------------------------

TEST(SubdivisionMasks, SumToOneExactly) {
    for (int degree = 1; degree <= maxDegree; ++degree) {
        const auto mask = subdivisionMask(laneRiesenfeld(degree, square(), true, 1));
        EXPECT_EQ(std::accumulate(mask.even.begin(), mask.even.end(), 0.0), 1) << degree;
        EXPECT_EQ(std::accumulate(mask.odd.begin(), mask.odd.end(), 0.0), 1) << degree;
    }
    for (const double w : {-1.0, 0.0, 0.0625, 1.0}) {
        const auto mask = subdivisionMask(fourPoint(w, square(), true, 1));
        EXPECT_EQ(std::accumulate(mask.odd.begin(), mask.odd.end(), 0.0), 1) << w;
    }
}

TEST(SubdivisionMasks, AreBinomial) {
    const auto cubic = subdivisionMask(laneRiesenfeld(3, square(), true, 1));
    EXPECT_EQ(std::vector<double>(cubic.even.begin(), cubic.even.begin() + 3),
              (std::vector<double>{0.5, 0.5, 0}));
    EXPECT_EQ(std::vector<double>(cubic.odd.begin(), cubic.odd.begin() + 3),
              (std::vector<double>{0.125, 0.75, 0.125}));
}

TEST(CurveSubdivision, APolygonInAPlaneOfTheAxesStaysThereToTheBit) {
    for (const bool closed : {true, false}) {
        std::vector<CurveSubdivision> all;
        auto points = wholePoints(30, 9);
        for (Vec3& p : points) p.z = 0.1;
        for (int degree = 1; degree <= maxDegree; ++degree) {
            all.push_back(laneRiesenfeld(degree, points, closed, 7));
        }
        for (const double w : {-0.9, 0.0, 1.0 / 16, 0.19, 1.0}) {
            all.push_back(fourPoint(w, points, closed, 7));
        }
        for (const auto& s : all) {
            for (const Vec3& p : subdivided(s)) ASSERT_EQ(p.z, 0.1) << s.degree << ' ' << s.tension;
        }
    }
}

// ---- Four points -------------------------------------------------------------------------------

TEST(FourPointScheme, IsItsFormulaWithReflectedEnds) {
    const double w = 0.11;
    for (const std::size_t n : {2U, 3U, 20U}) {
        std::vector<Vec3> p = wholePoints(n, 10);
        const auto found = subdivided(fourPoint(w, p, false, 9));
        for (int level = 0; level < 9; ++level) {
            p.insert(p.begin(), 2.0 * p[0] - p[1]);
            p.push_back(2.0 * p[p.size() - 1] - p[p.size() - 2]);
            std::vector<Vec3> q;
            for (std::size_t i = 1; i + 2 < p.size(); ++i) {
                q.push_back(p[i]);
                q.push_back((0.5 + w) * (p[i] + p[i + 1]) - w * (p[i - 1] + p[i + 2]));
            }
            q.push_back(p[p.size() - 2]);
            p = q;
        }
        EXPECT_LE(farthest(found, p), rounding) << n;
    }
}

TEST(FourPointScheme, KeepsTheGivenPoints) {
    for (const bool closed : {true, false}) {
        const auto points = wholePoints(40, 11);
        const auto found = subdivided(fourPoint(0.08, points, closed, 8));
        for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(found[i << 8], points[i]);
    }
}

TEST(FourPointScheme, OfTheDefaultTensionKeepsCubics) {
    const auto cubic = [](double t) { return Vec3(t, t * t * (t - 7) / 8, (t - 3) * (t - 4) * t); };
    std::vector<Vec3> points;
    for (int i = 0; i < 10; ++i) points.push_back(cubic(i));
    const auto found = subdivided(fourPoint(1.0 / 16, points, false, 6));
    for (std::size_t j = 2 * 64; j <= 7 * 64; ++j) {
        const Vec3 expected = cubic(static_cast<double>(j) / 64);
        EXPECT_LE(glm::length(found[j] - expected), rounding) << j;
    }
    const auto other = subdivided(fourPoint(0.0626, points, false, 6));
    EXPECT_GT(glm::length(other[4 * 64 + 32] - cubic(4.5)), 1e-4);
}

TEST(FourPointScheme, OfTensionZeroStaysOnThePolygon) {
    const auto points = wholePoints(6, 12);
    for (const bool closed : {true, false}) {
        EXPECT_EQ(subdivided(fourPoint(0, points, closed, 5)),
                  subdivided(laneRiesenfeld(1, points, closed, 5)));
    }
}

// ---- Blocks and refusals -----------------------------------------------------------------------

TEST(FinalPolygon, GivesAnyPartOfItself) {
    for (const auto& s : {laneRiesenfeld(4, wholePoints(9, 13), false, 8),
                          laneRiesenfeld(3, wholePoints(9, 13), true, 3),
                          fourPoint(0.05, wholePoints(9, 13), false, 7)}) {
        const auto whole = subdivided(s);
        const FinalPolygon polygon(s);
        for (std::size_t first = 0; first < whole.size(); first += 26) {
            for (const std::size_t count : {std::size_t{1}, std::size_t{6}, whole.size() - first}) {
                std::vector<double> part(3 * std::min(count, whole.size() - first) + 1, -7);
                polygon.points(first, {part.data(), part.size() - 1});
                for (std::size_t i = 0; i + 1 < part.size(); ++i) {
                    ASSERT_EQ(part[i], whole[first + i / 3][static_cast<int>(i % 3)]) << first;
                }
                ASSERT_EQ(part.back(), -7);
            }
        }
    }
}

void expectRefused(const CurveSubdivision& s, Code code, const std::string& path) {
    const auto checked = checkSubdivision(s, maxSubdividedPoints);
    ASSERT_FALSE(checked.ok()) << path;
    EXPECT_EQ(checked.error().code, code) << checked.error().message;
    EXPECT_EQ(checked.error().path, path);
    EXPECT_FALSE(checked.error().message.empty());
}

TEST(CurveSubdivisionRefusals, NameWhatIsWrong) {
    const auto some = wholePoints(9, 14);
    expectRefused(laneRiesenfeld(0, some, true, 1), Code::outOfRange, "degree");
    expectRefused(laneRiesenfeld(26, some, true, 1), Code::tooLarge, "degree");
    expectRefused(laneRiesenfeld(9, some, false, 1), Code::wrongLength, "points");
    expectRefused(laneRiesenfeld(3, {some[0], some[1]}, true, 1), Code::wrongLength, "points");
    expectRefused(fourPoint(0.1, {some[0]}, false, 1), Code::wrongLength, "points");
    expectRefused(chaikin({}, true, 1), Code::wrongLength, "points");
    expectRefused(chaikin(std::vector<Vec3>(100'001), true, 0), Code::tooLarge, "points");
    expectRefused(fourPoint(1.01, some, true, 1), Code::outOfRange, "tension");
    expectRefused(fourPoint(std::nan(""), some, true, 1), Code::notFinite, "tension");
    expectRefused(chaikin(some, true, -1), Code::outOfRange, "levels");
    expectRefused(chaikin(some, true, 23), Code::tooLarge, "levels");
    expectRefused(chaikin(some, true, 19), Code::tooLarge, "levels");
    auto far = some;
    far[4].y = 1.1e12;
    expectRefused(chaikin(far, true, 1), Code::outOfRange, "points[4]");
    far[4].y = std::numeric_limits<double>::infinity();
    expectRefused(chaikin(far, true, 1), Code::notFinite, "points[4]");
}

TEST(CurveSubdivisionRefusals, StopAtTheLimits) {
    EXPECT_TRUE(checkSubdivision(chaikin(wholePoints(8, 15), true, 19), maxSubdividedPoints).ok());
    EXPECT_TRUE(checkSubdivision(laneRiesenfeld(25, wholePoints(26, 15), false, 21),
                                 maxSubdividedPoints).ok());
    EXPECT_TRUE(checkSubdivision(fourPoint(-1, wholePoints(2, 15), false, 21),
                                 maxSubdividedPoints).ok());
    EXPECT_TRUE(checkSubdivision(laneRiesenfeld(1, wholePoints(100'000, 15), false, 5),
                                 maxSubdividedPoints).ok());
}

}  // namespace
}  // namespace knotwork
