// Surfaces of which fuzz targets make blends.
#pragma once

#include "fuzz/input.hpp"

#include "geometry/surface.hpp"

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace knotwork::fuzz {

inline Surface namedSurface(Input& input) {
    constexpr std::array names{"plane",   "cylinder", "torus",    "sphere",  "cone",
                               "moebius", "klein",    "helicoid", "seashell"};
    const int last = static_cast<int>(names.size()) - 1;
    return ParametricSurface::make(names[static_cast<std::size_t>(input.whole(0, last))]).value();
}

/// One curve moved along another, or nothing where they are refused.
inline std::optional<Surface> translationSurface(Input& input, int maxDegree) {
    const auto u = splineOf(input, maxDegree);
    const auto v = splineOf(input, maxDegree);
    if (!u || !v) return std::nullopt;
    std::vector<Vec3> points;
    for (const Vec3& a : u->points()) {
        for (const Vec3& b : v->points()) points.push_back(0.5 * (a + b));
    }
    auto made = BsplineSurface::make(u->knotVector(), v->knotVector(), std::move(points));
    return made ? std::optional<Surface>(*std::move(made)) : std::nullopt;
}

}  // namespace knotwork::fuzz
