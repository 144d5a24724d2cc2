// Commands on whole objects and effects.
#include "scene/command_parts.hpp"
#include "scene/document.hpp"
#include "scene/json_values.hpp"
#include "scene/validation.hpp"

#include <algorithm>
#include <cmath>

namespace knotwork::scene {

namespace {

template <class List>
auto placeIn(List& list, std::size_t i) {
    return list.begin() + static_cast<std::ptrdiff_t>(i);
}

/// Element `from` of the list put where it will be element `to`.
template <class List>
void reorder(List& list, std::size_t from, std::size_t to) {
    auto taken = std::move(list[from]);
    list.erase(placeIn(list, from));
    list.insert(placeIn(list, to), std::move(taken));
}

Error full(std::string path, std::size_t most, std::string_view what) {
    return refuse(Code::tooLarge, std::move(path),
                  "A scene has at most " + std::to_string(most) + " " + std::string(what) + ".");
}

/// The state with one more object before number `i`; errors are those of `path`.
Result<State> withNewObject(const State& state, std::size_t i, Json spec, const std::string& path) {
    if (state.objects.size() >= maximumObjects) return full(path, maximumObjects, "objects");
    if (!spec.is_object()) {
        return refuse(Code::wrongType, path,
                      "Expected an object, got " + describeValue(spec) + ".");
    }
    if (member(spec, "id") == nullptr) spec["id"] = freshId(state.objects);
    auto object = readObject(spec);
    if (!object) return object.error().under(path);
    if (state.find((*object)->id) != nullptr) {
        return refuse(Code::outOfRange, path + ".id",
                      "There is an object \"" + (*object)->id + "\" already.");
    }
    State next = state;
    next.objects.insert(placeIn(next.objects, i), std::move(*object));
    return next;
}

}  // namespace

Result<Executed> executeAdd(const State& state, const Json& object) {
    const std::size_t end = state.objects.size();
    auto next = withNewObject(state, end, object, "add");
    if (!next) return next.error();
    return Executed{std::move(*next), {"add", indexed("objects", end)}};
}

Result<State> setEntry(const State& state, const Path& path, const Json& value) {
    const std::size_t i = path[1].index;
    if (path[0].key == "effects") {
        if (i >= state.effects.size()) return missing(path);
        return withEffect(state, i, value);
    }
    if (i >= state.objects.size()) return missing(path);
    return withObject(state, i, dressed(value, *state.objects[i]));
}

Result<State> insertEntry(const State& state, const Path& path, const Json& value) {
    const std::size_t i = path[1].index;
    if (path[0].key == "objects") {
        if (i > state.objects.size()) return missing(path);
        return withNewObject(state, i, value, formatPath(path));
    }
    if (i > state.effects.size()) return missing(path);
    if (state.effects.size() >= maximumEffects) {
        return full(formatPath(path), maximumEffects, "effects");
    }
    auto effect = readEffect(value, state.objects);
    if (!effect) return effect.error().under(formatPath(path));
    State next = state;
    next.effects.insert(placeIn(next.effects, i), std::move(*effect));
    return next;
}

Result<State> removeEntry(const State& state, const Path& path) {
    State next = state;
    const std::size_t i = path[1].index;
    if (path[0].key == "effects") {
        if (i >= next.effects.size()) return missing(path);
        next.effects.erase(placeIn(next.effects, i));
        return next;
    }
    if (i >= next.objects.size()) return missing(path);
    const std::string id = next.objects[i]->id;
    next.objects.erase(placeIn(next.objects, i));
    // An effect without its object would refer to nothing.
    std::erase_if(next.effects, [&](const auto& effect) { return effect->target == id; });
    return next;
}

Result<State> moveEntry(const State& state, const Path& path, const Json& command) {
    const bool objects = path[0].key == "objects";
    const std::size_t count = objects ? state.objects.size() : state.effects.size();
    if (path[1].index >= count) return missing(path);
    const Json* to = member(command, "to");
    if (to == nullptr || !to->is_number()) {
        return refuse(Code::wrongType, "to", "Give the number of the place in the list.");
    }
    const double place = to->get<double>();
    if (place != std::floor(place)) {  // NaN included
        return refuse(Code::notInteger, "to", "Places in a list are whole numbers.");
    }
    if (place < 0 || place >= static_cast<double>(count)) {
        return refuse(Code::outOfRange, "to",
                      "There is no place " + formatNumber(place) + "; they are 0 to " +
                          std::to_string(count - 1) + ".");
    }
    State next = state;
    if (objects) {
        reorder(next.objects, path[1].index, static_cast<std::size_t>(place));
    } else {
        reorder(next.effects, path[1].index, static_cast<std::size_t>(place));
    }
    return next;
}

}  // namespace knotwork::scene
