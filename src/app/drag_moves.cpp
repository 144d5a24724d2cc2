#include "app/drag_moves.hpp"

#include "ui/plot.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace knotwork::app {

namespace {

/// An axis that is seen this much shorter than the longest is not one that a hand can mean.
constexpr double leastSeen = 0.1;
/// A plane that is seen at less than this sine is not one to slide along.
constexpr double leastTilt = 0.15;

double lengthOf(const Pixel& v) noexcept { return std::hypot(v.x, v.y); }
double dot(const Pixel& a, const Pixel& b) noexcept { return a.x * b.x + a.y * b.y; }

}  // namespace

double roundedTo(double value, double unitsPerPixel) noexcept {
    const double decade = std::floor(std::log10(unitsPerPixel));
    if (!std::isfinite(decade) || decade < -15 || decade > 15) return value;
    // Dividing by a whole power of ten gives the number nearest to the decimal; multiplying by a
    // fraction would give 0.30000000000000004.
    if (decade < 0) {
        const double power = std::pow(10.0, -decade);
        return std::round(value * power) / power;
    }
    const double power = std::pow(10.0, decade);
    return std::round(value / power) * power;
}

double multipleOf(double step, double value) noexcept {
    return roundedTo(std::round(value / step) * step, step / 10);
}

double stepOfGrid(const Sight& sight) noexcept {
    return ui::planeGridStep(1 / sight.unitsPerPixel());
}

Frame::Frame(const Affine& of) noexcept : placement(of), toObject(glm::inverse(of.linear)) {}

Vec3 alongAxis(const Pixel& by, const Frame& frame, const Sight& sight, bool inPlane) noexcept {
    Vec3 best{0.0};
    double farthest = 0;
    std::array<Pixel, 3> seen;
    double longest = 0;
    for (glm::length_t k = 0; k < 3; ++k) {
        const Pixel axis = sight.pixelVector(frame.placement.linear[k]);
        seen[static_cast<std::size_t>(k)] = axis;
        longest = std::max(longest, lengthOf(axis));
    }
    for (glm::length_t k = 0; k < (inPlane ? 2 : 3); ++k) {
        const Pixel axis = seen[static_cast<std::size_t>(k)];
        const double length = lengthOf(axis);
        if (!(length > leastSeen * longest)) continue;
        const double reach = dot(by, axis) / length;
        if (std::abs(reach) <= std::abs(farthest)) continue;
        farthest = reach;
        best = Vec3{0.0};
        best[k] = reach / length;
    }
    return best;
}

Vec3 acrossScreen(const Pixel& by, const Frame& frame, const Sight& sight,
                  bool inPlane) noexcept {
    Vec3 to = frame.toObject * sight.vector(by);
    if (!inPlane) return to;
    const Vec3 eye = glm::normalize(frame.toObject * sight.towardsEye());
    if (std::abs(eye.z) > leastTilt) to -= eye * (to.z / eye.z);
    to.z = 0;
    return to;
}

Vec3 rounded(Vec3 to, const Vec3& start, const Sight& sight, bool onGrid) noexcept {
    const double pixel = sight.unitsPerPixel();
    for (glm::length_t k = 0; k < 3; ++k) {
        // What stays where it is keeps all its digits.
        if (std::abs(to[k] - start[k]) < 1e-6 * pixel) {
            to[k] = start[k];
        } else if (onGrid) {
            to[k] = multipleOf(stepOfGrid(sight), to[k]);
        } else {
            to[k] = roundedTo(to[k], pixel);
        }
    }
    return to;
}

}  // namespace knotwork::app
