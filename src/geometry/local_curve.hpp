// One curve that takes part in a blend: a source over the global parameter (or over its own, by
// source parameter = rate·t + shift), posed about its own origin, its point at its knot.
#pragma once

#include "geometry/interval.hpp"
#include "geometry/pose.hpp"
#include "geometry/vec.hpp"

#include <memory>
#include <span>
#include <vector>

namespace knotwork {

class Curve;

class LocalCurve {
public:
    /// `side` says from where the source is looked at for the origin, should it jump at its knot.
    /// `domain` is where the local curve takes part; it can be evaluated anywhere.
    LocalCurve(std::shared_ptr<const Curve> source, double rate, double shift, double knot,
               Side side, const Pose& pose, const Interval& domain);

    // As every kind of curve; beyond its domain the source is continued.
    [[nodiscard]] Interval domain() const noexcept { return domain_; }
    [[nodiscard]] bool closed() const noexcept { return false; }
    [[nodiscard]] int dimension() const noexcept { return planar() ? 2 : 3; }
    void evaluate(double t, Side side, std::span<Vec3> rows) const noexcept;
    /// Those of its source on its domain, once withBreaks() has looked for them.
    [[nodiscard]] std::span<const double> breaks() const noexcept { return breaks_; }
    [[nodiscard]] LocalCurve withBreaks() const;

    [[nodiscard]] Vec3 point(double t) const noexcept;
    /// Turns rows of the source into rows of this local: the pose and the chain rule of `rate`.
    void place(std::span<Vec3> rows) const noexcept;

    [[nodiscard]] const Curve& source() const noexcept { return *source_; }
    [[nodiscard]] const std::shared_ptr<const Curve>& sharedSource() const noexcept { return source_; }
    [[nodiscard]] double rate() const noexcept { return rate_; }
    [[nodiscard]] double shift() const noexcept { return shift_; }
    /// The source's own parameter.
    [[nodiscard]] double sourceParameter(double t) const noexcept { return rate_ * t + shift_; }
    /// One parameter gives both the same point of the same source.
    [[nodiscard]] bool runsWith(const LocalCurve& other) const noexcept {
        return source_ == other.source_ && rate_ == other.rate_ && shift_ == other.shift_;
    }

    [[nodiscard]] const Pose& pose() const noexcept { return pose_; }
    [[nodiscard]] const Affine& placement() const noexcept { return placement_; }
    /// Where the local stands before it is posed, the pivot of scale and rotation.
    [[nodiscard]] const Vec3& origin() const noexcept { return origin_; }
    [[nodiscard]] LocalCurve withPose(const Pose& pose) const;
    /// Another source over the same parameter; the pose is then about its point at the knot.
    [[nodiscard]] LocalCurve withSource(std::shared_ptr<const Curve> source, double knot) const;
    [[nodiscard]] bool planar() const noexcept;

private:
    std::shared_ptr<const Curve> source_;
    double rate_;
    double shift_;
    Interval domain_;
    Vec3 origin_;
    Pose pose_;
    Affine placement_;
    std::vector<double> breaks_;
};

/// The pose with another pivot that places everything as `pose` about `origin` does.
[[nodiscard]] Pose aboutAnother(const Pose& pose, const Vec3& origin, const Vec3& pivot) noexcept;

}  // namespace knotwork
