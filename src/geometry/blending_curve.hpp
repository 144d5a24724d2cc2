// Blending spline curves (Lakså, Bang, Dechevsky: expo-rational B-splines and their family).
//
// n local curves c_0 … c_{n−1}, each centred at its knot; between two neighbouring knots the two
// local curves centred there are blended by a B-function B of the span's own parameter
// w = (t − t_i)/h:
//     C(t) = c_i(t) + B(w) (c_{i+1}(t) − c_i(t)),
// so C has at the knot t_i the point and, up to the Hermite order of B, the derivatives of c_i.
// A closed curve has one more knot, t_n = t_0 + T, and blends its last local into c_0(t − T).
// Two equal knots in a row are a permitted break: the curve jumps from one local to the next.
#pragma once

#include "geometry/b_function.hpp"
#include "geometry/blending_knots.hpp"
#include "geometry/interval.hpp"
#include "geometry/local_curve.hpp"
#include "geometry/pose.hpp"
#include "geometry/result.hpp"

#include <memory>
#include <span>
#include <vector>

namespace knotwork {

/// What is cut from a model: local_cuts.hpp.
enum class LocalKind { subCurve, line, arc, bezier, bspline };

struct LocalCut {
    LocalKind kind = LocalKind::subCurve;
    std::size_t degree = 3;  ///< of Bézier curves and B-splines
};

class BlendingCurve {
public:
    /// Cuts `count` local curves from a model, local j at knots[j]. The model is continued past its
    /// domain as it continues itself. `knots` empty: uniform over the model's domain. `poses` empty,
    /// or one for each local.
    /// Refuses fewer than 2 locals (OUT_OF_RANGE `locals.count`) or more than 10 000 (TOO_LARGE),
    /// knots as checkBlendingKnots() does, poses as checkPose() does under `poses[j]`, and what
    /// LocalCutter refuses.
    static Result<BlendingCurve> fromModel(Curve model, std::size_t count, BlendForm form,
                                           BFunction blend, std::vector<double> knots,
                                           std::span<const Pose> poses, const LocalCut& cut = {});

    /// From local curves given one by one; with `fit`, each source's domain is mapped affinely onto
    /// its support. `knots` empty: 0, 1, …
    static Result<BlendingCurve> fromLocals(std::vector<Curve> locals, BlendForm form,
                                            BFunction blend, std::vector<double> knots, bool fit,
                                            std::span<const Pose> poses);

    [[nodiscard]] Interval domain() const noexcept { return {knots_.front(), knots_.back()}; }
    [[nodiscard]] bool closed() const noexcept { return form_ == BlendForm::closed; }
    [[nodiscard]] int dimension() const noexcept { return dimension_; }
    [[nodiscard]] const BFunction& blend() const noexcept { return blend_; }
    [[nodiscard]] const std::vector<double>& knots() const noexcept { return knots_; }
    [[nodiscard]] const std::vector<LocalCurve>& locals() const noexcept { return *locals_; }
    /// What the locals were cut from, or null where they were given one by one.
    [[nodiscard]] const std::shared_ptr<const Curve>& model() const noexcept { return model_; }

    /// rows[k] = the k-th derivative; outside the domain a closed curve wraps and an open one is
    /// continued by its end local.
    void evaluate(double t, Side side, std::span<Vec3> rows) const noexcept;
    /// The knots, and between them the breaks of the local curves that are blended there.
    [[nodiscard]] std::span<const double> breaks() const noexcept { return *breaks_; }

    /// The n weights with which the locals are blended at t: at most two are not zero, sum 1.
    [[nodiscard]] std::vector<double> blendBasis(double t) const;
    /// The interval where local j takes part, [t_{j−1}, t_{j+1}] cut to the domain (a closed
    /// curve's first local: [t_{n−1} − T, t_1]).
    [[nodiscard]] Interval support(std::size_t j) const noexcept {
        return blendingSupport(knots_, j, form_);
    }

    [[nodiscard]] BlendingCurve withPoses(std::span<const Pose> poses) const;
    /// The blend of as many other local curves at the same knots.
    [[nodiscard]] BlendingCurve withLocals(std::vector<LocalCurve> locals) const;

    using Span = BlendingSpan;
    /// Where t falls.
    [[nodiscard]] Span spanAt(double t, Side side) const noexcept;

private:
    BlendingCurve(std::shared_ptr<const Curve> model, std::vector<LocalCurve> locals,
                  BlendForm form, BFunction blend, std::vector<double> knots);

    void setLocals(std::vector<LocalCurve> locals);
    void findBreaks();

    std::shared_ptr<const Curve> model_;
    std::shared_ptr<const std::vector<LocalCurve>> locals_;
    std::shared_ptr<const std::vector<double>> breaks_;
    BlendForm form_;
    BFunction blend_;
    std::vector<double> knots_;
    int dimension_ = 2;
};

}  // namespace knotwork
