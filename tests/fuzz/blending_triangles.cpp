// Blends of three patches of any kind over a triangle: refused, or a surface that is the sum of its
// patches by weights that are not negative and sum to one, that has its patches in its corners and
// its derivatives in all orders, and whose grid has its points.
#include "fuzz/models.hpp"

#include "geometry/surface_differential.hpp"
#include "geometry/surface_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>

using namespace knotwork;

namespace {

constexpr double rounding = 1e-9;  // relative to the size of the patches

Surface splineOf(fuzz::Input& input) {
    if (auto made = fuzz::translationSurface(input, 5)) return *std::move(made);
    return ParametricSurface::make("torus").value();
}

TriangleBlend weightsOf(fuzz::Input& input) {
    TriangleBlend blend{input.whole(0, 3), {}};
    if (input.whole(0, 1) == 0) blend.blend = fuzz::blendOf(input, 2);
    return blend;
}

Surface patchOf(fuzz::Input& input, int depth) {
    switch (input.whole(0, depth > 0 ? 4 : 1)) {
        case 0: return splineOf(input);
        case 1: return fuzz::namedSurface(input);
        case 2: {
            auto made = BlendingSurface::make(
                patchOf(input, depth - 1), {.count = 3, .blend = fuzz::blendOf(input, 1)},
                {.count = 2}, {static_cast<PatchKind>(input.whole(0, 2)), {2, 3}});
            return made ? Surface(*std::move(made)) : splineOf(input);
        }
        default: {
            const Surface one = patchOf(input, depth - 1);
            const Surface other = patchOf(input, depth - 1);
            auto made = BlendingTriangle::make({one, other, one}, weightsOf(input));
            return made ? Surface(*std::move(made)) : splineOf(input);
        }
    }
}

double sizeOf(const std::array<Vec3, 3>& points) {
    double size = 1;
    for (const Vec3& point : points) size = std::max(size, glm::length(point));
    return size;
}

/// The patches where the triangle has this place.
std::array<Vec3, 3> patchesAt(const BlendingTriangle& triangle, double u, double v) {
    std::array<Vec3, 3> points;
    for (std::size_t k = 0; k < 3; ++k) {
        const Rectangle whole = domain(triangle.local(k));
        const double x = u * (1 - v);
        const double y = u * v;
        points[k] = pointAt(triangle.local(k),
                            {x == 1 ? whole.u.end : whole.u.start + x * whole.u.length(),
                             y == 1 ? whole.v.end : whole.v.start + y * whole.v.length(),
                             x == 1 ? Side::left : Side::right, y == 1 ? Side::left : Side::right});
    }
    return points;
}

void checkPlace(const BlendingTriangle& triangle, double u, double v) {
    const Barycentric weights = triangle.weights(u, v);
    fuzz::checkWithin(std::abs(weights[0] + weights[1] + weights[2] - 1), 1e-14,
                      "weights sum to one");
    for (const double one : weights) fuzz::check(one >= -1e-15, "no weight is negative", one);
    const SurfacePlace at = *placeInDomain(Surface(triangle), u, v);
    constexpr SurfaceOrders orders{2, 2};
    std::array<Vec3, orders.size()> rows;
    triangle.derivatives(at, orders, rows);
    const auto patches = patchesAt(triangle, u, v);
    const double size = sizeOf(patches);
    Vec3 sum(0);
    for (std::size_t k = 0; k < 3; ++k) sum += weights[k] * patches[k];
    fuzz::checkWithin(glm::length(sum - pointAt(Surface(triangle), at)) / size, rounding,
                      "the surface is the weighted sum of its patches");
    fuzz::checkWithin(glm::length(rows[0] - sum) / size, rounding,
                      "a point alone is the first of the rows");
    const double length = glm::length(unitNormal(Surface(triangle), at));
    fuzz::check(length == 0 || std::abs(length - 1) < rounding, "normals are units", length);
}

void checkGrid(const Surface& surface) {
    constexpr std::size_t nu = 4;
    constexpr std::size_t nv = 5;
    SurfaceGrid grid(surface, nu, nv);
    std::array<double, 3 * nu * nv> positions;
    std::array<double, 3 * nu * nv> normals;
    grid.points(0, nu * nv, positions, normals);
    for (std::size_t i = 0; i < nu; ++i) {
        for (std::size_t j = 0; j < nv; ++j) {
            const auto at = placeInDomain(surface, uniformParameter({0, 1}, i, nu),
                                          uniformParameter({0, 1}, j, nv));
            const Vec3 point = pointAt(surface, *at);
            const double* found = &positions[3 * (i * nv + j)];
            fuzz::checkWithin(glm::length(point - Vec3(found[0], found[1], found[2])) /
                                  (1 + glm::length(point)),
                              rounding, "a grid has the surface's points");
        }
    }
    for (const double one : normals) fuzz::check(!std::isnan(one), "normals are numbers", one);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Input input(data, size);
    const Surface one = patchOf(input, 2);
    const Surface other = patchOf(input, 2);
    const Surface third = patchOf(input, 1);
    const auto triangle = BlendingTriangle::make({one, other, third}, weightsOf(input));
    if (!triangle) {
        fuzz::check(!triangle.error().path.empty(), "a refusal says where");
        return 0;
    }
    for (const double u : fuzz::parametersOf(input, {0, 1}, triangle->breaksU().first(
                              std::min<std::size_t>(triangle->breaksU().size(), 5)))) {
        for (const double v : {0.0, 1.0, input.share()}) checkPlace(*triangle, u, v);
    }
    checkGrid(*triangle);
    return 0;
}
