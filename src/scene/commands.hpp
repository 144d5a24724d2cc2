// Commands: the one kind of thing that changes a scene. A command makes a new state from an old
// one; the scene keeps the history.
#pragma once

#include "scene/scene.hpp"

namespace knotwork::scene {

struct Executed {
    State state;
    Change change;
};

constexpr std::size_t maximumCommands = 1000;

/// One of these, with `gesture` and `selection` for the scene:
///
/// { set: path, value }        replaces a field; what depends on it follows (adaptation.hpp). The
///                             whole of an object keeps the id, style and show that are not given.
/// { move: path, to | by }     a point, a knot or a number. A knot goes onto another one within
///                             `snap`; of a blending curve it leaves its local curves where they are
///                             with `recut: false`. An object or effect goes `to` a place in its list.
/// { move: [paths], by }       several places of objects by the same amount.
/// { insert: path, value }     an element before the one at the path, or after the last.
/// { remove: path }            takes one out; an object takes its effects with it.
/// { add: object }             appends an object.
/// { pose: { object, local | locals, translate?, rotate?, scale? } }
///                             places local curves, or patches [i, j]; what is left out keeps its
///                             value. { …, by: { translate?, rotate?, scale?, about? } } instead
///                             moves, turns and scales them farther, each about its own pivot or all
///                             about one point.
/// { insertKnot: { object, at } }
///                             refines a B-spline curve without moving it, or cuts one more local
///                             curve from the model of a blending curve.
/// { all: [commands] }         one after the other, as one step: all of them or none.
///
/// The error's path is that of the place in the document or of the command's own field; within a
/// list after `all[i]`.
[[nodiscard]] Result<Executed> executeCommand(const State& state, const Json& command);

}  // namespace knotwork::scene
