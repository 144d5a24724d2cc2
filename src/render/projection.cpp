#include "render/projection.hpp"

#include <glm/matrix.hpp>

#include <cmath>
#include <limits>

namespace knotwork::render {
namespace {

constexpr double noImage = std::numeric_limits<double>::quiet_NaN();

double halfWidth(const Rect& pane) { return 0.5 * static_cast<double>(pane.width); }
double halfHeight(const Rect& pane) { return 0.5 * static_cast<double>(pane.height); }

/// A pane that has been squeezed to nothing must not divide by zero.
double atLeastOne(double pixels) { return pixels < 1 ? 1 : pixels; }

glm::dmat4 scaling(double x, double y) {
    glm::dmat4 m(0.0);
    m[0][0] = x;
    m[1][1] = y;
    m[3][3] = 1;
    return m;
}

}  // namespace

Projection::Projection(const Rect& pane, const Vec3& centre, const glm::dmat4& clip,
                       const glm::dmat4& inverse) noexcept
    : pane_(pane), centre_(centre), clip_(clip), inverse_(inverse) {}

// The depth of a flat projection is 0 everywhere: nothing hides anything, painting order decides.
Projection Projection::flat(const Rect& pane, const Vec3& centre, double unitsPerPixelX,
                            double unitsPerPixelY) noexcept {
    const double x = atLeastOne(halfWidth(pane)) * unitsPerPixelX;
    const double y = atLeastOne(halfHeight(pane)) * unitsPerPixelY;
    return {pane, centre, scaling(1 / x, 1 / y), scaling(x, y)};
}

Projection Projection::spanning(const Rect& pane, Range x, Range y) noexcept {
    const Vec3 centre(x.min + 0.5 * x.length(), y.min + 0.5 * y.length(), 0.0);
    return flat(pane, centre, 0.5 * x.length() / atLeastOne(halfWidth(pane)),
                0.5 * y.length() / atLeastOne(halfHeight(pane)));
}

Projection Projection::cssPixels(const Rect& pane, double pixelRatio) noexcept {
    const Vec3 centre(halfWidth(pane) / pixelRatio, halfHeight(pane) / pixelRatio, 0.0);
    return flat(pane, centre, 1 / pixelRatio, 1 / pixelRatio);
}

Projection Projection::parallel(const Rect& pane, const Vec3& centre, const Mat3& orientation,
                                double unitsPerPixel, double depthRange) noexcept {
    const Vec3 sizes(atLeastOne(halfWidth(pane)) * unitsPerPixel,
                     atLeastOne(halfHeight(pane)) * unitsPerPixel, -depthRange);
    glm::dmat4 clip(1.0);
    glm::dmat4 inverse(1.0);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            clip[column][row] = orientation[column][row] / sizes[row];
            inverse[row][column] = orientation[column][row] * sizes[row];
        }
    }
    Projection made(pane, centre, clip, inverse);
    made.orientation_ = orientation;
    made.depthPerUnit_ = 1 / depthRange;
    return made;
}

Projection Projection::general(const Rect& pane, const Vec3& centre,
                               const glm::dmat4& clip) noexcept {
    return {pane, centre, clip, glm::inverse(clip)};
}

glm::dmat4 Projection::clipFrom(const Vec3& origin) const noexcept {
    glm::dmat4 clip = clip_;
    clip[3] += clip_ * glm::dvec4(origin - centre_, 0.0);
    return clip;
}

Vec3 Projection::toPane(const Vec3& world) const noexcept {
    const glm::dvec4 clip = clip_ * glm::dvec4(world - centre_, 1.0);
    if (!(clip.w > 0)) return Vec3(noImage);
    return {clip.x / clip.w * halfWidth(pane_), clip.y / clip.w * halfHeight(pane_),
            clip.z / clip.w};
}

Vec3 Projection::toPixels(const Vec3& world) const noexcept {
    const Vec3 p = toPane(world);
    return {p.x + pane_.x + halfWidth(pane_), p.y + pane_.y + halfHeight(pane_), p.z};
}

Vec3 Projection::fromPixels(const Vec3& pixels) const noexcept {
    const glm::dvec4 clip((pixels.x - pane_.x) / atLeastOne(halfWidth(pane_)) - 1,
                          (pixels.y - pane_.y) / atLeastOne(halfHeight(pane_)) - 1, pixels.z, 1.0);
    const glm::dvec4 world = inverse_ * clip;
    return centre_ + Vec3(world) / world.w;
}

Vec3 Projection::unitsPerPixel() const noexcept {
    const Vec3 middle = toPixels(centre_);
    const Vec3 origin = fromPixels(middle);
    return {glm::length(fromPixels(middle + Vec3(1, 0, 0)) - origin),
            glm::length(fromPixels(middle + Vec3(0, 1, 0)) - origin), 0.0};
}

}  // namespace knotwork::render
