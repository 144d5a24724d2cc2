// Specifications of surfaces: checked, completed to their canonical form, and turned into geometry.
#pragma once

#include "geometry/surface.hpp"
#include "scene/json.hpp"
#include "scene/specs.hpp"

namespace knotwork::scene {

/// A surface specification of any type. What an object of a scene has besides (`id`, `style`, `show`)
/// may stand in it, is checked, and does not come back.
[[nodiscard]] Result<Made<Surface>> makeSurface(const Json& spec);

/// The canonical specification of a surface that has been computed; makeSurface() makes it again.
[[nodiscard]] Json specOf(const Surface& surface);

/// kw.parametricSurfaces: [{ name, label, formula, closed: [u, v], parameters: […] }].
[[nodiscard]] Json describeParametricSurfaces();

}  // namespace knotwork::scene
