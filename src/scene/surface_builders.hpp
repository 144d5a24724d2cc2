// From checked specifications to surfaces, one function a type. For surface_specs.cpp and the
// builders themselves, which call each other for nested surfaces; everyone else calls makeSurface().
//
// A builder trusts the types and ranges of the fields, since validation came first, and fills into
// the specification what it computes.
#pragma once

#include "geometry/surface.hpp"
#include "scene/json.hpp"

namespace knotwork::scene {

/// Of any type; the keys are in the order of the field tables afterwards.
[[nodiscard]] Result<Surface> buildSurface(Json& spec);

[[nodiscard]] Result<Surface> buildBsplineSurface(Json& spec);
[[nodiscard]] Result<Surface> buildParametricSurface(Json& spec);
[[nodiscard]] Result<Surface> buildBlendingSurface(Json& spec);
[[nodiscard]] Result<Surface> buildBlendingTriangle(Json& spec);

// And back again, for what is computed.
[[nodiscard]] Json specOf(const BsplineSurface& surface);
[[nodiscard]] Json specOf(const ParametricSurface& surface);
[[nodiscard]] Json specOf(const BlendingSurface& surface);
[[nodiscard]] Json specOf(const BlendingTriangle& triangle);

}  // namespace knotwork::scene
