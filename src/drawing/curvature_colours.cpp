#include "drawing/curvature_colours.hpp"

#include "drawing/colour_bytes.hpp"
#include "geometry/triangle_curvatures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace knotwork::drawing {

namespace {

constexpr Colour neutral{0.894, 0.894, 0.894, 1};
constexpr Colour negative{0.10, 0.47, 0.80, 1};
constexpr Colour positive{0.80, 0.33, 0.00, 1};
/// Steps on either side of zero: as many as eight bits can tell apart between these colours.
constexpr int steps = 128;
/// Curvature times size (of Gauss's: times its square) below which rounding is all that is seen.
constexpr double asGoodAsFlat = 1e-6;

std::array<ColourBytes, 2 * steps + 1> table() noexcept {
    std::array<ColourBytes, 2 * steps + 1> colours{};
    for (int i = -steps; i <= steps; ++i) {
        colours[static_cast<std::size_t>(i + steps)] =
            toBytes(curvatureColour(static_cast<double>(i) / steps));
    }
    return colours;
}

/// The size below which `rangeShare` of the values lie that some triangle uses.
double robustRange(const Shape& shape, const std::vector<double>& values) {
    std::vector<bool> used(values.size());
    for (const std::uint32_t i : shape.indices) used[i] = true;
    std::vector<double> sizes;
    sizes.reserve(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (used[i]) sizes.push_back(std::abs(values[i]));
    }
    if (sizes.empty()) return 0;
    const auto place = static_cast<std::ptrdiff_t>(rangeShare *
                                                   static_cast<double>(sizes.size() - 1));
    std::nth_element(sizes.begin(), sizes.begin() + place, sizes.end());
    return sizes[static_cast<std::size_t>(place)];
}

}  // namespace

Colour curvatureColour(double share) noexcept {
    const double strength = std::min(std::abs(share), 1.0);
    return scene::mixColours(neutral, share < 0 ? negative : positive, strength);
}

CurvatureColours curvatureColours(const Shape& triangles, scene::Colouring by) {
    if (triangles.normals.size() != triangles.positions.size()) return {};
    const VertexCurvatures all =
        triangleCurvatures(triangles.positions, triangles.normals, triangles.indices);
    const bool gaussian = by == scene::Colouring::gaussian;
    const std::vector<double>& values = gaussian ? all.gaussian : all.mean;
    Bounds bounds;
    bounds.add(triangles);
    const double size = glm::length(bounds.max - bounds.min);
    CurvatureColours made;
    made.range = robustRange(triangles, values);
    if (made.range * (gaussian ? size * size : size) < asGoodAsFlat) made.range = 0;
    const auto colours = table();
    made.colours.reserve(values.size());
    for (const double value : values) {
        const double share = made.range > 0 ? std::clamp(value / made.range, -1.0, 1.0) : 0;
        made.colours.push_back(colours[static_cast<std::size_t>(std::lround(share * steps) +
                                                                steps)]);
    }
    return made;
}

}  // namespace knotwork::drawing
