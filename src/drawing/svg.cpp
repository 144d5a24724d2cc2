#include "drawing/svg.hpp"

#include "drawing/extent.hpp"
#include "drawing/outlook.hpp"
#include "drawing/screen.hpp"
#include "drawing/svg_plots.hpp"
#include "drawing/svg_shapes.hpp"
#include "drawing/svg_theme.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace knotwork::drawing {

namespace {

constexpr double lineTolerance = 0.1;   // pixels
/// Of pictures with surfaces, whose triangles would take megabytes otherwise. Curves are drawn
/// from what they are, and do not suffer.
constexpr double surfaceTolerance = 3;
constexpr double leastRounding = 1e-3;  // pixels: nobody sees less
constexpr double shareRounding = 5e-7;  // of the smaller side

int decimalsFor(const SvgOptions& options) noexcept {
    const double step =
        std::min(leastRounding, shareRounding * std::min(options.width, options.height));
    return static_cast<int>(std::ceil(-std::log10(step) - 1e-9));
}

std::string_view themeName(SvgTheme theme) noexcept {
    constexpr std::array names{std::string_view("light"), std::string_view("dark"),
                               std::string_view("contrast")};
    return names[static_cast<std::size_t>(theme)];
}

Orientation orientationOf(const Outlook& outlook) noexcept {
    return outlook.spatial ? orientationFrom(outlook.azimuth, outlook.elevation)
                           : planeOrientation();
}

/// The document's camera where it says how much it shows, otherwise nothing.
std::optional<Aim> cameraAim(const Outlook& outlook, const Orientation& orientation,
                             const Bounds& bounds, const Frame& frame) {
    if (!(outlook.height > 0)) return std::nullopt;
    const Vec3 middle = outlook.centre ? orientation * *outlook.centre
                                       : (bounds.min + bounds.max) * 0.5;
    return Aim{middle.x, middle.y, frame.height / outlook.height};
}

Bounds seenBounds(const Drawing& drawing, const Orientation& orientation) {
    Bounds bounds;
    for (const Shape& shape : drawing.shapes) {
        if (shape.pane != Pane::curve) continue;
        for (std::size_t i = 0; i < shape.positions.size(); i += 3) {
            const double* p = shape.positions.data() + i;
            const Vec3 seen = orientation * Vec3(p[0], p[1], p[2]);
            if (isFinite(seen)) bounds.add(seen);
        }
    }
    return bounds;
}

/// Units of the world that a pixel takes, or a little less.
double pixelSize(const scene::State& state, const SvgOptions& options) {
    const double height = outlookOf(state, {}).height;
    if (height > 0) return height / options.height;
    return roughSize(state, options.moment) / std::max(options.width, options.height);
}

double toleranceOf(const scene::State& state) noexcept {
    const bool surfaces = std::any_of(
        state.objects.begin(), state.objects.end(),
        [](const auto& object) { return object->body.surface() != nullptr; });
    return surfaces ? surfaceTolerance : lineTolerance;
}

std::string matrixText(const Affine& screen) {
    const auto& m = screen.linear;
    scene::Json numbers{m[0][0], m[0][1], m[1][0], m[1][1], screen.offset.x, screen.offset.y};
    std::string text = scene::dumpJson(numbers);
    std::replace(text.begin(), text.end(), ',', ' ');
    return text.substr(1, text.size() - 2);
}

void beginPicture(XmlWriter& xml, const scene::State& state, const SvgOptions& options) {
    const std::string title =
        options.title.value_or(scene::stringOr(*state.header, "title", ""));
    const std::string description =
        options.description.value_or(scene::stringOr(*state.header, "description", ""));
    xml.begin("svg").attribute("xmlns", "http://www.w3.org/2000/svg");
    xml.number("width", options.width).number("height", options.height);
    std::string box = "0 0 ";
    appendNumber(box, options.width, xml.decimals());
    box += ' ';
    appendNumber(box, options.height, xml.decimals());
    xml.attribute("viewBox", box).attribute("role", "img");
    xml.attribute("class", "knotwork knotwork-" + std::string(themeName(options.theme)));
    xml.begin("title").text(title.empty() ? "Knotwork" : title);
    if (!description.empty()) xml.begin("desc").text(description);
}

void background(XmlWriter& xml, const SvgOptions& options) {
    if (options.background == "none") return;
    const bool own = options.background != "theme";
    xml.begin("rect").attribute("class", "knotwork-background");
    xml.number("width", options.width).number("height", options.height);
    xml.attribute("fill", own ? options.background : svgColours(options.theme).ground);
    xml.end();
}

}  // namespace

std::string svg(const scene::State& state, const SvgOptions& options) {
    const Drawing drawing = draw(state, {.moment = options.moment,
                                         .tolerance = toleranceOf(state) * pixelSize(state, options),
                                         .dark = svgColours(options.theme).dark});
    const Outlook outlook = outlookOf(state, drawing.bounds);
    const Orientation orientation = orientationOf(outlook);
    const Bounds bounds = seenBounds(drawing, orientation);
    const SvgLayout layout = svgLayout({0, 0, options.width, options.height}, drawing, options.panes);
    const Frame& frame = layout.curve;
    const Aim aim = cameraAim(outlook, orientation, bounds, frame).value_or(aimAt(bounds, frame));
    const PanePicture picture{Pane::curve, screenOf(orientation, aim, frame), options.theme, -1, -1, frame};

    XmlWriter xml(decimalsFor(options));
    beginPicture(xml, state, options);
    background(xml, options);
    if (frame.height > 0) {
        xml.begin("g").attribute("class", "knotwork-pane").attribute("data-pane", "curve");
        xml.attribute("data-matrix", matrixText(picture.screen));
        writeShapes(xml, drawing, state, picture);
        xml.end();
    }
    writePlots(xml, drawing, state, layout, orientation, options.theme);
    xml.end();
    return xml.take();
}

}  // namespace knotwork::drawing
