#include "drawing/svg_solid.hpp"

#include "drawing/svg_theme.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace knotwork::drawing {

namespace {

/// Towards the light, in pixels: over the left shoulder.
constexpr Vec3 light{-0.299, -0.427, 0.854};
constexpr double darkest = 0.45;  // of the colour, where a triangle stands across the light
constexpr double seamWidth = 0.6; // pixels: hides the ground between neighbours
constexpr std::size_t mostPiecesOfALine = 4096;

/// A triangle, or a piece of a line: two points.
struct Piece {
    double depth = 0;
    std::array<Vec3, 3> points{};
    const Shape* shape = nullptr;
    std::string paint;  ///< its colour

    [[nodiscard]] bool isTriangle() const noexcept { return shape->kind == Kind::triangles; }
    [[nodiscard]] bool paintsLike(const Piece& other) const noexcept {
        return shape == other.shape && paint == other.paint;
    }
};

double longestSide(const std::array<Vec3, 3>& t) noexcept {
    const auto side = [](const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y); };
    return std::max({side(t[0], t[1]), side(t[1], t[2]), side(t[2], t[0])});
}

double depthRange(const std::array<Vec3, 3>& t) noexcept {
    const auto [low, high] = std::minmax({t[0].z, t[1].z, t[2].z});
    return high - low;
}

class SolidWriter {
public:
    SolidWriter(XmlWriter& xml, const PanePicture& picture) : xml_(xml), picture_(picture) {}

    void write(std::span<const Shape> shapes) {
        for (const Shape& shape : shapes) {
            if (shape.kind == Kind::triangles) triangles(shape);
        }
        for (const Shape& shape : shapes) {
            if (belongsToSolid(shape) && shape.kind == Kind::polyline) line(shape);
        }
        std::stable_sort(pieces_.begin(), pieces_.end(),
                         [](const Piece& a, const Piece& b) { return a.depth < b.depth; });
        xml_.begin("g").attribute("class", "knotwork-solid").attribute("fill", "none");
        xml_.attribute("stroke-linecap", "round").attribute("stroke-linejoin", "round");
        for (std::size_t i = 0; i < pieces_.size();) i = run(i);
        xml_.end();
    }

private:
    [[nodiscard]] Vec3 at(const Shape& shape, std::size_t i) const noexcept {
        const double* p = shape.positions.data() + 3 * i;
        return picture_.screen.point({p[0], p[1], p[2]});
    }

    /// The k-th of the corners of triangles, or of the ends of segments.
    [[nodiscard]] static std::size_t cornerCount(const Shape& shape) noexcept {
        return shape.indices.empty() ? shape.positions.size() / 3 : shape.indices.size();
    }
    [[nodiscard]] Vec3 corner(const Shape& shape, std::size_t k) const noexcept {
        return at(shape, shape.indices.empty() ? k : shape.indices[k]);
    }

    void triangles(const Shape& shape) {
        for (std::size_t i = 0; i + 2 < cornerCount(shape); i += 3) {
            const std::array corners{corner(shape, i), corner(shape, i + 1), corner(shape, i + 2)};
            if (!isFinite(corners[0] + corners[1] + corners[2])) continue;
            longest_ = std::max(longest_, longestSide(corners));
            thickest_ = std::max(thickest_, depthRange(corners));
            const double depth = (corners[0].z + corners[1].z + corners[2].z) / 3;
            pieces_.push_back({depth, corners, &shape, shaded(shape.colour, corners)});
        }
    }

    [[nodiscard]] std::string shaded(const Colour& colour, const std::array<Vec3, 3>& t) const {
        const Vec3 across = glm::cross(t[1] - t[0], t[2] - t[0]);
        const double size = glm::length(across);
        const double facing = size > 0 ? std::abs(glm::dot(across, light)) / size : 1;
        const double share = darkest + (1 - darkest) * facing;
        return svgColour({share * colour.red, share * colour.green, share * colour.blue, 1},
                         picture_.theme);
    }

    /// In pieces no longer than a triangle, each before the triangles that it lies on.
    void line(const Shape& shape) {
        const std::string paint = svgColour(shape.colour, picture_.theme);
        const double longest = std::max(longest_, 1.0);
        const std::size_t step = shape.indices.empty() ? 1 : 2;
        for (std::size_t i = 1; i < cornerCount(shape); i += step) {
            const Vec3 from = corner(shape, i - 1);
            const Vec3 to = corner(shape, i);
            if (!isFinite(from + to)) continue;
            const double length = std::hypot(to.x - from.x, to.y - from.y);
            const auto count = static_cast<std::size_t>(std::clamp(
                std::ceil(length / longest), 1.0, static_cast<double>(mostPiecesOfALine)));
            for (std::size_t k = 0; k < count; ++k) {
                const auto part = [&](std::size_t j) {
                    return from + static_cast<double>(j) / static_cast<double>(count) * (to - from);
                };
                const double depth = (part(k).z + part(k + 1).z) / 2 + thickest_;
                pieces_.push_back({depth, {part(k), part(k + 1), {}}, &shape, paint});
            }
        }
    }

    void pair(std::string& data, char command, const Vec3& p) const {
        data += command;
        appendNumber(data, p.x, 2);
        data += ',';
        appendNumber(data, p.y, 2);
    }

    /// One path for all the neighbours in depth that are painted alike; past the last of them.
    std::size_t run(std::size_t first) {
        const Piece& model = pieces_[first];
        std::string data;
        std::size_t i = first;
        for (; i < pieces_.size() && pieces_[i].paintsLike(model); ++i) {
            pair(data, 'M', pieces_[i].points[0]);
            pair(data, 'L', pieces_[i].points[1]);
            if (model.isTriangle()) pair(data, 'L', pieces_[i].points[2]);
            if (model.isTriangle()) data += 'Z';
        }
        const Shape& shape = *model.shape;
        xml_.begin("path").attribute("data-role", roleName(shape.role));
        if (model.isTriangle()) xml_.attribute("fill", model.paint);
        xml_.attribute("stroke", model.paint);
        xml_.number("stroke-width", model.isTriangle()
                                        ? seamWidth
                                        : svgColours(picture_.theme).strength *
                                              static_cast<double>(shape.width));
        if (shape.colour.alpha < 1) xml_.number("opacity", shape.colour.alpha);
        xml_.attribute("d", data);
        xml_.end();
        return i;
    }

    XmlWriter& xml_;
    const PanePicture& picture_;
    std::vector<Piece> pieces_;
    double longest_ = 0;   ///< side of a triangle in the picture
    double thickest_ = 0;  ///< depth of one
};

}  // namespace

bool belongsToSolid(const Shape& shape) noexcept {
    return shape.kind == Kind::triangles ||
           (shape.kind == Kind::polyline &&
            (shape.role == Role::isoline || shape.role == Role::wireframe));
}

void writeSolid(XmlWriter& xml, std::span<const Shape> shapes, const PanePicture& picture) {
    SolidWriter(xml, picture).write(shapes);
}

}  // namespace knotwork::drawing
