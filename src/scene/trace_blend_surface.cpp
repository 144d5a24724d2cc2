// A blending surface at a place: S(u, v) = Σ β_a(u) γ_b(v) P_{i+a,j+b}(u, v), a and b from 0 to 1.
#include "scene/trace_algorithms.hpp"
#include "scene/trace_formula.hpp"
#include "scene/trace_parts.hpp"

#include <algorithm>
#include <cmath>

namespace knotwork::scene {

namespace {

constexpr Sentence begin{
    "blend-surface.begin", "The cell of ({u}, {v})",
    "The parameter u = {u} lies between the knots {fromU} and {toU}, and v = {v} between {fromV} and "
    "{toV}; there the local patches ({patch0}), ({patch1}), ({patch2}) and ({patch3}) are blended."};
constexpr Sentence ratios{
    "blend-surface.ratios", "The values of the B-functions",
    "The part of the cell that u has passed is {wu}, and the {familyU} B-function takes it to {bu}; "
    "the part that v has passed is {wv}, and the {familyV} B-function takes it to {bv}."};
constexpr Sentence weights{
    "blend-surface.weights", "The four weights",
    "Each patch counts the product of its weight along u, {au} or {bu}, and its weight along v, {av} "
    "or {bv}: {weight0}, {weight1}, {weight2} and {weight3}, which together are 1."};
constexpr Sentence patches{
    "blend-surface.patches", "The four patches",
    "At ({u}, {v}) patch ({patch0}) is at {point0}, patch ({patch1}) at {point1}, patch ({patch2}) "
    "at {point2} and patch ({patch3}) at {point3}."};
constexpr Sentence result{
    "blend-surface.result", "The point",
    "Blended with these weights they give the point of the surface at ({u}, {v}), {point}."};

/// Points that show each side of a patch over the cell.
constexpr std::size_t sidePoints = 8;

/// One direction: the span in which the surface is evaluated, and what is blended there.
struct Along {
    Along(const BlendDirection& direction, double parameter, Side seenFrom)
        : side(seenFrom),
          span(direction.spanAt(parameter, seenFrom)),
          to(span.start + span.length),
          w(span.ratio()),
          b(direction.blend.value(w)),
          family(direction.blend.description().name) {
        const Interval whole = direction.domain();
        reading = {.size = std::max(std::abs(whole.start), std::abs(whole.end)),
                   .gap = span.length};
    }
    [[nodiscard]] std::size_t index(std::size_t which) const {
        return which == 0 ? span.first : span.second;
    }
    [[nodiscard]] double shift(std::size_t which) const { return which == 0 ? 0 : span.shift; }
    [[nodiscard]] double weight(std::size_t which) const { return which == 0 ? 1 - b : b; }

    Side side;
    BlendingSpan span;
    double to;
    double w;
    double b;
    std::string_view family;
    Reading reading;
};

/// The four patches, number 2a + b the one that is a along u and b along v.
struct Cell {
    Cell(const BlendingSurface& of, const SurfacePlace& at)
        : surface(of), u(of.alongU(), at.u, at.sideU), v(of.alongV(), at.v, at.sideV) {
        for (std::size_t k = 0; k < 4; ++k) {
            points[k] = pointOf(k, u.span.t, v.span.t);
            products[k] = u.weight(k / 2) * v.weight(k % 2);
        }
        places = readingOf(points);
    }
    [[nodiscard]] Vec3 pointOf(std::size_t k, double atU, double atV) const {
        Vec3 point;
        surface.patch(u.index(k / 2), v.index(k % 2),
                      {atU - u.shift(k / 2), atV - v.shift(k % 2), u.side, v.side}, {}, {&point, 1});
        return point;
    }
    [[nodiscard]] std::vector<Vec3> outline(std::size_t k) const;
    [[nodiscard]] SentenceValues values() const;
    [[nodiscard]] std::string text(const Vec3& point) const { return readable(point, 3, places); }
    [[nodiscard]] std::string note(const Vec3& point) const { return noted(point, 3, places); }
    [[nodiscard]] std::string term(std::size_t k) const {
        return indexedTerm("P", u.index(k / 2), v.index(k % 2));
    }

    const BlendingSurface& surface;
    Along u;
    Along v;
    std::array<Vec3, 4> points;
    std::array<double, 4> products;
    Reading places;
};

/// The sides of a patch over the cell, once round.
std::vector<Vec3> Cell::outline(std::size_t k) const {
    const Interval alongU{u.span.start, u.to};
    const Interval alongV{v.span.start, v.to};
    std::vector<Vec3> round;
    for (std::size_t side = 0; side < 4; ++side) {
        for (std::size_t i = 0; i < sidePoints; ++i) {
            const std::size_t forth = side < 2 ? i : sidePoints - i;
            const double atU = uniformParameter(alongU, forth, sidePoints + 1);
            const double atV = uniformParameter(alongV, forth, sidePoints + 1);
            if (side % 2 == 0) {
                round.push_back(pointOf(k, atU, side == 0 ? alongV.start : alongV.end));
            } else {
                round.push_back(pointOf(k, side == 1 ? alongU.end : alongU.start, atV));
            }
        }
    }
    return round;
}

SentenceValues Cell::values() const {
    constexpr std::array<std::array<std::string_view, 3>, 4> names{
        {{"patch0", "weight0", "point0"},
         {"patch1", "weight1", "point1"},
         {"patch2", "weight2", "point2"},
         {"patch3", "weight3", "point3"}}};
    SentenceValues all{{"u", readable(u.span.t, u.reading)},
                       {"v", readable(v.span.t, v.reading)},
                       {"fromU", readable(u.span.start, u.reading)},
                       {"toU", readable(u.to, u.reading)},
                       {"fromV", readable(v.span.start, v.reading)},
                       {"toV", readable(v.to, v.reading)},
                       {"familyU", std::string(u.family)},
                       {"familyV", std::string(v.family)},
                       {"wu", readable(u.w)},
                       {"wv", readable(v.w)},
                       {"au", readable(1 - u.b)},
                       {"bu", readable(u.b)},
                       {"av", readable(1 - v.b)},
                       {"bv", readable(v.b)}};
    for (std::size_t k = 0; k < 4; ++k) {
        all.emplace_back(names[k][0],
                         readable(u.index(k / 2)) + ", " + readable(v.index(k % 2)));
        all.emplace_back(names[k][1], readable(products[k]));
        all.emplace_back(names[k][2], text(points[k]));
    }
    return all;
}

/// A frame with the four patches in the picture.
TraceFrame withPatches(const Sentence& sentence, const Cell& cell, SentenceValues values) {
    TraceFrame frame = tell(sentence, std::move(values));
    for (std::size_t k = 0; k < 4; ++k) addPolygon(frame, cell.outline(k), true);
    return frame;
}

/// The weight along a direction: B(w), or 1 − B(w) for the patch before.
std::string factor(std::size_t which, std::string_view variable) {
    const std::string value = "B_{" + std::string(variable) + "}(w_{" + std::string(variable) + "})";
    return which == 0 ? "(1-" + value + ")" : value;
}

TraceFrame beginFrame(const Cell& cell) {
    TraceFrame frame = withPatches(begin, cell, cell.values());
    std::string sum;
    for (std::size_t k = 0; k < 4; ++k) {
        if (k > 0) sum += "\\\\&+&";
        sum += factor(k / 2, "u") + factor(k % 2, "v") + cell.term(k);
    }
    frame.formula = mathml("\\table{S(u,v)&=&" + sum + "}");
    return frame;
}

std::string ratioRow(const Along& along, std::string_view variable) {
    const std::string name(variable);
    return "w_{" + name + "}&=&" +
           fraction(notedDifference(along.span.t, along.span.start, along.reading),
                    notedDifference(along.to, along.span.start, along.reading)) +
           "&=&" + noted(along.w) + "\\\\B_{" + name + "}(w_{" + name + "})&=&" + noted(along.b);
}

TraceFrame ratiosFrame(const Cell& cell) {
    TraceFrame frame = withPatches(ratios, cell, cell.values());
    frame.weights = {1 - cell.u.b, cell.u.b, 1 - cell.v.b, cell.v.b};
    frame.formula =
        mathml("\\table{" + ratioRow(cell.u, "u") + "\\\\" + ratioRow(cell.v, "v") + '}');
    return frame;
}

TraceFrame weightsFrame(const Cell& cell) {
    TraceFrame frame = withPatches(weights, cell, cell.values());
    const auto& w = cell.products;
    frame.weights.assign(w.begin(), w.end());
    frame.matrix = {{w[0], w[1]}, {w[2], w[3]}};
    const std::vector<std::vector<double>> column{{1 - cell.u.b}, {cell.u.b}};
    const std::vector<std::vector<double>> row{{1 - cell.v.b, cell.v.b}};
    frame.formula =
        mathml(notedMatrix(column) + notedMatrix(row) + "=" + notedMatrix(frame.matrix));
    return frame;
}

TraceFrame patchesFrame(const Cell& cell) {
    TraceFrame frame = withPatches(patches, cell, cell.values());
    for (const Vec3& point : cell.points) addMarked(frame, {&point, 1});
    frame.weights.assign(cell.products.begin(), cell.products.end());
    std::string rows;
    for (std::size_t k = 0; k < 4; ++k) {
        if (k > 0) rows += "\\\\";
        rows += cell.term(k) + "&=&" + cell.note(cell.points[k]);
    }
    frame.formula = mathml("\\table{" + rows + '}');
    return frame;
}

TraceFrame resultFrame(const Cell& cell) {
    Vec3 point(0);
    std::string sum;
    for (std::size_t k = 0; k < 4; ++k) {
        point += cell.products[k] * cell.points[k];
        if (k > 0) sum += "\\\\&+&";
        sum += noted(cell.products[k]) + cell.note(cell.points[k]);
    }
    SentenceValues values = cell.values();
    values.emplace_back("point", cell.text(point));
    TraceFrame frame = withPatches(result, cell, std::move(values));
    const std::size_t first = frame.points.size();
    frame.points.insert(frame.points.end(), cell.points.begin(), cell.points.end());
    frame.points.push_back(point);
    for (std::size_t k = 0; k < 4; ++k) frame.edges.push_back({first + k, first + 4});
    frame.marked.push_back(first + 4);
    frame.weights.assign(cell.products.begin(), cell.products.end());
    frame.formula =
        mathml("\\table{S(u,v)&=&" + sum + "\\\\&=&" + cell.note(point) + '}');
    return frame;
}

}  // namespace

Result<Trace> traceBlend(const BlendingSurface& surface, const SurfacePlace& at) {
    const Cell cell(surface, at);
    TraceWriter writer("blend");
    writer.add(beginFrame(cell));
    writer.add(ratiosFrame(cell));
    writer.add(weightsFrame(cell));
    writer.add(patchesFrame(cell));
    writer.add(resultFrame(cell));
    return std::move(writer).finish("surface");
}

}  // namespace knotwork::scene
