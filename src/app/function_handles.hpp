// Handles on the graphs of B-functions: points of a graph that are dragged to set a parameter.
//
// A handle stands at a fixed t and goes up and down, or at a fixed value and goes to and fro; the
// parameter becomes the one whose graph passes through it. What the handles are: the number of an
// order, p, q, m and c; for an expo-rational B-function its λ (which is where it stands) and β; the
// values of a table; the weight of a mixture.
#pragma once

#include "app/drag_moves.hpp"
#include "drawing/drawing.hpp"
#include "scene/scene.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace knotwork::app {

struct FunctionHandle {
    enum class Way { upAndDown, toAndFro, along };
    std::string path;   ///< `objects[0].bFunction.beta`
    std::string label;  ///< "β"
    int object = 0;
    drawing::Pane pane = drawing::Pane::bFunction;
    Way way = Way::upAndDown;  ///< along: the parameter is the t at which it stands
    Vec3 at{0.0};              ///< t and B(t), in the plane of its pane
    Vec3 origin{0.0};          ///< where that plane has (0, 0)
    double unit = 1;           ///< and how long its side is
    bool integer = false;
    double value = 0;
};

/// Of all objects that show a graph.
[[nodiscard]] std::vector<FunctionHandle> functionHandles(const scene::State& state);

/// The parameter that brings the handle to this place of its plane, or as near as there is one, with
/// three digits; `onGrid` makes a λ a multiple of 1/20. Cost: about a dozen B-functions made.
[[nodiscard]] double parameterFor(const scene::State& state, const FunctionHandle& handle,
                                  const Vec3& to, bool onGrid);

/// The command that sets it.
[[nodiscard]] scene::Json setCommand(const std::string& path, scene::Json value);

}  // namespace knotwork::app
