#include "scene/mesh_stencils.hpp"

#include <algorithm>
#include <array>

namespace knotwork::scene {

namespace {

/// In the order of MeshElement.
constexpr std::array<std::string_view, 4> names{"vertex", "edge", "face", "corner"};

}  // namespace

MeshElement meshElementNamed(std::string_view name) noexcept {
    return static_cast<MeshElement>(std::find(names.begin(), names.end(), name) - names.begin());
}

std::string_view meshElementName(MeshElement element) noexcept {
    return names[static_cast<std::size_t>(element)];
}

Result<std::optional<MeshStencil>> stencilOf(const Json& spec, const SubdivisionSurface& surface) {
    const Json* asked = member(spec, "stencil");
    if (asked == nullptr) return std::optional<MeshStencil>();
    const MeshElement element = meshElementNamed(stringOr(*asked, "of", ""));
    const auto index = static_cast<std::size_t>(numberOr(*asked, "index", 0));
    const std::size_t count = elementCount(surface.control, element);
    auto made = stencil(surface.control, surface.scheme, element,
                        std::min(index, count > 0 ? count - 1 : 0));
    if (!made) return made.error().under("stencil");
    return std::optional(std::move(*made));
}

}  // namespace knotwork::scene
