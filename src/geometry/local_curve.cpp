#include "geometry/local_curve.hpp"

#include "geometry/curve.hpp"

namespace knotwork {

namespace {

Vec3 pointOf(const Curve& curve, double t, Side side) noexcept {
    Vec3 point;
    evaluate(curve, t, side, {&point, 1});
    return point;
}

}  // namespace

LocalCurve::LocalCurve(std::shared_ptr<const Curve> source, double rate, double shift, double knot,
                       Side side, const Pose& pose, const Interval& domain)
    : source_(std::move(source)), rate_(rate), shift_(shift), domain_(domain),
      origin_(pointOf(*source_, rate * knot + shift, side)), pose_(pose),
      placement_(affineOf(pose, origin_)) {}

void LocalCurve::evaluate(double t, Side side, std::span<Vec3> rows) const noexcept {
    knotwork::evaluate(*source_, sourceParameter(t), side, rows);
    place(rows);
}

void LocalCurve::place(std::span<Vec3> rows) const noexcept {
    if (rows.empty()) return;
    rows[0] = placement_.point(rows[0]);
    double power = rate_;
    for (Vec3& row : rows.subspan(1)) {
        row = power * placement_.vector(row);
        power *= rate_;
    }
}

Vec3 LocalCurve::point(double t) const noexcept {
    return placement_.point(pointAt(*source_, sourceParameter(t)));
}

LocalCurve LocalCurve::withBreaks() const {
    LocalCurve found = *this;
    const Interval part{sourceParameter(domain_.start), sourceParameter(domain_.end)};
    found.breaks_.clear();
    for (const double knot : breakParameters(*source_, part)) {
        found.breaks_.push_back((knot - shift_) / rate_);
    }
    return found;
}

LocalCurve LocalCurve::withPose(const Pose& pose) const {
    LocalCurve posed = *this;
    posed.pose_ = pose;
    posed.placement_ = affineOf(pose, origin_);
    return posed;
}

LocalCurve LocalCurve::withSource(std::shared_ptr<const Curve> source, double knot) const {
    return {std::move(source), rate_, shift_, knot,
            knot == domain_.end ? Side::left : Side::right, pose_, domain_};
}

bool LocalCurve::planar() const noexcept {
    return knotwork::dimension(*source_) == 2 && (pose_.isIdentity() || pose_.keepsPlane());
}

Pose aboutAnother(const Pose& pose, const Vec3& origin, const Vec3& pivot) noexcept {
    Pose moved = pose;
    if (pose.angle == 0 && pose.scale == Vec3(1.0)) return moved;  // a translation has no pivot
    moved.translate = affineOf(pose, origin).point(pivot) - pivot;
    if (pose.keepsPlane() && origin.z == 0 && pivot.z == 0) moved.translate.z = 0;
    return moved;
}

}  // namespace knotwork
