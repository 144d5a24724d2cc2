// Arc length, s(t) = ∫ |C′|, and its inverse.
//
// Every smooth piece is halved until Gauss–Legendre rules of 8 and of 16 nodes agree, which finds
// cusps and the steep ends of square roots by itself. The panels that come of it are kept with the
// length up to each, so that every later question takes one panel: 16 evaluations for a length,
// about five times that for the parameter at a length.
#pragma once

#include "geometry/curve.hpp"

#include <optional>
#include <vector>

namespace knotwork {

class ArcLength {
public:
    /// Of the whole domain. Error: about 1e-14 of the length for coordinates of its size, more by
    /// the rounding of C′ where a curve lies far from the origin.
    explicit ArcLength(const Curve& curve);

    [[nodiscard]] const Curve& curve() const noexcept { return curve_; }
    [[nodiscard]] double total() const noexcept { return upTo_.back(); }

    /// From a to b, both in the domain, a ≤ b.
    [[nodiscard]] double between(double a, double b) const noexcept;
    /// The t at which the length from the start is s, 0 ≤ s ≤ total(): inverse to rounding, by
    /// Newton's method inside a bracket. Where the curve stands still, one of those t.
    [[nodiscard]] double parameterAt(double s) const noexcept;

private:
    [[nodiscard]] std::size_t panelAt(double t) const noexcept;
    [[nodiscard]] double inPanel(double a, double b) const noexcept;

    Curve curve_;
    CurveSampler sampler_;
    std::vector<double> ends_;  // of the panels: the start of the domain, and then each one's end
    std::vector<double> upTo_;  // the length from the start of the domain to each of them
};

/// The length from a to b, by default from and to the ends of the domain. A closed curve is
/// followed from a in its direction: over as many turns as b lies beyond a, and through the seam to
/// a b that lies before it. Refusals: NOT_FINITE, and of a curve that is not closed OUT_OF_RANGE,
/// at `a` and `b`; b before a is OUT_OF_RANGE at `b`.
[[nodiscard]] Result<double> lengthBetween(const ArcLength& lengths, std::optional<double> a,
                                           std::optional<double> b);

/// parameterAt() for any s: round a closed curve again, otherwise OUT_OF_RANGE at `s`.
[[nodiscard]] Result<double> parameterAtLength(const ArcLength& lengths, double s);

}  // namespace knotwork
