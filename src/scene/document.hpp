// Documents: read into states and written back.
#pragma once

#include "scene/scene.hpp"

namespace knotwork::scene {

/// The version of the document format that this program writes, and the newest that it reads.
constexpr int documentVersion = 1;
constexpr std::size_t maximumObjects = 1000;
constexpr std::size_t maximumEffects = 1000;

/// A whole document. VERSION for one of a future version; otherwise as validation refuses, with
/// paths such as `objects[0].knots[3]` or `effects[1].target`.
[[nodiscard]] Result<State> readDocument(const Json& document);
[[nodiscard]] Json writeDocument(const State& state);

// The parts, for commands that change one of them; paths are relative to the part.
[[nodiscard]] Result<std::shared_ptr<const Json>> readHeader(const Json& header);
/// `spec` must have its id.
[[nodiscard]] Result<std::shared_ptr<const Object>> readObject(const Json& spec);
/// The object with another specification, canonical but for points that were checked.
[[nodiscard]] Result<std::shared_ptr<const Object>> remakeObject(const Object& object, Json spec);
/// Among these objects must be the effect's target.
[[nodiscard]] Result<std::shared_ptr<const Effect>> readEffect(
    const Json& spec, std::span<const std::shared_ptr<const Object>> objects);
/// `c1`, `c2` …: the first that no object has. O(objects).
[[nodiscard]] std::string freshId(std::span<const std::shared_ptr<const Object>> objects);
/// OUT_OF_RANGE `id` where an object has it already.
[[nodiscard]] Result<Done> checkNewId(std::span<const std::shared_ptr<const Object>> objects,
                                      std::string_view id);

// How a document is taken apart, for readDocument() and findProblems().
/// The document as one of this version (migrations.hpp). WRONG_TYPE for what is no object and for a
/// missing version, VERSION for a future one.
[[nodiscard]] Result<Json> currentVersion(const Json& document);
[[nodiscard]] Json headerOf(const Json& document);
/// Null where it is left out; WRONG_TYPE and TOO_LARGE.
[[nodiscard]] Result<const Json*> listUnder(const Json& document, std::string_view key,
                                            std::size_t most);

}  // namespace knotwork::scene
