// Commands that change what stands at a place: a point, a knot, a number, or many at once.
#include "scene/command_parts.hpp"
#include "scene/edits.hpp"
#include "scene/knot_edits.hpp"
#include "scene/validation.hpp"

#include <algorithm>
#include <map>

namespace knotwork::scene {

namespace {

constexpr std::size_t maximumMoved = 10'000;

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

Result<State> withChange(const State& state, const Part& part, Json changed) {
    if (part.of == Part::Of::object && changesOnlyPoint(changed, part.rest)) {
        return withPointsOf(state, part.index, std::move(changed));
    }
    return withPart(state, part, std::move(changed));
}

Result<Executed> moveKnot(const State& state, const Part& part, Path path, const Json& command) {
    auto moved = moveKnotIn(*part.spec, part.rest, command);
    if (!moved) {
        return moved.error().path == "snap" ? moved.error() : moved.error().under(part.path());
    }
    auto next = withPart(state, part, std::move(moved->part));
    if (!next) return next.error();
    path.back().index = moved->index;
    return Executed{std::move(*next), {"move", formatPath(path)}};
}

Result<Executed> moveAt(const State& state, const Path& path, const Json& command) {
    const auto part = partAt(state, path);
    if (!part) return part.error();
    if (namesKnot(*part->spec, part->rest)) return moveKnot(state, *part, path, command);
    if (member(command, "snap") != nullptr) {
        return refuse(Code::unknownField, "snap", "Only knots are merged with others nearby.");
    }
    Json changed = editable(state, *part);
    const Json* value = find(changed, part->rest);
    if (value == nullptr) return missing(path);
    const auto moved = movedValue(*value, command);
    if (!moved) return moved.error().under(part->path());
    auto set = setIn(std::move(changed), part->rest, *moved);
    if (!set) return set.error().under(part->path());
    auto next = withChange(state, *part, std::move(*set));
    if (!next) return next.error();
    return Executed{std::move(*next), {"move", formatPath(path)}};
}

/// An object of which several places are moved.
struct Moving {
    Json changed;
    Json edited = nullptr;  ///< as it was, a solid turned into vertices and faces, if that is needed
    bool onlyPoints = true;
};

/// The object as it was, with the place in it where that is to be had.
const Json& originalOf(const State& state, const Part& part, Moving& moving) {
    if (find(*part.spec, part.rest) != nullptr) return *part.spec;
    if (moving.edited.is_null()) {
        moving.edited = editable(state, part);
        if (const Json* mesh = member(moving.edited, "mesh")) moving.changed["mesh"] = *mesh;
    }
    return moving.edited;
}

/// Moves what stands at `part` of the unchanged object, in the object as it is so far.
Result<Done> moveOne(const Part& part, const Json& original, const Json& command, Moving& moving) {
    const Json* value = find(original, part.rest);
    if (value == nullptr) {
        const std::string place = formatPath(Path(part.rest.begin(), part.rest.end()));
        return refuse(Code::unknownField, joinPath(part.path(), place),
                      "There is nothing at this place in this scene.");
    }
    const auto moved = movedValue(*value, command);
    if (!moved) return moved.error();
    auto set = namesKnot(original, part.rest)
                   ? withKnotAt(std::move(moving.changed), part.rest, *moved)
                   : setIn(std::move(moving.changed), part.rest, *moved);
    if (!set) return set.error().under(part.path());
    moving.changed = std::move(*set);
    moving.onlyPoints = moving.onlyPoints && changesOnlyPoint(moving.changed, part.rest);
    return Done{};
}

/// The steps that all paths begin with.
Path inCommon(const std::vector<Path>& paths) {
    Path common = paths.front();
    for (const Path& path : paths) {
        std::size_t same = 0;
        while (same < std::min(common.size(), path.size()) && common[same] == path[same]) ++same;
        common.resize(same);
    }
    return common;
}

Result<std::vector<Path>> readPaths(const Json& list) {
    if (list.empty()) return refuse(Code::wrongLength, "move", "Give at least one path to move.");
    if (list.size() > maximumMoved) {
        return refuse(Code::tooLarge, "move",
                      std::to_string(list.size()) + " paths; at most " +
                          std::to_string(maximumMoved) + " are moved at once.");
    }
    std::vector<Path> paths;
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (!list[i].is_string()) {
            return refuse(Code::wrongType, indexed("move", i),
                          "Expected a path such as \"objects[0].points[2]\", got " +
                              describeValue(list[i]) + ".");
        }
        auto path = parsePath(list[i].get_ref<const std::string&>());
        if (!path) return path.error().under(indexed("move", i));
        if (!startsWith(*path, "objects") || path->size() < 3) {
            return refuse(Code::notSupported, indexed("move", i),
                          "What is moved together are places in objects.");
        }
        paths.push_back(std::move(*path));
    }
    return paths;
}

}  // namespace

Result<State> setField(const State& state, const Path& path, const Json& value) {
    const auto part = partAt(state, path);
    if (!part) return part.error();
    auto changed = setIn(editable(state, *part), part->rest, value);
    if (!changed) return changed.error().under(part->path());
    return withChange(state, *part, std::move(*changed));
}

Result<Executed> executeMove(const State& state, const Path& path, const Json& command) {
    const auto keeps = keepsLocals(state, path, command);
    if (!keeps) return keeps.error();
    if (!*keeps && (path.size() > 2 || !startsWith(path, path[0].key))) {
        return moveAt(state, path, command);
    }
    auto next = *keeps ? withLocalsKept(state, path, command) : moveEntry(state, path, command);
    if (!next) return next.error();
    return Executed{std::move(*next), {"move", formatPath(path)}};
}

Result<Executed> executeMoves(const State& state, const Json& command) {
    for (const char* argument : {"to", "recut", "snap"}) {
        if (member(command, argument) == nullptr) continue;
        return refuse(Code::notSupported, argument, "Several places are moved \"by\" an amount.");
    }
    const auto paths = readPaths(*member(command, "move"));
    if (!paths) return paths.error();
    std::map<std::size_t, Moving> objects;
    for (const Path& path : *paths) {
        const auto part = partAt(state, path);
        if (!part) return part.error();
        const auto [found, fresh] = objects.try_emplace(part->index);
        Moving& moving = found->second;
        if (fresh) moving.changed = *part->spec;
        const auto moved = moveOne(*part, originalOf(state, *part, moving), command, moving);
        if (!moved) return moved.error();
    }
    State next = state;
    for (auto& [i, moving] : objects) {
        auto changed = moving.onlyPoints
                           ? withPointsOf(next, i, std::move(moving.changed))
                           : withPart(next, {Part::Of::object, i, &state.objects[i]->spec, {}},
                                      std::move(moving.changed));
        if (!changed) return changed.error();
        next = std::move(*changed);
    }
    return Executed{std::move(next), {"move", formatPath(inCommon(*paths))}};
}

}  // namespace knotwork::scene
