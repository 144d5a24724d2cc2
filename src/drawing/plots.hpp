// The functions behind a curve, sampled for plotting: basis functions, blending functions, the
// B-function with its derivatives, and the knots as a line.
#pragma once

#include "drawing/drawing.hpp"

namespace knotwork::drawing {

/// More basis functions than this are not drawn: in a picture nobody could tell them apart.
constexpr std::size_t maximumBasisFunctions = 400;

/// One polyline a function, `index` its number, over the domain. Of a closed curve a function that
/// reaches over the seam is one polyline for each side of it.
[[nodiscard]] std::vector<Shape> basisPlot(const Curve& curve, int object, bool dark);

/// How the functions of an object are drawn.
struct Pen {
    Colour colour;
    bool dashed = false;
};

/// B, B′ and B″: polylines over [0, 1] with `index` the order of the derivative.
[[nodiscard]] std::vector<Shape> bFunctionPlot(const BFunction& blend, int object, const Pen& pen);

/// More than these in one plot nobody tells apart.
constexpr std::size_t mostCompared = 4;

/// The objects whose B-functions stand in one plot, ascending: this one and the first of each other
/// function; it alone where there are more than mostCompared.
[[nodiscard]] std::vector<int> comparedObjects(const Drawing& drawing, int object);

/// The knots as points, equal ones in a pile.
[[nodiscard]] Shape knotLine(std::span<const double> knots, int object, std::string path,
                             bool dark);

}  // namespace knotwork::drawing
