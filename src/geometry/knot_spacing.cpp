#include "geometry/knot_spacing.hpp"

#include "geometry/arc_length.hpp"

#include <cmath>

namespace knotwork {

std::optional<std::vector<double>> equalLengthKnots(const Curve& curve, std::size_t number) {
    const ArcLength lengths(curve);
    if (!(lengths.total() > 0) || !std::isfinite(lengths.total())) return std::nullopt;
    const Interval whole = domain(curve);
    std::vector<double> knots(number, whole.start);
    for (std::size_t i = 1; i + 1 < number; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(number - 1);
        knots[i] = lengths.parameterAt(share * lengths.total());
    }
    knots.back() = whole.end;
    return knots;
}

}  // namespace knotwork
