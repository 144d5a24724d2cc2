#include "app/gizmo.hpp"

#include "app/hit.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace knotwork::app {

namespace {

/// CSS pixels from the handle. No two parts are nearer to each other than 22 where they are not
/// foreshortened; in a plane the ring lies inside, where it hides least.
struct Layout {
    double ring;
    double shaft;  ///< where an arrow begins
    double tip;
    double box;
};
constexpr Layout planeLayout{32, 40, 60, 84};
constexpr Layout spaceLayout{94, 15, 46, 70};

constexpr double leastSeen = 0.3;    // of an axis' length
constexpr double leastOpen = 0.25;   // of a ring: sine of the angle at which it is seen
constexpr std::size_t ringPoints = 97;
constexpr double headLength = 9;
constexpr double headWidth = 5.5;
constexpr double twoPi = 6.283185307179586;

const Layout& layoutOf(const Gizmo& gizmo) noexcept {
    return gizmo.inPlane ? planeLayout : spaceLayout;
}

double dot(const Pixel& a, const Pixel& b) noexcept { return a.x * b.x + a.y * b.y; }

/// What a unit vector of the world is on the screen, at most of length 1.
Pixel seenUnit(const Vec3& axis, const Sight& sight) noexcept {
    const Pixel v = sight.pixelVector(axis);
    const double unit = sight.unitsPerPixel();
    return {v.x * unit, v.y * unit};
}

/// At so many pixels along an axis, or nothing where it is foreshortened too much.
std::optional<Pixel> alongAxis(const Gizmo& gizmo, const Sight& sight, const Vec3& axis, int k,
                               double pixels) {
    if (gizmo.inPlane && k == 2) return std::nullopt;
    const Pixel direction = seenUnit(axis, sight);
    if (dot(direction, direction) < leastSeen * leastSeen) return std::nullopt;
    const Pixel at = sight.toPixels(gizmo.at);
    const auto inside = [&](double reach) {
        return gizmo.within.contains({at.x + reach * direction.x, at.y + reach * direction.y});
    };
    const double far = layoutOf(gizmo).box + 6;
    const double signedPixels = !inside(far) && inside(-far) ? -pixels : pixels;
    return Pixel{at.x + signedPixels * direction.x, at.y + signedPixels * direction.y};
}

/// Two unit vectors that span the plane across an axis.
std::array<Vec3, 2> across(const Gizmo& gizmo, int axis) noexcept {
    const auto k = static_cast<std::size_t>(axis);
    return {gizmo.axes[(k + 1) % 3], gizmo.axes[(k + 2) % 3]};
}

/// How near the pointer comes to a part, or nothing where that is left out.
std::optional<double> distanceTo(const Gizmo& gizmo, const Sight& sight, const GizmoPart& part,
                                 const Pixel& p) {
    if (part.kind == GizmoKind::turn) {
        const std::vector<Pixel> ring = ringOf(gizmo, sight, part.axis);
        std::optional<double> least;
        for (std::size_t i = 1; i < ring.size(); ++i) {
            const double away = distanceToSegment(p, ring[i - 1], ring[i]);
            if (!least || away < *least) least = away;
        }
        return least;
    }
    const bool moves = part.kind == GizmoKind::move;
    const auto end = moves ? arrowTip(gizmo, sight, part.axis) : boxPlace(gizmo, sight, part.axis);
    if (!end) return std::nullopt;
    const Pixel at = sight.toPixels(gizmo.at);
    const double from = moves ? layoutOf(gizmo).shaft / layoutOf(gizmo).tip : 1;
    const Pixel start{at.x + from * (end->x - at.x), at.y + from * (end->y - at.y)};
    return distanceToSegment(p, start, *end);
}

Shape shapeOf(drawing::Kind kind, const scene::Colour& colour, float width) {
    Shape shape;
    shape.object = -1;
    shape.role = drawing::Role::handle;
    shape.kind = kind;
    shape.colour = colour;
    shape.width = width;
    return shape;
}

class GizmoWriter {
public:
    GizmoWriter(const Gizmo& gizmo, const Sight& sight, const std::optional<GizmoPart>& part,
                bool dark)
        : gizmo_(gizmo), sight_(sight), part_(part), dark_(dark) {}

    void write() {
        for (int axis = 0; axis < 3; ++axis) ring(axis);
        for (int axis = 0; axis < 3; ++axis) arrow(axis);
        for (int axis = 0; axis < 3; ++axis) box(axis);
    }
    std::vector<Shape> shapes;

private:
    Shape& add(drawing::Kind kind, const GizmoPart& part, float width) {
        const bool meant = part_ == part;
        Shape shape = shapeOf(kind, axisColour(part.axis, dark_), meant ? width + 1.5F : width);
        if (part_ && !meant) shape.colour.alpha *= 0.55;
        return shapes.emplace_back(std::move(shape));
    }

    void append(Shape& shape, const Pixel& p) const {
        const Vec3 world = sight_.fromPixels(p, gizmo_.at);
        shape.positions.insert(shape.positions.end(), {world.x, world.y, world.z});
    }

    void ring(int axis) {
        const std::vector<Pixel> points = ringOf(gizmo_, sight_, axis);
        if (points.empty()) return;
        Shape& shape = add(drawing::Kind::polyline, {GizmoKind::turn, axis}, 2);
        for (const Pixel& p : points) append(shape, p);
    }

    void arrow(int axis) {
        const auto tip = arrowTip(gizmo_, sight_, axis);
        if (!tip) return;
        const Pixel at = sight_.toPixels(gizmo_.at);
        const double length = std::hypot(tip->x - at.x, tip->y - at.y);
        const Pixel along{(tip->x - at.x) / length, (tip->y - at.y) / length};
        const double start = length * layoutOf(gizmo_).shaft / layoutOf(gizmo_).tip;
        Shape& shaft = add(drawing::Kind::polyline, {GizmoKind::move, axis}, 2.5F);
        append(shaft, {at.x + start * along.x, at.y + start * along.y});
        append(shaft, *tip);
        Shape& head = add(drawing::Kind::polyline, {GizmoKind::move, axis}, 2.5F);
        for (const double side : {1.0, 0.0, -1.0}) {
            const double back = side == 0 ? 0 : headLength;
            append(head, {tip->x - back * along.x - side * headWidth * along.y,
                          tip->y - back * along.y + side * headWidth * along.x});
        }
    }

    void box(int axis) {
        const auto place = boxPlace(gizmo_, sight_, axis);
        if (!place) return;
        Shape& shape = add(drawing::Kind::points, {GizmoKind::scale, axis}, 9);
        shape.square = true;
        append(shape, *place);
    }

    const Gizmo& gizmo_;
    const Sight& sight_;
    const std::optional<GizmoPart>& part_;
    bool dark_;
};

}  // namespace

int facingAxis(const Gizmo& gizmo, const Sight& sight) noexcept {
    int best = 2;
    for (int k = 0; k < 2; ++k) {
        const auto towards = [&](int axis) {
            return std::abs(glm::dot(gizmo.axes[static_cast<std::size_t>(axis)], sight.towardsEye()));
        };
        if (towards(k) > towards(best) + 1e-9) best = k;
    }
    return best;
}

std::optional<Gizmo> gizmoOf(const scene::State& state, const Target& target,
                             const Affine& placement, bool inPlane, const Box& within) {
    if (target.kind != TargetKind::pose || target.object < 0 ||
        static_cast<std::size_t>(target.object) >= state.objects.size()) {
        return std::nullopt;
    }
    const auto local =
        posedLocal(state.objects[static_cast<std::size_t>(target.object)]->body, target.index);
    if (!local) return std::nullopt;
    const Mat3 turned = rotation(local->pose.axis, local->pose.angle);
    Gizmo gizmo{target.at, {}, {}, inPlane, within};
    for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(k);
        gizmo.axes[i] = glm::normalize(placement.linear[k]);
        gizmo.own[i] = glm::normalize(placement.vector(turned[k]));
    }
    return gizmo;
}

std::optional<Pixel> arrowTip(const Gizmo& gizmo, const Sight& sight, int axis) {
    return alongAxis(gizmo, sight, gizmo.axes[static_cast<std::size_t>(axis)], axis,
                     layoutOf(gizmo).tip);
}

std::optional<Pixel> boxPlace(const Gizmo& gizmo, const Sight& sight, int axis) {
    return alongAxis(gizmo, sight, gizmo.own[static_cast<std::size_t>(axis)], axis,
                     layoutOf(gizmo).box);
}

std::vector<Pixel> ringOf(const Gizmo& gizmo, const Sight& sight, int axis) {
    const Vec3& normal = gizmo.axes[static_cast<std::size_t>(axis)];
    const Vec3 eye = sight.towardsEye();
    const double open = glm::dot(normal, eye);
    if ((gizmo.inPlane && axis != 2) || std::abs(open) < leastOpen) return {};
    const auto [first, second] = across(gizmo, axis);
    // The front half begins where the ring is as deep as its centre; one that is seen from nearly
    // straight above is shown whole.
    const bool whole = std::abs(open) > 0.98;
    const double toFront = std::atan2(glm::dot(second, eye), glm::dot(first, eye));
    const double span = whole ? twoPi : twoPi / 2;
    const double radius = layoutOf(gizmo).ring * sight.unitsPerPixel();
    std::vector<Pixel> points;
    for (std::size_t i = 0; i < ringPoints; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(ringPoints - 1) - 0.5;
        const double angle = toFront + span * share;
        points.push_back(sight.toPixels(
            gizmo.at + radius * (std::cos(angle) * first + std::sin(angle) * second)));
    }
    return points;
}

std::optional<GizmoPart> partAt(const Gizmo& gizmo, const Sight& sight, const Pixel& p,
                                double radius) {
    std::optional<GizmoPart> best;
    double least = radius;
    for (const GizmoKind kind : {GizmoKind::turn, GizmoKind::move, GizmoKind::scale}) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto away = distanceTo(gizmo, sight, {kind, axis}, p);
            if (!away || *away > least) continue;
            least = *away;
            best = GizmoPart{kind, axis};
        }
    }
    return best;
}

double angleOnRing(const Gizmo& gizmo, const Sight& sight, int axis, const Pixel& p) noexcept {
    const Vec3& normal = gizmo.axes[static_cast<std::size_t>(axis)];
    const Vec3 eye = sight.towardsEye();
    const Vec3 from = sight.fromPixels(p, gizmo.at) - gizmo.at;
    const Vec3 there = from - eye * (glm::dot(from, normal) / glm::dot(eye, normal));
    const auto [first, second] = across(gizmo, axis);
    return std::atan2(glm::dot(there, second), glm::dot(there, first));
}

std::vector<Shape> gizmoShapes(const Gizmo& gizmo, const Sight& sight,
                               const std::optional<GizmoPart>& part, bool dark) {
    GizmoWriter writer(gizmo, sight, part, dark);
    writer.write();
    return std::move(writer.shapes);
}

// Vermilion, bluish green and blue of the palette by Okabe and Ito (2008), which all eyes tell apart.
scene::Colour axisColour(int axis, bool dark) noexcept {
    constexpr std::array<scene::Colour, 3> light{scene::Colour{0.80, 0.33, 0.0, 1},
                                                 scene::Colour{0.0, 0.54, 0.40, 1},
                                                 scene::Colour{0.0, 0.42, 0.70, 1}};
    constexpr std::array<scene::Colour, 3> bright{scene::Colour{0.95, 0.52, 0.20, 1},
                                                  scene::Colour{0.15, 0.75, 0.57, 1},
                                                  scene::Colour{0.40, 0.74, 0.95, 1}};
    return dark ? bright[static_cast<std::size_t>(axis)] : light[static_cast<std::size_t>(axis)];
}

}  // namespace knotwork::app
