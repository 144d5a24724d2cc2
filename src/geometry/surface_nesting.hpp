// How deep surfaces are nested that are made of surfaces: what one point of them takes.
#pragma once

#include "geometry/result.hpp"

#include <string_view>

namespace knotwork {

class Surface;

struct SurfaceNesting {
    int depth = 0;           ///< of blends that are evaluated within each other
    double evaluations = 1;  ///< of innermost surfaces, at most, that one point takes
};

[[nodiscard]] SurfaceNesting nestingOf(const Surface& surface) noexcept;

/// TOO_LARGE at `path` beyond 8 deep, each of which takes 50 kB of stack, or 1024 evaluations.
[[nodiscard]] Result<Done> checkNesting(const SurfaceNesting& nesting, std::string_view path);

}  // namespace knotwork
