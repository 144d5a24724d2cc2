// Blending triangles: three local patches of any kind, blended over a triangle.
//
//     S = W_0(λ) P_0(x, y) + W_1(λ) P_1(x, y) + W_2(λ) P_2(x, y),   x = λ_1, y = λ_2,
// with the weights of TriangleWeights. P_k is the k-th local patch, the rectangle that it is defined
// over mapped to [0, 1]²: the corners of the triangle, (0, 0), (1, 0) and (0, 1), are its corners
// (start, start), (end, start) and (start, end), and three equal patches blend into what they are
// over that half of the rectangle. In corner k, S has the point and, up to the order of the weights,
// all derivatives of P_k; on the side opposite to it P_k has no influence up to that order.
//
// As every surface it is one over a rectangle, [0, 1]², of which the side u = 0 is corner 0 and
// u = 1 the side opposite to it:
//     (λ_0, λ_1, λ_2) = (1 − u, u (1 − v), u v),   x = u (1 − v), y = u v.
// So grids and triangulations cover the triangle and nothing else, its sides are isolines, and the
// normal is that of P_x × P_y, since ∂(x, y)/∂(u, v) = u; corner 0 is a pole, with a limit there.
//
// (M. Duffy, Quadrature over a pyramid or cube of integrands with a singularity at a vertex, 1982,
// has the collapsed square.)
#pragma once

#include "geometry/result.hpp"
#include "geometry/surface_nesting.hpp"
#include "geometry/surface_parameter.hpp"
#include "geometry/triangle_weights.hpp"
#include "geometry/vec.hpp"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace knotwork {

class BlendingTriangle {
public:
    /// Refuses an order that is not 1 or 2 (OUT_OF_RANGE `order`); a B-function so flat that its
    /// weights would vanish in the middle, B(1/3) < 1e-9 (OUT_OF_RANGE `bFunction`); and blends within
    /// blends beyond what checkNesting() allows (TOO_LARGE `locals`).
    [[nodiscard]] static Result<BlendingTriangle> make(const std::array<Surface, 3>& locals,
                                                       TriangleBlend blend);

    /// The local patch of corner 0, 1 or 2, over its own rectangle.
    [[nodiscard]] const Surface& local(std::size_t corner) const noexcept;
    [[nodiscard]] const TriangleBlend& blend() const noexcept { return blend_; }
    /// W_0, W_1, W_2 at (u, v).
    [[nodiscard]] Barycentric weights(double u, double v) const noexcept;

    // As every kind of surface; outside its domain the formulas go on.
    [[nodiscard]] Rectangle domain() const noexcept { return {}; }
    [[nodiscard]] ClosedDirections closed() const noexcept { return {}; }
    /// Derivatives (a, b) with a + b ≤ 25; those beyond are not numbers.
    void derivatives(const SurfacePlace& at, const SurfaceOrders& orders,
                     std::span<Vec3> rows) const noexcept;
    /// Of the matrix of orders {order, order} only the entries with a + b ≤ order, which take half
    /// the order of all.
    void derivativesWithin(const SurfacePlace& at, int order,
                           std::span<Vec3> rows) const noexcept;
    /// Where knots of the patches leave through the sides of the triangle, at most 256. Between them
    /// they run along lines x = const and y = const, which are none of u or v: crossed() tells where.
    [[nodiscard]] std::span<const double> breaksU() const noexcept { return *breaksU_; }
    [[nodiscard]] std::span<const double> breaksV() const noexcept { return *breaksV_; }
    /// Whether a knot of a patch may run through the inside of a cell. O(log knots).
    [[nodiscard]] bool crossed(const Rectangle& cell) const noexcept;

    /// The coefficients of the Taylor series in u and v up to `order` ≤ 25 in all, graded;
    /// gradedSize(order) of them.
    void series(const SurfacePlace& at, std::size_t order, std::span<Vec3> terms) const noexcept;
    [[nodiscard]] SurfaceNesting nesting() const noexcept;

private:
    BlendingTriangle(const std::array<Surface, 3>& locals, TriangleBlend blend);
    void findBreaks();
    void takeWithin(const SurfacePlace& at, const SurfaceOrders& orders, std::size_t total,
                    std::span<Vec3> rows) const noexcept;

    /// The series of patch `corner` in x and y at a place of the unit square.
    void takePatch(std::size_t corner, const SurfacePlace& at, std::size_t order,
                   std::span<Vec3> terms) const noexcept;

    std::shared_ptr<const std::vector<Surface>> locals_;
    std::array<Rectangle, 3> over_;  // their domains
    TriangleBlend blend_;
    std::shared_ptr<const std::vector<double>> knotsX_;  // of all patches, inside (0, 1), ascending
    std::shared_ptr<const std::vector<double>> knotsY_;
    std::shared_ptr<const std::vector<double>> breaksU_;
    std::shared_ptr<const std::vector<double>> breaksV_;
};

}  // namespace knotwork
