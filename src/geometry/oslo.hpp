// The Oslo algorithms: all points of a refined curve in one pass, each a combination of d+1 points
// of the curve with weights that do not depend on them, the discrete B-splines.
//     b_j = sum_i alpha_{i,d}(j) c_i,  alpha_{i,0}(j) = [tau_i ≤ t_j < tau_{i+1}],
//     alpha_{i,k}(j) = w_{k,i}(t_{j+k}) alpha_{i,k-1}(j) + (1 - w_{k,i+1}(t_{j+k})) alpha_{i+1,k-1}(j)
// For checked refinements: `refined` is a result of refinedKnots() (refinement.hpp).
#pragma once

#include "geometry/bspline_indexing.hpp"
#include "geometry/homogeneous.hpp"
#include "geometry/knot_vector.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace knotwork {

/// The knots of a curve, with those that stand before and after them where a span needs more than
/// there are: d of their own making at either end of an open vector, which only ever meet weights
/// that are exactly 0. Column j of span s is then the control point s-d+j of pointOf().
class OsloKnots {
public:
    explicit OsloKnots(const KnotVector& knots);
    OsloKnots(const OsloKnots&) = delete;
    OsloKnots& operator=(const OsloKnots&) = delete;

    [[nodiscard]] std::span<const double> all() const noexcept { return all_; }
    [[nodiscard]] std::size_t degree() const noexcept { return degree_; }

    /// Points in the order in which spans use them: span s the points s-d … s of the answer.
    template <class Point>
    [[nodiscard]] std::vector<Point> inOrder(std::span<const Point> points) const {
        std::vector<Point> ordered;
        ordered.reserve(before_ + points.size() + after_);
        ordered.insert(ordered.end(), before_, points.front());
        ordered.insert(ordered.end(), points.begin(), points.end());
        for (std::size_t i = 0; i < after_; ++i) {
            ordered.push_back(closed_ ? points[i] : points.back());
        }
        return ordered;
    }

    /// Which control point is point i of that order; nothing's where its weight is exactly 0.
    [[nodiscard]] std::size_t pointOf(std::size_t i) const noexcept;

private:
    std::vector<double> own_;
    std::span<const double> all_;
    std::size_t degree_;
    std::size_t count_;
    std::size_t before_ = 0;
    std::size_t after_ = 0;
    bool closed_;
};

/// Calls visit(j, span, arguments) for every control point j of `finer`, any vector that has each
/// knot of `knots` at least as often, of the same or a higher degree: `span` is that of `knots` in
/// which t_j lies, `arguments` are the knots of j that follow t_j. O(n + m).
template <class Visit>
void forEachOsloRow(const OsloKnots& knots, const KnotVector& finer, Visit visit) {
    const std::span<const double> tau = knots.all();
    const std::span<const double> t = finer.extended();
    const auto count = static_cast<std::size_t>(finer.pointCount());
    const auto degree = static_cast<std::size_t>(finer.degree());
    // Rows of a closed vector are taken where t_j lies in its period, whatever stands at the seam.
    const std::size_t first = finer.closed() ? seamIndex(finer) : 0;
    std::size_t span = knots.degree();
    for (std::size_t row = first; row < first + count; ++row) {
        while (tau[span + 1] <= t[row]) ++span;
        visit(row < count ? row : row - count, span, t.subspan(row + 1, degree));
    }
}

/// The matrix of discrete B-splines, m rows of n: a control point of the refined curve is its row
/// times the points of the curve. Rows sum to 1 and none of their numbers is negative; at most d+1
/// of them are not 0. O(m n).
[[nodiscard]] std::vector<double> osloMatrix(const KnotVector& knots, const KnotVector& refined);

/// Oslo 1: builds the rows of the matrix, and with them the points. O(m d²), nothing is allocated
/// but the answer and what OsloKnots holds.
[[nodiscard]] std::vector<Vec3> oslo1(const KnotVector& knots, const KnotVector& refined,
                                      std::span<const Vec3> points);
[[nodiscard]] std::vector<Homogeneous> oslo1(const KnotVector& knots, const KnotVector& refined,
                                             std::span<const Homogeneous> points);

/// Oslo 2: each point as the value of the blossom at its d knots. O(m d²).
[[nodiscard]] std::vector<Homogeneous> oslo2(const KnotVector& knots, const KnotVector& refined,
                                             std::span<const Homogeneous> points);

}  // namespace knotwork
