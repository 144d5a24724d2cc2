#include "render/line_clip.hpp"
#include "render/line_vertices.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace knotwork::render {
namespace {

constexpr Rect pane{0, 0, 200, 100};

/// World units are pixels from the middle of the pane.
Projection pixels() { return Projection::flat(pane, Vec3(0.0), 1, 1); }

std::vector<LineVertex> stroked(const std::vector<double>& positions, const LineStyle& style = {}) {
    LineVertices vertices;
    vertices.polyline(pixels(), positions, style);
    return vertices.records();
}

/// The segments that the program will draw: windows of four records whose middle two lie on a run.
int drawnSegments(const std::vector<LineVertex>& records) {
    int count = 0;
    for (std::size_t i = 0; i + 3 < records.size(); ++i) {
        if (records[i + 1].arc >= 0 && records[i + 2].arc >= 0) ++count;
    }
    return count;
}

std::vector<double> circle(double radius, int corners) {
    std::vector<double> points;
    for (int i = 0; i <= corners; ++i) {
        const double angle = 2 * std::numbers::pi * (i % corners) / corners;
        points.insert(points.end(), {radius * std::cos(angle), radius * std::sin(angle), 0});
    }
    return points;
}

TEST(LineVertices, AnOpenLineHasCapsAtBothEnds) {
    const auto records = stroked({-10, 0, 0, 0, 5, 0, 10, 0, 0});
    ASSERT_EQ(records.size(), 5U);
    EXPECT_EQ(records.front().arc, noNeighbour);
    EXPECT_EQ(records.back().arc, noNeighbour);
    EXPECT_EQ(drawnSegments(records), 2);
}

TEST(LineVertices, AClosedLineKnowsItsNeighboursWhereItCloses) {
    const auto records = stroked({-10, 0, 0, 0, 10, 0, 10, 0, 0, -10, 0, 0});
    ASSERT_EQ(records.size(), 6U);
    EXPECT_EQ(records.front().arc, neighbourOnly);
    EXPECT_EQ(records.front().x, 10);
    EXPECT_EQ(records.back().arc, neighbourOnly);
    EXPECT_EQ(records.back().y, 10);
    EXPECT_EQ(drawnSegments(records), 3);
}

TEST(LineVertices, TwoLinesInOneBatchAreNotJoined) {
    LineVertices vertices;
    vertices.polyline(pixels(), std::vector<double>{-10, 0, 0, 0, 0, 0}, {});
    vertices.polyline(pixels(), std::vector<double>{0, 20, 0, 10, 20, 0}, {});
    EXPECT_EQ(drawnSegments(vertices.records()), 2);
}

TEST(LineVertices, APointAloneIsADot) {
    EXPECT_EQ(drawnSegments(stroked({3, 4, 0})), 1);
    EXPECT_EQ(drawnSegments(stroked({3, 4, 0, 3, 4, 0, 3, 4, 0})), 1);
    EXPECT_TRUE(stroked({}).empty());
}

TEST(LineVertices, PointsThatNobodyCanTellApartAreLeftOut) {
    std::vector<double> dense;
    for (int i = 0; i <= 10000; ++i) dense.insert(dense.end(), {i * 0.005, 0, 0});
    const auto records = stroked(dense);
    EXPECT_LT(records.size(), 210U);
    EXPECT_NEAR(records[records.size() - 2].x, 50, 0.25);
}

TEST(LineVertices, ALineIsClippedJustOutsideThePane) {
    const auto records = stroked({-1e6, 10, 0, 1e6, 10, 0}, {.width = 4});
    ASSERT_EQ(records.size(), 4U);
    EXPECT_NEAR(records[1].x, -104, 1e-3);
    EXPECT_NEAR(records[2].x, 104, 1e-3);
    EXPECT_EQ(records[1].y, 10);
}

TEST(LineVertices, ALineThatLeavesAndComesBackIsTwoRuns) {
    const auto records = stroked({0, 0, 0, 500, 0, 0, 500, 40, 0, 0, 40, 0});
    EXPECT_EQ(drawnSegments(records), 2);
}

TEST(LineVertices, ALineOutsideThePaneCostsNothing) {
    EXPECT_TRUE(stroked({-500, 80, 0, 500, 80, 0}).empty());
}

TEST(LineVertices, APointWithoutImageBreaksTheLine) {
    const double none = std::nan("");
    EXPECT_EQ(drawnSegments(stroked({-20, 0, 0, -10, 0, 0, none, 0, 0, 10, 0, 0, 20, 0, 0})), 2);
}

TEST(LineVertices, ArcLengthIsMeasuredInPixelsAlongTheLine) {
    const auto records = stroked({0, 0, 0, 30, 40, 0, 30, 45, 0}, {.width = 2, .period = 1000});
    ASSERT_EQ(records.size(), 5U);
    EXPECT_EQ(records[1].arc, 0);
    EXPECT_EQ(records[2].arc, 50);
    EXPECT_EQ(records[3].arc, 55);
}

TEST(LineVertices, DashesStayOnTheLineWhenItIsPannedOutOfThePane) {
    // entering the pane at x = -103 is 897 pixels after the start: 7 pixels into a period of 10
    const auto records = stroked({-1000, 0, 0, 50, 0, 0}, {.width = 2, .period = 10});
    ASSERT_EQ(records.size(), 4U);
    EXPECT_NEAR(records[1].arc, 7, 1e-4);
    EXPECT_NEAR(records[2].arc - records[1].arc, 153, 1e-4);
}

TEST(LineVertices, ArcLengthStaysExactAMillionPixelsAlong) {
    const auto records = stroked({-1e9, 0, 0, 50, 0, 0}, {.width = 2, .period = 10});
    ASSERT_EQ(records.size(), 4U);
    EXPECT_GE(records[1].arc, 0);
    EXPECT_LT(records[1].arc, 10);
    EXPECT_NEAR(records[1].arc, 7, 1e-3);
}

TEST(LineVertices, AClosedLineHasAWholeNumberOfDashes) {
    const auto points = circle(40, 90);
    const auto records = stroked(points, {.width = 2, .period = 10});
    const double length = 90 * 2 * 40 * std::sin(std::numbers::pi / 90);
    const double dashes = length / static_cast<double>(records[1].period);
    EXPECT_NEAR(dashes, std::round(dashes), 1e-4);
    EXPECT_NEAR(static_cast<double>(records[1].period), 10, 0.5);
}

TEST(LineVertices, ThinLinesHaveNoShorterDashesThanOneCanSee) {
    EXPECT_EQ(dashPeriod(0.5, 1), 9);
    EXPECT_EQ(dashPeriod(0.5, 2), 18);
    EXPECT_EQ(dashPeriod(5, 2), 40);
}

TEST(LineVertices, CrispSegmentsLieBetweenPixels) {
    LineVertices vertices;
    const std::vector<double> cross{-20, 10.3, 0, 20, 10.3, 0, 7.9, -5, 0, 7.9, 5, 0};
    vertices.segments(pixels(), cross, {.width = 1.2, .crisp = true});
    ASSERT_EQ(vertices.records().size(), 8U);
    EXPECT_EQ(vertices.records()[1].width, 1);
    EXPECT_EQ(vertices.records()[1].y, 10.5F);
    EXPECT_EQ(vertices.records()[2].y, 10.5F);
    EXPECT_EQ(vertices.records()[5].x, 7.5F);
}

TEST(LineVertices, CrispSegmentsOfEvenWidthLieOnPixelBorders) {
    LineVertices vertices;
    vertices.segments(pixels(), std::vector<double>{-20, 10.3, 0, 20, 10.3, 0},
                      {.width = 2, .crisp = true});
    EXPECT_EQ(vertices.records()[1].y, 10);
}

TEST(ClipSegment, KeepsWhatLiesInside) {
    const auto part = clipSegment({-10, 0, 0}, {10, 0, 0}, 5, 5);
    ASSERT_TRUE(part);
    EXPECT_DOUBLE_EQ(part->first, 0.25);
    EXPECT_DOUBLE_EQ(part->second, 0.75);
}

TEST(ClipSegment, RefusesACornerThatIsOnlyPassed) {
    EXPECT_FALSE(clipSegment({0, 11, 0}, {11, 0, 0}, 5, 5));
    EXPECT_FALSE(clipSegment({6, -1, 0}, {6, 1, 0}, 5, 5));
}

}  // namespace
}  // namespace knotwork::render
