// Poses: how a local curve or a whole object is placed. Scale, then rotate, both about an origin
// that the caller names, then translate (MATH: c = o + τ + R Σ (c⁰ − o)).
#pragma once

#include "geometry/result.hpp"
#include "geometry/vec.hpp"

namespace knotwork {

/// x ↦ linear·x + offset.
struct Affine {
    Mat3 linear{1.0};
    Vec3 offset{0.0};

    [[nodiscard]] Vec3 point(const Vec3& p) const noexcept { return linear * p + offset; }
    [[nodiscard]] Vec3 vector(const Vec3& v) const noexcept { return linear * v; }
    friend bool operator==(const Affine&, const Affine&) = default;
};

/// `compose(outer, inner)` applies `inner` first.
[[nodiscard]] Affine compose(const Affine& outer, const Affine& inner) noexcept;

/// The pose of the public interface. The default is the identity, exactly.
struct Pose {
    Vec3 translate{0.0};
    Vec3 axis{0.0, 0.0, 1.0};  ///< any length but zero
    double angle = 0;          ///< radians, right-handed about axis
    Vec3 scale{1.0};

    [[nodiscard]] bool isIdentity() const noexcept;
    /// Whether a curve in the plane z = 0 stays in it.
    [[nodiscard]] bool keepsPlane() const noexcept;
    friend bool operator==(const Pose&, const Pose&) = default;
};

/// Refuses non-finite numbers (NOT_FINITE), an axis of length zero and a scale factor of zero
/// (OUT_OF_RANGE), naming `translate`, `rotate.axis`, `rotate.angle` or `scale`.
[[nodiscard]] Result<Done> checkPose(const Pose& pose);

/// Rotation by `angle` about `axis` (Rodrigues' formula); the identity exactly where angle is 0.
[[nodiscard]] Mat3 rotation(const Vec3& axis, double angle) noexcept;

/// The affine map of a pose whose scale and rotation are about `origin`.
[[nodiscard]] Affine affineOf(const Pose& pose, const Vec3& origin) noexcept;

}  // namespace knotwork
