// What names a local curve or patch keeps naming the same one when others come and go.
#pragma once

#include "scene/json.hpp"

#include <optional>

namespace knotwork::scene {

/// The `local` of a pose or an effect, j of a blending curve or [i, j] of a blending surface, as it is
/// called in `after`, which `before` has become: one more or one less in a list of local curves, or
/// in a list of knots, moves those behind it. Nothing where it is gone, or where the
/// types differ. `before` is canonical, `after` has at least as many locals as it says.
[[nodiscard]] std::optional<Json> followedLocal(const Json& before, const Json& after,
                                                const Json& local);

/// The specification of an effect on an object that has become `after`: nothing where its local curve
/// or patch is gone, or where objects of the new type have nothing that it could move.
[[nodiscard]] std::optional<Json> followedEffect(const Json& before, const Json& after,
                                                 const Json& effect);

}  // namespace knotwork::scene
