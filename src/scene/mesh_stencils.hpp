// The stencil that is shown on a subdivision surface.
#pragma once

#include "geometry/mesh_stencil.hpp"
#include "scene/body.hpp"
#include "scene/json.hpp"

#include <optional>
#include <string_view>

namespace knotwork::scene {

[[nodiscard]] MeshElement meshElementNamed(std::string_view name) noexcept;
[[nodiscard]] std::string_view meshElementName(MeshElement element) noexcept;

/// What `stencil: { of, index }` of a canonical subdivision surface asks for; the last element stands
/// for those beyond the end. Refusals as knotwork::stencil(), at `stencil.of` and `stencil.index`.
[[nodiscard]] Result<std::optional<MeshStencil>> stencilOf(const Json& spec,
                                                           const SubdivisionSurface& surface);

}  // namespace knotwork::scene
