#include "drawing/svg_shapes.hpp"

#include "drawing/curve_path.hpp"
#include "drawing/letters.hpp"
#include "drawing/svg_solid.hpp"
#include "drawing/svg_theme.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace knotwork::drawing {

namespace {

constexpr double cubicTolerance = 0.05;  // pixels
/// A polygon with more vertices than can be told apart is drawn as its polyline.
constexpr std::size_t mostExactSteps = 8192;
constexpr double borderWidth = 1.5;
constexpr double fontSize = 13;

/// Writes the data of a path; a line to where the path stands already is left out.
class PathData {
public:
    explicit PathData(int decimals) : decimals_(decimals) {}

    void move(const Vec3& p) {
        last_ = pair(p);
        start_ = last_;
        text_ += 'M' + last_;
    }
    void line(const Vec3& p) {
        std::string end = pair(p);
        if (end == last_) return;
        text_ += 'L' + end;
        last_ = std::move(end);
    }
    void cubic(const Vec3& first, const Vec3& second, const Vec3& end) {
        last_ = pair(end);
        text_ += 'C' + pair(first) + ' ' + pair(second) + ' ' + last_;
    }
    /// Where the path is back at its start the join is one like all others.
    void close() {
        if (!text_.empty() && last_ == start_) text_ += 'Z';
    }
    [[nodiscard]] std::string take() { return std::move(text_); }

private:
    [[nodiscard]] std::string pair(const Vec3& p) const {
        std::string text;
        appendNumber(text, p.x, decimals_);
        text += ',';
        appendNumber(text, p.y, decimals_);
        return text;
    }

    int decimals_;
    std::string text_;
    std::string last_;
    std::string start_;
};

// What things weigh, in numbers written as text (sliced_work.hpp).
constexpr double pointWeight = 8;   // an element of its own
constexpr double cornerWeight = 2;  // of a path
constexpr double exactWeight = 20'000;  // a curve as a path

class ShapeWriter {
public:
    ShapeWriter(SlicedWork& work, XmlWriter& xml, const Drawing& drawing,
                const scene::State& state, const PanePicture& picture)
        : work_(work), xml_(xml), drawing_(drawing), state_(state), picture_(picture),
          colours_(svgColours(picture.theme)) {}

    /// The loops keep the writer.
    static void plan(const std::shared_ptr<ShapeWriter>& self) {
        const std::vector<Shape>& shapes = self->drawing_.shapes;
        for (std::size_t i = 0; i < shapes.size();) {
            const std::size_t end = self->runEnd(i, [](const Shape&, const Shape&) { return true; });
            if (self->picture_.shows(shapes[i])) {
                self->work_.step(self->weightOf(i, end), [self, i, end] { self->object(self, i, end); });
            }
            i = end;
        }
    }

private:
    /// Past the last of the shapes that are of the same object as this one, like it, and shown or not
    /// as it is.
    template <class Like>
    [[nodiscard]] std::size_t runEnd(std::size_t first, const Like& like) const {
        const Shape& model = drawing_.shapes[first];
        std::size_t end = first + 1;
        while (end < drawing_.shapes.size()) {
            const Shape& shape = drawing_.shapes[end];
            const bool together = shape.object == model.object &&
                                  picture_.shows(shape) == picture_.shows(model);
            if (!together || !like(model, shape)) break;
            ++end;
        }
        return end;
    }

    [[nodiscard]] bool isSolid(std::size_t first, std::size_t last) const {
        const auto begin = drawing_.shapes.begin();
        return std::any_of(begin + static_cast<std::ptrdiff_t>(first),
                           begin + static_cast<std::ptrdiff_t>(last),
                           [](const Shape& shape) { return shape.kind == Kind::triangles; });
    }

    [[nodiscard]] static double weightOf(const Shape& shape) noexcept {
        const std::size_t corners = shape.positions.size() / 3 + shape.indices.size();
        const double each = shape.kind == Kind::points ? pointWeight : cornerWeight;
        return each * static_cast<double>(corners) + (shape.source ? exactWeight : 0);
    }
    [[nodiscard]] double weightOf(std::size_t first, std::size_t last) const noexcept {
        double weight = 0;
        for (std::size_t i = first; i < last; ++i) weight += weightOf(drawing_.shapes[i]);
        return weight;
    }

    void object(const std::shared_ptr<ShapeWriter>& self, std::size_t first, std::size_t last) {
        const scene::Object& object =
            *state_.objects[static_cast<std::size_t>(drawing_.shapes[first].object)];
        xml_.begin("g").attribute("class", "knotwork-object").attribute("data-object", object.id);
        xml_.attribute("data-type", scene::stringOr(object.spec, "type", ""));
        const bool solid = isSolid(first, last);
        if (solid) {
            planSolid(work_, xml_, std::span(drawing_.shapes).subspan(first, last - first), picture_);
        }
        while (first < last) {
            const std::size_t end = runEnd(first, [](const Shape& a, const Shape& b) {
                return a.role == b.role && a.kind == b.kind;
            });
            if (!solid || !belongsToSolid(drawing_.shapes[first])) {
                work_.step(0, [self, first] { self->beginRole(first); });
                for (std::size_t i = first; i < end; ++i) planShape(self, i, {first, end});
                work_.step(0, [self] { self->xml_.end(); });
            }
            first = end;
        }
        work_.step(0, [self] { self->xml_.end(); });
    }

    /// Shapes of one role, and with it of one kind.
    struct RoleRun {
        std::size_t first = 0;
        std::size_t last = 0;
    };

    void beginRole(std::size_t first) {
        const Shape& model = drawing_.shapes[first];
        const std::string name(roleName(model.role));
        xml_.begin("g").attribute("class", "knotwork-" + name).attribute("data-role", name);
        switch (model.kind) {
            case Kind::polyline: beginLines(model); break;
            case Kind::points: beginPoints(model); break;
            case Kind::label: beginLabels(); break;
            case Kind::triangles: break;
        }
    }

    void planShape(const std::shared_ptr<ShapeWriter>& self, std::size_t i, const RoleRun& role) {
        const Shape& shape = drawing_.shapes[i];
        const Shape& model = drawing_.shapes[role.first];
        const double weight = weightOf(shape);
        switch (shape.kind) {
            case Kind::polyline:
                return work_.step(weight, [self, &shape, &model, role] {
                    self->line(self, shape, model, role.last - role.first > 1);
                });
            case Kind::points:
                return work_.loop(shape.positions.size() / 3, weight,
                                  [self, &shape, &model](std::size_t first, std::size_t last) {
                                      for (std::size_t k = first; k < last; ++k) {
                                          self->point(shape, self->at(shape, k), model);
                                      }
                                  });
            case Kind::label: return work_.step(1, [self, &shape] { self->label(shape); });
            case Kind::triangles: break;
        }
    }

    [[nodiscard]] Vec3 at(const Shape& shape, std::size_t i) const noexcept {
        const double* xyz = shape.positions.data() + 3 * i;
        return picture_.screen.point({xyz[0], xyz[1], xyz[2]});
    }

    void stroke(const Shape& shape) {
        xml_.attribute("stroke", svgColour(shape.colour, picture_.theme));
        if (shape.colour.alpha < 1) xml_.number("stroke-opacity", shape.colour.alpha);
        xml_.number("stroke-width", colours_.strength * static_cast<double>(shape.width));
    }

    void fill(const Shape& shape) {
        xml_.attribute("fill", svgColour(shape.colour, picture_.theme));
        if (shape.colour.alpha < 1) xml_.number("fill-opacity", shape.colour.alpha);
    }

    void beginLines(const Shape& model) {
        xml_.attribute("fill", "none");
        stroke(model);
        xml_.attribute("stroke-linecap", "round").attribute("stroke-linejoin", "round");
    }

    void line(const std::shared_ptr<ShapeWriter>& self, const Shape& shape, const Shape& model,
              bool numbered) {
        xml_.begin("path");
        if (numbered) xml_.attribute("data-index", std::to_string(shape.index));
        if (shape.colour != model.colour || shape.width != model.width) stroke(shape);
        if (shape.dashed) xml_.attribute("stroke-dasharray", "6 5");
        if (shape.source != nullptr) {
            const CurvePart& part = *shape.source;
            const auto steps = curvePath(
                {part.curve, part.part, compose(picture_.screen, part.placement)}, cubicTolerance);
            if (steps.size() <= mostExactSteps) return endLine(pathOf(steps));
        }
        planPolyline(self, shape);
    }

    void endLine(const std::string& data) {
        xml_.attribute("d", data);
        xml_.end();
    }

    void planPolyline(const std::shared_ptr<ShapeWriter>& self, const Shape& shape) {
        const auto path = std::make_shared<PathData>(xml_.decimals());
        const bool runs = shape.indices.empty();
        const std::size_t count = runs ? shape.positions.size() / 3 : shape.indices.size() / 2;
        work_.loop(count, weightOf(shape), [self, &shape, path, runs](std::size_t first,
                                                                     std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                if (!runs) {
                    path->move(self->at(shape, shape.indices[2 * i]));
                    path->line(self->at(shape, shape.indices[2 * i + 1]));
                } else if (i == 0) {
                    path->move(self->at(shape, i));
                } else {
                    path->line(self->at(shape, i));
                }
            }
        });
        work_.step(0, [self, path, runs] {
            if (runs) path->close();
            self->endLine(path->take());
        });
    }

    [[nodiscard]] std::string pathOf(const std::vector<PathStep>& steps) const {
        PathData path(xml_.decimals());
        for (const PathStep& step : steps) {
            switch (step.kind) {
                case PathStep::Kind::move: path.move(step.end); break;
                case PathStep::Kind::line: path.line(step.end); break;
                case PathStep::Kind::cubic: path.cubic(step.first, step.second, step.end); break;
            }
        }
        path.close();
        return path.take();
    }

    void beginPoints(const Shape& model) {
        fill(model);
        xml_.attribute("stroke", colours_.border).number("stroke-width", borderWidth);
    }

    void point(const Shape& shape, const Vec3& p, const Shape& model) {
        const auto size = static_cast<double>(shape.width);
        if (shape.square) {
            xml_.begin("rect").number("x", p.x - size / 2).number("y", p.y - size / 2);
            xml_.number("width", size).number("height", size);
        } else {
            xml_.begin("circle").number("cx", p.x).number("cy", p.y).number("r", size / 2);
        }
        if (shape.colour != model.colour) fill(shape);
        xml_.end();
    }

    /// The middle of a text, moved so that all of the text is in the picture.
    [[nodiscard]] Vec3 inFrame(Vec3 middle, const std::string& text) const noexcept {
        const Frame& frame = picture_.frame;
        const double width = 0.3 * fontSize * static_cast<double>(lettersIn(text));
        const double height = 0.6 * fontSize;
        if (frame.width > 2 * width) {
            middle.x = std::clamp(middle.x, frame.x + width, frame.x + frame.width - width);
        }
        if (frame.height > 2 * height) {
            middle.y = std::clamp(middle.y, frame.y + height, frame.y + frame.height - height);
        }
        return middle;
    }

    /// Words with a rim of the ground's colour, so that they can be read on lines.
    void beginLabels() {
        xml_.attribute("fill", colours_.ink).attribute("stroke", colours_.ground);
        xml_.number("stroke-width", 3).attribute("stroke-linejoin", "round");
        xml_.attribute("paint-order", "stroke").attribute("text-anchor", "middle");
        xml_.attribute("font-family", "sans-serif").number("font-size", fontSize);
    }

    void label(const Shape& shape) {
        if (shape.positions.size() < 3) return;
        // The middle of the letters, not their baseline, is where the label is.
        constexpr double baseline = 0.35 * fontSize;
        const bool beside = shape.offset[1] != 0 || shape.offset[0] != 0;
        const Vec3 p = inFrame(at(shape, 0) + Vec3(shape.offset[0], shape.offset[1], 0), shape.text);
        xml_.begin("text").number("x", p.x).number("y", p.y + (beside ? baseline : 0));
        xml_.text(shape.text);
    }

    SlicedWork& work_;
    XmlWriter& xml_;
    const Drawing& drawing_;
    const scene::State& state_;
    PanePicture picture_;
    const SvgColours& colours_;
};

}  // namespace

void planShapes(SlicedWork& work, XmlWriter& xml, const Drawing& drawing,
                const scene::State& state, const PanePicture& picture) {
    ShapeWriter::plan(std::make_shared<ShapeWriter>(work, xml, drawing, state, picture));
}

void writeShapes(XmlWriter& xml, const Drawing& drawing, const scene::State& state,
                 const PanePicture& picture) {
    SlicedWork work;
    planShapes(work, xml, drawing, state, picture);
    work.finish();
}

}  // namespace knotwork::drawing
