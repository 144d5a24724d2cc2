#include "scene/commands.hpp"

#include "scene/adaptation.hpp"
#include "scene/blending_specs.hpp"
#include "scene/document.hpp"
#include "scene/edits.hpp"
#include "scene/json_values.hpp"
#include "scene/knot_edits.hpp"
#include "scene/path.hpp"
#include "scene/specs.hpp"
#include "scene/validation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace knotwork::scene {

namespace {

constexpr std::array<std::string_view, 7> verbs{"set", "move", "insert", "remove",
                                                "add", "pose", "insertKnot"};

Error missing(const Path& path) {
    return refuse(Code::unknownField, formatPath(path),
                  "There is nothing at " + formatPath(path) + " in this scene.");
}

// --- what a path leads to ---------------------------------------------------------------------

bool startsWith(const Path& path, std::string_view list) {
    return path.size() >= 2 && path[0].key == list && path[1].isIndex();
}

/// The state with object `i` made anew from `spec`.
Result<State> withObject(const State& state, std::size_t i, const Json& spec) {
    auto object = readObject(spec);
    if (!object) return object.error().under(indexed("objects", i));
    State next = state;
    for (std::size_t other = 0; other < state.objects.size(); ++other) {
        if (other != i && state.objects[other]->id == (*object)->id) {
            return refuse(Code::outOfRange, indexed("objects", i) + ".id",
                          "There is an object \"" + (*object)->id + "\" already.");
        }
    }
    const std::string former = state.objects[i]->id;
    next.objects[i] = std::move(*object);
    // Effects follow their object to a new name, and must still fit what it has become.
    for (std::size_t k = 0; k < next.effects.size(); ++k) {
        if (next.effects[k]->target != former) continue;
        Json effect = next.effects[k]->spec;
        effect["target"] = next.objects[i]->id;
        auto read = readEffect(effect, next.objects);
        if (!read) return read.error().under(indexed("effects", k));
        next.effects[k] = std::move(*read);
    }
    return next;
}

Result<State> withEffect(const State& state, std::size_t i, const Json& spec) {
    auto effect = readEffect(spec, state.objects);
    if (!effect) return effect.error().under(indexed("effects", i));
    State next = state;
    next.effects[i] = std::move(*effect);
    return next;
}

Result<State> withHeader(const State& state, const Json& header) {
    auto read = readHeader(header);
    if (!read) return read.error();
    State next = state;
    next.header = std::move(*read);
    return next;
}

/// The state after `change` has been applied to the JSON of the part that `path` leads into.
/// `change` gets that part and the rest of the path.
template <class ChangePart>
Result<State> changeAt(const State& state, const Path& path, ChangePart change) {
    const std::span<const PathStep> all(path);
    if (startsWith(path, "objects") && path.size() > 2) {
        const std::size_t i = path[1].index;
        if (i >= state.objects.size()) return missing(path);
        const Json& before = state.objects[i]->spec;
        auto changed = change(before, all.subspan(2));
        if (!changed) return changed.error().under(indexed("objects", i));
        return withObject(state, i, adaptObject(before, std::move(*changed)));
    }
    if (startsWith(path, "effects") && path.size() > 2) {
        const std::size_t i = path[1].index;
        if (i >= state.effects.size()) return missing(path);
        auto changed = change(state.effects[i]->spec, all.subspan(2));
        if (!changed) return changed.error().under(indexed("effects", i));
        return withEffect(state, i, *changed);
    }
    if (path[0].key == "objects" || path[0].key == "effects") return missing(path);
    auto changed = change(*state.header, all);
    if (!changed) return changed.error();
    return withHeader(state, *changed);
}

// --- knots ------------------------------------------------------------------------------------

/// `spec` with what the object has besides its curve taken over from `object`.
Json dressed(Json spec, const Object& object) {
    Json full{{"id", object.id}};
    full.update(spec);
    for (const char* key : {"style", "show"}) {
        if (const Json* value = member(object.spec, key)) full[key] = *value;
    }
    return full;
}

/// Whether the command moves a knot of a blending curve whose local curves are to stay.
Result<bool> keepsLocals(const State& state, const Path& path, const Json& command) {
    const Json* recut = member(command, "recut");
    if (recut == nullptr) return false;
    if (!recut->is_boolean()) {
        return refuse(Code::wrongType, "recut",
                      "Expected true or false, got " + describeValue(*recut) + ".");
    }
    const bool knot = startsWith(path, "objects") && path.size() == 4 && path[2].key == "knots" &&
                      path[1].index < state.objects.size();
    if (!knot || state.objects[path[1].index]->body.as<BlendingCurve>() == nullptr) {
        return refuse(Code::notSupported, "recut",
                      "Only local curves are cut anew or not, when a knot of theirs is moved.");
    }
    return !recut->get<bool>();
}

/// The state after a knot has been moved while every local curve stays where it is.
Result<State> withLocalsKept(const State& state, const Path& path, const Json& command) {
    const std::size_t i = path[1].index;
    const Object& object = *state.objects[i];
    const auto moved = moveIn(object.spec, std::span<const PathStep>(path).subspan(2), command);
    if (!moved) return moved.error().under(indexed("objects", i));
    // Whatever is wrong with the knots is said as it is of any others.
    if (const auto checked = readObjectSpec(*moved); !checked) {
        return checked.error().under(indexed("objects", i));
    }
    auto spec = withKnots(object.spec, *object.body.as<BlendingCurve>(),
                          numbersOf(*member(*moved, "knots")), false);
    if (!spec) return spec.error().under(indexed("objects", i));
    return withObject(state, i, dressed(std::move(*spec), object));
}

/// The object that a command names by its id under `key`.
Result<std::size_t> objectNamed(const State& state, const Json& arguments, std::string_view verb) {
    const std::string path = std::string(verb) + ".object";
    const Json* id = member(arguments, "object");
    if (id == nullptr || !id->is_string()) {
        return refuse(Code::wrongType, path, "Give the id of an object, a text.");
    }
    for (std::size_t i = 0; i < state.objects.size(); ++i) {
        if (state.objects[i]->id == id->get_ref<const std::string&>()) return i;
    }
    return refuse(Code::unknownName, path, "There is no object " + describeValue(*id) + ".");
}

Result<Executed> executeInsertKnot(const State& state, const Json& arguments) {
    const auto i = objectNamed(state, arguments, "insertKnot");
    if (!i) return i.error();
    const Json* at = member(arguments, "at");
    if (at == nullptr || !at->is_number()) {
        return refuse(Code::wrongType, "insertKnot.at", "Give the parameter of the new knot.");
    }
    if (!std::isfinite(at->get<double>())) {
        return refuse(Code::notFinite, "insertKnot.at", "The knot must be a finite number.");
    }
    auto spec = withKnot(state.objects[*i]->spec, at->get<double>());
    if (!spec) {
        const bool unsuited = spec.error().code == Code::notSupported;
        return refuse(spec.error().code, unsuited ? "insertKnot.object" : "insertKnot.at",
                      spec.error().message);
    }
    auto next = withObject(state, *i, *spec);
    if (!next) return next.error();
    return Executed{std::move(*next), {"insertKnot", indexed("objects", *i) + ".knots"}};
}

// --- objects and poses ------------------------------------------------------------------------

Result<Executed> executeAdd(const State& state, const Json& given) {
    if (state.objects.size() >= maximumObjects) {
        return refuse(Code::tooLarge, "add", "A scene has at most 1000 objects.");
    }
    if (!given.is_object()) {
        return refuse(Code::wrongType, "add",
                      "Expected an object, got " + describeValue(given) + ".");
    }
    Json spec = given;
    if (member(spec, "id") == nullptr) spec["id"] = freshId(state.objects);
    auto object = readObject(spec);
    if (!object) return object.error().under("add");
    if (state.find((*object)->id) != nullptr) {
        return refuse(Code::outOfRange, "add.id",
                      "There is an object \"" + (*object)->id + "\" already.");
    }
    State next = state;
    next.objects.push_back(std::move(*object));
    return Executed{std::move(next), {"add", indexed("objects", state.objects.size())}};
}

/// The poses with those of `arguments` taken over for its local curve.
Json mergedPoses(const Json& poses, const Json& arguments) {
    Json merged = poses;
    Json fields = arguments;
    fields.erase("object");
    const double local = numberOr(arguments, "local", -1);
    for (Json& pose : merged) {
        if (numberOr(pose, "local", -1) != local) continue;
        pose.update(fields);
        return merged;
    }
    merged.push_back(std::move(fields));
    return merged;
}

Result<Executed> executePose(const State& state, const Json& arguments) {
    const auto i = objectNamed(state, arguments, "pose");
    if (!i) return i.error();
    Json fields = arguments;
    fields.erase("object");
    if (const auto pose = readGroup(fields, poseFields()); !pose) return pose.error().under("pose");
    const Object& object = *state.objects[*i];
    const Json* poses = member(object.spec, "poses");
    if (poses == nullptr) {
        return refuse(Code::notSupported, "pose.object",
                      "\"" + object.id + "\" has no local curves that could be posed.");
    }
    Json spec = object.spec;
    spec["poses"] = mergedPoses(*poses, arguments);
    auto next = withObject(state, *i, spec);
    if (!next) return next.error();
    return Executed{std::move(*next), {"pose", indexed("objects", *i) + ".poses"}};
}

// --- whole entries of the two lists -------------------------------------------------------------

Result<State> withoutEntry(const State& state, const Path& path) {
    State next = state;
    const std::size_t i = path[1].index;
    if (path[0].key == "effects") {
        if (i >= next.effects.size()) return missing(path);
        next.effects.erase(next.effects.begin() + static_cast<std::ptrdiff_t>(i));
        return next;
    }
    if (i >= next.objects.size()) return missing(path);
    const std::string id = next.objects[i]->id;
    next.objects.erase(next.objects.begin() + static_cast<std::ptrdiff_t>(i));
    // An effect without its object would refer to nothing.
    std::erase_if(next.effects, [&](const auto& effect) { return effect->target == id; });
    return next;
}

Result<State> withEntry(const State& state, const Path& path, const Json& value, bool replace) {
    Json document = writeDocument(state);
    Json& list = document[path[0].key];
    const std::size_t i = path[1].index;
    if (replace ? i >= list.size() : i > list.size()) return missing(path);
    if (replace) {
        list[i] = value;
    } else {
        list.insert(list.begin() + static_cast<std::ptrdiff_t>(i), value);
    }
    return readDocument(document);
}

Result<State> executeAt(const State& state, std::string_view verb, const Path& path,
                        const Json& command) {
    const bool entry = path.size() == 2 && (startsWith(path, "objects") || startsWith(path, "effects"));
    const bool needsValue = verb == "set" || verb == "insert";
    const Json* value = member(command, "value");
    if (needsValue && value == nullptr) {
        return refuse(Code::wrongType, "value", "The command needs a \"value\".");
    }
    if (verb == "move") {
        const auto keeps = keepsLocals(state, path, command);
        if (!keeps) return keeps.error();
        if (*keeps) return withLocalsKept(state, path, command);
    }
    if (entry && verb == "remove") return withoutEntry(state, path);
    if (entry && needsValue) return withEntry(state, path, *value, verb == "set");
    return changeAt(state, path, [&](const Json& part, std::span<const PathStep> rest) {
        if (verb == "set") return setIn(part, rest, *value);
        if (verb == "move") return moveIn(part, rest, command);
        const bool knots = leadsToKnots(part, rest);
        if (verb == "insert") {
            return knots ? insertKnotIn(part, rest, *value) : insertIn(part, rest, *value);
        }
        // Without an index it is the whole list that goes, and the default comes back.
        return knots && rest.back().isIndex() ? removeKnotIn(part, rest) : removeIn(part, rest);
    });
}

Result<std::string_view> verbOf(const Json& command) {
    std::string_view verb;
    int count = 0;
    for (const auto& item : command.items()) {
        const auto known = std::find(verbs.begin(), verbs.end(), item.key());
        const bool argument = item.key() == "value" || item.key() == "to" || item.key() == "by" ||
                              item.key() == "gesture" || item.key() == "recut";
        if (known == verbs.end() && !argument) {
            return refuse(Code::unknownField, item.key(),
                          "A command has no field \"" + item.key() + "\".");
        }
        if (known == verbs.end()) continue;
        verb = *known;
        ++count;
    }
    if (count == 1) return verb;
    return refuse(Code::wrongType, "",
                  "A command has one of set, move, insert, remove, add, pose, insertKnot.");
}

}  // namespace

Result<Executed> executeCommand(const State& state, const Json& command) {
    if (!command.is_object()) {
        return refuse(Code::wrongType, "",
                      "Expected a command such as { \"set\": path, \"value\": … }, got " +
                          describeValue(command) + ".");
    }
    const auto verb = verbOf(command);
    if (!verb) return verb.error();
    if (*verb != "move" && member(command, "recut") != nullptr) {
        return refuse(Code::unknownField, "recut", "Only a move of a knot can keep local curves.");
    }
    const Json& argument = *member(command, *verb);
    if (*verb == "add") return executeAdd(state, argument);
    if (*verb == "pose") return executePose(state, argument);
    if (*verb == "insertKnot") return executeInsertKnot(state, argument);
    if (!argument.is_string()) {
        return refuse(Code::wrongType, std::string(*verb),
                      "Expected a path such as \"objects[0].degree\", got " +
                          describeValue(argument) + ".");
    }
    const auto path = parsePath(argument.get_ref<const std::string&>());
    if (!path) return path.error().under(*verb);
    auto next = executeAt(state, *verb, *path, command);
    if (!next) return next.error();
    return Executed{std::move(*next), {std::string(*verb), formatPath(*path)}};
}

}  // namespace knotwork::scene
