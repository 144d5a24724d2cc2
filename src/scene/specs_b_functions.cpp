#include "scene/spec_builders.hpp"

#include "scene/json_values.hpp"

namespace knotwork::scene {

namespace {

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

}  // namespace

Result<BFunction> buildBFunction(const Json& spec) {
    const std::string name = stringOr(spec, "family", "");
    const BFamilyDescription& family = *findBFamily(name);
    switch (family.family) {
        case BFamily::tabulated: return BFunction::makeTabulated(numbersOf(*member(spec, "values")));
        case BFamily::formula: return BFunction::makeFormula(stringOr(spec, "expression", ""));
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

Json specOf(const BFunction& blend) {
    const BFamilyDescription& family = blend.description();
    Json spec{{"family", family.name}};
    if (family.tabulated) spec["values"] = listOf(blend.values());
    if (family.expression) spec["expression"] = blend.expression();
    const std::vector<BFunction> operands = blend.operands();
    std::size_t next = 0;
    for (const OperandDescription& operand : family.operands) {
        Json& given = spec[std::string(operand.name)];
        if (operand.count == 1) {
            given = specOf(operands[next++]);
            continue;
        }
        given = Json::array();
        for (int k = 0; k < operand.count; ++k) given.push_back(specOf(operands[next++]));
    }
    for (std::size_t k = 0; k < family.parameters.size(); ++k) {
        spec[std::string(family.parameters[k].name)] = blend.parameters()[k];
    }
    return spec;
}

}  // namespace knotwork::scene
