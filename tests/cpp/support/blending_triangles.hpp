// Blending triangles for tests: every blend, on patches that differ in all their derivatives.
#pragma once

#include "geometry/surface.hpp"
#include "support/blends.hpp"
#include "support/surfaces.hpp"

#include <array>
#include <string>
#include <vector>

namespace knotwork::test {

namespace gates {

inline constexpr double weightSum = 2e-15;
// Taylor coefficients up to order 6 of size up to 1e4 against jets, relative to the largest.
inline constexpr double triangleSeries = 1e-13;
// Points and derivatives against those of a patch, relative to its largest derivative.
inline constexpr double triangleCorner = 1e-13;
inline constexpr double trianglePoint = 1e-14;
// Normals and curvatures at the pole by power series.
inline constexpr double trianglePole = 1e-9;

}  // namespace gates

struct NamedTriangleBlend {
    std::string name;
    TriangleBlend blend;
};

inline std::vector<NamedTriangleBlend> triangleBlends() {
    std::vector<NamedTriangleBlend> all{{"order 1", {1, {}}}, {"order 2", {2, {}}}};
    for (const NamedBlend& one : someBlends()) all.push_back({one.name, {1, one.blend}});
    return all;
}

/// Bézier patches without symmetries over rectangles of different sizes.
inline std::array<Surface, 3> threePatches() {
    return {someSurface({3, 4, Form::clamped, Form::clamped, 4, 5, false, 11}),
            someSurface({4, 3, Form::clamped, Form::clamped, 5, 4, true, 12}),
            someSurface({5, 2, Form::clamped, Form::clamped, 6, 3, false, 13})};
}

inline BlendingTriangle triangleOf(const std::array<Surface, 3>& locals,
                                   const TriangleBlend& blend = {}) {
    return BlendingTriangle::make(locals, blend).value();
}

inline BlendingTriangle threeTimes(const Surface& local, const TriangleBlend& blend = {}) {
    return triangleOf({local, local, local}, blend);
}

/// The place of a patch that (x, y) of the unit square is.
inline SurfacePlace onPatch(const Surface& patch, double x, double y, Side sideX = Side::right,
                            Side sideY = Side::right) {
    const Rectangle whole = domain(patch);
    return {whole.u.start + x * whole.u.length(), whole.v.start + y * whole.v.length(),
            x == 1 ? Side::left : sideX, y == 1 ? Side::left : sideY};
}

inline double largest(std::span<const Vec3> rows) {
    double size = 1;
    for (const Vec3& row : rows) size = std::max(size, glm::length(row));
    return size;
}

}  // namespace knotwork::test
