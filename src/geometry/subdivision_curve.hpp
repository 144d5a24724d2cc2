// Subdivision curves: the polyline through a final polygon, under the parameter of its limit.
//
// With n points and h = 2^−levels, vertex j of the final polygon stands at the parameter
//   degree d (Lane–Riesenfeld; Chaikin is d = 2):
//     closed  j·h − (d−1)h/2, modulo n, in the domain [0, n];
//     open    d − (d−1)h/2 + j·h, in the domain [d, n];
//   four-point:  j·h, in the domain [0, n] where closed, [0, n−1] where open,
// which for the former is where the basis function of the vertex has its maximum: the polyline then
// converges to the uniform B-spline (closed, knots 0 … n; open, knots 0 … n+d) at equal parameters,
// four times as near with every level. An open polygon of degree d reaches (d−1)h/2 past both ends
// of the domain, since the spline ends before its control polygon does: the curve is the part of it
// between them, continued along the rest.
#pragma once

#include "geometry/curve_subdivision.hpp"
#include "geometry/interval.hpp"

#include <span>
#include <vector>

namespace knotwork {

/// How many points the final polygon of a curve may have.
inline constexpr std::size_t maxSubdivisionCurvePoints = std::size_t{1} << 20;

class SubdivisionCurve {
public:
    /// Refusals: as checkSubdivision() with at most 2^20 points of the final polygon.
    [[nodiscard]] static Result<SubdivisionCurve> make(CurveSubdivision subdivision);

    [[nodiscard]] const CurveSubdivision& subdivision() const noexcept { return subdivision_; }
    /// The final polygon; a closed one does not repeat its first point.
    [[nodiscard]] std::span<const Vec3> vertices() const noexcept { return vertices_; }

    [[nodiscard]] Interval domain() const noexcept;
    [[nodiscard]] bool closed() const noexcept { return subdivision_.closed; }
    /// 2 where all points have z = 0, else 3.
    [[nodiscard]] int dimension() const noexcept { return dimension_; }

    /// The point, the slope of the leg (of the one before or after a vertex), zeros. O(1).
    void evaluate(double t, Side side, std::span<Vec3> rows) const noexcept;
    /// The parameters of the vertices in the domain, ascending (exact).
    [[nodiscard]] std::span<const double> breaks() const noexcept { return breaks_; }

    /// Where the points that the polygon was made from go, one each: for degree d the B-spline's
    /// point at the parameter above (h = 1; an odd degree's knot, the middle of an even one's span),
    /// at the nearer end of an open domain for those before or past it. The four-point scheme leaves
    /// them where they are. O(d²) each.
    [[nodiscard]] std::vector<Vec3> limitPoints() const;

    /// The derivatives of the limit there. Four-point:
    ///     ((P_{i+1} − P_{i−1}) / 2 − w (P_{i+2} − P_{i−2})) / (1 − 4w),
    /// the left eigenvector to 1/2 of the scheme, for 0 < w < 0.19273 (C¹: J. Hechler, B. Mößner,
    /// U. Reif, C¹-continuity of the generalized four-point scheme, 2009). NOT_SUPPORTED for any
    /// other tension and for degree 1, whose limits have corners.
    [[nodiscard]] Result<std::vector<Vec3>> limitTangents() const;

private:
    explicit SubdivisionCurve(CurveSubdivision subdivision);

    struct Leg;
    [[nodiscard]] Leg legAt(double t, Side side) const noexcept;
    [[nodiscard]] std::vector<Vec3> limitRows(std::size_t order) const;

    CurveSubdivision subdivision_;
    std::vector<Vec3> vertices_;
    std::vector<double> breaks_;
    double spacing_;
    double first_;  ///< the parameter of the first vertex
    int dimension_;
};

}  // namespace knotwork
