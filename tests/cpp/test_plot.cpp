#include "ui/basis_plot.hpp"
#include "ui/bfunction_plot.hpp"
#include "ui/knot_line.hpp"
#include "ui/layout.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace knotwork::ui {
namespace {

const Theme& light() { return theme(ThemeName::light); }

std::vector<std::string> texts(const std::vector<Tick>& ticks) {
    std::vector<std::string> all;
    for (const Tick& tick : ticks) all.push_back(tick.text);
    return all;
}

bool inside(const Box& inner, const Box& outer) {
    return inner.x >= outer.x - 1e-9 && inner.y >= outer.y - 1e-9 &&
           inner.right() <= outer.right() + 1e-9 && inner.bottom() <= outer.bottom() + 1e-9;
}

const Label* labelWith(const std::vector<Plot>& plots, const std::string& part) {
    for (const Plot& plot : plots) {
        for (const Label& label : plot.labels) {
            if (label.text.find(part) != std::string::npos) return &label;
        }
    }
    return nullptr;
}

TEST(Ticks, StandAtRoundNumbers) {
    EXPECT_EQ(texts(niceTicks({0, 1}, 5)), (std::vector<std::string>{"0", "0.2", "0.4", "0.6", "0.8", "1"}));
    EXPECT_EQ(texts(niceTicks({-3, 7}, 4)), (std::vector<std::string>{"0", "5"}));
    EXPECT_EQ(texts(niceTicks({-1, 1}, 2)), (std::vector<std::string>{"−1", "0", "1"}));
}

TEST(Ticks, AreNeverMoreThanStepsAskedForAndOne) {
    for (double length = 1e-6; length < 1e6; length *= 1.37) {
        for (int most = 1; most < 12; ++most) {
            const auto ticks = niceTicks({-0.3 * length, 0.7 * length}, most);
            EXPECT_LE(ticks.size(), static_cast<std::size_t>(most) + 1) << length << ' ' << most;
            EXPECT_GE(niceStep(length, most) * most, length * (1 - 1e-6));
        }
    }
}

TEST(Ticks, NameNumbersAsPeopleWriteThem) {
    EXPECT_EQ(numberText(-0.5, 2), "−0.5");
    EXPECT_EQ(numberText(-0.0001, 2), "0");
    EXPECT_EQ(numberText(20, 0), "20");
    EXPECT_EQ(numberText(2.5e9, 3), "2.5e+09");
}

TEST(PlaneMap, GoesThereAndBack) {
    const PlaneMap map = mapOnto({10, 20, 300, 100}, {-1, 2}, {0, 4});
    EXPECT_NEAR(map.pixelX(-1), 10, 1e-12);
    EXPECT_NEAR(map.pixelY(0), 120, 1e-12);
    EXPECT_NEAR(map.pixelY(4), 20, 1e-12);
    const Vec3 p = map.fromPixels(map.toPixels({0.3, 1.7, 0}));
    EXPECT_NEAR(p.x, 0.3, 1e-12);
    EXPECT_NEAR(p.y, 1.7, 1e-12);
}

TEST(Layout, PutsTheBasisStraightAboveItsKnotLine) {
    for (const Box& figure : {Box{0, 0, 1280, 720}, Box{0, 0, 390, 600}, Box{0, 0, 700, 900}}) {
        const FigureLayout layout = layoutFigure(figure, {true, true, true, true, 4});
        ASSERT_TRUE(layout.curve && layout.basis && layout.knots);
        EXPECT_EQ(layout.basis->x, layout.knots->x);
        EXPECT_EQ(layout.basis->width, layout.knots->width);
        EXPECT_NEAR(layout.basis->bottom(), layout.knots->y, 1e-9);
        for (const auto& box : {layout.curve, layout.basis, layout.knots, layout.bFunction}) {
            EXPECT_TRUE(!box || inside(*box, figure));
        }
    }
}

TEST(Layout, GivesTheCurveTheLargestBox) {
    for (const Box& figure : {Box{0, 0, 1280, 720}, Box{0, 0, 390, 600}}) {
        const FigureLayout layout = layoutFigure(figure, {true, true, true, false, 4});
        ASSERT_TRUE(layout.curve && layout.basis);
        EXPECT_GT(layout.curve->width * layout.curve->height,
                  layout.basis->width * layout.basis->height);
    }
}

TEST(Layout, DropsPlotsThatWouldLeaveNoRoomForTheCurve) {
    const FigureLayout tiny = layoutFigure({0, 0, 320, 180}, {true, true, true, true, 4});
    ASSERT_TRUE(tiny.curve);
    EXPECT_GE(tiny.curve->height, 150);
    EXPECT_FALSE(tiny.basis || tiny.bFunction);
}

TEST(Layout, FillsTheFigureWithWhatThereIs) {
    const Box figure{0, 0, 900, 500};
    EXPECT_EQ(*layoutFigure(figure, {}).curve, figure);
    const FigureLayout only = layoutFigure(figure, {false, false, false, true, 1});
    EXPECT_FALSE(only.curve);
    EXPECT_EQ(*only.bFunction, figure);
}

TEST(Layout, PartsTheBoxOfTheCurveWithTheHodographWhereThereIsRoom) {
    WantedPanes wanted;
    wanted.hodograph = true;
    const FigureLayout wide = layoutFigure({0, 0, 900, 500}, wanted);
    ASSERT_TRUE(wide.curve && wide.hodograph);
    EXPECT_EQ(wide.curve->right(), wide.hodograph->x);
    EXPECT_NEAR(wide.curve->width + wide.hodograph->width, 900, 1e-9);
    EXPECT_GT(wide.curve->width, wide.hodograph->width);
    const FigureLayout tall = layoutFigure({0, 0, 390, 700}, wanted);
    ASSERT_TRUE(tall.curve && tall.hodograph);
    EXPECT_EQ(tall.curve->bottom(), tall.hodograph->y);
    EXPECT_FALSE(layoutFigure({0, 0, 300, 120}, wanted).hodograph);
    wanted.curve = false;
    EXPECT_EQ(*layoutFigure({0, 0, 900, 500}, wanted).hodograph, (Box{0, 0, 900, 500}));
    wanted.basis = wanted.knots = true;
    const FigureLayout withPlots = layoutFigure({0, 0, 900, 700}, wanted);
    EXPECT_TRUE(!withPlots.curve && withPlots.hodograph && withPlots.basis && withPlots.knots);
}

TEST(KnotLine, PilesEqualKnotsUp) {
    EXPECT_EQ(pileRows({0, 0, 0, 1, 2, 2}), (std::vector<int>{0, 1, 2, 0, 0, 1}));
    EXPECT_EQ(tallestPile({0, 0, 0, 1, 2, 2}), 3);
    EXPECT_EQ(tallestPile({}), 1);
}

TEST(KnotLine, KeepsEveryHandleInsideItsBox) {
    for (int rows = 1; rows < 27; ++rows) {
        const Box box{0, 100, 400, 117};
        const KnotLineContent content{std::vector<double>(static_cast<std::size_t>(rows), 2.0),
                                      {0, 5}};
        const Plot plot = knotLine(box, parameterAxis(box, {0, 5}), content, light());
        EXPECT_GE(plot.map.pixelY(rows - 1) - 6, box.y);
        EXPECT_LT(plot.map.pixelY(0) + 6, box.bottom());
    }
}

TEST(KnotLine, SharesItsAxisWithTheBasisToTheBit) {
    const Box knots{500, 600, 700, 104};
    const ParameterAxis axis = parameterAxis(knots, {-0.37, 6.01});
    const Plot line = knotLine(knots, axis, {{0, 1, 2}, {0, 2}}, light());
    const Plot basis = basisPlot({500, 300, 700, 300}, axis, {{0, 0.8}, {0, 1, 2}}, false, light());
    for (const double t : {-0.37, 0.0, 1.234567, 6.01}) {
        EXPECT_NEAR(line.map.pixelX(t), basis.map.pixelX(t), 1e-10);
    }
}

TEST(BasisPlot, ShowsZeroToOneWhateverIsDrawn) {
    const Box box{0, 0, 500, 300};
    const Plot plot = basisPlot(box, parameterAxis(box, {0, 1}), {{0, 0.6}, {}}, true, light());
    EXPECT_NEAR(plot.map.pixelY(0), plot.area.bottom(), 1e-9);
    EXPECT_NEAR(plot.map.pixelY(1), plot.area.y, 1e-9);
}

TEST(BFunctionPlot, GivesEveryDerivativeARowOfItsOwn) {
    const Box box{0, 0, 500, 600};
    const auto plots = bFunctionPlots(box, {{{0, 1}, {0, 2}, {-9.3, 9.3}}}, light());
    ASSERT_EQ(plots.size(), 3u);
    EXPECT_GT(plots[0].area.height, plots[1].area.height);
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(plots[k].index, static_cast<int>(k));
        EXPECT_EQ(plots[k].area.x, plots[0].area.x);
        EXPECT_TRUE(inside(plots[k].area, plots[k].box));
        EXPECT_NEAR(plots[k].box.y, k > 0 ? plots[k - 1].box.bottom() : box.y, 1e-9);
    }
    EXPECT_LE(plots[2].map.unitY(plots[2].area.bottom()), -9.3);
    EXPECT_GE(plots[2].map.unitY(plots[2].area.y), 9.3);
}

TEST(BFunctionPlot, KeepsBWhereThereIsRoomForNothingElse) {
    const auto plots = bFunctionPlots({0, 0, 300, 150}, {{{0, 1}, {0, 2}, {-6, 6}}}, light());
    ASSERT_EQ(plots.size(), 1u);
    EXPECT_EQ(plots[0].index, 0);
}

TEST(BFunctionPlot, SaysTheHermiteOrderAtBothEnds) {
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(orderText("orden {0} ved 0, {1} ved 1", {infinite, 2}), "orden ∞ ved 0, 2 ved 1");
    const auto plots = bFunctionPlots({0, 0, 500, 600}, {{{0, 1}}, {1, infinite}}, light());
    EXPECT_NE(labelWith(plots, "order 1 at 0, ∞ at 1"), nullptr);
}

TEST(BFunctionPlot, NamesDerivativesAsOneWritesThem) {
    EXPECT_EQ(derivativeName(0), "B");
    EXPECT_EQ(derivativeName(2), "B″");
    EXPECT_EQ(derivativeName(4), "B⁽⁴⁾");
}

TEST(BFunctionPlot, AVanishingDerivativeIsALineAndNotNoise) {
    const Interval range = rowInterval({-3e-15, 2e-15});
    EXPECT_EQ(range, (Interval{-1, 1}));
    EXPECT_EQ(rowInterval({0.5, 2}), (Interval{0, 2.12}));
}

TEST(Label, StandsBesideOrOnItsPlaceAsItIsAligned) {
    const Box left = boxOf({"0.5", {100, 50}, Align::left, Baseline::top, 10, false, {}});
    EXPECT_EQ(left, (Box{100, 50, 18, 10}));
    const Box right = boxOf({"0.5", {100, 50}, Align::right, Baseline::bottom, 10, false, {}});
    EXPECT_EQ(right, (Box{82, 40, 18, 10}));
    const Box centre = boxOf({"0.5", {100, 50}, Align::centre, Baseline::middle, 10, false, {}});
    EXPECT_EQ(centre, (Box{91, 45, 18, 10}));
}

}  // namespace
}  // namespace knotwork::ui
