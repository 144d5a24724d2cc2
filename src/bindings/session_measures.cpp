// The part of the session that measures curves.
#include "bindings/session.hpp"
#include "geometry/closest_point.hpp"
#include "geometry/curve_sphere.hpp"
#include "geometry/differential.hpp"

#include <cmath>

namespace knotwork::bindings {

namespace {

std::optional<double> given(double value) noexcept {
    return std::isnan(value) ? std::nullopt : std::optional(value);
}

void write(const Frame& frame, double* at) noexcept {
    for (const Vec3& v : {frame.point, frame.tangent, frame.normal, frame.binormal}) {
        for (int axis = 0; axis < 3; ++axis) *at++ = v[axis];
    }
    at[0] = frame.curvature;
    at[1] = frame.torsion;
}

}  // namespace

bool Session::curveFrame(int handle, double t, int side) {
    const auto* held = find<CurveValue>(handle);
    if (!held) return false;
    const auto inside = parameterInDomain(held->curve, t);
    if (!inside) return refuse(inside.error());
    const bool left = side < 0 || (side == 0 && *inside == domain(held->curve).end);
    write(frameAt(held->curve, *inside, left ? Side::left : Side::right), block_.data());
    return true;
}

/// Made when it is first asked for, and kept with the curve.
const ArcLength* Session::findLengths(int handle) {
    auto* held = find<CurveValue>(handle);
    if (!held) return nullptr;
    if (!held->lengths) held->lengths.emplace(held->curve);
    return &*held->lengths;
}

bool Session::curveLength(int handle, double a, double b) {
    const ArcLength* lengths = findLengths(handle);
    if (!lengths) return false;
    const auto length = lengthBetween(*lengths, given(a), given(b));
    if (!length) return refuse(length.error());
    block_[0] = *length;
    return true;
}

bool Session::curveParameterAtLength(int handle, double s) {
    const ArcLength* lengths = findLengths(handle);
    if (!lengths) return false;
    const auto t = parameterAtLength(*lengths, s);
    if (!t) return refuse(t.error());
    block_[0] = *t;
    return true;
}

bool Session::curveClosestPoint(int handle, double x, double y, double z) {
    const auto* held = find<CurveValue>(handle);
    if (!held) return false;
    const auto found = closestPoint(held->curve, {x, y, z});
    if (!found) return refuse(found.error());
    block_[0] = found->t;
    for (int axis = 0; axis < 3; ++axis) block_[static_cast<std::size_t>(axis) + 1] = found->point[axis];
    block_[4] = found->distance;
    return true;
}

bool Session::curveSphere(int handle) {
    const auto* held = find<CurveValue>(handle);
    if (!held) return false;
    const Sphere sphere = knotwork::enclosingSphere(held->curve);
    for (int axis = 0; axis < 3; ++axis) block_[static_cast<std::size_t>(axis)] = sphere.center[axis];
    block_[3] = sphere.radius;
    return true;
}

}  // namespace knotwork::bindings
