// B-splines in another form without moving: opened at the seam, or joined where they close.
#pragma once

#include "geometry/bspline_curve.hpp"
#include "geometry/bspline_surface.hpp"

#include <optional>

namespace knotwork::scene {

/// The same curve in another form, where it has one. A closed curve of n points and degree d is an
/// open or a clamped one of n + d points over one period. An open or clamped curve that closes as
/// smoothly as its knots let it (its first d points over periodic knots are its last d, to 1e-9 of
/// the size of the points) is a closed one of n − d points. Between open and clamped there is
/// nothing to keep: the same points make two curves.
[[nodiscard]] std::optional<BsplineCurve> inForm(const BsplineCurve& curve, Form form);

/// The same of a surface, line by line, in both directions; a direction that has this form already
/// stays as it is.
[[nodiscard]] std::optional<BsplineSurface> inForms(const BsplineSurface& surface, Form u, Form v);

}  // namespace knotwork::scene
