// The part of the session that only blending curves answer.
#include "bindings/marshal.hpp"
#include "bindings/session.hpp"

namespace knotwork::bindings {

const BlendingCurve* Session::findBlending(int handle) {
    const auto* held = find<CurveValue>(handle);
    const auto* blending = held ? held->curve.as<BlendingCurve>() : nullptr;
    if (held && !blending) refuse({Code::notSupported, "", "Only a blending curve answers this."});
    return blending;
}

int Session::curveBlendBasis(int handle, double t) {
    const auto* blending = findBlending(handle);
    if (!blending) return -1;
    const auto inside = parameterInDomain(find<CurveValue>(handle)->curve, t);
    if (!inside) {
        refuse(inside.error());
        return -1;
    }
    std::vector<double> weights = blending->blendBasis(*inside);
    const std::size_t count = weights.size();
    return leave(std::move(weights), count);
}

int Session::curveWithPose(int handle, int local, unsigned bytes) {
    const auto* blending = findBlending(handle);
    if (!blending) return 0;
    const std::size_t count = blending->locals().size();
    if (local < 0 || static_cast<std::size_t>(local) >= count) {
        return refuse({Code::outOfRange, "j",
                       "There is no local curve " + std::to_string(local) + "; they are 0 to " +
                           std::to_string(count - 1) + "."});
    }
    auto pose = input(bytes);
    if (!pose) return refuse(pose.error());
    auto spec = specWithPose(specOf(*find<CurveValue>(handle)), local, std::move(*pose));
    if (!spec) return refuse(spec.error());
    auto made = scene::makeCurve(*spec);
    if (!made) return refuse(seenFromPose(made.error()));
    return holdCurve(std::move(made));
}

}  // namespace knotwork::bindings
