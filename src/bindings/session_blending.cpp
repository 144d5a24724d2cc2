// The part of the session that only blending curves answer.
#include "bindings/marshal.hpp"
#include "bindings/session.hpp"
#include "scene/blending_specs.hpp"
#include "scene/json_values.hpp"
#include "scene/validation.hpp"

#include <array>

namespace knotwork::bindings {

namespace {

using scene::Field;
using scene::FieldKind;

constexpr std::array withKnotsFields{
    Field{.name = "knots", .label = "Knots", .kind = FieldKind::numbers,
          .help = "Where the local curves are centred.", .required = true},
    Field{.name = "recut", .label = "Cut anew", .kind = FieldKind::flag,
          .help = "Cuts the local curves anew at the new knots.", .defaultJson = "true"},
};

}  // namespace

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

std::optional<std::size_t> Session::findLocal(const BlendingCurve& curve, int local) {
    const std::size_t count = curve.locals().size();
    if (local >= 0 && static_cast<std::size_t>(local) < count) {
        return static_cast<std::size_t>(local);
    }
    refuse({Code::outOfRange, "j",
            "There is no local curve " + std::to_string(local) + "; they are 0 to " +
                std::to_string(count - 1) + "."});
    return std::nullopt;
}

int Session::curveLocal(int handle, int local) {
    const auto* blending = findBlending(handle);
    const auto j = blending ? findLocal(*blending, local) : std::nullopt;
    return j ? holdCurve(scene::localCurve(specOf(*find<CurveValue>(handle)), *blending, *j)) : 0;
}

int Session::curveWithKnots(int handle, unsigned bytes) {
    const auto* blending = findBlending(handle);
    if (!blending) return 0;
    const auto given = input(bytes);
    if (!given) return refuse(given.error());
    const auto read = scene::readGroup(*given, withKnotsFields);
    if (!read) return refuse(read.error());
    const auto spec = scene::withKnots(specOf(*find<CurveValue>(handle)), *blending,
                                       scene::numbersOf(*scene::member(*read, "knots")),
                                       scene::flagOr(*read, "recut", true));
    if (!spec) return refuse(spec.error());
    return holdCurve(scene::makeCurve(*spec));
}

int Session::curveWithPose(int handle, int local, unsigned bytes) {
    const auto* blending = findBlending(handle);
    if (!blending) return 0;
    if (!findLocal(*blending, local)) return 0;
    auto pose = input(bytes);
    if (!pose) return refuse(pose.error());
    auto spec = specWithPose(specOf(*find<CurveValue>(handle)), local, std::move(*pose));
    if (!spec) return refuse(spec.error());
    auto made = scene::makeCurve(*spec);
    if (!made) return refuse(seenFromPose(made.error()));
    return holdCurve(std::move(made));
}

}  // namespace knotwork::bindings
