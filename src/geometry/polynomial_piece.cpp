#include "geometry/polynomial_piece.hpp"

#include "geometry/bspline_kernels.hpp"

#include <span>

namespace knotwork {

namespace {

// The d+1 active points of a span, `components` numbers each.
void gatherActive(const BsplineCurve& curve, std::size_t span, std::size_t components,
                  Coefficients& active) noexcept {
    const KnotVector& knots = curve.knotVector();
    for (std::size_t j = 0; j <= static_cast<std::size_t>(knots.degree()); ++j) {
        const std::size_t i = knots.pointIndex(span, j);
        const double weight = components == 4 ? curve.weights()[i] : 1;
        double* to = &active[j * components];
        to[0] = weight * curve.points()[i].x;
        to[1] = weight * curve.points()[i].y;
        if (components >= 3) to[2] = weight * curve.points()[i].z;
        if (components == 4) to[3] = weight;
    }
}

// Power form about mid-span: c_k = C^(k)(m) h^k / k!, half width h. Both the functions N_{i,d-k}(m)
// and the differences of the points need 1 / (t_{i+k} - t_i), kept in `inverse`. Fixed is the degree
// where the compiler knows it, else 0: cubics are what is made anew for every picture.
template <std::size_t Fixed>
class TaylorPiece {
public:
    TaylorPiece(std::span<const double> knots, std::size_t degree, std::size_t span) noexcept
        : degree_(Fixed > 0 ? Fixed : degree) {
        const double start = knots[span];
        const double end = knots[span + 1];
        const double centre = start + (end - start) / 2;
        halfWidth_ = (end - start) / 2;
        basis_[0] = 1;
        for (std::size_t k = 1; k <= this->degree(); ++k) {
            double carried = 0;
            for (std::size_t j = 0; j < k; ++j) {
                const std::size_t i = span + 1 + j - k;
                const double inverse = 1 / (knots[i + k] - knots[i]);
                const double upper = (centre - knots[i]) * inverse * basis_[at(k - 1, j)];
                inverse_[at(k, j)] = inverse;
                basis_[at(k, j)] = carried + basis_[at(k - 1, j)] - upper;
                carried = upper;
            }
            basis_[at(k, k)] = carried;
        }
    }

    template <std::size_t Components>
    void coefficients(Coefficients& active, double* to) const noexcept {
        combine<Components>(active, degree(), to);
        for (std::size_t k = 1; k <= degree(); ++k) {
            const std::size_t lower = degree() - k;
            const double factor =
                halfWidth_ * static_cast<double>(lower + 1) / static_cast<double>(k);
            for (std::size_t j = 0; j <= lower; ++j) {
                const double scale = factor * inverse_[at(lower + 1, j)];
                for (std::size_t c = 0; c < Components; ++c) {
                    double& value = active[j * Components + c];
                    value = (active[(j + 1) * Components + c] - value) * scale;
                }
            }
            combine<Components>(active, lower, to + k * Components);
        }
    }

private:
    [[nodiscard]] std::size_t degree() const noexcept { return Fixed > 0 ? Fixed : degree_; }

    // Row k of a triangle has k+1 entries.
    static constexpr std::size_t at(std::size_t k, std::size_t j) noexcept {
        return k * (k + 1) / 2 + j;
    }
    static constexpr std::size_t highest = Fixed > 0 ? Fixed : maxPowerDegree;
    static constexpr std::size_t triangleSize = (highest + 1) * (highest + 2) / 2;

    template <std::size_t Components>
    void combine(const Coefficients& points, std::size_t k, double* to) const noexcept {
        for (std::size_t c = 0; c < Components; ++c) {
            double sum = 0;
            for (std::size_t j = 0; j <= k; ++j) {
                sum += basis_[at(k, j)] * points[j * Components + c];
            }
            to[c] = sum;
        }
    }

    std::size_t degree_;
    double halfWidth_;
    std::array<double, triangleSize> basis_;
    std::array<double, triangleSize> inverse_;
};

template <std::size_t Fixed>
void taylorCoefficients(const BsplineCurve& curve, std::size_t span, std::size_t components,
                        Coefficients& active, double* to) noexcept {
    const auto degree = static_cast<std::size_t>(curve.degree());
    const TaylorPiece<Fixed> piece(curve.knotVector().extended(), degree, span);
    if (components == 2) return piece.template coefficients<2>(active, to);
    piece.template coefficients<3>(active, to);
}

// Point `to` becomes (1-w) point `from` + w point `from+1`.
void blendPair(Coefficients& points, std::size_t components, std::size_t from, std::size_t to,
               double w) noexcept {
    for (std::size_t i = 0; i < components; ++i) {
        points[to * components + i] =
            (1 - w) * points[from * components + i] + w * points[(from + 1) * components + i];
    }
}

}  // namespace

void powerCoefficients(const BsplineCurve& curve, std::size_t span, std::size_t components,
                       Coefficients& c) noexcept {
    Coefficients active;
    gatherActive(curve, span, components, active);
    if (curve.degree() == 3) return taylorCoefficients<3>(curve, span, components, active, c.data());
    taylorCoefficients<0>(curve, span, components, active, c.data());
}

// b_k is the blossom of d-k times the start a of the span and k times its end b. The triangle at a
// leaves the points for the knots a, …, a, t_{s+1}, …, t_{s+d}; the one at b goes on from those.
void bernsteinCoefficients(const BsplineCurve& curve, std::size_t span, std::size_t components,
                           Coefficients& b) noexcept {
    const auto knots = curve.knotVector().extended();
    const auto degree = static_cast<std::size_t>(curve.degree());
    const double start = knots[span];
    const double width = knots[span + 1] - start;
    gatherActive(curve, span, components, b);
    for (std::size_t r = 1; r <= degree; ++r) {
        for (std::size_t j = 0; j + r <= degree; ++j) {
            const std::size_t i = span + j + r - degree;
            blendPair(b, components, j, j, kernels::weight(knots, degree + 1 - r, i, start));
        }
    }
    for (std::size_t r = 1; r <= degree; ++r) {
        for (std::size_t j = degree; j >= r; --j) {
            blendPair(b, components, j - 1, j, width / (knots[span + j + 1 - r] - start));
        }
    }
}

void differentiatePower(Coefficients& c, std::size_t degree, std::size_t components,
                        double scale) noexcept {
    for (std::size_t k = 0; k < degree; ++k) {
        const double factor = static_cast<double>(k + 1) * scale;
        for (std::size_t i = 0; i < components; ++i) {
            c[k * components + i] = factor * c[(k + 1) * components + i];
        }
    }
}

void differentiateBernstein(Coefficients& b, std::size_t degree, std::size_t components,
                            double scale) noexcept {
    const double factor = static_cast<double>(degree) * scale;
    for (std::size_t k = 0; k < degree * components; ++k) {
        b[k] = factor * (b[k + components] - b[k]);
    }
}

void multiplyBinomials(Coefficients& b, std::size_t degree, std::size_t components) noexcept {
    double binomial = 1;
    for (std::size_t k = 1; k <= degree; ++k) {
        binomial *= static_cast<double>(degree + 1 - k) / static_cast<double>(k);
        for (std::size_t i = 0; i < components; ++i) b[k * components + i] *= binomial;
    }
}

}  // namespace knotwork
