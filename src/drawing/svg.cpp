#include "drawing/svg.hpp"

#include "drawing/export_parts.hpp"
#include "drawing/extent.hpp"
#include "drawing/outlook.hpp"
#include "drawing/screen.hpp"
#include "drawing/sketch.hpp"
#include "drawing/svg_plots.hpp"
#include "drawing/svg_shapes.hpp"
#include "drawing/svg_theme.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

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

/// A picture on its way. The loops keep it.
class PictureWriter {
public:
    PictureWriter(ExportRun& run, const SvgOptions& options)
        : run_(run), options_(options), xml_(decimalsFor(options)),
          tolerance_(toleranceOf(run.state) * pixelSize(run.state, options)),
          placed_(scene::place(run.state, options.moment)) {}

    static void plan(const std::shared_ptr<PictureWriter>& self) {
        self->run_.flush = [self] { self->run_.text += self->xml_.take(); };
        SlicedWork& work = self->run_.work;
        double drawn = 0;
        for (std::size_t i = 0; i < self->placed_.size(); ++i) {
            const double weight = drawWeight(self->placed_[i].body);
            drawn += weight;
            work.step(weight, [self, i] { self->draw(i); });
        }
        work.step(writingWeight * drawn, [self] { self->frame(self); });
    }

private:
    static constexpr double anyWeight = 20'000;   // of a curve or surface, drawn
    static constexpr double vertexWeight = 4;     // of a mesh, drawn
    static constexpr double writingWeight = 5;    // of what has been drawn

    static double drawWeight(const scene::Body& body) noexcept {
        const auto* mesh = body.subdivision();
        if (mesh == nullptr) return anyWeight;
        return vertexWeight * static_cast<double>(mesh->refined.points().size());
    }

    void draw(std::size_t i) {
        const bool dark = svgColours(options_.theme).dark;
        drawObject(drawing_, placed_[i], static_cast<int>(i),
                   {.moment = options_.moment, .tolerance = tolerance_, .dark = dark});
    }

    /// All that comes after the drawing.
    void frame(const std::shared_ptr<PictureWriter>& self) {
        SlicedWork& work = run_.work;
        outlook_ = outlookOf(run_.state, drawing_.bounds);
        orientation_ = orientationOf(outlook_);
        double positions = 0;
        for (const Shape& shape : drawing_.shapes) {
            const auto count = static_cast<double>(shape.positions.size());
            positions += count;
            work.loop(shape.positions.size() / 3, 0.05 * count,
                      [self, &shape](std::size_t first, std::size_t last) {
                          self->see(shape, first, last);
                      });
        }
        work.step(writingWeight * positions, [self] { self->write(self); });
    }

    void see(const Shape& shape, std::size_t first, std::size_t last) noexcept {
        if (shape.pane != Pane::curve) return;
        for (std::size_t i = first; i < last; ++i) {
            const Vec3 seen = orientation_ * positionAt(shape, i);
            if (isFinite(seen)) seen_.add(seen);
        }
    }

    void write(const std::shared_ptr<PictureWriter>& self) {
        layout_ = svgLayout({0, 0, options_.width, options_.height}, drawing_, options_.panes);
        const Frame& frame = layout_.curve;
        const Aim aim =
            cameraAim(outlook_, orientation_, seen_, frame).value_or(aimAt(seen_, frame));
        const PanePicture picture{Pane::curve, screenOf(orientation_, aim, frame), options_.theme,
                                  -1, -1, frame};
        beginPicture(xml_, run_.state, options_);
        background(xml_, options_);
        if (frame.height > 0) {
            xml_.begin("g").attribute("class", "knotwork-pane").attribute("data-pane", "curve");
            xml_.attribute("data-matrix", matrixText(picture.screen));
            planShapes(run_.work, xml_, drawing_, run_.state, picture);
            run_.work.step(0, [self] { self->xml_.end(); });
        }
        run_.work.step(anyWeight, [self] { self->end(); });
    }

    void end() {
        writePlots(xml_, drawing_, run_.state, layout_, orientation_, options_.theme);
        xml_.end();
    }

    ExportRun& run_;
    SvgOptions options_;
    XmlWriter xml_;
    double tolerance_;
    std::vector<scene::Placed> placed_;
    Drawing drawing_;
    Outlook outlook_;
    Orientation orientation_;
    Bounds seen_;
    SvgLayout layout_;
};

}  // namespace

void planPicture(ExportRun& run, const SvgOptions& picture) {
    run.work.step(0, [&run, picture] {
        PictureWriter::plan(std::make_shared<PictureWriter>(run, picture));
    });
}

std::string svg(const scene::State& state, const SvgOptions& options) {
    return SceneExport(state, options).finish().value();  // a picture is never refused
}

}  // namespace knotwork::drawing
