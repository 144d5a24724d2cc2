// The part of the session that answers questions by name.
#include "bindings/queries.hpp"
#include "bindings/session.hpp"
#include "scene/validation.hpp"

namespace knotwork::bindings {

using scene::Json;

namespace {

template <class Query, class Value>
Result<Answer> answerOf(const Query& query, const Value& value, const Json& given) {
    const auto arguments = scene::readGroup(given, query.fields);
    return arguments ? query.answer(value, *arguments) : Result<Answer>(arguments.error());
}

Result<Answer> answerOf(const FreeQuery& query, const Json& given) {
    if (!query.checked) return query.answer(given);
    const auto arguments = scene::readGroup(given, query.fields);
    return arguments ? query.answer(*arguments) : Result<Answer>(arguments.error());
}

}  // namespace

std::string Session::deliver(Result<Answer> answer) {
    if (!answer) {
        refuse(answer.error());
        return {};
    }
    const auto list = [&](const char* values, int handle, std::size_t traitCount) {
        Json traits = Json::array();
        for (std::size_t i = 0; i < traitCount; ++i) traits.push_back(block_[i]);
        answer->json[values].push_back({{"handle", handle}, {"traits", std::move(traits)}});
    };
    for (Curve& curve : answer->curves) {
        const int handle = holdCurve({std::move(curve), std::nullopt, std::nullopt, {}});
        if (handle == 0) return {};
        list("curves", handle, curveTraits);
    }
    for (Surface& surface : answer->surfaces) {
        const int handle = holdSurface({std::move(surface), std::nullopt});
        if (handle == 0) return {};
        list("surfaces", handle, surfaceTraits);
    }
    if (!answer->numbers.empty()) {
        const std::size_t count = answer->numbers.size();
        answer->json["count"] = leave(std::move(answer->numbers), count);
    }
    return scene::dumpJson(answer->json);
}

std::string Session::askCurve(const std::string& name, int handle, unsigned bytes) {
    const auto* held = find<CurveValue>(handle);
    if (!held) return {};
    const auto given = input(bytes);
    if (!given) return deliver(given.error());
    return deliver(answerOf(*findCurveQuery(name), held->curve, *given));
}

std::string Session::askSurface(const std::string& name, int handle, unsigned bytes) {
    const auto* held = find<SurfaceValue>(handle);
    if (!held) return {};
    const auto given = input(bytes);
    if (!given) return deliver(given.error());
    return deliver(answerOf(*findSurfaceQuery(name), held->surface, *given));
}

std::string Session::ask(const std::string& name, unsigned bytes) {
    const auto given = input(bytes);
    if (!given) return deliver(given.error());
    return deliver(answerOf(*findFreeQuery(name), *given));
}

}  // namespace knotwork::bindings
