// The knots of blending curves: what is allowed, and where each local curve takes part.
//
// n knots t_0 … t_{n−1} where open, one for each local curve; one more, t_n = t_0 + T, where closed.
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

}  // namespace knotwork
