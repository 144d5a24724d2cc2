#include "geometry/blending_patch.hpp"

#include "geometry/surface.hpp"

#include <algorithm>

namespace knotwork {

Result<Done> cutPatch(const Surface& model, const PatchCut& cut, const SurfacePlace& at,
                      std::span<Vec3> matrix) {
    const SurfaceOrders orders = cut.orders();
    derivatives(model, at, orders, matrix);
    if (cut.kind == PatchKind::plane) matrix[orders.at(1, 1)] = Vec3(0);
    if (std::all_of(matrix.begin(), matrix.end(), isFinite)) return Done{};
    return refuse(Code::notFinite, "model",
                  "The model has no derivatives at (" + formatNumber(at.u) + ", " +
                      formatNumber(at.v) +
                      ") that patches of this kind could be made of; move the knots, lower the "
                      "degree, or cut sub-surfaces.");
}

void taylorPowers(double t, std::span<double> powers) noexcept {
    double power = 1;
    for (std::size_t k = 0; k < powers.size(); ++k) {
        if (k > 0) power *= t / static_cast<double>(k);
        powers[k] = power;
    }
}

void polynomialDerivatives(std::span<const Vec3> matrix, const SurfaceOrders& degree, double x,
                           double y, const SurfaceOrders& orders, std::span<Vec3> rows) noexcept {
    std::array<double, maxSurfaceOrder + 1> alongX;
    std::array<double, maxSurfaceOrder + 1> alongY;
    const std::size_t lines = static_cast<std::size_t>(degree.u) + 1;
    const std::size_t columns = degree.columns();
    taylorPowers(x, std::span<double>(alongX).first(lines));
    taylorPowers(y, std::span<double>(alongY).first(columns));
    std::array<Vec3, maxSurfaceOrder + 1> collapsed;  // one line of the matrix each
    for (std::size_t b = 0; b < orders.columns(); ++b) {
        for (std::size_t line = 0; line < lines; ++line) {
            Vec3 sum(0);
            for (std::size_t k = columns; k-- > b;) sum += alongY[k - b] * matrix[degree.at(line, k)];
            collapsed[line] = sum;
        }
        for (std::size_t a = 0; a <= static_cast<std::size_t>(orders.u); ++a) {
            Vec3 sum(0);
            for (std::size_t k = lines; k-- > a;) sum += alongX[k - a] * collapsed[k];
            rows[orders.at(a, b)] = sum;
        }
    }
}

void PatchPlace::place(std::span<Vec3> rows) const noexcept {
    if (pose_.isIdentity()) return;
    rows[0] = placement_.point(rows[0]);
    for (Vec3& row : rows.subspan(1)) row = placement_.vector(row);
}

}  // namespace knotwork
