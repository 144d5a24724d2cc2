#include "scene/spec_builders.hpp"

#include "scene/json_values.hpp"

namespace knotwork::scene {

namespace {

Result<std::vector<Pose>> buildPoses(const Json& spec, std::size_t count) {
    std::vector<Pose> poses(count);
    std::vector<bool> seen(count, false);
    const Json& list = *member(spec, "poses");
    for (std::size_t k = 0; k < list.size(); ++k) {
        const auto j = static_cast<std::size_t>(numberOr(list[k], "local", 0));
        const std::string path = indexed("poses", k);
        if (j >= count) {
            return refuse(Code::outOfRange, path + ".local",
                          "There is no local curve " + std::to_string(j) + "; they are 0 to " +
                              std::to_string(count - 1) + ".");
        }
        if (seen[j]) {
            return refuse(Code::outOfRange, path + ".local",
                          "Local curve " + std::to_string(j) +
                              " has a pose already; there is one pose for each.");
        }
        seen[j] = true;
        poses[j] = poseOf(list[k]);
        if (const auto checked = checkPose(poses[j]); !checked) return checked.error().under(path);
    }
    return poses;
}

BlendForm blendFormOf(const Json& spec, bool closedByDefault) {
    const std::string form = stringOr(spec, "form", closedByDefault ? "closed" : "open");
    return form == "closed" ? BlendForm::closed : BlendForm::open;
}

std::vector<double> knotsOf(const Json& spec) {
    const Json* knots = member(spec, "knots");
    return knots != nullptr ? numbersOf(*knots) : std::vector<double>{};
}

Result<Curve> finishBlend(Json& spec, Result<BlendingCurve> made) {
    if (!made) return made.error();
    spec["form"] = made->closed() ? "closed" : "open";
    spec["knots"] = listOf(made->knots());
    return Curve(std::move(*made));
}

Result<Curve> buildFromModel(Json& spec, BFunction blend) {
    const Json* modelSpec = member(spec, "model");
    if (modelSpec == nullptr) {
        return refuse(Code::wrongType, "model",
                      "Local curves that are counted are cut from a model; give a curve as "
                      "\"model\", or a list of curves as \"locals\".");
    }
    if (member(spec, "fit") != nullptr) {
        return refuse(Code::notSupported, "fit",
                      "Local curves cut from a model have its parameter already; leave \"fit\" "
                      "out.");
    }
    Json completed = *modelSpec;
    auto model = buildCurve(completed);
    if (!model) return model.error().under("model");
    spec["model"] = std::move(completed);
    const auto count = static_cast<std::size_t>(numberOr(*member(spec, "locals"), "count", 0));
    const auto poses = buildPoses(spec, count);
    if (!poses) return poses.error();
    const BlendForm form = blendFormOf(spec, isClosed(*model));
    return finishBlend(spec, BlendingCurve::fromModel(*model, count, form, std::move(blend),
                                                      knotsOf(spec), *poses));
}

Result<Curve> buildFromList(Json& spec, BFunction blend) {
    if (member(spec, "model") != nullptr) {
        return refuse(Code::notSupported, "model",
                      "The local curves are given one by one; leave \"model\" out, or give "
                      "\"locals\" as { count, kind }.");
    }
    Json completed = *member(spec, "locals");
    std::vector<Curve> locals;
    for (std::size_t j = 0; j < completed.size(); ++j) {
        auto local = buildCurve(completed[j]);
        if (!local) return local.error().under(indexed("locals", j));
        locals.push_back(std::move(*local));
    }
    spec["locals"] = std::move(completed);
    const auto poses = buildPoses(spec, locals.size());
    if (!poses) return poses.error();
    return finishBlend(spec, BlendingCurve::fromLocals(
                                 std::move(locals), blendFormOf(spec, false), std::move(blend),
                                 knotsOf(spec), member(spec, "fit") != nullptr, *poses));
}

}  // namespace

Result<Curve> buildBlending(Json& spec) {
    auto blend = buildBFunction(*member(spec, "bFunction"));
    if (!blend) return blend.error().under("bFunction");
    return member(spec, "locals")->is_array() ? buildFromList(spec, std::move(*blend))
                                              : buildFromModel(spec, std::move(*blend));
}

}  // namespace knotwork::scene
