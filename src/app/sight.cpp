#include "app/sight.hpp"

#include <glm/matrix.hpp>

#include <algorithm>

namespace knotwork::app {

Sight::Sight(const Orientation& orientation, const Vec3& centre, double scale,
             const Pixel& middle) noexcept
    : orientation_(orientation), scaleX_(scale), scaleY_(scale) {
    const Vec3 seen = orientation * centre;
    origin_ = {middle.x - scale * seen.x, middle.y + scale * seen.y};
}

Pixel Sight::toPixels(const Vec3& p) const noexcept {
    const Vec3 seen = orientation_ * p;
    return {origin_.x + scaleX_ * seen.x, origin_.y - scaleY_ * seen.y};
}

Pixel Sight::pixelVector(const Vec3& v) const noexcept {
    const Vec3 seen = orientation_ * v;
    return {scaleX_ * seen.x, -scaleY_ * seen.y};
}

double Sight::nearness(const Vec3& p) const noexcept {
    return scaleX_ * glm::dot(towardsEye(), p);
}

Vec3 Sight::vector(const Pixel& by) const noexcept {
    return glm::transpose(orientation_) * Vec3(by.x / scaleX_, -by.y / scaleY_, 0.0);
}

Vec3 Sight::fromPixels(const Pixel& p, const Vec3& through) const noexcept {
    const Pixel at = toPixels(through);
    return through + vector({p.x - at.x, p.y - at.y});
}

Vec3 Sight::towardsEye() const noexcept {
    return {orientation_[0][2], orientation_[1][2], orientation_[2][2]};
}

double Sight::unitsPerPixel() const noexcept { return 1 / std::max(scaleX_, 1e-300); }

}  // namespace knotwork::app
