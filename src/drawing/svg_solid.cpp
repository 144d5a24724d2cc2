#include "drawing/svg_solid.hpp"

#include "drawing/svg_theme.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace knotwork::drawing {

namespace {

/// Towards the light, in pixels: over the left shoulder.
constexpr Vec3 light{-0.299, -0.427, 0.854};
constexpr double darkest = 0.45;  // of the colour, where a facet stands across the light
constexpr double shades = 48;     // from the darkest to the lightest: steps that nobody sees
constexpr double seamWidth = 1;   // pixels: hides the ground between neighbours, also at half the size
constexpr int facetDecimals = 1;  // of their corners: the seam is wider than what is lost
constexpr int lineDecimals = 2;
/// Two triangles that turn less than this (the cosine of 8°) and have a side in common are a facet.
constexpr double flat = 0.99;
constexpr std::size_t mostPiecesOfALine = 4096;
/// So many paths back a piece looks for one of its colour.
constexpr std::size_t farthestBack = 96;

/// A facet of three or four corners, or a piece of a line: two points.
struct Piece {
    double depth = 0;
    std::array<Vec3, 4> points{};
    std::size_t corners = 3;
    const Shape* shape = nullptr;
    std::string paint;  ///< its colour

    [[nodiscard]] bool isFacet() const noexcept { return corners > 2; }
    [[nodiscard]] std::span<const Vec3> outline() const noexcept {
        return std::span(points).first(corners);
    }
};

using Triangle = std::array<Vec3, 3>;

/// Which piece is how deep: what is sorted in place of the pieces themselves.
struct Place {
    double depth = 0;
    std::uint32_t piece = 0;

    /// Of equally deep ones the former is painted first.
    friend bool operator<(const Place& a, const Place& b) noexcept {
        return a.depth < b.depth || (a.depth == b.depth && a.piece < b.piece);
    }
};

/// Sorts them in slices: runs of a fixed length each, and then pairs of runs merged, until one is left.
class PlaceSort {
public:
    std::vector<Place> places;

    /// `self` is kept as long as it takes.
    static void plan(const std::shared_ptr<PlaceSort>& self, SlicedWork& work) {
        const std::size_t count = self->places.size();
        self->merged_.resize(count);
        const double pass = sortWeight * static_cast<double>(count);
        work.loop((count + runLength - 1) / runLength, 13 * pass,
                  [self](std::size_t first, std::size_t last) {
                      for (std::size_t k = first; k < last; ++k) self->sortRun(k * runLength);
                  });
        for (std::size_t length = runLength; length < count; length *= 2) {
            const std::size_t pairs = (count + 2 * length - 1) / (2 * length);
            work.loop(pairs, pass, [self, length](std::size_t first, std::size_t last) {
                for (std::size_t k = first; k < last; ++k) self->merge(2 * k * length, length);
            });
            work.step(0, [self] { self->places.swap(self->merged_); });
        }
    }

private:
    static constexpr std::size_t runLength = 8192;
    static constexpr double sortWeight = 0.04;

    [[nodiscard]] auto at(std::size_t i) noexcept {
        return places.begin() + static_cast<std::ptrdiff_t>(std::min(i, places.size()));
    }
    void sortRun(std::size_t first) { std::sort(at(first), at(first + runLength)); }
    void merge(std::size_t first, std::size_t length) {
        std::merge(at(first), at(first + length), at(first + length), at(first + 2 * length),
                   merged_.begin() + static_cast<std::ptrdiff_t>(first));
    }

    std::vector<Place> merged_;
};

/// Where something is painted, its stroke included.
struct Extent {
    double left = std::numeric_limits<double>::infinity();
    double right = -left;
    double top = left;
    double bottom = -left;

    void add(const Vec3& p, double margin) noexcept {
        left = std::min(left, p.x - margin);
        right = std::max(right, p.x + margin);
        top = std::min(top, p.y - margin);
        bottom = std::max(bottom, p.y + margin);
    }
    void add(const Extent& other) noexcept {
        left = std::min(left, other.left);
        right = std::max(right, other.right);
        top = std::min(top, other.top);
        bottom = std::max(bottom, other.bottom);
    }
    [[nodiscard]] bool meets(const Extent& other) const noexcept {
        return left < other.right && other.left < right && top < other.bottom &&
               other.top < bottom;
    }
};

/// Pieces of one colour that are painted at once, none on what was painted between them.
struct Layer {
    const Piece* model = nullptr;
    std::vector<const Piece*> pieces;
    std::vector<Extent> extents;  ///< of each piece
    Extent whole;

    [[nodiscard]] bool paintsLike(const Piece& piece) const noexcept {
        return model->shape == piece.shape && model->paint == piece.paint;
    }
    [[nodiscard]] bool meets(const Extent& place) const noexcept {
        return whole.meets(place) &&
               std::any_of(extents.begin(), extents.end(),
                           [&](const Extent& one) { return one.meets(place); });
    }
};

double longestSide(const Triangle& t) noexcept {
    const auto side = [](const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y); };
    return std::max({side(t[0], t[1]), side(t[1], t[2]), side(t[2], t[0])});
}

double depthRange(const Triangle& t) noexcept {
    const auto [low, high] = std::minmax({t[0].z, t[1].z, t[2].z});
    return high - low;
}

Vec3 areaOf(const Triangle& t) noexcept { return glm::cross(t[1] - t[0], t[2] - t[0]); }

double cosine(const Vec3& a, const Vec3& b) noexcept {
    const double size = glm::length(a) * glm::length(b);
    return size > 0 ? glm::dot(a, b) / size : 0;
}

/// Both as one outline of four corners, where they have a side in common, lie nearly in a plane and
/// are seen from the same side.
std::optional<std::array<Vec3, 4>> joined(const Triangle& a, const Triangle& b) noexcept {
    const Vec3 areaA = areaOf(a);
    const Vec3 areaB = areaOf(b);
    if (!(areaA.z * areaB.z > 0) || !(cosine(areaA, areaB) > flat)) return std::nullopt;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            // From a[i] to a[i+1], and back in b.
            if (a[i] != b[(j + 1) % 3] || a[(i + 1) % 3] != b[j]) continue;
            return std::array{a[(i + 1) % 3], a[(i + 2) % 3], a[i], b[(j + 2) % 3]};
        }
    }
    return std::nullopt;
}

// What things weigh, in numbers written as text (sliced_work.hpp).
constexpr double facetWeight = 1;
constexpr double layerWeight = 4;   // a piece that looks for its layer
constexpr double pathWeight = 5;    // a piece that is written

class SolidWriter {
public:
    SolidWriter(SlicedWork& work, XmlWriter& xml, const PanePicture& picture)
        : work_(work), xml_(xml), picture_(picture) {}

    /// The loops keep the writer.
    static void plan(const std::shared_ptr<SolidWriter>& self, std::span<const Shape> shapes) {
        double corners = 0;
        for (const Shape& shape : shapes) {
            if (shape.kind != Kind::triangles) continue;
            corners += self->planCorners(shape, [self, &shape](std::size_t last) {
                self->facets(shape, last);
            });
        }
        for (const Shape& shape : shapes) {
            if (!belongsToSolid(shape) || shape.kind != Kind::polyline) continue;
            corners += self->planCorners(shape, [self, &shape](std::size_t last) {
                self->line(shape, last);
            });
        }
        self->work_.step((layerWeight + pathWeight) / 4 * corners, [self] { planPieces(self); });
    }

private:
    /// A loop over the corners of a shape, which goes on to the last of a slice or a little farther.
    template <class Run>
    double planCorners(const Shape& shape, Run run) {
        const std::size_t count = cornerCount(shape);
        const auto weight = static_cast<double>(count);
        work_.loop(count, facetWeight * weight, [this, run](std::size_t first, std::size_t last) {
            if (first == 0) corner_ = 0;
            run(last);
        });
        return weight;
    }

    static void planPieces(const std::shared_ptr<SolidWriter>& self) {
        const auto sort = std::make_shared<PlaceSort>();
        sort->places.reserve(self->pieces_.size());
        for (const Piece& piece : self->pieces_) {
            sort->places.push_back({piece.depth, static_cast<std::uint32_t>(sort->places.size())});
        }
        PlaceSort::plan(sort, self->work_);
        const std::size_t count = self->pieces_.size();
        const auto pieces = static_cast<double>(count);
        self->work_.loop(count, layerWeight * pieces,
                         [self, sort](std::size_t first, std::size_t last) {
                             for (std::size_t i = first; i < last; ++i) {
                                 self->layer(self->pieces_[sort->places[i].piece]);
                             }
                         });
        self->work_.step(pathWeight * pieces, [self] { planPaths(self); });
    }

    static void planPaths(const std::shared_ptr<SolidWriter>& self) {
        XmlWriter& xml = self->xml_;
        xml.begin("g").attribute("class", "knotwork-solid").attribute("fill", "none");
        xml.attribute("stroke-linecap", "round").attribute("stroke-linejoin", "round");
        self->work_.loop(self->layers_.size(),
                         pathWeight * static_cast<double>(self->pieces_.size()),
                         [self](std::size_t first, std::size_t last) {
                             for (std::size_t k = first; k < last; ++k) {
                                 self->path(self->layers_[k]);
                             }
                         });
        self->work_.step(0, [self] { self->xml_.end(); });
    }

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
    [[nodiscard]] std::optional<Triangle> triangle(const Shape& shape, std::size_t i) const {
        if (i + 2 >= cornerCount(shape)) return std::nullopt;
        const Triangle t{corner(shape, i), corner(shape, i + 1), corner(shape, i + 2)};
        if (!isFinite(t[0] + t[1] + t[2])) return std::nullopt;
        return t;
    }

    /// From where the last slice has ended. Cells of a grid come as two triangles, one after the other.
    void facets(const Shape& shape, std::size_t last) {
        for (; corner_ < last; corner_ += 3) {
            const std::size_t i = corner_;
            const auto first = triangle(shape, i);
            if (!first) continue;
            measure(*first);
            const auto second = triangle(shape, i + 3);
            const auto both = second ? joined(*first, *second) : std::nullopt;
            if (!both) {
                facet(shape, i, {(*first)[0], (*first)[1], (*first)[2], {}}, 3, areaOf(*first));
                continue;
            }
            measure(*second);
            facet(shape, i, *both, 4, areaOf(*first) + areaOf(*second));
            corner_ += 3;
        }
    }

    void measure(const Triangle& t) noexcept {
        longest_ = std::max(longest_, longestSide(t));
        thickest_ = std::max(thickest_, depthRange(t));
    }

    /// All facets go round in one sense, so that none of a path takes another's paint away.
    void facet(const Shape& shape, std::size_t first, std::array<Vec3, 4> points,
               std::size_t corners, const Vec3& area) {
        const auto end = points.begin() + static_cast<std::ptrdiff_t>(corners);
        if (area.z < 0) std::reverse(points.begin() + 1, end);
        double depth = 0;
        for (std::size_t k = 0; k < corners; ++k) depth += points[k].z;
        pieces_.push_back({depth / static_cast<double>(corners), points, corners, &shape,
                           shaded(colourOf(shape, first), area)});
    }

    /// Of the triangle whose corners begin with the k-th.
    [[nodiscard]] static Colour colourOf(const Shape& shape, std::size_t k) noexcept {
        if (shape.colours.empty()) return shape.colour;
        std::array<double, 3> sum{};
        for (std::size_t i = k; i < k + 3; ++i) {
            const ColourBytes& own = shape.colours[shape.indices.empty() ? i : shape.indices[i]];
            for (std::size_t c = 0; c < 3; ++c) sum[c] += own[c] / (3 * 255.0);
        }
        return {sum[0], sum[1], sum[2], 1};
    }

    [[nodiscard]] std::string shaded(const Colour& colour, const Vec3& area) const {
        const double size = glm::length(area);
        const double facing = size > 0 ? std::abs(glm::dot(area, light)) / size : 1;
        const double share = darkest + (1 - darkest) * std::round(shades * facing) / shades;
        return svgColour({share * colour.red, share * colour.green, share * colour.blue, 1},
                         picture_.theme);
    }

    /// From where the last slice has ended: in pieces no longer than a triangle, each before the
    /// triangles that it lies on.
    void line(const Shape& shape, std::size_t last) {
        const std::string paint = svgColour(shape.colour, picture_.theme);
        const double longest = std::max(longest_, 1.0);
        const std::size_t step = shape.indices.empty() ? 1 : 2;
        for (; corner_ + 1 < cornerCount(shape) && corner_ < last; corner_ += step) {
            const Vec3 from = corner(shape, corner_);
            const Vec3 to = corner(shape, corner_ + 1);
            if (!isFinite(from + to)) continue;
            const double length = std::hypot(to.x - from.x, to.y - from.y);
            const auto count = static_cast<std::size_t>(std::clamp(
                std::ceil(length / longest), 1.0, static_cast<double>(mostPiecesOfALine)));
            for (std::size_t k = 0; k < count; ++k) {
                const auto part = [&](std::size_t j) {
                    return from + static_cast<double>(j) / static_cast<double>(count) * (to - from);
                };
                const double depth = (part(k).z + part(k + 1).z) / 2 + thickest_;
                pieces_.push_back({depth, {part(k), part(k + 1), {}, {}}, 2, &shape, paint});
            }
        }
    }

    [[nodiscard]] double strokeOf(const Piece& piece) const noexcept {
        if (piece.isFacet()) return seamWidth;
        return svgColours(picture_.theme).strength * static_cast<double>(piece.shape->width);
    }

    /// Into the last layer of its colour, if nothing that was painted since lies below it. What can be
    /// seen through is painted one by one.
    void layer(const Piece& piece) {
        Extent place;
        for (const Vec3& p : piece.outline()) place.add(p, strokeOf(piece) / 2);
        const std::size_t last = layers_.size() > farthestBack ? layers_.size() - farthestBack : 0;
        for (std::size_t k = layers_.size(); k > last; --k) {
            Layer& candidate = layers_[k - 1];
            if (piece.shape->colour.alpha >= 1 && candidate.paintsLike(piece)) {
                candidate.pieces.push_back(&piece);
                candidate.extents.push_back(place);
                candidate.whole.add(place);
                return;
            }
            if (candidate.meets(place)) break;
        }
        layers_.push_back({&piece, {&piece}, {place}, place});
    }

    void path(const Layer& layer) {
        const Piece& model = *layer.model;
        const int decimals = model.isFacet() ? facetDecimals : lineDecimals;
        std::string data;
        for (const Piece* piece : layer.pieces) {
            char command = 'M';
            for (const Vec3& p : piece->outline()) {
                data += std::exchange(command, 'L');
                appendNumber(data, p.x, decimals);
                data += ',';
                appendNumber(data, p.y, decimals);
            }
            if (model.isFacet()) data += 'Z';
        }
        const Shape& shape = *model.shape;
        xml_.begin("path").attribute("data-role", roleName(shape.role));
        if (model.isFacet()) xml_.attribute("fill", model.paint);
        // The seams of what can be seen through would be seen twice.
        if (!model.isFacet() || shape.colour.alpha >= 1) {
            xml_.attribute("stroke", model.paint).number("stroke-width", strokeOf(model));
        }
        if (shape.colour.alpha < 1) xml_.number("opacity", shape.colour.alpha);
        xml_.attribute("d", data);
        xml_.end();
    }

    SlicedWork& work_;
    XmlWriter& xml_;
    PanePicture picture_;
    std::size_t corner_ = 0;  ///< of the shape that is looked at
    std::vector<Piece> pieces_;
    std::vector<Layer> layers_;
    double longest_ = 0;   ///< side of a triangle in the picture
    double thickest_ = 0;  ///< depth of one
};

}  // namespace

bool belongsToSolid(const Shape& shape) noexcept {
    return shape.kind == Kind::triangles ||
           (shape.kind == Kind::polyline &&
            (shape.role == Role::isoline || shape.role == Role::wireframe));
}

void planSolid(SlicedWork& work, XmlWriter& xml, std::span<const Shape> shapes,
               const PanePicture& picture) {
    SolidWriter::plan(std::make_shared<SolidWriter>(work, xml, picture), shapes);
}

}  // namespace knotwork::drawing
