#include "scene/spec_builders.hpp"

#include "geometry/knot_spacing.hpp"
#include "geometry/local_cuts.hpp"
#include "geometry/named.hpp"
#include "scene/json_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>

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

struct NamedKind {
    std::string_view name;
    LocalKind kind;
    bool hasDegree;
};
constexpr std::array localKinds{
    NamedKind{"sub-curve", LocalKind::subCurve, false}, NamedKind{"line", LocalKind::line, false},
    NamedKind{"arc", LocalKind::arc, false}, NamedKind{"bezier", LocalKind::bezier, true},
    NamedKind{"bspline", LocalKind::bspline, true}};

/// What `locals` says is cut; the degree is filled in where the kind has one.
Result<LocalCut> localCutOf(Json& locals) {
    const std::string name = stringOr(locals, "kind", "sub-curve");
    const NamedKind* named = findNamed(localKinds, &NamedKind::name, name);
    LocalCut cut{.kind = named->kind};
    const Json* degree = member(locals, "degree");
    if (!named->hasDegree) {
        if (degree == nullptr) return cut;
        return refuse(Code::notSupported, "locals.degree",
                      "Local curves of the kind \"" + name + "\" have no degree; leave it out.");
    }
    if (degree != nullptr) cut.degree = static_cast<std::size_t>(degree->get<double>());
    if (named->kind == LocalKind::bspline && cut.degree >= localSplinePoints) {
        return refuse(Code::outOfRange, "locals.degree",
                      "The degree is " + std::to_string(cut.degree) +
                          "; a B-spline with 8 control points has at most degree 7.");
    }
    locals["degree"] = static_cast<double>(cut.degree);
    return cut;
}

/// Whether these are the knots that are written beside `spacing` in a canonical specification.
bool areThese(std::span<const double> given, std::span<const double> spaced) {
    const double tolerance = 1e-9 * (spaced.back() - spaced.front());
    return std::equal(given.begin(), given.end(), spaced.begin(), spaced.end(),
                      [&](double a, double b) { return std::abs(a - b) <= tolerance; });
}

/// The knots of a curve that is cut from a model; none for the usual ones.
Result<std::vector<double>> spacedKnots(Json& spec, const Curve& model, std::size_t count,
                                        BlendForm form) {
    std::vector<double> given = knotsOf(spec);
    if (stringOr(spec, "spacing", "parameter") != "length") {
        spec["spacing"] = "parameter";
        return given;
    }
    if (count < 2) return given;
    auto spaced = equalLengthKnots(model, blendingKnotCount(count, form));
    if (!spaced) {
        return refuse(Code::notSupported, "spacing",
                      "The model has no length by which knots could be spaced; space them by "
                      "\"parameter\".");
    }
    if (given.empty()) return *spaced;
    if (areThese(given, *spaced)) return given;
    return refuse(Code::notSupported, "spacing",
                  "These knots are not those of equal lengths; leave \"knots\" out, or \"spacing\".");
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
    Json& locals = spec["locals"];
    const auto count = static_cast<std::size_t>(numberOr(locals, "count", 0));
    const auto cut = localCutOf(locals);
    if (!cut) return cut.error();
    const auto poses = buildPoses(spec, count);
    if (!poses) return poses.error();
    const BlendForm form = blendFormOf(spec, isClosed(*model));
    auto knots = spacedKnots(spec, *model, count, form);
    if (!knots) return knots.error();
    return finishBlend(spec, BlendingCurve::fromModel(*model, count, form, std::move(blend),
                                                      std::move(*knots), *poses, *cut));
}

Result<Curve> buildFromList(Json& spec, BFunction blend) {
    if (member(spec, "model") != nullptr) {
        return refuse(Code::notSupported, "model",
                      "The local curves are given one by one; leave \"model\" out, or give "
                      "\"locals\" as { count, kind }.");
    }
    if (member(spec, "spacing") != nullptr) {
        return refuse(Code::notSupported, "spacing",
                      "Knots are spaced along a model, and here the local curves are given one by "
                      "one; leave \"spacing\" out.");
    }
    const Json& given = *member(spec, "locals");
    Json completed = given;
    std::vector<Curve> locals;
    for (std::size_t j = 0; j < completed.size(); ++j) {
        if (j > 0 && given[j] == given[j - 1]) {  // one curve for both: it is evaluated once
            completed[j] = completed[j - 1];
            locals.push_back(locals.back());
            continue;
        }
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
