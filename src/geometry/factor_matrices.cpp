#include "geometry/factor_matrices.hpp"

#include "geometry/bspline_kernels.hpp"

namespace knotwork {

std::vector<std::vector<double>> factorMatrices(const KnotVector& knots, double t) {
    const double inside = knots.wrap(t);
    const std::size_t span = knots.findSpan(inside);
    std::vector<std::vector<double>> matrices;
    for (std::size_t k = 1; k <= static_cast<std::size_t>(knots.degree()); ++k) {
        std::vector<double> matrix(k * (k + 1));
        for (std::size_t row = 0; row < k; ++row) {
            const double w = kernels::weight(knots.extended(), k, span + 1 + row - k, inside);
            matrix[row * (k + 1) + row] = 1 - w;
            matrix[row * (k + 1) + row + 1] = w;
        }
        matrices.push_back(std::move(matrix));
    }
    return matrices;
}

}  // namespace knotwork
