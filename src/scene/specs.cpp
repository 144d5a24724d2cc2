#include "scene/specs.hpp"

#include "scene/parameter_fields.hpp"
#include "scene/spec_builders.hpp"
#include "scene/validation.hpp"

#include <algorithm>
#include <array>

namespace knotwork::scene {

namespace {

struct Builder {
    std::string_view type;
    Result<Curve> (*build)(Json& spec);
};

/// One for every type of curveTypes().
constexpr std::array builders{
    Builder{"bspline-curve", buildBspline},
    Builder{"parametric-curve", buildParametric},
    Builder{"blending-curve", buildBlending},
    Builder{"bezier-curve", buildBezier},
    Builder{"line-curve", buildLine},
    Builder{"arc-curve", buildArc},
    Builder{"subdivision-curve", buildSubdivision},
    Builder{"formula-curve", buildFormula},
};

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

}  // namespace

Result<Curve> buildCurve(Json& spec) {
    const std::string type = stringOr(spec, "type", "");
    const auto builder = std::find_if(builders.begin(), builders.end(),
                                      [&](const Builder& b) { return b.type == type; });
    auto made = builder->build(spec);
    if (made) spec = inOrder(spec);
    return made;
}

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

Json specOf(const Curve& curve) {
    // The other kinds are never computed.
    if (const auto* bezier = curve.as<BezierCurve>()) return specOf(*bezier);
    if (const auto* line = curve.as<LineCurve>()) return specOf(*line);
    if (const auto* arc = curve.as<ArcCurve>()) return specOf(*arc);
    if (const auto* subdivision = curve.as<SubdivisionCurve>()) return specOf(*subdivision);
    return specOf(*curve.as<BsplineCurve>());
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
