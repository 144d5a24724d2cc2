#include "scene/adaptation.hpp"

#include "scene/adaptation_parts.hpp"
#include "scene/json_values.hpp"
#include "scene/object_builders.hpp"
#include "scene/object_trace.hpp"
#include "scene/specs.hpp"

#include <algorithm>

namespace knotwork::scene {

namespace {

Json adaptParametric(const Json& before, Json after) {
    if (differs(before, after, "name")) {
        after.erase("parameters");
        after.erase("domain");
    } else if (differs(before, after, "parameters") && !differs(before, after, "domain")) {
        Json without = before;
        without.erase("domain");
        const auto made = makeCurve(without);
        if (made && !differs(made->spec, before, "domain")) after.erase("domain");
    }
    return after;
}

/// `degree` and `tension` belong to one scheme each.
Json adaptSubdivision(const Json& before, Json after) {
    if (differs(before, after, "scheme")) {
        after.erase("degree");
        after.erase("tension");
    }
    return after;
}

/// A triangle has weights of an order or those of a B-function.
Json adaptTriangle(const Json& before, Json after) {
    if (member(before, "order") == nullptr && member(after, "order") != nullptr) {
        after.erase("bFunction");
    } else if (member(before, "bFunction") == nullptr && member(after, "bFunction") != nullptr) {
        after.erase("order");
    }
    return after;
}

/// The object with the trace of a former one, where that algorithm works on its type too.
Json withTraceOf(const Json& before, Json object) {
    const Json* trace = member(before, "trace");
    if (trace == nullptr) return object;
    Json traced = object;
    traced["trace"] = *trace;
    traced = keepParameters(before, std::move(traced));
    const auto made = makeObject(object);
    const auto parameter = made ? parameterOf(traced, made->value) : Result<double>(made.error());
    return parameter && traceOf(traced, made->value, *parameter) ? traced : object;
}

/// Where nothing but the type was set: then the other fields are still those of the former one.
Json ofNewType(const Json& before, Json after) {
    const std::string type = stringOr(after, "type", "");
    if (findObjectType(type) == nullptr) return after;  // validation will say so
    Json former = after;
    former["type"] = before["type"];
    if (former != before) return after;
    Json object = ofType(before, type);
    if (findCurveType(type) == nullptr) object.erase("t");
    return withTraceOf(before, keepParameters(before, std::move(object)));
}

/// Enough samples that the table looks like the function it was made from.
constexpr std::size_t tabulatedSamples = 17;

Json sampledValues(const Json& spec) {
    std::vector<double> values(tabulatedSamples);
    if (const auto made = makeBFunction(spec)) made->value.sampleUniform(values);
    values.back() = 1;
    return listOf(values);
}

}  // namespace

bool differs(const Json& before, const Json& after, std::string_view key) {
    const Json* a = member(before, key);
    const Json* b = member(after, key);
    return (a == nullptr) != (b == nullptr) || (a != nullptr && *a != *b);
}

std::size_t changedIndex(const Json& shorter, const Json& longer) {
    std::size_t i = 0;
    while (i < shorter.size() && shorter[i] == longer[i]) ++i;
    return i;
}

Json adaptCurve(const Json& before, Json after) {
    const std::string type = stringOr(before, "type", "");
    if (stringOr(after, "type", "") != type) return ofNewType(before, std::move(after));
    if (type == "bspline-curve") return adaptBspline(before, std::move(after));
    if (type == "bezier-curve") return adaptWeights(before, std::move(after));
    if (type == "parametric-curve") return adaptParametric(before, std::move(after));
    if (type == "blending-curve") return adaptBlending(before, std::move(after));
    if (type == "subdivision-curve") return adaptSubdivision(before, std::move(after));
    return after;
}

Json adaptSurface(const Json& before, Json after) {
    const std::string type = stringOr(before, "type", "");
    if (stringOr(after, "type", "") != type) return ofNewType(before, std::move(after));
    if (type == "bspline-surface") return adaptBsplineSurface(before, std::move(after));
    if (type == "blending-surface") return adaptBlendingSurface(before, std::move(after));
    if (type == "blending-triangle") return adaptTriangle(before, std::move(after));
    if (type == "parametric-surface" && differs(before, after, "name")) after.erase("parameters");
    return after;
}

Json adaptObject(const Json& before, Json after) {
    const std::string type = stringOr(before, "type", "");
    if (stringOr(after, "type", "") != type) return ofNewType(before, std::move(after));
    if (type == "subdivision-surface") return adaptSubdivisionSurface(before, std::move(after));
    if (type == "point-cloud") return adaptPointCloud(before, std::move(after));
    if (findSurfaceType(type) != nullptr) return adaptSurface(before, std::move(after));
    return keepParameters(before, adaptCurve(before, std::move(after)));
}

Json keepParameters(const Json& before, Json after) {
    const auto stays = [](const Json& from, const Json& to) {
        const Json* t = member(to, "t");
        return t != nullptr && t->is_number() && !differs(from, to, "t");
    };
    const Json* former = member(before, "trace");
    const Json* trace = member(after, "trace");
    const bool own = stays(before, after);
    const bool traced = former != nullptr && trace != nullptr && stays(*former, *trace);
    if (!own && !traced) return after;
    const auto made = makeCurve(after);
    if (!made || isClosed(made->value)) return after;
    const Interval whole = domain(made->value);
    const auto keep = [&](Json& t) { t = std::clamp(t.get<double>(), whole.start, whole.end); };
    if (own) keep(after["t"]);
    if (traced) keep(after["trace"]["t"]);
    return after;
}

Json adaptFamily(const Json& before, const std::string& family) {
    Json adapted{{"family", family}};
    const BFamilyDescription* description = findBFamily(family);
    if (description == nullptr) return adapted;  // validation will say so
    for (const OperandDescription& operand : description->operands) {
        adapted[std::string(operand.name)] =
            operand.count == 1 ? before : Json::array({before, Json{{"family", "linear"}}});
    }
    if (description->tabulated) adapted["values"] = sampledValues(before);
    if (description->expression) adapted["expression"] = "t^2*(3-2*t)";
    return adapted;
}

}  // namespace knotwork::scene
