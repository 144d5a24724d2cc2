// Basis functions over the parameter axis that they share with the knot line below them.
#pragma once

#include "ui/knot_line.hpp"

namespace knotwork::ui {

struct BasisContent {
    Interval values;            ///< from the least to the greatest value drawn
    std::vector<double> knots;  ///< drawn as light verticals; ascending
    bool joinsAbove = false;    ///< whether the plot straight above has the same axis
};

[[nodiscard]] Plot basisPlot(const Box& box, const ParameterAxis& axis,
                             const BasisContent& content, bool namesBelow, const Theme& colours);

}  // namespace knotwork::ui
