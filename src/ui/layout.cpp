#include "ui/layout.hpp"

#include <algorithm>

namespace knotwork::ui {

namespace {

constexpr double leastBasis = 90;      // and as much for the curvature
constexpr double leastBFunction = 150;
constexpr double leastCurve = 150;
constexpr double leastColumn = 240;      // of plots beside the curve
constexpr double leastSideBySide = 600;  // width of a figure
constexpr double leastHodograph = 130;   // both ways
constexpr double hodographShare = 0.4;   // of the longer side of the curve's box

double knotHeight(const WantedPanes& wanted) noexcept {
    return wanted.knots ? 52 + 13.0 * std::clamp(wanted.knotRows, 1, 5) : 0;
}

/// Of what has a parameter of the curve on its axis.
double leastParameterPlots(const WantedPanes& wanted) noexcept {
    return (wanted.curvature ? leastBasis : 0) + (wanted.basis ? leastBasis : 0) +
           knotHeight(wanted);
}

double leastHeight(const WantedPanes& wanted) noexcept {
    return leastParameterPlots(wanted) + (wanted.bFunction ? leastBFunction : 0);
}

bool plotsWanted(const WantedPanes& wanted) noexcept {
    return wanted.basis || wanted.knots || wanted.bFunction || wanted.curvature;
}

bool onlyKnotsWanted(const WantedPanes& wanted) noexcept {
    return wanted.knots && !wanted.basis && !wanted.bFunction && !wanted.curvature;
}

/// Drops panes until the rest has room in this height; what matters most stays in any.
WantedPanes reduced(WantedPanes wanted, double height) noexcept {
    const auto crowded = [&] { return leastHeight(wanted) > height; };
    const bool parameters = wanted.basis || wanted.knots;
    if (crowded() && (wanted.curve || parameters || wanted.curvature)) wanted.bFunction = false;
    if (crowded() && (wanted.curve || parameters)) wanted.curvature = false;
    if (crowded() && (wanted.curve || wanted.knots)) wanted.basis = false;
    if (crowded() && wanted.curve) wanted.knots = false;
    return wanted;
}

/// A box that is parted in two.
struct Parting {
    SeamName name = SeamName::plots;
    Box whole;
    bool upright = false;
    double normal = 0;       ///< pixels left of the seam or above it
    double leastBefore = 0;
    double leastAfter = 0;
};

struct Parts {
    Box before;
    Box after;
};

/// Where the seam is wanted, but for what both sides need.
Parts part(FigureLayout& layout, const Parting& parting, const Shares& shares) noexcept {
    const Box& whole = parting.whole;
    const double length = std::max(1.0, parting.upright ? whole.width : whole.height);
    Seam seam;
    seam.upright = parting.upright;
    seam.length = length;
    seam.normal = parting.normal / length;
    seam.least = std::min(parting.leastBefore / length, seam.normal);
    seam.most = std::max(1 - parting.leastAfter / length, seam.normal);
    const auto& wanted = shares[static_cast<std::size_t>(parting.name)];
    seam.share = wanted ? std::clamp(*wanted, seam.least, seam.most) : seam.normal;
    const double before = wanted ? seam.share * length : parting.normal;
    Parts parts{whole, whole};
    if (parting.upright) {
        parts.before.width = before;
        parts.after.x += before;
        parts.after.width -= before;
        seam.at = {parts.after.x, whole.y, 0, whole.height};
    } else {
        parts.before.height = before;
        parts.after.y += before;
        parts.after.height -= before;
        seam.at = {whole.x, parts.after.y, whole.width, 0};
    }
    layout.seams[static_cast<std::size_t>(parting.name)] = seam;
    return parts;
}

/// Curvature, basis functions and knots from top to bottom.
void stackParameterPlots(FigureLayout& layout, Box column, const WantedPanes& wanted,
                         const Shares& shares) noexcept {
    const double knots = knotHeight(wanted);
    if (wanted.curvature && wanted.basis) {
        const Parts parts = part(layout, {SeamName::curvature, column, false,
                                          (column.height - knots) / 2, leastBasis,
                                          leastBasis + knots}, shares);
        layout.curvature = parts.before;
        column = parts.after;
    }
    Box above = column;
    if (wanted.basis || wanted.curvature) {
        above.height -= knots;
        (wanted.basis ? layout.basis : layout.curvature) = above;
        column.y = above.bottom();
        column.height = knots;
    }
    if (wanted.knots) layout.knots = column;
}

/// All plots from top to bottom of a column.
void stack(FigureLayout& layout, const Box& column, const WantedPanes& wanted,
           const Shares& shares) noexcept {
    if (!wanted.bFunction) return stackParameterPlots(layout, column, wanted, shares);
    if (!wanted.basis && !wanted.knots && !wanted.curvature) {
        layout.bFunction = column;
        return;
    }
    const int sharers = 1 + int{wanted.basis} + int{wanted.curvature};
    const double share = (column.height - knotHeight(wanted)) / sharers;
    const Parts parts = part(layout, {SeamName::bFunction, column, false, column.height - share,
                                      leastParameterPlots(wanted), leastBFunction}, shares);
    layout.bFunction = parts.after;
    stackParameterPlots(layout, parts.before, wanted, shares);
}

/// How tall the curve's picture is in its box.
double curveHeight(const FigureLayout& layout, const WantedPanes& wanted) noexcept {
    return std::min(layout.curve->width / wanted.curveAspect, layout.curve->height);
}

/// The curve with nothing but its knot line, or alone.
FigureLayout overKnots(const Box& figure, const WantedPanes& wanted) noexcept {
    FigureLayout layout;
    const double knots = knotHeight(wanted);
    layout.curve = Box{figure.x, figure.y, figure.width, figure.height - knots};
    if (wanted.knots) layout.knots = Box{figure.x, layout.curve->bottom(), figure.width, knots};
    return layout;
}

FigureLayout sideBySide(const Box& figure, WantedPanes wanted, const Shares& shares) noexcept {
    wanted = reduced(wanted, figure.height);
    if (onlyKnotsWanted(wanted) || !plotsWanted(wanted)) return overKnots(figure, wanted);
    FigureLayout layout;
    const double left = figure.width * (wanted.bFunction ? 0.52 : 0.58);
    const Parts parts =
        part(layout, {SeamName::plots, figure, true, left, leastCurve, leastColumn}, shares);
    layout.curve = parts.before;
    stack(layout, parts.after, wanted, shares);
    return layout;
}

FigureLayout stacked(const Box& figure, WantedPanes wanted, const Shares& shares) noexcept {
    wanted = reduced(wanted, figure.height - std::min(leastCurve, figure.height));
    if (onlyKnotsWanted(wanted) || !plotsWanted(wanted)) return overKnots(figure, wanted);
    FigureLayout layout;
    const double plots = std::max(leastHeight(wanted), figure.height * 0.46);
    const Parts parts = part(layout, {SeamName::plots, figure, false, figure.height - plots,
                                      leastCurve, leastHeight(wanted)}, shares);
    layout.curve = parts.before;
    stack(layout, parts.after, wanted, shares);
    return layout;
}

/// The curve's box parted with the hodograph, where it is large enough for both.
FigureLayout withHodograph(FigureLayout layout, bool curve, const Shares& shares) noexcept {
    if (!layout.curve) return layout;
    const Box box = *layout.curve;
    if (!curve) {
        layout.hodograph = box;
        layout.curve.reset();
        return layout;
    }
    const bool beside = box.width >= box.height;
    const double across = beside ? box.height : box.width;
    const double along = beside ? box.width : box.height;
    const double share = std::min(hodographShare * along, across);
    if (share < leastHodograph || across < leastHodograph) return layout;
    const Parts parts = part(layout, {SeamName::hodograph, box, beside, along - share, leastCurve,
                                      leastHodograph}, shares);
    layout.curve = parts.before;
    layout.hodograph = parts.after;
    return layout;
}

}  // namespace

FigureLayout layoutFigure(const Box& figure, const WantedPanes& wanted,
                          const Shares& shares) noexcept {
    if (wanted.hodograph) {
        WantedPanes others = wanted;
        others.hodograph = false;
        others.curve = true;
        return withHodograph(layoutFigure(figure, others, shares), wanted.curve, shares);
    }
    if (!wanted.curve && plotsWanted(wanted)) {
        FigureLayout layout;
        stack(layout, figure, reduced(wanted, figure.height), shares);
        return layout;
    }
    WantedPanes withCurve = wanted;
    withCurve.curve = true;
    // Where the plots go does not depend on the seams, or a hand that moves one would change it.
    const double heightAbove = curveHeight(stacked(figure, withCurve, {}), wanted);
    const bool beside = figure.width >= leastSideBySide &&
                        curveHeight(sideBySide(figure, withCurve, {}), wanted) > heightAbove;
    return beside ? sideBySide(figure, withCurve, shares) : stacked(figure, withCurve, shares);
}

}  // namespace knotwork::ui
