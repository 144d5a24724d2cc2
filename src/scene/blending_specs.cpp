#include "scene/blending_specs.hpp"

#include "scene/json_values.hpp"
#include "scene/spec_builders.hpp"

#include <array>

namespace knotwork::scene {

namespace {

Json poseSpec(std::size_t local, const Pose& pose) {
    const bool uniform = pose.scale.x == pose.scale.y && pose.scale.y == pose.scale.z;
    return {{"local", static_cast<double>(local)},
            {"translate", pointJson(pose.translate, pose.translate.z == 0 ? 2 : 3)},
            {"rotate", {{"axis", pointJson(pose.axis, 3)}, {"angle", pose.angle}}},
            {"scale", uniform ? Json(pose.scale.x) : pointJson(pose.scale, 3)}};
}

bool isFitted(const Json& spec) { return member(spec, "fit") != nullptr; }

/// The specification of what local curve j was before it was posed (and fitted).
Json sourceSpec(const Json& spec, const BlendingCurve& curve, std::size_t j) {
    const Json& locals = *member(spec, "locals");
    if (locals.is_array()) return locals[j];
    const LocalCurve& local = curve.locals()[j];
    return local.sharedSource() == curve.model() ? *member(spec, "model") : specOf(local.source());
}

/// The pose of the local curve about its point at another parameter.
Pose poseAt(const LocalCurve& local, double knot, Side side) {
    Vec3 pivot;
    evaluate(local.source(), local.sourceParameter(knot), side, {&pivot, 1});
    return aboutAnother(local.pose(), local.origin(), pivot);
}

/// Two copies of `source` blended into each other over the domain of `local`.
Json twoCopies(const Json& source, const LocalCurve& local, bool posed, bool fitted) {
    const Interval over = local.domain();
    Json poses = Json::array();
    if (posed && !local.pose().isIdentity()) {
        poses.push_back(poseSpec(0, poseAt(local, over.start, Side::right)));
        poses.push_back(poseSpec(1, poseAt(local, over.end, Side::left)));
    }
    Json spec{{"type", "blending-curve"},
              {"bFunction", {{"family", "linear"}}},
              {"locals", Json::array({source, source})},
              {"form", "open"}};
    if (fitted) spec["fit"] = "affine";
    spec["knots"] = Json::array({over.start, over.end});
    spec["poses"] = std::move(poses);
    return spec;
}

/// The local curve is its source, neither posed nor fitted nor seen on another interval.
bool isItsSource(const LocalCurve& local) {
    return local.pose().isIdentity() && local.rate() == 1 && local.shift() == 0 &&
           domain(local.source()) == local.domain() && !isClosed(local.source());
}

Error noLocal(std::size_t count) {
    return refuse(Code::outOfRange, "j",
                  "There is no such local curve; they are 0 to " + std::to_string(count - 1) + ".");
}

/// Every local curve by itself, in the parameter of the blending curve, where it stands.
Json givenOneByOne(const Json& spec, const BlendingCurve& curve, std::span<const double> knots) {
    Json locals = Json::array();
    Json poses = Json::array();
    for (std::size_t j = 0; j < curve.locals().size(); ++j) {
        const LocalCurve& local = curve.locals()[j];
        Json source = sourceSpec(spec, curve, j);
        // A fitted one would be fitted to its new support.
        locals.push_back(isFitted(spec) ? twoCopies(source, local, false, true) : std::move(source));
        if (local.pose().isIdentity()) continue;
        poses.push_back(poseSpec(j, poseAt(local, knots[j], blendingSide(knots, j))));
    }
    return {{"type", "blending-curve"},      {"bFunction", *member(spec, "bFunction")},
            {"locals", std::move(locals)},   {"form", *member(spec, "form")},
            {"knots", listOf(knots)},        {"poses", std::move(poses)}};
}

}  // namespace

Result<Made<Curve>> localCurve(const Json& spec, const BlendingCurve& curve, std::size_t j) {
    if (j >= curve.locals().size()) return noLocal(curve.locals().size());
    const LocalCurve& local = curve.locals()[j];
    Json source = sourceSpec(spec, curve, j);
    if (isItsSource(local)) return Made<Curve>{std::move(source), local.source()};
    auto made = makeCurve(twoCopies(source, local, true, isFitted(spec)));
    if (!made) return made.error();
    return Made<Curve>{std::move(made->spec), Curve(local.withBreaks())};
}

Result<Json> withKnots(const Json& spec, const BlendingCurve& curve,
                       const std::vector<double>& knots, bool recut) {
    const BlendForm form = curve.closed() ? BlendForm::closed : BlendForm::open;
    const auto checked = checkBlendingKnots(knots, curve.locals().size(), form);
    if (!checked) return checked.error();
    if (!recut) return givenOneByOne(spec, curve, knots);
    Json moved = spec;
    moved["knots"] = listOf(knots);
    if (member(moved, "spacing") != nullptr) moved["spacing"] = "parameter";
    return moved;
}

}  // namespace knotwork::scene
