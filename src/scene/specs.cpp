#include "scene/specs.hpp"

#include "scene/json_values.hpp"
#include "scene/validation.hpp"

#include <algorithm>

namespace knotwork::scene {

namespace {

Result<BFunction> buildBFunction(const Json& spec);
Result<Curve> buildCurve(Json& spec);

// --- B-functions ----------------------------------------------------------------------------

Result<BFunction> buildMixed(const Json& spec) {
    const Json& of = *member(spec, "of");
    const auto first = buildBFunction(of[0]);
    if (!first) return first.error().under("of[0]");
    const auto second = buildBFunction(of[1]);
    if (!second) return second.error().under("of[1]");
    return BFunction::makeMixed(*first, *second, numberOr(spec, "weight", 0.5));
}

Result<BFunction> buildComposed(const Json& spec) {
    const auto outer = buildBFunction(*member(spec, "outer"));
    if (!outer) return outer.error().under("outer");
    const auto inner = buildBFunction(*member(spec, "inner"));
    if (!inner) return inner.error().under("inner");
    return BFunction::makeComposed(*outer, *inner);
}

Result<BFunction> buildFromOne(const Json& spec, bool dual) {
    const auto of = buildBFunction(*member(spec, "of"));
    if (!of) return of.error().under("of");
    return dual ? BFunction::makeDual(*of) : BFunction::makeSymmetrised(*of);
}

Result<BFunction> buildBFunction(const Json& spec) {
    const std::string name = stringOr(spec, "family", "");
    const BFamilyDescription& family = *findBFamily(name);
    switch (family.family) {
        case BFamily::tabulated: return BFunction::makeTabulated(numbersOf(*member(spec, "values")));
        case BFamily::dual: return buildFromOne(spec, true);
        case BFamily::symmetrised: return buildFromOne(spec, false);
        case BFamily::composed: return buildComposed(spec);
        case BFamily::mixed: return buildMixed(spec);
        default: break;
    }
    std::vector<NamedValue> parameters;
    for (const auto& parameter : family.parameters) {
        parameters.emplace_back(parameter.name,
                                numberOr(spec, parameter.name, parameter.defaultValue));
    }
    return BFunction::make(name, parameters);
}

// --- curves ---------------------------------------------------------------------------------

Form formOf(const Json& spec) {
    const std::string name = stringOr(spec, "form", "clamped");
    return name == "open" ? Form::open : name == "closed" ? Form::closed : Form::clamped;
}

std::string_view formName(Form form) noexcept {
    switch (form) {
        case Form::clamped: return "clamped";
        case Form::open: return "open";
        case Form::closed: return "closed";
    }
    return "clamped";
}

Result<Curve> buildBspline(Json& spec) {
    const Json& list = *member(spec, "points");
    if (list.size() > maxPointCount) {
        return refuse(Code::tooLarge, "points",
                      std::to_string(list.size()) + " points; a curve has at most 100000.");
    }
    std::vector<Vec3> points;
    points.reserve(list.size());
    for (const Json& point : list) points.push_back(vec3Of(point));
    const bool planar = std::all_of(points.begin(), points.end(),
                                    [](const Vec3& p) { return p.z == 0; });
    const int degree = static_cast<int>(numberOr(spec, "degree", 0));
    const int count = static_cast<int>(points.size());
    const Json* given = member(spec, "knots");
    auto knots = given != nullptr ? KnotVector::make(numbersOf(*given), degree, count, formOf(spec))
                                  : KnotVector::uniform(degree, count, formOf(spec));
    if (!knots) return knots.error();
    if (given == nullptr) spec["knots"] = listOf(knots->knots());
    const Json* weights = member(spec, "weights");
    auto curve = BsplineCurve::make(std::move(*knots), std::move(points), planar ? 2 : 3,
                                    weights != nullptr ? numbersOf(*weights)
                                                       : std::vector<double>{});
    if (!curve) return curve.error();
    return Curve(std::move(*curve));
}

Result<Curve> buildParametric(Json& spec) {
    std::vector<NamedValue> parameters;
    for (const auto& item : member(spec, "parameters")->items()) {
        parameters.emplace_back(item.key(), item.value().get<double>());
    }
    std::optional<Interval> over;
    if (const Json* given = member(spec, "domain")) {
        over = Interval{(*given)[0].get<double>(), (*given)[1].get<double>()};
    }
    auto curve = ParametricCurve::make(stringOr(spec, "name", ""), parameters, over);
    if (!curve) return curve.error();
    spec["domain"] = Json::array({curve->domain().start, curve->domain().end});
    return Curve(std::move(*curve));
}

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

Result<Curve> buildBlending(Json& spec) {
    auto blend = buildBFunction(*member(spec, "bFunction"));
    if (!blend) return blend.error().under("bFunction");
    return member(spec, "locals")->is_array() ? buildFromList(spec, std::move(*blend))
                                              : buildFromModel(spec, std::move(*blend));
}

/// The keys of a curve in the order of the tables: what was computed stands last until then.
Json inOrder(const Json& spec) {
    Json ordered = Json::object();
    const auto take = [&](std::string_view key) {
        if (const Json* value = member(spec, key)) ordered[std::string(key)] = *value;
    };
    take("id");
    take("type");
    for (const Field& field : findCurveType(stringOr(spec, "type", ""))->fields) take(field.name);
    take("style");
    take("show");
    return ordered;
}

/// Makes the curve of a validated specification and fills in what is computed.
Result<Curve> buildCurve(Json& spec) {
    const std::string type = stringOr(spec, "type", "");
    auto made = type == "bspline-curve"      ? buildBspline(spec)
                : type == "parametric-curve" ? buildParametric(spec)
                                             : buildBlending(spec);
    if (made) spec = inOrder(spec);
    return made;
}

Json describeParameters(std::span<const ParameterDescription> parameters) {
    Json list = Json::array();
    for (const ParameterDescription& parameter : parameters) {
        list.push_back({{"name", parameter.name},
                        {"label", parameter.label},
                        {"min", parameter.min},
                        {"max", parameter.max},
                        {"default", parameter.defaultValue},
                        {"minOpen", parameter.minOpen},
                        {"maxOpen", parameter.maxOpen},
                        {"integer", parameter.integer},
                        {"help", parameter.help}});
    }
    return list;
}

}  // namespace

Result<Made<BFunction>> makeBFunction(const Json& spec) {
    auto canonical = readBFunction(spec);
    if (!canonical) return canonical.error();
    auto made = buildBFunction(*canonical);
    if (!made) return made.error();
    return Made<BFunction>{std::move(*canonical), std::move(*made)};
}

Result<Made<Curve>> makeCurve(const Json& spec) {
    auto canonical = readCurve(spec, objectFields());
    if (!canonical) return canonical.error();
    for (const Field& field : objectFields()) canonical->erase(std::string(field.name));
    auto made = buildCurve(*canonical);
    if (!made) return made.error();
    return Made<Curve>{std::move(*canonical), std::move(*made)};
}

Result<Made<Curve>> makeObject(const Json& spec) {
    auto canonical = readCurve(spec, objectFields());
    if (!canonical) return canonical.error();
    for (const std::string_view group : {"style", "show"}) {
        const Json* given = member(*canonical, group);
        const auto field = std::find_if(objectFields().begin(), objectFields().end(),
                                        [&](const Field& f) { return f.name == group; });
        auto filled = readGroup(given != nullptr ? *given : Json::object(), field->fields.all());
        if (!filled) return filled.error().under(group);
        (*canonical)[std::string(group)] = std::move(*filled);
    }
    auto made = buildCurve(*canonical);
    if (!made) return made.error();
    return Made<Curve>{std::move(*canonical), std::move(*made)};
}

Json specOf(const BsplineCurve& curve) {
    Json points = Json::array();
    for (const Vec3& point : curve.points()) points.push_back(pointJson(point, curve.dimension()));
    Json spec{{"type", "bspline-curve"},
              {"degree", static_cast<double>(curve.degree())},
              {"form", formName(curve.knotVector().form())},
              {"points", std::move(points)},
              {"knots", listOf(curve.knotVector().knots())}};
    if (!curve.weights().empty()) spec["weights"] = listOf(curve.weights());
    return spec;
}

Json describeBFunctions() {
    Json list = Json::array();
    for (const BFamilyDescription& family : bFunctionFamilies()) {
        Json described{{"family", family.name},
                       {"label", family.label},
                       {"formula", family.formula},
                       {"parameters", describeParameters(family.parameters)}};
        Json operands = Json::array();
        for (const OperandDescription& operand : family.operands) {
            operands.push_back({{"name", operand.name}, {"label", operand.label},
                                {"count", static_cast<double>(operand.count)}});
        }
        described["operands"] = std::move(operands);
        list.push_back(std::move(described));
    }
    return list;
}

Json describeParametricCurves() {
    Json list = Json::array();
    for (const ParametricModelDescription& model : parametricCurveModels()) {
        list.push_back({{"name", model.name},
                        {"label", model.label},
                        {"dimension", static_cast<double>(model.dimension)},
                        {"parameters", describeParameters(model.parameters)}});
    }
    return list;
}

}  // namespace knotwork::scene
