#include "scene/specs.hpp"

#include "geometry/named.hpp"
#include "scene/parameter_fields.hpp"
#include "scene/spec_builders.hpp"
#include "scene/validation.hpp"

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

}  // namespace

Json inOrder(Json spec, std::span<const Field> fields) {
    Json ordered = Json::object();
    const auto take = [&](std::string_view key) {
        Json* value = member(spec, key);
        if (value == nullptr || member(ordered, key) != nullptr) return;
        ordered[std::string(key)] = std::move(*value);
    };
    take("id");
    take("type");
    for (const Field& field : fields) take(field.name);
    for (const Field& field : objectFields()) take(field.name);
    return ordered;
}

Result<Curve> buildCurve(Json& spec) {
    const std::string type = stringOr(spec, "type", "");
    auto made = findNamed(builders, &Builder::type, type)->build(spec);
    if (made) spec = inOrder(std::move(spec), findCurveType(type)->fields);
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
