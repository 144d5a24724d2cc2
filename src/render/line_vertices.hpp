// Polylines as the line program reads them: projected, thinned, clipped, with their arc length.
//
// The program draws one capsule for each window of four records (before, start, end, after) and
// lets every pixel belong to the nearest of neighbouring capsules, so that a join is covered once.
// Two negative values of `arc` steer it: `noNeighbour` (a cap follows) and `neighbourOnly` (the
// position is known but no segment leads there).
#pragma once

#include "drawing/colour_bytes.hpp"
#include "render/projection.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace knotwork::render {

using drawing::ColourBytes;

constexpr float noNeighbour = -1;
constexpr float neighbourOnly = -2;

struct LineVertex {
    float x = 0;  ///< device pixels from the middle of the pane
    float y = 0;
    float z = 0;  ///< depth in [-1, 1]
    float arc = 0;     ///< device pixels along the line modulo the dash period, or a marker
    float width = 1;   ///< device pixels
    float period = 0;  ///< of the dashes in device pixels, 0 for a solid line
    ColourBytes colour{};
    float unused = 0;  // two texels a record
};
static_assert(sizeof(LineVertex) == 32);

/// Lengths in device pixels.
struct LineStyle {
    double width = 1;
    double period = 0;
    ColourBytes colour{};
    double nearer = 0;   ///< depth by which it is set before where it is
    bool crisp = false;  ///< of segments: upright and level ones are moved to whole pixels
};

/// Period of the dashes of a line: about four widths, and never so short that thin lines dot.
[[nodiscard]] double dashPeriod(double width, double pixelRatio) noexcept;

class LineVertices {
public:
    void clear() noexcept { records_.clear(); }
    [[nodiscard]] bool empty() const noexcept { return records_.empty(); }
    [[nodiscard]] const std::vector<LineVertex>& records() const noexcept { return records_; }

    /// A polyline through x,y,z triples. Closed when its last point equals its first: then there is
    /// a join, not two caps, and a whole number of dashes. A point without an image breaks it.
    void polyline(const Projection& projection, std::span<const double> positions,
                  const LineStyle& style);
    /// Segments of two points each.
    void segments(const Projection& projection, std::span<const double> positions,
                  const LineStyle& style);

private:
    struct Point {
        Vec3 at;
        double arc = 0;
    };
    void stroke(const Rect& pane, const LineStyle& style);
    void collect(const Vec3& at);
    void run(const Rect& pane, const LineStyle& style, bool closed);
    void begin(const Point& start, const Point* before, const LineStyle& style);
    void end(const Point& last, const Point* after, const LineStyle& style);
    void emit(const Vec3& at, double arc, const LineStyle& style);

    std::vector<LineVertex> records_;
    std::vector<Point> points_;  ///< of the polyline at hand
    double turnOver_ = 0;        ///< arc length that is subtracted since the current run began
};

}  // namespace knotwork::render
