// The part of the session that measures curves.
#include "bindings/session.hpp"

#include <cmath>

namespace knotwork::bindings {

namespace {

std::optional<double> given(double value) noexcept {
    return std::isnan(value) ? std::nullopt : std::optional(value);
}

}  // namespace

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

}  // namespace knotwork::bindings
