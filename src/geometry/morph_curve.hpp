// Between two curves: C(t) = (1 − w)·A(t) + w·B(φ(t)), with φ the affine map of A's parameter onto
// B's. Weight 0 is A and weight 1 is B, exactly.
#pragma once

#include "geometry/interval.hpp"
#include "geometry/vec.hpp"

#include <memory>
#include <span>
#include <vector>

namespace knotwork {

class Curve;
class BlendingCurve;

class MorphCurve {
public:
    /// φ(t) = rate·t + shift.
    MorphCurve(std::shared_ptr<const Curve> from, std::shared_ptr<const Curve> to, double rate,
               double shift, double weight);

    /// That of A.
    [[nodiscard]] Interval domain() const noexcept;
    /// Where both are.
    [[nodiscard]] bool closed() const noexcept;
    [[nodiscard]] int dimension() const noexcept;
    /// Those of A and those of B.
    [[nodiscard]] std::span<const double> breaks() const noexcept { return breaks_; }
    /// Up to 26 rows; outside its domain each of the two goes on as it does.
    void evaluate(double t, Side side, std::span<Vec3> rows) const noexcept;

private:
    std::shared_ptr<const Curve> from_;
    std::shared_ptr<const Curve> to_;
    double rate_;
    double shift_;
    double weight_;
    std::vector<double> breaks_;
};

/// `weight` of the way from one curve to another, the domain of `to` mapped onto that of `from`. A
/// blending curve stays one: each of its local curves goes the way to its part of `to`, and keeps
/// its pose. Cost: linear in the breaks of both.
[[nodiscard]] Curve morphed(const Curve& from, const Curve& to, double weight);

}  // namespace knotwork
