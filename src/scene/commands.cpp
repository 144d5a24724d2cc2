#include "scene/commands.hpp"

#include "scene/command_parts.hpp"
#include "scene/edits.hpp"
#include "scene/knot_edits.hpp"
#include "scene/validation.hpp"

#include <algorithm>
#include <array>

namespace knotwork::scene {

namespace {

constexpr std::array<std::string_view, 8> verbs{"set", "move", "insert",     "remove",
                                                "add", "pose", "insertKnot", "all"};

/// What may stand beside a verb; `value`, `to` and `by` are ignored where they have no part.
constexpr std::array<std::string_view, 7> arguments{"value", "to",   "by",       "gesture",
                                                    "recut", "snap", "selection"};

template <std::size_t N>
bool among(const std::array<std::string_view, N>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

Result<std::string_view> verbOf(const Json& command) {
    std::string_view verb;
    int count = 0;
    for (const auto& item : command.items()) {
        const auto known = std::find(verbs.begin(), verbs.end(), item.key());
        if (known == verbs.end() && !among(arguments, item.key())) {
            return refuse(Code::unknownField, item.key(),
                          "A command has no field \"" + item.key() + "\".");
        }
        if (known == verbs.end()) continue;
        verb = *known;
        ++count;
    }
    if (count != 1) {
        return refuse(Code::wrongType, "",
                      "A command has one of set, move, insert, remove, add, pose, insertKnot, all.");
    }
    for (const char* knots : {"recut", "snap"}) {
        if (verb != "move" && member(command, knots) != nullptr) {
            return refuse(Code::unknownField, knots,
                          "Only a move of a knot can have \"" + std::string(knots) + "\".");
        }
    }
    return verb;
}

Result<State> insertAt(const State& state, const Part& part, const Json& value) {
    Json spec = editable(state, part);
    auto changed = leadsToKnots(spec, part.rest) ? insertKnotIn(spec, part.rest, value)
                                                 : insertIn(std::move(spec), part.rest, value);
    if (!changed && changed.error().path == "value") return changed.error();
    if (!changed) return changed.error().under(part.path());
    return withPart(state, part, std::move(*changed));
}

Result<State> removeAt(const State& state, const Part& part) {
    Json spec = editable(state, part);
    // Without an index it is the whole list that goes, and the default comes back.
    auto changed = namesKnot(spec, part.rest) ? removeKnotIn(spec, part.rest)
                                              : removeIn(std::move(spec), part.rest);
    if (!changed) return changed.error().under(part.path());
    return withPart(state, part, std::move(*changed));
}

/// `set`, `insert` and `remove`.
Result<State> executeAt(const State& state, std::string_view verb, const Path& path,
                        const Json& command) {
    const bool entry =
        path.size() == 2 && (startsWith(path, "objects") || startsWith(path, "effects"));
    const Json* value = member(command, "value");
    if (verb != "remove" && value == nullptr) {
        return refuse(Code::wrongType, "value", "The command needs a \"value\".");
    }
    if (verb == "set") return entry ? setEntry(state, path, *value) : setField(state, path, *value);
    if (entry) {
        return verb == "insert" ? insertEntry(state, path, *value) : removeEntry(state, path);
    }
    const auto part = partAt(state, path);
    if (!part) return part.error();
    return verb == "insert" ? insertAt(state, *part, *value) : removeAt(state, *part);
}

Result<Executed> executeAll(const State& state, const Json& commands) {
    if (!commands.is_array() || commands.empty()) {
        return refuse(Code::wrongType, "all",
                      "Expected a list of commands, got " + describeValue(commands) + ".");
    }
    if (commands.size() > maximumCommands) {
        return refuse(Code::tooLarge, "all",
                      std::to_string(commands.size()) + " commands; at most " +
                          std::to_string(maximumCommands) + " make one step.");
    }
    Executed executed{state, {}};
    for (std::size_t i = 0; i < commands.size(); ++i) {
        const std::string path = indexed("all", i);
        for (const char* whole : {"all", "gesture", "selection"}) {
            if (member(commands[i], whole) == nullptr) continue;
            return refuse(Code::unknownField, path + "." + whole,
                          "A command of a list has no \"" + std::string(whole) +
                              "\" of its own.");
        }
        auto next = executeCommand(executed.state, commands[i]);
        if (!next) return next.error().under(path);
        executed = std::move(*next);
    }
    executed.change = {"all", commands.size() == 1 ? executed.change.path : ""};
    return executed;
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
    const Json& argument = *member(command, *verb);
    if (*verb == "add") return executeAdd(state, argument);
    if (*verb == "pose") return executePose(state, argument);
    if (*verb == "insertKnot") return executeInsertKnot(state, argument);
    if (*verb == "all") return executeAll(state, argument);
    if (*verb == "move" && argument.is_array()) return executeMoves(state, command);
    if (!argument.is_string()) {
        return refuse(Code::wrongType, std::string(*verb),
                      "Expected a path such as \"objects[0].degree\", got " +
                          describeValue(argument) + ".");
    }
    const auto path = parsePath(argument.get_ref<const std::string&>());
    if (!path) return path.error().under(*verb);
    if (*verb == "move") return executeMove(state, *path, command);
    auto next = executeAt(state, *verb, *path, command);
    if (!next) return next.error();
    return Executed{std::move(*next), {std::string(*verb), formatPath(*path)}};
}

}  // namespace knotwork::scene
