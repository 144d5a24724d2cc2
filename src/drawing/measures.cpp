#include "drawing/measures.hpp"

#include "drawing/palette.hpp"
#include "geometry/convex_hull.hpp"
#include "geometry/curve_sphere.hpp"
#include "geometry/differential.hpp"
#include "geometry/smooth_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace knotwork::drawing {

namespace {

constexpr std::size_t sizeSamples = 65;
constexpr std::size_t wantedTeeth = 240;
constexpr std::size_t mostTeethOfPiece = 24;
constexpr std::size_t mostTeeth = 4000;
constexpr double toothQuantile = 0.9;   // of the teeth, that stay below …
constexpr double toothShare = 0.125;    // … this part of the size
constexpr std::size_t frameCount = 16;
constexpr double frameShare = 1.0 / 14;
constexpr double hodographShare = 2e-4; // of its size: a fifth of a pixel in a pane of 1000
constexpr double arcShare = 2;          // half of the longest osculating arc
constexpr std::size_t mostChords = 720;

// --- the comb -----------------------------------------------------------------------------------

std::vector<Frame> combFrames(const Curve& curve) {
    const std::vector<Interval> pieces = smoothPieces(curve);
    const std::size_t each =
        std::clamp<std::size_t>(wantedTeeth / pieces.size(), 1, mostTeethOfPiece);
    const std::size_t step = pieces.size() / (mostTeeth / 2) + 1;
    std::vector<Frame> frames;
    for (std::size_t p = 0; p < pieces.size(); p += step) {
        for (std::size_t k = 0; k <= each; ++k) {
            const double t = uniformParameter(pieces[p], k, each + 1);
            frames.push_back(frameAt(curve, t, k == each ? Side::left : Side::right));
        }
    }
    return frames;
}

double combScaleOf(const std::vector<Frame>& frames, double size) {
    std::vector<double> bends;
    bends.reserve(frames.size());
    for (const Frame& frame : frames) bends.push_back(std::abs(frame.curvature));
    const auto place = static_cast<std::ptrdiff_t>(
        toothQuantile * static_cast<double>(bends.size() - 1));
    std::nth_element(bends.begin(), bends.begin() + place, bends.end());
    const double most = bends[static_cast<std::size_t>(place)];
    return most > 0 ? toothShare * size / most : 0;
}

Vec3 toothOf(const Frame& frame, double scale, double longest) noexcept {
    const double length = std::abs(scale * frame.curvature);
    return combPoint(frame, length > longest ? scale * longest / length : scale);
}

// --- the hodograph ------------------------------------------------------------------------------

/// Halves a piece of the derivative until its middle is as close to the chord as is wanted.
class DerivativeLine {
public:
    DerivativeLine(const Curve& curve, double tolerance) : curve_(curve), tolerance_(tolerance) {}

    [[nodiscard]] Vec3 at(double t, Side side) const noexcept {
        std::array<Vec3, 2> rows{};
        evaluate(curve_, t, side, rows);
        return rows[1];
    }
    /// Appends what follows the start of a piece.
    void extend(Shape& shape, const Interval& piece, const Vec3& from, const Vec3& to,
                int depth) const {
        const double middle = (piece.start + piece.end) / 2;
        const Vec3 there = at(middle, Side::right);
        const Vec3 quarter = at((piece.start + middle) / 2, Side::right);
        const bool close = glm::length(there - (from + to) * 0.5) <= tolerance_ &&
                           glm::length(quarter - (0.75 * from + 0.25 * to)) <= tolerance_;
        if (close || depth == 0) {
            append(shape, to);
            return;
        }
        extend(shape, {piece.start, middle}, from, there, depth - 1);
        extend(shape, {middle, piece.end}, there, to, depth - 1);
    }

private:
    const Curve& curve_;
    double tolerance_;
};

double largestDerivative(const DerivativeLine& line, const Interval& whole) noexcept {
    double largest = 0;
    for (std::size_t i = 0; i < sizeSamples; ++i) {
        const Vec3 d = line.at(uniformParameter(whole, i, sizeSamples),
                               i + 1 == sizeSamples ? Side::left : Side::right);
        largest = std::max(largest, glm::length(d));
    }
    return largest;
}

// --- circles ------------------------------------------------------------------------------------

struct Circle {
    Vec3 centre;
    Vec3 x;  ///< from the centre to where the angle is 0
    Vec3 y;  ///< to where it is a quarter turn
};

void appendArc(Shape& shape, const Circle& circle, const Interval& angles, double tolerance) {
    const double radius = glm::length(circle.x);
    const double cosine = std::max(1 - tolerance / radius, -1.0);
    const double chords = std::ceil(angles.length() / (2 * std::acos(cosine)));
    const auto count = static_cast<std::size_t>(
        std::clamp(chords, 24.0, static_cast<double>(mostChords)));
    for (std::size_t i = 0; i <= count; ++i) {
        const double a = uniformParameter(angles, i, count + 1);
        append(shape, circle.centre + std::cos(a) * circle.x + std::sin(a) * circle.y);
    }
}

void drawSphereShapes(Sketch& sketch, const Sphere& sphere, bool inPlane) {
    if (!(sphere.radius > 0)) return;
    constexpr Interval turn{0, 2 * std::numbers::pi};
    const std::array<Vec3, 3> axes{Vec3(sphere.radius, 0, 0), Vec3(0, sphere.radius, 0),
                                   Vec3(0, 0, sphere.radius)};
    for (std::size_t k = 0; k < (inPlane ? 1U : 3U); ++k) {
        Shape& shape = sketch.add(Role::sphere, Kind::polyline, 1.5F);
        shape.index = static_cast<int>(k);
        appendArc(shape, {sphere.center, axes[k], axes[(k + 1) % 3]}, turn, sketch.tolerance());
    }
    Shape& centre = sketch.add(Role::sphere, Kind::points, 6);
    append(centre, sphere.center);
}

}  // namespace

bool isFlat(std::span<const Vec3> points) noexcept {
    return std::all_of(points.begin(), points.end(), [](const Vec3& p) { return p.z == 0; });
}

double sizeOf(const Curve& curve) {
    std::vector<double> xyz(3 * sizeSamples);
    CurveSampler(curve).uniform(0, sizeSamples, sizeSamples, xyz);
    Bounds bounds;
    for (std::size_t i = 0; i < xyz.size(); i += 3) bounds.add({xyz[i], xyz[i + 1], xyz[i + 2]});
    return glm::length(bounds.max - bounds.min);
}

void drawComb(Sketch& sketch, const Curve& curve) {
    const std::vector<Frame> frames = combFrames(curve);
    const double size = sizeOf(curve);
    const double wanted = sketch.options().combScale;
    const double scale = wanted > 0 ? wanted : combScaleOf(frames, size);
    Shape& teeth = sketch.add(Role::comb, Kind::polyline, 1);
    for (const Frame& frame : frames) {
        appendSegment(teeth, frame.point, toothOf(frame, scale, size));
    }
    Shape& line = sketch.add(Role::comb, Kind::polyline, 1.5F);
    line.index = 1;
    for (const Frame& frame : frames) append(line, toothOf(frame, scale, size));
}

void drawHodograph(Sketch& sketch, const Curve& curve) {
    const Interval whole = domain(curve);
    const double size = sizeOf(curve);
    const double largest = largestDerivative({curve, 0}, whole);
    const double share = size > 0 ? std::min(1.0, sketch.tolerance() / size) : 1;
    const DerivativeLine line(curve, std::max(share, hodographShare) * largest);
    Shape& shape = sketch.add(Role::hodograph, Kind::polyline, 2, Pane::hodograph);
    for (const Interval& piece : smoothPieces(curve)) {
        const Vec3 from = line.at(piece.start, Side::right);
        const Vec3 to = line.at(piece.end, Side::left);
        append(shape, from);
        line.extend(shape, piece, from, to, 9);
    }
    Shape& arrow = sketch.add(Role::hodograph, Kind::polyline, 1.5F, Pane::hodograph);
    arrow.index = 1;
    const double t = sketch.parameterOn(curve);
    appendSegment(arrow, Vec3(0), line.at(t, t < whole.end ? Side::right : Side::left));
}

void drawOsculatingCircle(Sketch& sketch, const Curve& curve) {
    const double t = sketch.parameterOn(curve);
    const Frame frame = frameAt(curve, t, t < domain(curve).end ? Side::right : Side::left);
    const double size = sizeOf(curve);
    Shape& shape = sketch.add(Role::frame, Kind::polyline, 1.5F);
    shape.index = 3;
    const auto centre = centreOfCurvature(frame);
    const double radius = centre ? glm::length(*centre - frame.point) : 0;
    // Beyond this no eye tells an arc from its tangent, and the sum of centre and radius is noise.
    if (!centre || radius > 1e4 * size) {
        append(shape, frame.point - size * frame.tangent);
        append(shape, frame.point + size * frame.tangent);
        return;
    }
    const Vec3 out = frame.point - *centre;
    const Circle circle{*centre, out, radius * frame.tangent};
    const double half = std::min(std::numbers::pi, arcShare * size / std::max(radius, 1e-300));
    appendArc(shape, circle, {-half, half}, sketch.tolerance());
    if (half < std::numbers::pi) return;
    Shape& spoke = sketch.add(Role::frame, Kind::polyline, 1);
    spoke.index = 3;
    appendSegment(spoke, frame.point, *centre);
    Shape& point = sketch.add(Role::frame, Kind::points, 6);
    point.index = 3;
    append(point, *centre);
}

void drawFrames(Sketch& sketch, const Curve& curve) {
    const Interval whole = domain(curve);
    const double length = frameShare * sizeOf(curve);
    const std::size_t count = isClosed(curve) ? frameCount : frameCount + 1;
    std::vector<Frame> frames;
    for (std::size_t i = 0; i < count; ++i) {
        const double t = uniformParameter(whole, i, frameCount + 1);
        frames.push_back(frameAt(curve, t, t < whole.end ? Side::right : Side::left));
    }
    constexpr std::array<Vec3 Frame::*, 3> axes{&Frame::tangent, &Frame::normal, &Frame::binormal};
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension(curve)); ++k) {
        Shape& shape = sketch.add(Role::frame, Kind::polyline, 1.75F);
        shape.index = static_cast<int>(k);
        shape.colour = cycleColour(k == 0 ? 1 : k == 1 ? 2 : 0, sketch.options().dark);
        for (const Frame& frame : frames) {
            appendSegment(shape, frame.point, frame.point + length * (frame.*axes[k]));
        }
    }
}

void drawHull(Sketch& sketch, std::span<const Vec3> points) {
    if (points.empty()) return;
    Shape& shape = sketch.add(Role::hull, Kind::polyline, 1.25F);
    shape.dashed = true;
    if (isFlat(points)) {
        const std::vector<std::uint32_t> corners = planeHull(points);
        for (const std::uint32_t i : corners) append(shape, points[i]);
        if (corners.size() > 2) append(shape, points[corners.front()]);
        return;
    }
    for (const auto& edge : hullEdges(points)) {
        appendSegment(shape, points[edge[0]], points[edge[1]]);
    }
}

void drawSphere(Sketch& sketch, const Curve& curve) {
    drawSphereShapes(sketch, enclosingSphere(curve), dimension(curve) == 2);
}

void drawSphere(Sketch& sketch, std::span<const Vec3> points) {
    const auto sphere = enclosingSphere(points);
    if (sphere) drawSphereShapes(sketch, *sphere, isFlat(points));
}

void drawCurveMeasures(Sketch& sketch, const Curve& curve, std::span<const Vec3> control) {
    const scene::Show& show = sketch.show();
    if (show.hull) drawHull(sketch, control);
    if (show.comb) drawComb(sketch, curve);
    if (show.osculating) drawOsculatingCircle(sketch, curve);
    if (show.frames) drawFrames(sketch, curve);
    if (show.hodograph && sketch.options().panes.hodograph) drawHodograph(sketch, curve);
    if (show.curvature && sketch.options().panes.curvature) drawCurvature(sketch, curve);
}

}  // namespace knotwork::drawing
