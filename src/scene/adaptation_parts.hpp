// What of an object follows when one of its fields changes, by type. For adaptation*.cpp.
//
// `before` is canonical; `after` is it with a change, not yet validated: whatever in it is not as it
// should be is left alone, for validation to name.
#pragma once

#include "scene/json.hpp"

#include <string_view>

namespace knotwork::scene {

[[nodiscard]] bool differs(const Json& before, const Json& after, std::string_view key);
/// Where one list has an element more than the other: the first place at which they differ.
[[nodiscard]] std::size_t changedIndex(const Json& shorter, const Json& longer);

/// Curves of every type, models and other nested ones included.
[[nodiscard]] Json adaptCurve(const Json& before, Json after);
[[nodiscard]] Json adaptBspline(const Json& before, Json after);
[[nodiscard]] Json adaptWeights(const Json& before, Json after);
[[nodiscard]] Json adaptBlending(const Json& before, Json after);

[[nodiscard]] Json adaptSurface(const Json& before, Json after);
[[nodiscard]] Json adaptBsplineSurface(const Json& before, Json after);
[[nodiscard]] Json adaptBlendingSurface(const Json& before, Json after);

[[nodiscard]] Json adaptSubdivisionSurface(const Json& before, Json after);
[[nodiscard]] Json adaptPointCloud(const Json& before, Json after);

/// The object as one of another type: with the same points, or made of what it was, as far as that
/// goes; with its id, style, show and parameter.
[[nodiscard]] Json ofType(const Json& before, std::string_view type);

}  // namespace knotwork::scene
