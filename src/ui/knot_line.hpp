// The knot line: knots as handles on a parameter axis, equal knots piled up, the curve's domain as
// a band.
#pragma once

#include "ui/plot.hpp"

#include <optional>
#include <vector>

namespace knotwork::ui {

/// The parameter axis that a knot line and the basis functions above it share to the pixel.
struct ParameterAxis {
    Interval range;    ///< of parameters
    double left = 0;   ///< where the range begins and ends, CSS pixels
    double right = 1;
};

/// Left and right margins of every plot with a parameter axis.
inline constexpr Margins plotMargins{44, 14, 22, 10};

[[nodiscard]] ParameterAxis parameterAxis(const Box& column, const Interval& range) noexcept;

/// Each knot's row in its pile: row k for the k-th of equal knots (in ascending order).
[[nodiscard]] std::vector<int> pileRows(const std::vector<double>& knots);
[[nodiscard]] int tallestPile(const std::vector<double>& knots);

/// Distance between the rows of a pile such that `rows` of them fit a knot line of this height.
[[nodiscard]] double rowSpacing(double height, int rows) noexcept;

struct KnotLineContent {
    std::vector<double> knots;  ///< as drawn, in ascending order
    Interval domain;            ///< of the curve
    bool underBasis = false;    ///< basis functions stand straight above
};

/// Light verticals at the distinct knots, unless they would be a grey wash.
void addKnotLines(Plot& plot, const ParameterAxis& axis, const std::vector<double>& knots,
                  const Theme& colours);

[[nodiscard]] Plot knotLine(const Box& box, const ParameterAxis& axis,
                            const KnotLineContent& content, const Theme& colours);

}  // namespace knotwork::ui
