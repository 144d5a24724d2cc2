// From where a document wants its world to be seen: what views and exporters have in common.
#pragma once

#include "drawing/drawing.hpp"
#include "drawing/screen.hpp"

#include <optional>

namespace knotwork::drawing {

struct Outlook {
    bool spatial = false;  ///< else straight down on the plane z = 0
    double azimuth = usualAzimuth;      ///< of a spatial one, as in orientationFrom()
    double elevation = usualElevation;
    std::optional<Vec3> centre;  ///< in the middle of the view
    double height = 0;           ///< units of the world from top to bottom; 0: as all fits
};

/// Whether the bounds are more than a plane parallel to z = 0.
[[nodiscard]] bool hasDepth(const Bounds& bounds) noexcept;

/// What view and camera of the document say. Whatever has depth is seen in space, also where the
/// document does not ask for it: from above a helix is a circle.
[[nodiscard]] Outlook outlookOf(const scene::State& state, const Bounds& bounds);

}  // namespace knotwork::drawing
