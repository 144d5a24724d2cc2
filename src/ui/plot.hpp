// A plot: a box of a view with axes, in whose plane the shapes of one pane are painted.
//
// What a plot adds to the drawing (grid, axes, cursor) lies in the same plane, so that one renderer
// paints everything; words are labels, which the page writes over the picture.
#pragma once

#include "drawing/drawing.hpp"
#include "drawing/ticks.hpp"
#include "ui/plane_map.hpp"
#include "ui/theme.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace knotwork::ui {

using drawing::Colour;
using drawing::Pane;
using drawing::Shape;
using drawing::Tick;
using drawing::niceStep;
using drawing::niceTicks;
using drawing::numberText;
using drawing::ticksEvery;

enum class Align { left, centre, right };
enum class Baseline { top, middle, bottom };

struct Label {
    std::string text;
    Pixel at;
    Align align = Align::left;
    Baseline baseline = Baseline::middle;
    double size = 11;  ///< CSS pixels
    bool strong = false;
    Colour colour;
    bool number = false;  ///< holds numbers, whose decimal point is the language's
    bool halo = false;    ///< stands over the picture, parted from it by a rim of the background
};

/// About where its text will stand; the page knows its font, we only know its size.
[[nodiscard]] Box boxOf(const Label& label) noexcept;

/// Straight pieces in a plot's plane, two points each.
struct Lines {
    std::vector<double> segments;  ///< x,y,z triples
    Colour colour;
    double width = 1;  ///< CSS pixels
    bool dashed = false;

    void add(const Vec3& from, const Vec3& to);
};

struct Plot {
    Pane pane = Pane::curve;
    int index = -1;  ///< only the shapes with this index, or all of the pane
    int object = -1; ///< only the shapes of this object, or all of them
    std::vector<int> besides{};  ///< objects that are compared with it
    Box box;         ///< what is painted, labels included
    Box area;        ///< where the axes' intervals lie
    PlaneMap map;
    bool joinsBelow = false;  ///< shares its axis with the plot straight below it
    bool joinsAbove = false;
    std::vector<Lines> under;  ///< painted before the shapes
    std::vector<Lines> over;   ///< and after them
    std::vector<Label> labels;

    [[nodiscard]] bool shows(const Shape& shape) const noexcept {
        return shape.pane == pane && (index < 0 || shape.index == index) &&
               (object < 0 || shape.object == object ||
                std::find(besides.begin(), besides.end(), shape.object) != besides.end());
    }
};

/// Smallest and largest x or y of some shapes; nothing: [0, 1]; a single value: one about it.
[[nodiscard]] Interval extentX(const std::vector<const Shape*>& shapes) noexcept;
[[nodiscard]] Interval extentY(const std::vector<const Shape*>& shapes) noexcept;

/// Lines across the area, from edge to edge.
void addVertical(Lines& lines, const Plot& plot, double x);
void addHorizontal(Lines& lines, const Plot& plot, double y);
/// A vertical that runs on into the plots with which this one shares its axis.
void addThrough(Lines& lines, const Plot& plot, double x);

/// Grid lines across the area at the ticks of an axis, and their names beside it.
void addGridX(Plot& plot, const std::vector<Tick>& ticks, const Theme& colours);
void addGridY(Plot& plot, const std::vector<Tick>& ticks, const Theme& colours);
void nameTicksX(Plot& plot, const std::vector<Tick>& ticks, const Theme& colours);
void nameTicksY(Plot& plot, const std::vector<Tick>& ticks, const Theme& colours);

/// How many ticks fit a length of so many pixels without crowding.
[[nodiscard]] int ticksAcross(double width) noexcept;
[[nodiscard]] int ticksUp(double height) noexcept;

/// The width of a cell of the grid of a plane that is seen at so many CSS pixels a unit.
[[nodiscard]] double planeGridStep(double pixelsPerUnit) noexcept;
/// The plane of a curve: a square grid whose step follows the zoom, the axes a little stronger.
void addPlaneGrid(Plot& plot, const Theme& colours);
/// The same with the names of its lines below and beside it.
void addPlaneAxes(Plot& plot, const Theme& colours);

}  // namespace knotwork::ui
