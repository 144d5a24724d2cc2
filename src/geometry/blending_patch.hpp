// Local patches cut from a model surface at a knot of each direction: what each kind keeps of it.
//
// A sub-surface is the model itself. A plane is the tangent plane
//     S + (u − u_i) S_u + (v − v_j) S_v,
// and a Bézier patch of degree (m, n) the Taylor polynomial with all derivatives up to (m, n),
//     Σ_{a ≤ m, b ≤ n} ∂^{a+b}S/∂u^a∂v^b (u − u_i)^a/a! (v − v_j)^b/b!.
// Both are kept as that matrix of derivatives, so that a patch has them exactly at its knots.
#pragma once

#include "geometry/pose.hpp"
#include "geometry/result.hpp"
#include "geometry/surface_parameter.hpp"
#include "geometry/vec.hpp"

#include <array>
#include <span>

namespace knotwork {

class Surface;

enum class PatchKind { subSurface, plane, bezier };

struct PatchCut {
    PatchKind kind = PatchKind::subSurface;
    std::array<int, 2> degree{3, 3};  ///< of Bézier patches along u and v, 1 … 25

    /// Of the polynomial; (0, 0) for a sub-surface, which has one coefficient: its origin.
    [[nodiscard]] SurfaceOrders orders() const noexcept {
        if (kind == PatchKind::subSurface) return {0, 0};
        return kind == PatchKind::plane ? SurfaceOrders{1, 1} : SurfaceOrders{degree[0], degree[1]};
    }
    friend bool operator==(const PatchCut&, const PatchCut&) = default;
};

/// What a patch of this kind keeps of the model at its knots, cut.orders().size() derivatives.
/// NOT_FINITE `model` where the model has none there.
[[nodiscard]] Result<Done> cutPatch(const Surface& model, const PatchCut& cut,
                                    const SurfacePlace& at, std::span<Vec3> matrix);

/// The derivatives (a, b) ≤ `orders` of the polynomial with these derivatives `matrix` at its
/// centre, at the place (centre + x, centre + y). O(degree) an entry.
void polynomialDerivatives(std::span<const Vec3> matrix, const SurfaceOrders& degree, double x,
                           double y, const SurfaceOrders& orders, std::span<Vec3> rows) noexcept;

/// t^k / k! for k < powers.size().
void taylorPowers(double t, std::span<double> powers) noexcept;

/// How a patch stands: posed about its own origin, its point at its knots.
class PatchPlace {
public:
    PatchPlace(const Vec3& origin, const Pose& pose) noexcept
        : origin_(origin), pose_(pose), placement_(affineOf(pose, origin)) {}

    /// Where the patch's own origin stands before it is posed, the pivot of scale and rotation.
    [[nodiscard]] const Vec3& origin() const noexcept { return origin_; }
    [[nodiscard]] const Pose& pose() const noexcept { return pose_; }
    [[nodiscard]] const Affine& placement() const noexcept { return placement_; }
    /// Places a matrix of derivatives.
    void place(std::span<Vec3> rows) const noexcept;

private:
    Vec3 origin_;
    Pose pose_;
    Affine placement_;
};

}  // namespace knotwork
