// Objects of a scene: from specifications of any type to bodies.
#pragma once

#include "scene/body.hpp"
#include "scene/specs.hpp"

#include <string_view>

namespace knotwork::scene {

/// An object of a scene: the specification of a curve, a surface, a subdivision surface, a cloud of
/// points or a proposed B-function, with `id`, `style` and `show`, the last two filled in; an id that
/// was left out stays out.
[[nodiscard]] Result<Made<Body>> makeObject(const Json& spec);

/// The same of a specification that is canonical, but for points that were checked: it is not checked
/// again, which is most of the time that a large object takes.
[[nodiscard]] Result<Made<Body>> remakeObject(Json spec);

[[nodiscard]] std::string_view objectTypeLabel(const Json& spec) noexcept;

}  // namespace knotwork::scene
