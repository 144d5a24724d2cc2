// What of a document can be taken hold of in a view: an element of one of its lists, or a value that
// has a handle of its own.
#pragma once

#include "drawing/drawing.hpp"
#include "scene/scene.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace knotwork::app {

using drawing::Pane;
using drawing::Shape;

/// `line` is the point or the direction of an object's line. A parameter is one of a B-function, an
/// effect's value says how far that goes; both are values and no elements of lists.
enum class TargetKind { point, knot, pose, line, parameter, effect };

[[nodiscard]] constexpr bool isValue(TargetKind kind) noexcept {
    return kind == TargetKind::parameter || kind == TargetKind::effect;
}

struct Target {
    int object = 0;
    Pane pane = Pane::curve;
    TargetKind kind = TargetKind::point;
    std::string list;  ///< `objects[0].points`; of a value where it stands
    std::size_t index = 0;
    Vec3 at{0.0};      ///< where it stood in its pane's plane when it was found

    [[nodiscard]] std::string path() const {
        return isValue(kind) ? list : indexed(list, index);
    }
    [[nodiscard]] bool same(const Target& other) const noexcept {
        return index == other.index && list == other.list;
    }
};

/// A local curve or patch that a handle stands for.
struct PosedLocal {
    scene::Json name;  ///< as poses name it: j, or [i, j]
    Pose pose;
    Vec3 origin{0.0};  ///< its pivot before it is posed, in the object's coordinates
};
/// That of the k-th handle of an object, or nothing where there is none.
[[nodiscard]] std::optional<PosedLocal> posedLocal(const scene::Body& body, std::size_t k);

/// The pose command that puts it so.
[[nodiscard]] scene::Json poseCommand(const std::string& object, const scene::Json& local,
                                      const Pose& pose);

/// By the last name of the list, whose rows count as it does, or by where a value stands; nothing for
/// what cannot be dragged.
[[nodiscard]] std::optional<TargetKind> kindOfList(std::string_view list) noexcept;
[[nodiscard]] std::string_view kindName(TargetKind kind) noexcept;

/// Whether the elements of this shape can be taken hold of.
[[nodiscard]] bool offers(const Shape& shape) noexcept;
[[nodiscard]] Vec3 positionOf(const Shape& shape, std::size_t k) noexcept;

/// The target of this path in a drawing, or nothing where the drawing does not show it.
[[nodiscard]] std::optional<Target> findTarget(const drawing::Drawing& drawing,
                                               std::string_view path);
/// Whether its elements are of the target's kind and object, and in its pane.
[[nodiscard]] bool siblings(const Shape& shape, const Target& target) noexcept;
/// The paths of all targets of the same kind and object that the drawing shows, a net's row after
/// row.
[[nodiscard]] std::vector<std::string> siblingsOf(const drawing::Drawing& drawing,
                                                  const Target& target);

/// The value at a path such as `objects[0].points[2]` or `effects[1].angle`, or null.
[[nodiscard]] const scene::Json* valueAt(const scene::State& state, std::string_view path);

}  // namespace knotwork::app
