#include "drawing/drawing.hpp"

#include "drawing/palette.hpp"
#include "drawing/plots.hpp"
#include "geometry/tessellation.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace knotwork::drawing {

namespace {

constexpr std::array roleNames{
    std::string_view("curve"), std::string_view("surface"), std::string_view("wireframe"),
    std::string_view("polygon"), std::string_view("points"), std::string_view("knots"),
    std::string_view("local"), std::string_view("handle"), std::string_view("basis"),
    std::string_view("bFunction"), std::string_view("comb"), std::string_view("hodograph"),
    std::string_view("hull"), std::string_view("frame"), std::string_view("sphere"),
    std::string_view("residual"), std::string_view("isoline"), std::string_view("trace"),
    std::string_view("label")};
static_assert(roleNames.size() == static_cast<std::size_t>(Role::label) + 1);

void append(Shape& shape, const Vec3& p) {
    shape.positions.insert(shape.positions.end(), {p.x, p.y, p.z});
}

/// Draws one object of a scene as it stands at a moment.
class ObjectPainter {
public:
    ObjectPainter(const scene::Placed& placed, int object, const Options& options, Drawing& into)
        : placed_(placed), object_(object), options_(options), drawing_(into) {}

    void paint() {
        if (placed_.body.curve() != nullptr) paintCurve(*placed_.body.curve());
    }

private:
    void paintCurve(const Curve& itself) {
        const scene::Show& show = placed_.object->show;
        const auto* spline = placed_.body.as<BsplineCurve>();
        const auto* blend = placed_.body.as<BlendingCurve>();
        if (blend != nullptr && show.locals) locals(*blend);
        const ControlPolygon control = controlPolygon(itself);
        if (!control.points.empty() && show.polygon) polygon(control);
        if (show.curve) curve();
        if (show.knots && spline != nullptr) knotsOnCurve(spline->knotVector().knots());
        if (show.knots && blend != nullptr) knotsOnCurve(blend->knots());
        if (!control.points.empty() && show.points) controlPoints(control);
        if (blend != nullptr && show.handles) handles(*blend);
        plots(spline, blend);
    }

    Shape& add(Role role, Kind kind) {
        Shape shape;
        shape.object = object_;
        shape.role = role;
        shape.kind = kind;
        shape.colour = roleColour(role, options_.dark);
        drawing_.shapes.push_back(std::move(shape));
        return drawing_.shapes.back();
    }

    void place(Shape& shape, const Vec3& p) {
        const Vec3 placed = placed_.placement.point(p);
        append(shape, placed);
        drawing_.bounds.add(placed);
    }

    /// A part of a curve that is first placed on its own.
    void placeCurve(Shape& shape, const Curve& curve, const Interval& part, const Affine& first) {
        const std::vector<double> xyz = polyline(curve, part, options_.tolerance).xyz;
        shape.positions.reserve(xyz.size());
        for (std::size_t i = 0; i < xyz.size(); i += 3) {
            place(shape, first.point({xyz[i], xyz[i + 1], xyz[i + 2]}));
        }
        shape.source = std::make_shared<const CurvePart>(
            CurvePart{curve, part, compose(placed_.placement, first)});
    }

    void curve() {
        Shape& shape = add(Role::curve, Kind::polyline);
        shape.colour = onBackground(placed_.colour, options_.dark);
        shape.width = static_cast<float>(placed_.object->style.width);
        placeCurve(shape, *placed_.body.curve(), domain(*placed_.body.curve()), {});
    }

    void polygon(const ControlPolygon& control) {
        Shape& shape = add(Role::polygon, Kind::polyline);
        shape.width = 1.5F;
        for (const Vec3& p : control.points) place(shape, p);
        if (control.closed) place(shape, control.points.front());
    }

    void controlPoints(const ControlPolygon& control) {
        Shape& shape = add(Role::points, Kind::points);
        shape.width = 11;
        shape.path = indexed("objects", static_cast<std::size_t>(object_)) + ".points";
        for (const Vec3& p : control.points) place(shape, p);
    }

    /// Every knot of the domain once, where the curve passes it.
    void knotsOnCurve(std::span<const double> knots) {
        Shape& shape = add(Role::knots, Kind::points);
        shape.width = 6;
        const Interval whole = domain(*placed_.body.curve());
        for (std::size_t i = 0; i < knots.size(); ++i) {
            const bool repeated = i > 0 && knots[i] == knots[i - 1];
            if (repeated || !whole.contains(knots[i])) continue;
            place(shape, pointAt(*placed_.body.curve(), knots[i]));
        }
    }

    void handles(const BlendingCurve& blend) {
        Shape& shape = add(Role::handle, Kind::points);
        shape.width = 10;
        shape.square = true;
        shape.path = indexed("objects", static_cast<std::size_t>(object_)) + ".poses";
        for (const LocalCurve& local : blend.locals()) {
            place(shape, local.placement().point(local.origin()));
        }
    }

    /// A local curve over part of its support.
    void localPart(const LocalCurve& local, std::size_t j, const Interval& part, bool dashed) {
        if (!(part.length() > 0)) return;
        Shape& shape = add(Role::local, Kind::polyline);
        shape.width = 1.5F;
        shape.dashed = dashed;
        shape.index = static_cast<int>(j);
        const Interval own{local.rate() * part.start + local.shift(),
                           local.rate() * part.end + local.shift()};
        placeCurve(shape, local.source(), own, local.placement());
    }

    /// Solid where the local curve has the greater weight, dashed where its neighbour has it.
    void locals(const BlendingCurve& blend) {
        for (std::size_t j = 0; j < blend.locals().size(); ++j) {
            const Interval support = blend.support(j);
            const double centre = blend.knots()[j];
            const Interval strong{(support.start + centre) / 2, (centre + support.end) / 2};
            const LocalCurve& local = blend.locals()[j];
            localPart(local, j, {support.start, strong.start}, true);
            localPart(local, j, strong, false);
            localPart(local, j, {strong.end, support.end}, true);
        }
    }

    void plots(const BsplineCurve* spline, const BlendingCurve* blend) {
        if (spline == nullptr && blend == nullptr) return;
        const bool dark = options_.dark;
        const scene::Show& show = placed_.object->show;
        if (show.basis) take(basisPlot(*placed_.body.curve(), object_, dark));
        const std::string path = indexed("objects", static_cast<std::size_t>(object_)) + ".knots";
        const std::span<const double> knots =
            spline != nullptr ? spline->knotVector().knots() : std::span<const double>(blend->knots());
        if (show.knots || show.basis) drawing_.shapes.push_back(knotLine(knots, object_, path, dark));
        if (blend != nullptr && show.bFunction) take(bFunctionPlot(blend->blend(), object_, dark));
    }

    void take(std::vector<Shape> shapes) {
        std::move(shapes.begin(), shapes.end(), std::back_inserter(drawing_.shapes));
    }

    const scene::Placed& placed_;
    int object_;
    const Options& options_;
    Drawing& drawing_;
};

}  // namespace

std::string_view roleName(Role role) noexcept { return roleNames[static_cast<std::size_t>(role)]; }

std::string_view kindName(Kind kind) noexcept {
    constexpr std::array names{std::string_view("polyline"), std::string_view("points"),
                               std::string_view("triangles"), std::string_view("label")};
    return names[static_cast<std::size_t>(kind)];
}

std::string_view paneName(Pane pane) noexcept {
    constexpr std::array names{std::string_view("curve"), std::string_view("basis"),
                               std::string_view("knots"), std::string_view("bFunction")};
    return names[static_cast<std::size_t>(pane)];
}

void Bounds::add(const Vec3& p) noexcept {
    min = empty ? p : Vec3(std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z));
    max = empty ? p : Vec3(std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z));
    empty = false;
}

ControlPolygon controlPolygon(const Curve& curve) noexcept {
    if (const auto* spline = curve.as<BsplineCurve>()) return {spline->points(), spline->closed()};
    if (const auto* subdivision = curve.as<SubdivisionCurve>()) {
        return {subdivision->subdivision().points, subdivision->closed()};
    }
    return {};
}

Drawing draw(const scene::State& state, const Options& options) {
    Drawing drawing;
    const std::vector<scene::Placed> placed = scene::place(state, options.moment);
    for (std::size_t i = 0; i < placed.size(); ++i) {
        ObjectPainter(placed[i], static_cast<int>(i), options, drawing).paint();
    }
    return drawing;
}

}  // namespace knotwork::drawing
