#include "geometry/surface_grid.hpp"

#include "geometry/blending_grid.hpp"
#include "geometry/blending_model_grid.hpp"
#include "geometry/bspline_grid.hpp"
#include "geometry/point_grid.hpp"
#include "geometry/polynomial_piece.hpp"
#include "geometry/surface_differential.hpp"
#include "geometry/table_grid.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <variant>

namespace knotwork {

namespace {

/// The power forms of all rows of the net pay where there are more points of the grid than of it.
constexpr std::size_t worthwhile = 4;

using Rows = std::variant<PolynomialGrid, TensorGrid, ProductGrid, BlendedPolynomialGrid,
                          BlendedModelGrid, PointGrid<BlendingSurface>,
                          PointGrid<BlendingTriangle>>;

Rows rowsOf(const BsplineSurface& spline, const GridLine& u, const GridLine& v) {
    const auto degree = static_cast<std::size_t>(spline.knotsV().degree());
    const bool polynomial = !spline.rational() && degree <= maxPowerDegree;
    if (polynomial && u.count * v.count >= worthwhile * spline.points().size()) {
        return PolynomialGrid(spline, u, v);
    }
    return TensorGrid(spline, u, v);
}

Rows rowsOf(const ParametricSurface& model, const GridLine& u, const GridLine& v) {
    return ProductGrid(model, u, v);
}

Rows rowsOf(const BlendingTriangle& triangle, const GridLine& u, const GridLine& v) {
    return PointGrid<BlendingTriangle>(triangle, u, v);
}

Rows rowsOf(const BlendingSurface& blend, const GridLine& u, const GridLine& v) {
    if (blend.isModel()) {
        return std::visit([&](const auto& kind) { return rowsOf(kind, u, v); },
                          blend.model().kind());
    }
    if (!blend.cutsModel()) return BlendedPolynomialGrid(blend, u, v);
    if (BlendedModelGrid::suits(blend)) return BlendedModelGrid(blend, u, v);
    return PointGrid<BlendingSurface>(blend, u, v);
}

}  // namespace

struct SurfaceGrid::Engine {
    Surface surface;  // the rows refer to it
    Rows rows;
    std::optional<std::size_t> prepared = {};

    Engine(Surface of, const GridLine& u, const GridLine& v)
        : surface(std::move(of)),
          rows(std::visit([&](const auto& kind) { return rowsOf(kind, u, v); }, surface.kind())) {}
};

SurfaceGrid::SurfaceGrid(Surface surface, std::size_t nu, std::size_t nv)
    : u_{domain(surface).u, closedDirections(surface).u, nu},
      v_{domain(surface).v, closedDirections(surface).v, nv},
      engine_(std::make_unique<Engine>(std::move(surface), u_, v_)) {}
SurfaceGrid::~SurfaceGrid() = default;
SurfaceGrid::SurfaceGrid(SurfaceGrid&&) noexcept = default;
SurfaceGrid& SurfaceGrid::operator=(SurfaceGrid&&) noexcept = default;

void SurfaceGrid::points(std::size_t first, std::size_t count, std::span<double> positions,
                         std::span<double> normals) noexcept {
    const auto part = [&](auto& rows, std::size_t row, std::size_t column, std::size_t number,
                          std::size_t done) {
        if (engine_->prepared != row) rows.prepare(row);
        engine_->prepared = row;
        rows.columns(column, number, &positions[3 * done], &normals[3 * done]);
        for (const std::size_t j : rows.unclear()) {
            const GridLine::Place u = u_.at(row);
            const GridLine::Place v = v_.at(j);
            const SurfacePlace at{u.parameter, v.parameter, u.side, v.side};
            write(unitNormal(engine_->surface, at), &normals[3 * (done + j - column)]);
        }
    };
    for (std::size_t done = 0; done < count;) {
        const std::size_t row = (first + done) / v_.count;
        const std::size_t column = (first + done) % v_.count;
        const std::size_t number = std::min(count - done, v_.count - column);
        std::visit([&](auto& rows) { part(rows, row, column, number, done); }, engine_->rows);
        done += number;
    }
}

std::vector<std::uint32_t> gridTriangles(std::size_t nu, std::size_t nv, ClosedDirections closed) {
    std::vector<std::uint32_t> triangles;
    triangles.reserve(6 * (nu - 1) * (nv - 1));
    for (std::size_t i = 0; i + 1 < nu; ++i) {
        const std::size_t row = i * nv;
        const std::size_t next = closed.u && i + 2 == nu ? 0 : row + nv;
        for (std::size_t j = 0; j + 1 < nv; ++j) {
            const std::size_t right = closed.v && j + 2 == nv ? 0 : j + 1;
            for (const std::size_t corner :
                 {row + j, next + j, next + right, row + j, next + right, row + right}) {
                triangles.push_back(static_cast<std::uint32_t>(corner));
            }
        }
    }
    return triangles;
}

}  // namespace knotwork
