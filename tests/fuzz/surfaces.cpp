// B-spline surfaces of every form: what holds at every knot from both sides, grids against single
// points, and refinements.
#include "fuzz/input.hpp"

#include "geometry/surface_differential.hpp"
#include "geometry/surface_grid.hpp"

using namespace knotwork;

namespace {

// Points in [−1, 1]³, weights 1/4 … 4, degrees up to 7, spans that differ by up to 1e10.
constexpr double rounding = 1e-9;

Result<BsplineSurface> surfaceOf(fuzz::Input& input) {
    const auto u = fuzz::splineOf(input, 7);
    if (!u) return u.error();
    const auto v = fuzz::splineOf(input, 7);
    if (!v) return v.error();
    const bool rational = input.whole(0, 2) == 0;
    const std::size_t count = u->points().size() * v->points().size();
    std::vector<Vec3> points;
    std::vector<double> weights;
    for (std::size_t k = 0; k < count; ++k) {
        // The rows of one curve moved along the other, and every third point somewhere else.
        const Vec3 sum = u->points()[k / v->points().size()] + v->points()[k % v->points().size()];
        const Vec3 other(input.real(), input.real(), input.real());
        points.push_back(k % 3 == 0 ? other : 0.5 * sum);
        if (rational) weights.push_back(std::pow(4.0, input.real()));
    }
    return BsplineSurface::make(u->knotVector(), v->knotVector(), std::move(points),
                                std::move(weights));
}

void checkPlace(const Surface& surface, double u, double v) {
    const auto at = placeInDomain(surface, u, v);
    fuzz::check(at.ok(), "what lies in the domain is taken");
    const Vec3 point = pointAt(surface, *at);
    for (int axis = 0; axis < 3; ++axis) {
        fuzz::checkWithin(std::abs(point[axis]), 1 + rounding, "points stay in the box of the net");
    }
    const double length = glm::length(unitNormal(surface, *at));
    fuzz::check(length == 0 || std::abs(length - 1) < rounding, "normals are units", length);
    if (const auto found = curvatures(surface, *at)) {
        fuzz::check(found->k1 >= found->k2, "principal curvatures are in order", found->k1);
    }
}

void checkGrid(const Surface& surface, std::size_t nu, std::size_t nv) {
    SurfaceGrid grid(surface, nu, nv);
    std::vector<double> positions(3 * nu * nv);
    std::vector<double> normals(3 * nu * nv);
    grid.points(0, nu * nv, positions, normals);
    for (std::size_t i = 0; i < nu; ++i) {
        for (std::size_t j = 0; j < nv; ++j) {
            const Rectangle whole = domain(surface);
            const auto at = placeInDomain(surface, uniformParameter(whole.u, i, nu),
                                          uniformParameter(whole.v, j, nv));
            const Vec3 point = pointAt(surface, *at);
            const double* found = &positions[3 * (i * nv + j)];
            const double distance = glm::length(point - Vec3(found[0], found[1], found[2]));
            fuzz::checkWithin(distance, rounding, "a grid has the points of the surface");
        }
    }
    for (const double one : normals) fuzz::check(std::isfinite(one), "normals are finite", one);
}

std::vector<double> withOneMore(const KnotVector& knots, double share) {
    std::vector<double> more(knots.knots().begin(), knots.knots().end());
    const Interval domain = knots.domain();
    more.push_back(std::min(domain.start + share * domain.length(), domain.end));
    std::sort(more.begin(), more.end());
    return more;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Input input(data, size);
    const auto made = surfaceOf(input);
    if (!made) return 0;
    const auto us = fuzz::parametersOf(input, made->domain().u, made->breaksU());
    const auto vs = fuzz::parametersOf(input, made->domain().v, made->breaksV());
    const Surface surface = *made;
    for (std::size_t i = 0; i < std::max(us.size(), vs.size()); ++i) {
        checkPlace(surface, us[i % us.size()], vs[i % vs.size()]);
        checkPlace(surface, us[i % us.size()], vs[(3 * i + 1) % vs.size()]);
    }
    const auto nu = static_cast<std::size_t>(input.whole(2, 9));
    checkGrid(surface, nu, static_cast<std::size_t>(input.whole(2, 40)));
    const double shareU = input.share();
    const auto refined = refine(*made, withOneMore(made->knotsU(), shareU),
                                withOneMore(made->knotsV(), input.share()));
    if (!refined) {
        fuzz::check(refined.error().path.starts_with("knots"), "a refusal names the knots");
        return 0;
    }
    fuzz::check(refined->rowCount() == made->rowCount() + 1, "a knot brings a row");
    return 0;
}
