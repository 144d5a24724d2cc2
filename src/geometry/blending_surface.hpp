// Blending surfaces (Lakså, Bang, Dechevsky: Exploring expo-rational B-splines for curves and
// surfaces, 2005).
//
// A model surface is cut into nu × nv local patches, patch (i, j) centred at the knots (u_i, v_j).
// Between neighbouring knots of both directions the four patches centred at the corners are blended
// by a B-function a direction, each of the cell's own parameter w = (t − t_i)/h:
//     S(u, v) = Σ_{a, b ∈ {0, 1}} β_a(u) γ_b(v) P_{i+a, j+b}(u, v),   β_1 = B_u(w), β_0 = 1 − β_1.
// So S has at (u_i, v_j) the point and, up to the Hermite orders of the B-functions, the derivatives
// of P_{i,j}. A closed direction has one more knot, t_n = t_0 + T, and blends its last patches into
// its first ones at t − T, each direction by its own number of patches. Two equal knots in a row are
// a permitted break. Beyond an open end the patches there go on.
#pragma once

#include "geometry/b_function.hpp"
#include "geometry/blending_knots.hpp"
#include "geometry/blending_patch.hpp"
#include "geometry/surface_nesting.hpp"
#include "geometry/surface_parameter.hpp"

#include <memory>
#include <span>
#include <vector>

namespace knotwork {

/// How patches are blended along one direction.
struct BlendDirection {
    std::size_t count = 2;  ///< of patches
    BlendForm form = BlendForm::open;
    BFunction blend{};
    std::vector<double> knots{};  ///< empty: uniform over the model's domain

    [[nodiscard]] Interval domain() const noexcept { return {knots.front(), knots.back()}; }
    [[nodiscard]] bool closed() const noexcept { return form == BlendForm::closed; }
    [[nodiscard]] BlendingSpan spanAt(double t, Side side) const noexcept {
        return blendingSpan(knots, form, t, side);
    }
    /// Where the patches of this index take part.
    [[nodiscard]] Interval support(std::size_t index) const noexcept {
        return blendingSupport(knots, index, form);
    }
};

class BlendingSurface {
public:
    /// `poses` empty, or one for each patch, patch (i, j) at [i · nv + j].
    ///
    /// Refuses fewer than 2 patches in a direction (OUT_OF_RANGE `locals[0]` or `locals[1]`), more
    /// than 10 000 patches or 500 000 coefficients in all (TOO_LARGE `locals`), degrees that are not
    /// 1 … 25 (`degree[i]`), knots as checkBlendingKnots() does (`knots[0]…` along u, `knots[1]…`
    /// along v), poses as checkPose() does under `poses[k]`, a model without the derivatives that
    /// are needed (NOT_FINITE `model`), and sub-surfaces of blends beyond what checkNesting() allows
    /// (TOO_LARGE `model`).
    [[nodiscard]] static Result<BlendingSurface> make(Surface model, BlendDirection u,
                                                      BlendDirection v, const PatchCut& cut,
                                                      std::span<const Pose> poses = {});

    [[nodiscard]] const Surface& model() const noexcept { return *model_; }
    [[nodiscard]] const PatchCut& cut() const noexcept { return cut_; }
    [[nodiscard]] const BlendDirection& alongU() const noexcept { return u_; }
    [[nodiscard]] const BlendDirection& alongV() const noexcept { return v_; }

    // As every kind of surface.
    [[nodiscard]] Rectangle domain() const noexcept { return {u_.domain(), v_.domain()}; }
    [[nodiscard]] ClosedDirections closed() const noexcept { return {u_.closed(), v_.closed()}; }
    /// Leibniz' rule in both directions; only patches whose weights are not zero are evaluated, and
    /// sub-surfaces that are posed alike are evaluated once and not blended.
    void derivatives(const SurfacePlace& at, const SurfaceOrders& orders,
                     std::span<Vec3> rows) const noexcept;
    /// The knots, and between them those of the model where sub-surfaces are blended.
    [[nodiscard]] std::span<const double> breaksU() const noexcept { return *breaksU_; }
    [[nodiscard]] std::span<const double> breaksV() const noexcept { return *breaksV_; }

    /// Patch (i, j), posed, by itself: the same for any place, in the parameters of the surface.
    void patch(std::size_t i, std::size_t j, const SurfacePlace& at, const SurfaceOrders& orders,
               std::span<Vec3> rows) const noexcept;
    [[nodiscard]] const PatchPlace& place(std::size_t i, std::size_t j) const noexcept {
        return (*places_)[i * v_.count + j];
    }
    /// What patch (i, j) keeps of the model, not posed: cut().orders().size() derivatives.
    [[nodiscard]] std::span<const Vec3> matrix(std::size_t i, std::size_t j) const noexcept {
        const std::size_t size = cut_.orders().size();
        return std::span<const Vec3>(*matrices_).subspan((i * v_.count + j) * size, size);
    }
    /// Whether the patches are sub-surfaces.
    [[nodiscard]] bool cutsModel() const noexcept { return cut_.kind == PatchKind::subSurface; }
    /// Whether it is nothing but its model: sub-surfaces that nobody posed, over all of it.
    [[nodiscard]] bool isModel() const noexcept;
    /// By how much the second patch of a span is evaluated earlier: span.shift, or 0 where the patch
    /// is the same there (a sub-surface of a model that has this period itself).
    [[nodiscard]] double shiftU(const BlendingSpan& span) const noexcept {
        return cutsModel() && modelTurnsU_ ? 0 : span.shift;
    }
    [[nodiscard]] double shiftV(const BlendingSpan& span) const noexcept {
        return cutsModel() && modelTurnsV_ ? 0 : span.shift;
    }

    /// With this pose, already checked, of patch (i, j). O(patches).
    [[nodiscard]] BlendingSurface withPose(std::size_t i, std::size_t j, const Pose& pose) const;
    /// One pose for each patch, already checked.
    [[nodiscard]] BlendingSurface withPoses(std::span<const Pose> poses) const;
    [[nodiscard]] SurfaceNesting nesting() const noexcept;

private:
    class Patches;

    BlendingSurface(std::shared_ptr<const Surface> model, BlendDirection u, BlendDirection v,
                    const PatchCut& cut);

    [[nodiscard]] Result<Done> cutPatches(std::span<const Pose> poses);
    void findBreaks();

    std::shared_ptr<const Surface> model_;
    BlendDirection u_;
    BlendDirection v_;
    PatchCut cut_;
    bool modelTurnsU_;
    bool modelTurnsV_;
    std::shared_ptr<const std::vector<Vec3>> matrices_;  // one of cut_.orders() a patch
    std::shared_ptr<const std::vector<PatchPlace>> places_;
    std::shared_ptr<const std::vector<double>> breaksU_;
    std::shared_ptr<const std::vector<double>> breaksV_;
};

}  // namespace knotwork
