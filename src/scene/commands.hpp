// Commands: the one kind of thing that changes a scene. A command makes a new state from an old
// one; the scene keeps the history.
#pragma once

#include "scene/scene.hpp"

namespace knotwork::scene {

struct Executed {
    State state;
    Change change;
};

/// { set: path, value } replaces a field, { move: path, to | by } a point or a knot (or a number),
/// { insert: path, value } puts an element before the one at the path (or after the last),
/// { remove: path } takes one out, { add: object } appends an object, { pose: { object, local,
/// translate?, rotate?, scale? } } places a local curve (what is left out keeps its value), and
/// { insertKnot: { object, at } } refines a B-spline curve without moving it, or cuts one more
/// local curve from the model of a blending curve.
///
/// The error's path is that of the place in the document or of the command's own field.
[[nodiscard]] Result<Executed> executeCommand(const State& state, const Json& command);

}  // namespace knotwork::scene
