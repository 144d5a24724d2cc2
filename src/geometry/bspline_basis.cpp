#include "geometry/bspline_basis.hpp"

#include "geometry/bspline_kernels.hpp"

#include <algorithm>
#include <array>

namespace knotwork {

void basisFunctions(const KnotVector& knots, std::size_t span, double t,
                    std::span<double> values) noexcept {
    kernels::basis(knots.extended(), static_cast<std::size_t>(knots.degree()), span, t, values);
}

void basisDerivatives(const KnotVector& knots, std::size_t span, double t, int derivatives,
                      std::span<double> rows) noexcept {
    const auto degree = static_cast<std::size_t>(knots.degree());
    for (std::size_t order = 0; order <= static_cast<std::size_t>(derivatives); ++order) {
        kernels::basisDerivative(knots.extended(), degree, span, order, t,
                                 rows.subspan(order * (degree + 1), degree + 1));
    }
}

void basisRows(const KnotVector& knots, double t, Side side, int derivatives,
               std::span<double> rows) noexcept {
    const auto degree = static_cast<std::size_t>(knots.degree());
    const auto count = static_cast<std::size_t>(knots.pointCount());
    const double inside = knots.wrap(t, side);
    const std::size_t span = knots.findSpan(inside, side);
    std::array<double, maxDegree + 1> values{};
    std::fill(rows.begin(), rows.end(), 0.0);
    for (std::size_t order = 0; order <= static_cast<std::size_t>(derivatives); ++order) {
        kernels::basisDerivative(knots.extended(), degree, span, order, inside,
                                 std::span<double>(values));
        for (std::size_t j = 0; j <= degree; ++j) {
            rows[order * count + knots.pointIndex(span, j)] = values[j];
        }
    }
}

}  // namespace knotwork
