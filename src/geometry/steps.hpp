// Where what walks over meshes says that it takes a step: nothing, and nothing is compiled for it. The
// tests compile the same sources over a header of this name that counts.
#pragma once

namespace knotwork {

constexpr void step() noexcept {}

}  // namespace knotwork
