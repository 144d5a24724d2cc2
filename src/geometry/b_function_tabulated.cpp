#include "geometry/b_function_families.hpp"

#include <algorithm>
#include <cmath>

namespace knotwork::b_function {

namespace {

constexpr std::size_t stencil = 5;  // quartics: fourth-order slopes
constexpr double snap = 1e-12;      // of the neighbouring differences: rounding of the stencil

/// Slope at node k of the polynomial through `values`, on a grid of step 1 (Lagrange's formula).
double interpolatedSlope(std::span<const double> values, std::size_t k) noexcept {
    const auto gap = [](std::size_t i, std::size_t j) {
        return static_cast<double>(i) - static_cast<double>(j);
    };
    double slope = 0;
    for (std::size_t j = 0; j < values.size(); ++j) {
        if (j == k) continue;
        double weight = 1 / gap(j, k);
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (i != j && i != k) weight *= gap(k, i) / gap(j, i);
        }
        slope += weight * (values[j] - values[k]);
    }
    return slope;
}

/// Slopes for a grid of step 1, each within [0, 3 · the smaller neighbouring difference].
std::vector<double> monotoneSlopes(std::span<const double> values) {
    const std::size_t count = values.size();
    const std::size_t width = std::min(stencil, count);
    std::vector<double> slopes(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t start = std::min(i > width / 2 ? i - width / 2 : 0, count - width);
        const double before = i > 0 ? values[i] - values[i - 1] : values[1] - values[0];
        const double after = i + 1 < count ? values[i + 1] - values[i] : before;
        const double limit = 3 * std::min(before, after);
        const double slope = interpolatedSlope(values.subspan(start, width), i - start);
        if (slope > snap * std::max(before, after)) {
            slopes[i] = slope >= limit * (1 - snap) ? limit : slope;
        }
    }
    return slopes;
}

/// The exponent at which a cubic with this difference over the cell and these slopes at its near
/// and far end leaves its near end.
double leavingPower(double difference, double nearSlope, double farSlope) noexcept {
    if (nearSlope != 0) return 1;
    if (farSlope != 3 * difference) return 2;
    return difference != 0 ? 3 : infinitePower;
}

}  // namespace

Tabulated::Tabulated(std::span<const double> values) {
    const std::vector<double> slopes = monotoneSlopes(values);
    std::vector<Cell> cells(values.size() - 1);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const double difference = values[i + 1] - values[i];
        cells[i].coefficients = {values[i], slopes[i],
                                 3 * difference - 2 * slopes[i] - slopes[i + 1],
                                 slopes[i] + slopes[i + 1] - 2 * difference};
    }
    const std::size_t last = values.size() - 1;
    powers_ = {leavingPower(values[1] - values[0], slopes[0], slopes[1]),
               leavingPower(values[last] - values[last - 1], slopes[last], slopes[last - 1])};
    symmetric_ = true;
    for (std::size_t i = 0; i <= last; ++i) {
        symmetric_ = symmetric_ && std::abs(values[i] + values[last - i] - 1) <= 1e-15;
    }
    values_ = std::make_shared<const std::vector<double>>(values.begin(), values.end());
    cells_ = std::make_shared<const std::vector<Cell>>(std::move(cells));
}

double Tabulated::value(double t) const noexcept {
    const double position = t * static_cast<double>(cells_->size());
    const std::size_t i = std::min(static_cast<std::size_t>(position), cells_->size() - 1);
    const double x = position - static_cast<double>(i);
    const auto& c = (*cells_)[i].coefficients;
    return c[0] + x * (c[1] + x * (c[2] + x * c[3]));
}

void Tabulated::derivatives(double t, std::span<double> rows) const noexcept {
    if (rows.size() < 2) return;
    const double scale = static_cast<double>(cells_->size());
    const std::size_t i = std::min(static_cast<std::size_t>(t * scale), cells_->size() - 1);
    const double x = t * scale - static_cast<double>(i);
    const auto& c = (*cells_)[i].coefficients;
    const std::array slopes{c[1] + x * (2 * c[2] + x * 3 * c[3]), 2 * c[2] + x * 6 * c[3],
                            6 * c[3]};
    double factor = 1;
    for (std::size_t k = 1; k < rows.size(); ++k) {
        factor *= scale;
        rows[k] = k <= slopes.size() ? factor * slopes[k - 1] : 0;
    }
}

}  // namespace knotwork::b_function
