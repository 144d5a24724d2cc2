// Blends of patches of any models, knots, poses and B-functions: refused, or a surface that is the
// sum of four patches by weights that sum to one, at every knot from both sides, with a grid that has
// its points and patches that are surfaces by themselves.
#include "fuzz/models.hpp"

#include "geometry/patch_surface.hpp"
#include "geometry/surface_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>

using namespace knotwork;

namespace {

constexpr double rounding = 1e-9;  // relative to the size of the patches

Surface modelOf(fuzz::Input& input) {
    if (input.whole(0, 2) > 0) {
        if (auto made = fuzz::translationSurface(input, 4)) return *std::move(made);
    }
    return fuzz::namedSurface(input);
}

BlendDirection directionOf(fuzz::Input& input, const Interval& domain) {
    BlendDirection along;
    along.count = static_cast<std::size_t>(input.whole(0, 6));
    along.form = input.whole(0, 1) == 0 ? BlendForm::open : BlendForm::closed;
    along.blend = fuzz::blendOf(input, 1);
    if (input.whole(0, 2) == 0) return along;
    const std::size_t number = blendingKnotCount(along.count, along.form);
    along.knots.push_back(domain.start + domain.length() * input.real() / 4);
    while (along.knots.size() < number) {
        along.knots.push_back(along.knots.back() + domain.length() * input.gap(1e-6) / 2);
    }
    if (input.whole(0, 15) == 0) along.knots[input.byte() % along.knots.size()] = input.anyNumber();
    return along;
}

/// Whether knots lie where the model is: far from it polynomials grow beyond all bounds.
bool near(const Interval& knots, const Interval& whole) {
    return knots.start >= whole.start - 3 * whole.length() &&
           knots.end <= whole.end + 3 * whole.length();
}

/// What may be rounded: the four patches about the place, and their sum.
struct Blended {
    Vec3 sum{0};
    double size = 1;
};

Blended blendedAt(const BlendingSurface& surface, const SurfacePlace& at) {
    const BlendingSpan u = surface.alongU().spanAt(at.u, at.sideU);
    const BlendingSpan v = surface.alongV().spanAt(at.v, at.sideV);
    const double beta = surface.alongU().blend.value(u.ratio());
    const double gamma = surface.alongV().blend.value(v.ratio());
    Blended found;
    for (int a = 0; a < 2; ++a) {
        for (int b = 0; b < 2; ++b) {
            Vec3 point;
            surface.patch(a == 0 ? u.first : u.second, b == 0 ? v.first : v.second,
                          {a == 0 ? u.t : u.t - surface.shiftU(u),
                           b == 0 ? v.t : v.t - surface.shiftV(v), at.sideU, at.sideV},
                          {}, {&point, 1});
            found.sum += (a == 0 ? 1 - beta : beta) * (b == 0 ? 1 - gamma : gamma) * point;
            found.size = std::max(found.size, glm::length(point));
        }
    }
    return found;
}

void checkPlace(const BlendingSurface& surface, double u, double v) {
    for (const Side side : {Side::left, Side::right}) {
        const SurfacePlace at{u, v, side, side};
        constexpr SurfaceOrders orders{2, 2};
        std::array<Vec3, orders.size()> rows;
        std::array<Vec3, 1> point;
        surface.derivatives(at, orders, rows);
        surface.derivatives(at, {}, point);
        const Blended expected = blendedAt(surface, at);
        fuzz::checkWithin(glm::length(point[0] - expected.sum) / expected.size, rounding,
                          "the surface is the weighted sum of its patches");
        fuzz::checkWithin(glm::length(rows[0] - point[0]) / expected.size, rounding,
                          "a point alone is the first of the rows");
    }
}

void checkGrid(const BlendingSurface& surface) {
    constexpr std::size_t nu = 5;
    constexpr std::size_t nv = 7;
    SurfaceGrid grid(surface, nu, nv);
    std::array<double, 3 * nu * nv> positions;
    std::array<double, 3 * nu * nv> normals;
    grid.points(0, nu * nv, positions, normals);
    double farthest = 0;
    double largest = 1;  // a power form is rounded by what it is in all of its cell
    for (std::size_t i = 0; i < nu; ++i) {
        for (std::size_t j = 0; j < nv; ++j) {
            const auto at =
                placeInDomain(Surface(surface), uniformParameter(surface.domain().u, i, nu),
                              uniformParameter(surface.domain().v, j, nv));
            const Blended expected = blendedAt(surface, *at);
            const double* found = &positions[3 * (i * nv + j)];
            farthest = std::max(
                farthest, glm::length(expected.sum - Vec3(found[0], found[1], found[2])));
            largest = std::max(largest, expected.size);
        }
    }
    // Parameters of a grid are rounded once more than those of a place: short spans magnify that.
    fuzz::checkWithin(farthest / largest, 10 * rounding, "a grid has the surface's points");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Input input(data, size);
    const Surface model = modelOf(input);
    const Rectangle whole = domain(model);
    BlendDirection u = directionOf(input, whole.u);
    BlendDirection v = directionOf(input, whole.v);
    const PatchCut cut{static_cast<PatchKind>(input.whole(0, 2)),
                       {input.whole(0, 7), input.whole(0, 7)}};
    std::vector<Pose> poses;
    for (std::size_t k = 0; k < u.count * v.count; ++k) poses.push_back(fuzz::poseOf(input));
    const auto surface = BlendingSurface::make(model, std::move(u), std::move(v), cut, poses);
    if (!surface) {
        fuzz::check(!surface.error().path.empty(), "a refusal says where");
        return 0;
    }
    if (!near(surface->domain().u, whole.u) || !near(surface->domain().v, whole.v)) return 0;
    for (const double s : fuzz::parametersOf(input, surface->domain().u, surface->breaksU())) {
        for (const double t : fuzz::parametersOf(input, surface->domain().v, surface->alongV().knots)) {
            checkPlace(*surface, s, t);
        }
    }
    checkGrid(*surface);
    const std::size_t i = input.byte() % surface->alongU().count;
    const std::size_t j = input.byte() % surface->alongV().count;
    if (const auto patch = patchSurface(*surface, i, j)) {
        fuzz::check(isFinite(pointAt(*patch, {domain(*patch).u.start, domain(*patch).v.end})),
                    "a patch by itself is finite");
    }
    return 0;
}
