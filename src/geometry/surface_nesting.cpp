#include "geometry/surface_nesting.hpp"

#include "geometry/surface.hpp"

namespace knotwork {

namespace {

constexpr double maximumEvaluations = 1024;
constexpr int maximumDepth = 8;

}  // namespace

SurfaceNesting nestingOf(const Surface& surface) noexcept {
    if (const auto* blend = surface.as<BlendingSurface>()) return blend->nesting();
    if (const auto* triangle = surface.as<BlendingTriangle>()) return triangle->nesting();
    return {};
}

Result<Done> checkNesting(const SurfaceNesting& nesting, std::string_view path) {
    if (nesting.evaluations <= maximumEvaluations && nesting.depth <= maximumDepth) return Done{};
    return refuse(Code::tooLarge, std::string(path),
                  "Blends of surfaces are nested " + std::to_string(nesting.depth) +
                      " deep, and one point would take up to " +
                      formatNumber(nesting.evaluations) +
                      " points of the innermost surfaces; at most 8 and 1024 are supported.");
}

}  // namespace knotwork
