#include "ui/layout.hpp"

#include <algorithm>

namespace knotwork::ui {

namespace {

constexpr double leastBasis = 90;
constexpr double leastBFunction = 150;
constexpr double leastCurve = 150;
constexpr double leastSideBySide = 600;  // width of a figure
constexpr double leastHodograph = 130;   // both ways
constexpr double hodographShare = 0.4;   // of the longer side of the curve's box

double knotHeight(const WantedPanes& wanted) noexcept {
    return 52 + 13.0 * std::clamp(wanted.knotRows, 1, 5);
}

double leastHeight(const WantedPanes& wanted) noexcept {
    return (wanted.basis ? leastBasis : 0) + (wanted.knots ? knotHeight(wanted) : 0) +
           (wanted.bFunction ? leastBFunction : 0);
}

bool plotsWanted(const WantedPanes& wanted) noexcept {
    return wanted.basis || wanted.knots || wanted.bFunction;
}

/// Drops panes until the rest has room in this height.
WantedPanes reduced(WantedPanes wanted, double height) noexcept {
    if (leastHeight(wanted) > height && (wanted.curve || wanted.basis || wanted.knots)) {
        wanted.bFunction = false;
    }
    if (leastHeight(wanted) > height && (wanted.curve || wanted.knots)) wanted.basis = false;
    if (leastHeight(wanted) > height && wanted.curve) wanted.knots = false;
    return wanted;
}

/// Basis, knots and B-function from top to bottom of a column.
void stack(FigureLayout& layout, const Box& column, const WantedPanes& wanted) noexcept {
    const double flexible = column.height - (wanted.knots ? knotHeight(wanted) : 0);
    const int sharers = (wanted.basis ? 1 : 0) + (wanted.bFunction ? 1 : 0);
    const double share = sharers > 0 ? flexible / sharers : 0;
    double y = column.y;
    const auto take = [&](double height) {
        const Box box{column.x, y, column.width, height};
        y += height;
        return box;
    };
    if (wanted.basis) layout.basis = take(share);
    if (wanted.knots) layout.knots = take(sharers > 0 ? knotHeight(wanted) : column.height);
    if (wanted.bFunction) layout.bFunction = take(share);
}

/// How tall the curve's picture is in its box.
double curveHeight(const FigureLayout& layout, const WantedPanes& wanted) noexcept {
    return std::min(layout.curve->width / wanted.curveAspect, layout.curve->height);
}

FigureLayout sideBySide(const Box& figure, WantedPanes wanted) noexcept {
    FigureLayout layout;
    wanted = reduced(wanted, figure.height);
    const bool onlyKnots = wanted.knots && !wanted.basis && !wanted.bFunction;
    if (onlyKnots || !plotsWanted(wanted)) {
        const double knots = wanted.knots ? knotHeight(wanted) : 0;
        layout.curve = Box{figure.x, figure.y, figure.width, figure.height - knots};
        if (onlyKnots) layout.knots = Box{figure.x, layout.curve->bottom(), figure.width, knots};
        return layout;
    }
    const double left = figure.width * (wanted.bFunction ? 0.52 : 0.58);
    layout.curve = Box{figure.x, figure.y, left, figure.height};
    stack(layout, {figure.x + left, figure.y, figure.width - left, figure.height}, wanted);
    return layout;
}

FigureLayout stacked(const Box& figure, WantedPanes wanted) noexcept {
    FigureLayout layout;
    wanted = reduced(wanted, figure.height - std::min(leastCurve, figure.height));
    double plots = plotsWanted(wanted) ? std::max(leastHeight(wanted), figure.height * 0.46) : 0;
    if (wanted.knots && !wanted.basis && !wanted.bFunction) plots = knotHeight(wanted);
    layout.curve = Box{figure.x, figure.y, figure.width, figure.height - plots};
    stack(layout, {figure.x, layout.curve->bottom(), figure.width, plots}, wanted);
    return layout;
}

/// The curve's box parted with the hodograph, where it is large enough for both.
FigureLayout withHodograph(FigureLayout layout, bool curve) noexcept {
    if (!layout.curve) return layout;
    Box& box = *layout.curve;
    if (!curve) {
        layout.hodograph = box;
        layout.curve.reset();
        return layout;
    }
    const bool beside = box.width >= box.height;
    const double across = beside ? box.height : box.width;
    const double share = std::min(hodographShare * (beside ? box.width : box.height), across);
    if (share < leastHodograph || across < leastHodograph) return layout;
    if (beside) {
        box.width -= share;
        layout.hodograph = Box{box.right(), box.y, share, box.height};
    } else {
        box.height -= share;
        layout.hodograph = Box{box.x, box.bottom(), box.width, share};
    }
    return layout;
}

}  // namespace

FigureLayout layoutFigure(const Box& figure, const WantedPanes& wanted) noexcept {
    if (wanted.hodograph) {
        WantedPanes others = wanted;
        others.hodograph = false;
        others.curve = true;
        return withHodograph(layoutFigure(figure, others), wanted.curve);
    }
    if (!wanted.curve && plotsWanted(wanted)) {
        FigureLayout layout;
        stack(layout, figure, reduced(wanted, figure.height));
        return layout;
    }
    WantedPanes withCurve = wanted;
    withCurve.curve = true;
    FigureLayout below = stacked(figure, withCurve);
    if (figure.width < leastSideBySide) return below;
    FigureLayout beside = sideBySide(figure, withCurve);
    return curveHeight(beside, wanted) > curveHeight(below, wanted) ? beside : below;
}

}  // namespace knotwork::ui
