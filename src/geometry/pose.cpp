#include "geometry/pose.hpp"

#include <glm/matrix.hpp>

#include <cmath>

namespace knotwork {

Affine compose(const Affine& outer, const Affine& inner) noexcept {
    return {outer.linear * inner.linear, outer.linear * inner.offset + outer.offset};
}

bool Pose::isIdentity() const noexcept {
    return translate == Vec3(0.0) && angle == 0 && scale == Vec3(1.0);
}

bool Pose::keepsPlane() const noexcept {
    return translate.z == 0 && (angle == 0 || (axis.x == 0 && axis.y == 0));
}

Result<Done> checkPose(const Pose& pose) {
    const auto finite = [](const Vec3& v, const char* path) -> Result<Done> {
        if (isFinite(v)) return Done{};
        return refuse(Code::notFinite, path, std::string(path) + " needs three finite numbers.");
    };
    if (auto checked = finite(pose.translate, "translate"); !checked) return checked;
    if (auto checked = finite(pose.axis, "rotate.axis"); !checked) return checked;
    if (auto checked = finite(pose.scale, "scale"); !checked) return checked;
    if (!std::isfinite(pose.angle)) {
        return refuse(Code::notFinite, "rotate.angle",
                      "The angle is " + formatNumber(pose.angle) + "; give a number of radians.");
    }
    if (pose.angle != 0 && !(glm::length(pose.axis) > 0)) {
        return refuse(Code::outOfRange, "rotate.axis",
                      "The axis has length zero and names no direction; give for example [0, 0, 1].");
    }
    if (pose.scale.x == 0 || pose.scale.y == 0 || pose.scale.z == 0) {
        return refuse(Code::outOfRange, "scale",
                      "A factor of zero flattens the curve; give factors that are not zero.");
    }
    return Done{};
}

Mat3 rotation(const Vec3& axis, double angle) noexcept {
    if (angle == 0) return Mat3(1.0);
    const Vec3 a = glm::normalize(axis);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double v = 2 * std::sin(angle / 2) * std::sin(angle / 2);  // 1 − cos without cancellation
    // Columns, as GLM stores them.
    return Mat3(c + a.x * a.x * v, a.y * a.x * v + a.z * s, a.z * a.x * v - a.y * s,
                a.x * a.y * v - a.z * s, c + a.y * a.y * v, a.z * a.y * v + a.x * s,
                a.x * a.z * v + a.y * s, a.y * a.z * v - a.x * s, c + a.z * a.z * v);
}

Affine affineOf(const Pose& pose, const Vec3& origin) noexcept {
    if (pose.angle == 0 && pose.scale == Vec3(1.0)) return {Mat3(1.0), pose.translate};
    Mat3 linear = rotation(pose.axis, pose.angle);
    for (int column = 0; column < 3; ++column) linear[column] *= pose.scale[column];
    return {linear, origin + pose.translate - linear * origin};
}

}  // namespace knotwork
