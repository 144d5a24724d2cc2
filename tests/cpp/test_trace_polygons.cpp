// Traces that refine a polygon end with the one that the library and the truth have.
#include "support/traces.hpp"

#include "geometry/oslo.hpp"
#include "geometry/refinement.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace knotwork::scene {
namespace {

TEST(TraceBoehm, EndsWithThePointsOfInsertKnot) {
    int inserted = 0;
    eachParameter(704, 12, [&](const BsplineCurve& curve, double t) {
        const auto refined = insertKnot(curve, t, 1);
        const auto trace = makeTrace(about("boehm", curve, "knot", t));
        ASSERT_EQ(trace.ok(), refined.ok());
        if (!refined.ok()) {
            EXPECT_EQ(trace.error().path, "knot");
            EXPECT_EQ(codeName(trace.error().code), codeName(refined.error().code));
            return;
        }
        ++inserted;
        expectReadable(*trace);
        ASSERT_EQ(trace->frames.size(), 3u);
        const auto& points = trace->frames.back().points;
        ASSERT_EQ(points.size(), refined->points().size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_LE(distance(points[i], refined->points()[i]), test::gates::exact) << i;
        }
        const int present = curve.knotVector().multiplicity(t);
        EXPECT_EQ(trace->frames[1].weights.size(),
                  static_cast<std::size_t>(curve.degree() - present));
        for (const double a : trace->frames[1].weights) EXPECT_TRUE(0 < a && a <= 1) << a;
    });
    EXPECT_GT(inserted, 200);
}

TEST(TraceBoehm, SaysWhereTheNewPointsLie) {
    const Trace trace = traced(onQuadratic("boehm", "\"knot\":2"));
    EXPECT_EQ(trace.frames[0].text,
              "The knot 2 is put between the knots 1 and 3; its multiplicity is 0 so far and "
              "the degree is 2, so the number of legs of the control polygon that get a new "
              "point is 2.");
    EXPECT_EQ(trace.frames[1].text,
              "Each new point divides its leg as 2 divides two knots that are 2 apart: with 0.6667 "
              "and 0.3333 of the leg passed, the new points are (2.333, 2.667) and (3.667, 2).");
    EXPECT_EQ(trace.frames[2].marked, (std::vector<std::size_t>{2, 3}));
}

TEST(TraceOslo, HasTheMatrixAndThePointsOfTheTruth) {
    const auto& truth = test::truth("oslo_quad");
    Json arguments = parsed(onQuadratic("oslo", "\"knots\":[]"));
    arguments["knots"] = listOf(test::doubles(test::rationals(truth["to"])));
    const Trace trace = traced(arguments);
    expectReadable(trace);
    const auto& alpha = truth["alpha"];
    ASSERT_EQ(trace.frames.size(), alpha.size() + 2);
    const TraceFrame& last = trace.frames.back();
    ASSERT_EQ(last.matrix.size(), alpha.size());
    for (std::size_t j = 0; j < alpha.size(); ++j) {
        const auto row = test::doubles(test::rationals(alpha[j]));
        const auto point = test::doubles(test::rationals(truth["ctrl"][j]));
        EXPECT_LE(distance(last.points[j], {point[0], point[1], 0}), test::gates::exact);
        for (std::size_t i = 0; i < row.size(); ++i) {
            EXPECT_NEAR(last.matrix[j][i], row[i], test::gates::exact) << j << ", " << i;
            EXPECT_EQ(trace.frames[j + 1].matrix[j][i], last.matrix[j][i]);
            EXPECT_EQ(trace.frames[j + 1].weights[i], last.matrix[j][i]);
        }
    }
    EXPECT_EQ(trace.frames[3].text,
              "New point 2 belongs to the new knots 0.5 and 1; with the weights 0.8333 and "
              "0.1667 of the old points 1 and 2 it lies at (1.333, 2.167).");
}

/// The curve's knots with some more among them, all inside the domain.
std::vector<double> moreKnots(const BsplineCurve& curve, RandomSplines& random) {
    const auto given = curve.knotVector().knots();
    std::vector<double> knots(given.begin(), given.end());
    const Interval domain = curve.domain();
    for (int i = random.integer(0, 5); i >= 0; --i) {
        const double t = random.real(domain.start, domain.end);
        const double existing = given[static_cast<std::size_t>(
            random.integer(0, static_cast<int>(given.size()) - 1))];
        const bool again = domain.start < existing && existing < domain.end &&
                           std::count(knots.begin(), knots.end(), existing) < curve.degree();
        knots.insert(std::upper_bound(knots.begin(), knots.end(), again ? existing : t),
                     again ? existing : t);
    }
    return knots;
}

TEST(TraceOslo, HasTheMatrixOfTheLibraryInEveryForm) {
    RandomSplines random(705);
    for (int i = 0; i < 40; ++i) {
        for (const Form form : test::allForms) {
            SplineKind kind{.maxDegree = 5, .rational = i % 3 == 0};
            const BsplineCurve curve = random.curve(form, kind);
            const std::vector<double> knots = moreKnots(curve, random);
            const Trace trace = traced(about("oslo", curve, "knots", listOf(knots)));
            expectReadable(trace);
            const TraceFrame& last = trace.frames.back();
            const KnotVector refined = refinedKnots(curve.knotVector(), knots).value();
            const std::vector<double> matrix = osloMatrix(curve.knotVector(), refined);
            ASSERT_EQ(last.matrix.size() * curve.points().size(), matrix.size());
            for (std::size_t j = 0; j < last.matrix.size(); ++j) {
                for (std::size_t c = 0; c < last.matrix[j].size(); ++c) {
                    EXPECT_NEAR(last.matrix[j][c], matrix[j * last.matrix[j].size() + c],
                                test::gates::exact);
                }
                double sum = 0;
                for (const double alpha : last.matrix[j]) {
                    EXPECT_GE(alpha, 0);
                    sum += alpha;
                }
                EXPECT_NEAR(sum, 1, test::gates::partitionOfUnity);
            }
        }
    }
}

TEST(TraceOslo, AgreesWithKnotsPutInOneByOne) {
    RandomSplines random(706);
    for (int i = 0; i < 60; ++i) {
        for (const Form form : test::allForms) {
            SplineKind kind{.maxDegree = 5, .rational = i % 3 == 0, .multipleKnots = i % 2 == 0};
            BsplineCurve curve = random.curve(form, kind);
            BsplineCurve refined = curve;
            for (int k = 0; k < 4; ++k) {
                const Interval domain = curve.domain();
                const auto knots = curve.knotVector().knots();
                const double existing = knots[static_cast<std::size_t>(
                    random.integer(0, static_cast<int>(knots.size()) - 1))];
                const double t = k % 2 == 0 && domain.contains(existing)
                                     ? existing
                                     : random.real(domain.start, domain.end);
                if (auto more = insertKnot(refined, t, 1); more.ok()) refined = std::move(*more);
            }
            const std::vector<Vec3> points =
                traced(about("oslo", curve, "knots", listOf(refined.knotVector().knots())))
                    .frames.back()
                    .points;
            ASSERT_EQ(points.size(), refined.points().size());
            for (std::size_t j = 0; j < points.size(); ++j) {
                EXPECT_LE(distance(points[j], refined.points()[j]), test::gates::refinement)
                    << "point " << j << " form " << static_cast<int>(form);
            }
        }
    }
}

/// Whether the polygon is this ring, from whatever point on.
bool sameRing(const std::vector<Vec3>& found, const std::vector<Vec3>& ring) {
    for (std::size_t shift = 0; shift < ring.size(); ++shift) {
        bool same = found.size() == ring.size();
        for (std::size_t i = 0; same && i < ring.size(); ++i) {
            same = distance(found[i], ring[(i + shift) % ring.size()]) <= test::gates::exact;
        }
        if (same) return true;
    }
    return false;
}

TEST(TraceLaneRiesenfeld, EndsWithTheRingsOfTheTruth) {
    for (int degree = 1; degree <= 3; ++degree) {
        const Trace trace =
            traced(onSquare("lane-riesenfeld", ",\"degree\":" + std::to_string(degree)));
        expectReadable(trace);
        // the beginning, doubling, d - 1 averagings, the level
        ASSERT_EQ(trace.frames.size(), 2 + static_cast<std::size_t>(degree));
        const std::string name = "d" + std::to_string(degree) + "_k1";
        auto ring = test::planarPoints(test::truth("LR")[name]);
        ring.pop_back();
        EXPECT_TRUE(sameRing(trace.frames.back().points, ring)) << name;
    }
}

TEST(TraceLaneRiesenfeld, HasItsMaskAndItsCountsAtEveryLevel) {
    const Trace closed = traced(onSquare("lane-riesenfeld", R"(,"levels":3)"));
    EXPECT_EQ(closed.frames.back().points.size(), 32u);
    EXPECT_EQ(closed.frames.back().weights, (std::vector<double>{0.125, 0.5, 0.75, 0.5, 0.125}));
    EXPECT_EQ(closed.frames.size(), 1u + 3 * 4);
    const Trace open = traced(R"({"algorithm":"lane-riesenfeld","degree":2,
        "points":[[0,0],[1,0],[1,1],[0,1]]})");
    EXPECT_EQ(open.frames.back().points.size(), 6u);
    EXPECT_LE(distance(open.frames.back().points[0], {0.25, 0, 0}), test::gates::exact);
    EXPECT_EQ(open.frames[2].text,
              "Averaging pass 1 of 1 at level 1: the 6 middles of the legs take the place of the 7 "
              "points and raise the degree to 2; the first one is (0.25, 0).");
}

TEST(TraceLaneRiesenfeld, IsKnotInsertionIntoTheUniformSpline) {
    RandomSplines random(707);
    for (int degree = 1; degree <= 6; ++degree) {
        Json points = Json::array();
        for (int i = 0; i < degree + 3; ++i) {
            points.push_back(Json::array({random.real(-1, 1), random.real(-1, 1)}));
        }
        for (const bool closed : {false, true}) {
            const double d = degree;
            Json curve{{"type", "bspline-curve"}, {"degree", d},
                       {"form", closed ? "closed" : "open"}, {"points", points}};
            BsplineCurve spline = *makeCurve(curve)->value.as<BsplineCurve>();
            const std::vector<double> given(spline.knotVector().knots().begin(),
                                            spline.knotVector().knots().end());
            const Interval domain = spline.domain();
            for (double t = domain.start + 0.5; t < domain.end; ++t) {
                spline = insertKnot(spline, t, 1).value();
            }
            const auto found = traced(Json{{"algorithm", "lane-riesenfeld"}, {"points", points},
                                           {"closed", closed}, {"degree", d}})
                                   .frames.back()
                                   .points;
            if (closed) {
                EXPECT_TRUE(sameRing(found, {spline.points().begin(), spline.points().end()}));
            } else {
                // Insertion leaves the d - 1 end points; between them the polygons are the same.
                const auto inner = static_cast<std::size_t>(degree - 1);
                ASSERT_EQ(found.size(), 2u * points.size() - static_cast<std::size_t>(degree));
                for (std::size_t i = inner / 2 + inner; i + 2 * inner < found.size(); ++i) {
                    double nearest = 1;
                    for (const Vec3& p : spline.points()) {
                        nearest = std::min(nearest, distance(p, found[i]));
                    }
                    EXPECT_LE(nearest, test::gates::exact) << degree << ": " << i;
                }
            }
        }
    }
}

TEST(TraceSubdivision, EndsWithTheFinalPolygonOfTheLibraryInItsOrder) {
    RandomSplines random(708);
    for (int i = 0; i < 40; ++i) {
        CurveSubdivision subdivision{.points = {}};
        subdivision.scheme = i % 4 == 0 ? CurveScheme::fourPoint : CurveScheme::laneRiesenfeld;
        subdivision.closed = i % 2 == 0;
        subdivision.levels = 1 + i % 3;
        subdivision.degree = random.integer(1, 6);
        subdivision.tension = random.real(-0.1, 0.2);
        Json points = Json::array();
        for (int k = 0; k < 8; ++k) {
            subdivision.points.emplace_back(random.real(-1, 1), random.real(-1, 1), random.real(0, 1));
            points.push_back(pointJson(subdivision.points.back(), 3));
        }
        const bool fourPoint = subdivision.scheme == CurveScheme::fourPoint;
        Json arguments{{"algorithm", fourPoint ? "four-point" : "lane-riesenfeld"},
                       {"points", points}, {"closed", subdivision.closed},
                       {"levels", static_cast<double>(subdivision.levels)}};
        if (fourPoint) arguments["tension"] = subdivision.tension;
        if (!fourPoint) arguments["degree"] = static_cast<double>(subdivision.degree);
        const FinalPolygon polygon(subdivision);
        std::vector<double> xyz(3 * polygon.size());
        polygon.points(0, xyz);
        const Trace trace = traced(arguments);
        expectReadable(trace);
        const std::vector<Vec3>& found = trace.frames.back().points;
        ASSERT_EQ(found.size(), polygon.size());
        for (std::size_t k = 0; k < found.size(); ++k) {
            EXPECT_LE(distance(found[k], {xyz[3 * k], xyz[3 * k + 1], xyz[3 * k + 2]}),
                      test::gates::exact)
                << k;
        }
    }
}

TEST(TraceFourPoint, EndsWithTheRingOfTheTruth) {
    const Trace trace = traced(onSquare("four-point"));
    expectReadable(trace);
    ASSERT_EQ(trace.frames.size(), 3u);
    EXPECT_TRUE(sameRing(trace.frames.back().points, test::planarPoints(test::truth("fourpoint_sq")["k1"])));
    EXPECT_EQ(trace.frames[1].weights, (std::vector<double>{-0.0625, 0.5625, 0.5625, -0.0625}));
    EXPECT_EQ(trace.frames[1].text,
              "New points at level 1: the two ends of each leg count 0.5625 each and their outer "
              "neighbours -0.0625 each, which makes 4 new points; the first one is (0.5, -0.125).");
}

TEST(TraceFourPoint, ReflectsAtOpenEnds) {
    const Trace trace = traced(R"({"algorithm":"four-point","points":[[0,0],[1,1],[3,0]],
        "tension":0.1,"levels":2})");
    expectReadable(trace);
    EXPECT_EQ(trace.frames.back().points.size(), 9u);
    // (1/2 + w)(P0 + P1) - w (2 P0 - P1 + P2)
    EXPECT_LE(distance(trace.frames[1].points[3], {0.6 - 0.2, 0.6 + 0.1, 0}), test::gates::exact);
    const Trace straight = traced(
        R"({"algorithm":"four-point","points":[[0,0],[2,2]],"tension":-1})");
    EXPECT_LE(distance(straight.frames.back().points[1], {1, 1, 0}), test::gates::exact);
}

}  // namespace
}  // namespace knotwork::scene
