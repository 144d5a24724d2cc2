#include "drawing/curvature_colours.hpp"
#include "ui/legend.hpp"

#include <gtest/gtest.h>

namespace knotwork::ui {
namespace {

constexpr Box pane{10, 20, 600, 400};

TEST(Legend, ABarRunsFromTheOneEndOfItsRangeToTheOther) {
    const Plot plot = curvatureLegend(pane, 0, "K  s", 0.25, theme(ThemeName::light));
    ASSERT_EQ(plot.labels.size(), 4U);
    EXPECT_EQ(plot.labels[0].text, "K  s");
    EXPECT_FALSE(plot.labels[0].number);
    EXPECT_EQ(plot.labels[1].text, "−0.25");
    EXPECT_EQ(plot.labels[2].text, "0");
    EXPECT_EQ(plot.labels[3].text, "0.25");
    EXPECT_NEAR(plot.labels[2].at.x, plot.box.centre().x, 1e-9);
    EXPECT_GT(plot.under.front().colour.blue, plot.under.front().colour.red);
    EXPECT_GT(plot.under.back().colour.red, plot.under.back().colour.blue);
    for (const Label& label : plot.labels) EXPECT_TRUE(pane.contains(label.at));
}

TEST(Legend, ASecondBarStandsAboveTheFirst) {
    const Theme& colours = theme(ThemeName::dark);
    const Plot first = curvatureLegend(pane, 0, "K", 1234, colours);
    const Plot second = curvatureLegend(pane, 1, "H", 0.00123, colours);
    EXPECT_LT(second.labels[3].at.y + 6, first.labels[0].at.y - 6);
    EXPECT_EQ(first.labels[3].text, "1234");
    EXPECT_EQ(second.labels[3].text, "0.0012");
}

}  // namespace
}  // namespace knotwork::ui
