// What lies under the pointer. Distances are CSS pixels; nothing smaller than the radius can be
// missed, so targets are at least twice the radius across however small they are drawn.
#pragma once

#include "app/figure.hpp"

#include <optional>
#include <string_view>

namespace knotwork::app {

/// Half of 24 CSS pixels for a mouse or pen, half of 44 for touch (WCAG 2.2, 2.5.8 and 2.5.5).
[[nodiscard]] double hitRadius(std::string_view pointerType) noexcept;

/// The nearest target within the radius, of almost equally near ones that in front, of those that
/// painted last. What a surface hides is found only where nothing else is.
[[nodiscard]] std::optional<Target> targetAt(const Figure& figure, const Pixel& p, double radius);

struct BasisHit {
    int object = -1;
    int index = -1;
};
/// The basis function whose graph passes within the radius.
[[nodiscard]] std::optional<BasisHit> basisAt(const Figure& figure, const Pixel& p, double radius);

/// The parameter under the pointer in a plot, kept inside its axis.
[[nodiscard]] std::optional<double> parameterAt(const PaneFigure& pane, const Pixel& p) noexcept;

/// Distance of p from the segment a b.
[[nodiscard]] double distanceToSegment(const Pixel& p, const Pixel& a, const Pixel& b) noexcept;

}  // namespace knotwork::app
