// A figure: the panes of a view at a moment, with all that is painted in them and written over them.
//
// It is made anew for every picture from a drawing (which is cached), a camera and what people point
// at; no GL is needed for that, so all of it can be tested.
#pragma once

#include "app/camera.hpp"
#include "app/gizmo.hpp"
#include "app/target.hpp"
#include "ui/knot_line.hpp"
#include "ui/layout.hpp"
#include "ui/plot.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace knotwork::app {

/// What stands out, everywhere at once: the same point, its basis function and its part of the
/// curve.
struct Emphasis {
    std::optional<Target> hovered;
    std::optional<Target> selected;
    /// Of a group: all that is selected besides.
    std::vector<Target> others;
    /// Whether it is one of several that are selected.
    [[nodiscard]] bool groups(const Target& target) const noexcept;
    /// A basis function that is pointed at: object and index.
    int basisObject = -1;
    int basisIndex = -1;
    /// A parameter that is pointed at in a plot, and the pane (basis and knots are one).
    std::optional<double> parameter;
    Pane parameterPane = Pane::basis;
    /// While an animation plays and nobody points at it, handles are left out of the picture.
    bool quiet = false;
    /// Of the tool at the selected handle: what is pointed at or held.
    std::optional<GizmoPart> part;
};

struct Mark {
    std::size_t index = 0;
    double strength = 1;
};

/// A shape with what emphasis adds to it.
struct Painted {
    const Shape* shape = nullptr;
    double opacity = 1;
    double extraWidth = 0;
    std::vector<Mark> marks;  ///< elements of a list of points that stand out
};

struct PaneFigure {
    ui::Plot plot;
    Sight sight;         ///< of the plot's plane, or of the world
    /// Of a pane in space: how far in front of the middle or behind it things may stand, in units;
    /// of a plane 0.
    double reach = 0;
    Vec3 middle{0.0};    ///< of what is seen
    std::vector<Painted> shapes;
    std::vector<Shape> below;  ///< halos, painted before the shapes
    std::vector<Shape> above;  ///< the point at the parameter, painted after them
    std::vector<Shape> tools;  ///< the gizmo, painted over everything
};

struct Figure {
    std::vector<PaneFigure> panes;
    ui::ParameterAxis axis;  ///< of basis and knots

    [[nodiscard]] const PaneFigure* paneAt(const Pixel& p) const noexcept;
    [[nodiscard]] const PaneFigure* find(Pane pane) const noexcept;
};

/// What a picture says in words, in the reader's language.
struct Words {
    std::string order = "order {0} at 0, {1} at 1";
    std::string decimalPoint = ".";
};

/// Numbers beside what is dragged.
struct Reading {
    Vec3 at{0.0};
    std::string text;
    Pane pane = Pane::curve;
};

struct FigureRequest {
    const drawing::Drawing* drawing = nullptr;
    const scene::State* state = nullptr;
    scene::Moment moment;
    Box box;                 ///< of the whole view that the figure may fill
    int object = -1;         ///< whose functions are plotted, or the first that has some
    double curveAspect = 1;  ///< width of what the camera fits over its height
    bool spatial = false;    ///< the curve's pane shows a world in space
    ui::ThemeName theme = ui::ThemeName::light;
    std::string orderWords = Words{}.order;
    Emphasis emphasis;
    /// During the drag of a knot the axis must stay, or the knot would run away from the pointer.
    std::optional<Interval> frozenRange;
    std::optional<Gizmo> gizmo;  ///< at the selected handle
    std::optional<Reading> reading;
    const std::vector<Shape>* ghost = nullptr;  ///< what is dragged as it was before
    ui::Shares shares;  ///< of panes whose seams were moved
    const std::vector<Shape>* values = nullptr;  ///< handles of values, and what makes them plain
    std::optional<Box> band;  ///< that a pointer draws round what it selects
};

/// The panes that the document asks for, and the one of the curve, which stands where there is no
/// other.
[[nodiscard]] drawing::Panes panesAsked(const scene::State& state) noexcept;
/// Where the panes lie that the document asks for and some object has.
[[nodiscard]] ui::FigureLayout layoutOf(const FigureRequest& request);
[[nodiscard]] Figure composeFigure(const FigureRequest& request, const ui::FigureLayout& layout,
                                   const Camera& camera);

}  // namespace knotwork::app
