// The knots of blending curves, and of blending surfaces along each of their directions: what is
// allowed, where each local takes part, and between which locals a parameter lies.
//
// n knots t_0 … t_{n−1} where open, one for each local; one more, t_n = t_0 + T, where closed.
#pragma once

#include "geometry/interval.hpp"
#include "geometry/result.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace knotwork {

enum class BlendForm { open, closed };

/// How many knots `count` local curves have.
[[nodiscard]] constexpr std::size_t blendingKnotCount(std::size_t count, BlendForm form) noexcept {
    return form == BlendForm::closed ? count + 1 : count;
}

/// Refuses knots of the wrong number (KNOTS_COUNT `knots`), that are not finite, beyond ±1e9 or next
/// to each other without being equal, that decrease (KNOTS_DECREASING) or of which three are equal
/// (KNOTS_MULTIPLICITY) as `knots[i]`, and a domain that is too short (OUT_OF_RANGE `knots`).
[[nodiscard]] Result<Done> checkBlendingKnots(std::span<const double> knots, std::size_t count,
                                              BlendForm form);

[[nodiscard]] std::vector<double> uniformKnots(const Interval& over, std::size_t number);

/// [t_{j−1}, t_{j+1}] cut to the domain, or [t_{n−1} − T, t_1] for a closed curve's first local
/// curve. Of length 0 at a doubled end knot, where the local curve is never seen.
[[nodiscard]] Interval blendingSupport(std::span<const double> knots, std::size_t j,
                                       BlendForm form) noexcept;

/// The support or, where that has no length, the span next to it.
[[nodiscard]] Interval blendingDomain(std::span<const double> knots, std::size_t j,
                                      BlendForm form) noexcept;

/// From where the local curve is seen at its knot: from the right, but from the left where nothing
/// of it is on the right (the last one of an open curve, the first one of a break).
[[nodiscard]] Side blendingSide(std::span<const double> knots, std::size_t j) noexcept;

/// Where t falls: between local `first`, centred at `start`, and local `second`, which is evaluated
/// at t − shift (the period for a closed form's wrapped local, otherwise 0).
struct BlendingSpan {
    std::size_t first = 0;
    std::size_t second = 0;
    double start = 0;
    double length = 1;
    double shift = 0;
    double t = 0;  ///< wrapped into the domain

    /// 0 at the first local's knot, 1 at the second's.
    [[nodiscard]] double ratio() const noexcept { return (t - start) / length; }
};

/// For any t: where closed it is wrapped, where open the end spans go on. At a knot the span on that
/// side; never one without length. O(log n).
[[nodiscard]] BlendingSpan blendingSpan(std::span<const double> knots, BlendForm form, double t,
                                        Side side) noexcept;

}  // namespace knotwork
