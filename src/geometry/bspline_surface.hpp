// B-spline surfaces, polynomial or rational; each direction open, clamped or closed, of a degree of
// its own: S(u, v) = Σ_i Σ_j N_i(u) N_j(v) c_{i,j}.
#pragma once

#include "geometry/knot_vector.hpp"
#include "geometry/result.hpp"
#include "geometry/surface_parameter.hpp"
#include "geometry/vec.hpp"

#include <span>
#include <string>
#include <vector>

namespace knotwork {

class BsplineSurface {
public:
    /// Points row by row: point (i, j), i along u, at [i · columns + j], columns those of knotsV;
    /// weights likewise, or none. Refusals: TOO_LARGE `points` beyond 100 000 in all; WRONG_LENGTH
    /// `points` or `weights`; NOT_FINITE and OUT_OF_RANGE `points[i][j]` (|coordinate| ≤ 1e12) and
    /// `weights[i][j]` (1e-9 … 1e9).
    [[nodiscard]] static Result<BsplineSurface> make(KnotVector knotsU, KnotVector knotsV,
                                                     std::vector<Vec3> points,
                                                     std::vector<double> weights = {});

    [[nodiscard]] const KnotVector& knotsU() const noexcept { return knotsU_; }
    [[nodiscard]] const KnotVector& knotsV() const noexcept { return knotsV_; }
    [[nodiscard]] std::span<const Vec3> points() const noexcept { return points_; }
    /// Empty, or one per point.
    [[nodiscard]] std::span<const double> weights() const noexcept { return weights_; }
    [[nodiscard]] std::size_t rowCount() const noexcept {
        return static_cast<std::size_t>(knotsU_.pointCount());
    }
    [[nodiscard]] std::size_t columnCount() const noexcept {
        return static_cast<std::size_t>(knotsV_.pointCount());
    }
    /// Whether the weights matter: given and not all equal.
    [[nodiscard]] bool rational() const noexcept { return rational_; }

    // As every kind of surface; a closed direction wraps, any other is continued by its end pieces.
    [[nodiscard]] Rectangle domain() const noexcept { return {knotsU_.domain(), knotsV_.domain()}; }
    [[nodiscard]] ClosedDirections closed() const noexcept {
        return {knotsU_.closed(), knotsV_.closed()};
    }
    /// O(d_u d_v) an entry of the matrix, rational surfaces O(its place) besides.
    void derivatives(const SurfacePlace& at, const SurfaceOrders& orders,
                     std::span<Vec3> rows) const noexcept;
    [[nodiscard]] std::span<const double> breaksU() const noexcept { return knotsU_.knots(); }
    [[nodiscard]] std::span<const double> breaksV() const noexcept { return knotsV_.knots(); }

    friend bool operator==(const BsplineSurface&, const BsplineSurface&) = default;

private:
    BsplineSurface(KnotVector knotsU, KnotVector knotsV, std::vector<Vec3> points,
                   std::vector<double> weights);

    KnotVector knotsU_;
    KnotVector knotsV_;
    std::vector<Vec3> points_;
    std::vector<double> weights_;
    bool rational_;
};

/// The same surface over the full refined vectors, in the forms of the old ones, by the Oslo
/// algorithm along every column and then every row. Refusals are those of refinedKnots() with paths
/// `knots[0]…` for u and `knots[1]…` for v, and TOO_LARGE `knots` beyond 100 000 points in all.
[[nodiscard]] Result<BsplineSurface> refine(const BsplineSurface& surface,
                                            std::vector<double> refinedU,
                                            std::vector<double> refinedV);

/// An error of KnotVector about direction 0 (u) or 1 (v) as seen from a surface: `knots[3]` is
/// `knots[1][3]`, `degree` is `degree[1]`; a number of `points` that does not do is one of rows, or
/// one of columns at `points[0]`.
[[nodiscard]] Error ofDirection(Error error, std::size_t direction);

}  // namespace knotwork
