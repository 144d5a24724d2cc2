// What commands are made of: a state with one part made anew. For the files commands*.cpp.
#pragma once

#include "scene/commands.hpp"
#include "scene/path.hpp"

#include <string_view>

namespace knotwork::scene {

/// UNKNOWN_FIELD: there is nothing at this path.
[[nodiscard]] Error missing(const Path& path);

/// Whether the path begins `objects[i]` (or `effects[i]`), where `list` says which.
[[nodiscard]] bool startsWith(const Path& path, std::string_view list);

/// The part of the document that a path leads into, and the rest of the path from there.
struct Part {
    enum class Of { header, object, effect };
    Of of = Of::header;
    std::size_t index = 0;  ///< in its list
    const Json* spec = nullptr;
    std::span<const PathStep> rest;

    /// `objects[2]`, or nothing for the header.
    [[nodiscard]] std::string path() const;
};

/// `path` outlives the part. Refuses what missing() says, whole entries of lists included.
[[nodiscard]] Result<Part> partAt(const State& state, const Path& path);

/// The JSON of the part, to be changed at `rest`. A solid is turned into vertices and faces where
/// `rest` leads to one of them.
[[nodiscard]] Json editable(const State& state, const Part& part);

/// The state with `changed` in the place of the part, and what depends on the change adapted.
[[nodiscard]] Result<State> withPart(const State& state, const Part& part, Json changed);

/// Whether `rest` names a point of the object or a coordinate of one, and what `changed` has there
/// is a point: then nothing else needs to be looked at again.
[[nodiscard]] bool changesOnlyPoint(const Json& changed, std::span<const PathStep> rest);

/// The object that a command names by its id under `object`; refusals at `<verb>.object`.
[[nodiscard]] Result<std::size_t> objectNamed(const State& state, const Json& arguments,
                                              std::string_view verb);

/// The state with object `i` made anew from `spec`. Effects follow their object to a new name and
/// their local curve to a new number; those that have nothing to move any more go.
[[nodiscard]] Result<State> withObject(const State& state, std::size_t i, const Json& spec);
/// The same where only points of the canonical specification changed, and were checked.
[[nodiscard]] Result<State> withPointsOf(const State& state, std::size_t i, Json spec);
[[nodiscard]] Result<State> withEffect(const State& state, std::size_t i, const Json& spec);
[[nodiscard]] Result<State> withHeader(const State& state, const Json& header);

/// What an object has besides its shape (`id`, `style`, `show`), put into `spec` where it has none.
[[nodiscard]] Json dressed(Json spec, const Object& object);

// The commands, by topic.

// commands_entries.cpp: whole entries of the two lists.
[[nodiscard]] Result<Executed> executeAdd(const State& state, const Json& object);
/// `set`, `insert` and `remove` of `objects[i]` or `effects[i]`.
[[nodiscard]] Result<State> setEntry(const State& state, const Path& path, const Json& value);
[[nodiscard]] Result<State> insertEntry(const State& state, const Path& path, const Json& value);
[[nodiscard]] Result<State> removeEntry(const State& state, const Path& path);
/// { move: 'objects[2]', to: 0 }: to another place in the list.
[[nodiscard]] Result<State> moveEntry(const State& state, const Path& path, const Json& command);

// commands_moves.cpp: points, knots and numbers, one or many.
[[nodiscard]] Result<Executed> executeMove(const State& state, const Path& path,
                                           const Json& command);
/// `set` of what is not a whole entry.
[[nodiscard]] Result<State> setField(const State& state, const Path& path, const Json& value);
/// { move: [paths], by }.
[[nodiscard]] Result<Executed> executeMoves(const State& state, const Json& command);

// commands_knots.cpp.
[[nodiscard]] Result<Executed> executeInsertKnot(const State& state, const Json& arguments);
/// The state after a knot has been moved while every local curve stays where it is.
[[nodiscard]] Result<State> withLocalsKept(const State& state, const Path& path,
                                           const Json& command);

// commands_poses.cpp.
[[nodiscard]] Result<Executed> executePose(const State& state, const Json& arguments);

}  // namespace knotwork::scene
