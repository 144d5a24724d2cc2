#include "drawing/surface_samples.hpp"

#include "drawing/normals.hpp"
#include "geometry/surface_grid.hpp"
#include "geometry/surface_tessellation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>

namespace knotwork::drawing {

namespace {

constexpr std::size_t uniformLines = 8;     // cells between them, of a direction without knots
constexpr std::size_t mostLines = 64;
constexpr std::size_t coarseCells = 4;      // a span of the grid that is looked at first
constexpr std::size_t leastCoarse = 24;
constexpr std::size_t mostCoarse = 64;
/// Cell by cell a vertex takes 3 to 10 µs, fifty times what one of a grid takes.
constexpr double coarser = 16;
constexpr int enlargements = 16;            // of a tolerance that asks for too many triangles

/// Knots of a surface in a direction, each once, and how often the most repeated one inside stands.
struct Knots {
    std::vector<double> distinct;
    std::size_t most = 1;
};

Knots knotsIn(std::span<const double> knots, const Interval& domain) {
    Knots found;
    std::size_t times = 0;
    for (const double t : knots) {
        if (!domain.contains(t)) continue;
        const bool again = !found.distinct.empty() && found.distinct.back() == t;
        times = again ? times + 1 : 1;
        if (!again) found.distinct.push_back(t);
        if (t > domain.start && t < domain.end) found.most = std::max(found.most, times);
    }
    return found;
}

bool areUniform(const std::vector<double>& knots) noexcept {
    const double whole = knots.back() - knots.front();
    for (std::size_t i = 1; i + 1 < knots.size(); ++i) {
        const double even = uniformParameter({knots.front(), knots.back()}, i, knots.size());
        if (std::abs(knots[i] - even) > 1e-9 * whole) return false;
    }
    return true;
}

/// One direction of a surface: where its lines are, and how a grid meets them.
struct Direction {
    std::vector<double> lines;  ///< all, ends included
    std::size_t unit = 1;       ///< a grid whose cells are a multiple of it has the lines
    bool creased = false;       ///< edges or gaps along lines that a grid may miss
};

Direction direction(const Interval& domain, const Knots& knots, bool rough, bool gap) {
    Direction made;
    if (knots.distinct.size() <= 2) {
        made.unit = uniformLines;
        for (std::size_t i = 0; i <= uniformLines; ++i) {
            made.lines.push_back(uniformParameter(domain, i, uniformLines + 1));
        }
        return made;
    }
    made.lines = knots.distinct;
    const bool uniform = areUniform(knots.distinct);
    made.unit = uniform ? knots.distinct.size() - 1 : 1;
    made.creased = gap || (rough && !uniform);
    return made;
}

Direction splineDirection(const KnotVector& knots) {
    const Knots found = knotsIn(knots.knots(), knots.domain());
    const auto degree = static_cast<std::size_t>(knots.degree());
    return direction(knots.domain(), found, found.most >= degree, found.most > degree);
}

Direction blendDirection(const BlendDirection& blend) {
    const Knots found = knotsIn(blend.knots, blend.domain());
    return direction(blend.domain(), found, false, found.most > 1);
}

struct Directions {
    Direction u;
    Direction v;
};

Directions directionsOf(const Surface& surface) {
    if (const auto* spline = surface.as<BsplineSurface>()) {
        return {splineDirection(spline->knotsU()), splineDirection(spline->knotsV())};
    }
    if (const auto* blend = surface.as<BlendingSurface>()) {
        return {blendDirection(blend->alongU()), blendDirection(blend->alongV())};
    }
    const Rectangle whole = domain(surface);
    return {direction(whole.u, {}, false, false), direction(whole.v, {}, false, false)};
}

SurfaceSamples gridOf(const Surface& surface, std::size_t nu, std::size_t nv) {
    SurfaceSamples made;
    made.nu = nu;
    made.nv = nv;
    made.positions.resize(3 * nu * nv);
    made.normals.resize(3 * nu * nv);
    SurfaceGrid(surface, nu, nv).points(0, nu * nv, made.positions, made.normals);
    return made;
}

/// M_uu, M_uv, M_vv for parameters that run over [0, 1].
struct Bends {
    double uu = 0;
    double uv = 0;
    double vv = 0;
};

class Differences {
public:
    explicit Differences(const SurfaceSamples& grid) noexcept : grid_(grid) {}

    [[nodiscard]] Bends bends() const noexcept {
        Bends largest;
        for (std::size_t i = 0; i < grid_.nu; ++i) {
            for (std::size_t j = 0; j < grid_.nv; ++j) {
                if (i > 0 && i + 1 < grid_.nu) largest.uu = std::max(largest.uu, across(i, j));
                if (j > 0 && j + 1 < grid_.nv) largest.vv = std::max(largest.vv, along(i, j));
                if (i > 0 && j > 0) largest.uv = std::max(largest.uv, twist(i, j));
            }
        }
        const auto u = static_cast<double>(grid_.nu - 1);
        const auto v = static_cast<double>(grid_.nv - 1);
        return {largest.uu * u * u, largest.uv * u * v, largest.vv * v * v};
    }

private:
    [[nodiscard]] Vec3 at(std::size_t i, std::size_t j) const noexcept {
        const double* p = &grid_.positions[3 * (i * grid_.nv + j)];
        return {p[0], p[1], p[2]};
    }
    [[nodiscard]] double across(std::size_t i, std::size_t j) const noexcept {
        return glm::length(at(i - 1, j) - 2.0 * at(i, j) + at(i + 1, j));
    }
    [[nodiscard]] double along(std::size_t i, std::size_t j) const noexcept {
        return glm::length(at(i, j - 1) - 2.0 * at(i, j) + at(i, j + 1));
    }
    [[nodiscard]] double twist(std::size_t i, std::size_t j) const noexcept {
        return glm::length(at(i, j) - at(i - 1, j) - at(i, j - 1) + at(i - 1, j - 1));
    }

    const SurfaceSamples& grid_;
};

std::size_t upToMultiple(double cells, std::size_t unit) noexcept {
    const auto whole = static_cast<std::size_t>(std::ceil(std::clamp(cells, 1.0, 1e6)));
    return (whole + unit - 1) / unit * unit;
}

/// Cells a direction. With h_u = s/√M_uu and h_v = s/√M_vv the bound is s² (2 + 2 M_uv/√(M_uu M_vv)).
std::array<std::size_t, 2> cellsFor(const Bends& bends, double tolerance, std::size_t unitU,
                                    std::size_t unitV) {
    // A direction without curvature of its own still shares in the twist.
    const double u = std::max(bends.uu, bends.uv * 1e-3);
    const double v = std::max(bends.vv, bends.uv * 1e-3);
    if (!(u > 0) && !(v > 0)) return {unitU, unitV};
    const double mixed = u > 0 && v > 0 ? bends.uv / std::sqrt(u * v) : 0;
    const double parts = (u > 0 ? 1 : 0) + (v > 0 ? 1 : 0) + 2 * mixed;
    const double s = std::sqrt(8 * tolerance / parts);
    double cellsU = std::max(1.0, std::sqrt(u) / s);
    double cellsV = std::max(1.0, std::sqrt(v) / s);
    const auto most = std::max(static_cast<double>(mostSurfacePoints),
                               static_cast<double>(unitU * unitV));
    // One that is at its least leaves all to the other.
    for (int pass = 0; pass < 2 && cellsU * cellsV > most; ++pass) {
        const double over = std::sqrt(cellsU * cellsV / most);
        cellsU = std::max(1.0, cellsU / over);
        cellsV = std::max(1.0, cellsV / over);
    }
    return {upToMultiple(cellsU, unitU), upToMultiple(cellsV, unitV)};
}

std::size_t coarseOf(const Direction& direction) noexcept {
    const std::size_t spans = direction.lines.size() - 1;
    return upToMultiple(static_cast<double>(std::clamp(coarseCells * spans, leastCoarse, mostCoarse)),
                        std::min(direction.unit, mostCoarse));
}

std::optional<SurfaceSamples> cellByCell(const Surface& surface, double tolerance) {
    for (int i = 0; i < enlargements; ++i, tolerance *= 4) {
        auto made = trianglesWithin(surface, coarser * tolerance);
        if (!made) continue;
        return SurfaceSamples{std::move(made->positions), std::move(made->normals),
                              std::move(made->triangles)};
    }
    return std::nullopt;
}

std::vector<double> thinned(std::vector<double> lines) {
    const std::size_t step = (lines.size() - 1 + mostLines - 1) / mostLines;
    if (step <= 1) return lines;
    std::vector<double> kept;
    for (std::size_t i = 0; i + 1 < lines.size(); i += step) kept.push_back(lines[i]);
    kept.push_back(lines.back());
    return kept;
}

/// The number of the row of a grid at this parameter.
std::optional<std::size_t> rowAt(const Interval& domain, std::size_t count, double at) noexcept {
    if (count < 2) return std::nullopt;
    const double place = (at - domain.start) / domain.length() * static_cast<double>(count - 1);
    const double nearest = std::round(place);
    if (std::abs(place - nearest) > 1e-6) return std::nullopt;
    return static_cast<std::size_t>(nearest);
}

}  // namespace

SurfaceLines surfaceLines(const Surface& surface) {
    Directions directions = directionsOf(surface);
    return {thinned(std::move(directions.u.lines)), thinned(std::move(directions.v.lines))};
}

SurfaceSamples sampleSurface(const Surface& surface, double tolerance) {
    const auto [u, v] = directionsOf(surface);
    std::optional<SurfaceSamples> made;
    if (u.creased || v.creased) made = cellByCell(surface, tolerance);
    if (!made) {
        const SurfaceSamples coarse = gridOf(surface, coarseOf(u) + 1, coarseOf(v) + 1);
        const auto cells =
            cellsFor(Differences(coarse).bends(), tolerance, u.unit, v.unit);
        made = gridOf(surface, cells[0] + 1, cells[1] + 1);
        made->triangles = gridTriangles(made->nu, made->nv, closedDirections(surface));
    }
    completeNormals(made->normals);
    return std::move(*made);
}

std::vector<double> lineOnSurface(const Surface& surface, const SurfaceSamples& samples,
                                  bool alongU, double at, double tolerance) {
    const Rectangle whole = domain(surface);
    const auto row = alongU ? rowAt(whole.v, samples.nv, at) : rowAt(whole.u, samples.nu, at);
    if (!row) {
        auto points = isolineWithin(surface, {alongU, at}, tolerance);
        return points ? std::move(*points)
                      : isolinePoints(surface, {alongU, at}, mostSurfacePoints / 100);
    }
    std::vector<double> points;
    const std::size_t count = alongU ? samples.nu : samples.nv;
    points.reserve(3 * count);
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t place = alongU ? k * samples.nv + *row : *row * samples.nv + k;
        const auto first = samples.positions.begin() + static_cast<std::ptrdiff_t>(3 * place);
        points.insert(points.end(), first, first + 3);
    }
    return points;
}

}  // namespace knotwork::drawing
