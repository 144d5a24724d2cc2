// The curvature over the parameter, on the axis of the basis functions and of the knots.
#pragma once

#include "ui/knot_line.hpp"

namespace knotwork::ui {

struct CurvatureContent {
    Interval values;  ///< of the graph
    std::vector<double> knots;
    bool joinsBelow = false;  ///< whether the plot straight below it has the same axis
    std::vector<const Shape*> labels{};  ///< beside marks of where the graph goes beyond the plot
};

[[nodiscard]] Plot curvaturePlot(const Box& box, const ParameterAxis& axis,
                                 const CurvatureContent& content, const Theme& colours);

}  // namespace knotwork::ui
