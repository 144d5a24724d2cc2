// Subdivision of a mesh, step by step (E. Catmull, J. Clark, Recursively generated B-spline
// surfaces on arbitrary topological meshes, 1978): points on the faces, points on the edges, the
// vertices' new places, and the quads between them.
#include "geometry/mesh_subdivision.hpp"
#include "scene/trace_algorithms.hpp"
#include "scene/trace_formula.hpp"
#include "scene/trace_parts.hpp"

#include <algorithm>

namespace knotwork::scene {

namespace {

constexpr Sentence begin{
    "catmull-clark.begin", "A mesh of {faces} faces",
    "The mesh has {vertices} vertices, {edges} edges and {faces} faces; every level puts a point "
    "on each face and on each edge, moves the vertices, and joins all of them to quads."};
constexpr Sentence faceStep{
    "catmull-clark.faces", "Level {level}: face points",
    "Face points at level {level}: each is the mean of the vertices of its face, which makes "
    "{made} of them; the first one is {point}."};
constexpr Sentence edgeStep{
    "catmull-clark.edges", "Level {level}: edge points",
    "Edge points at level {level}: each is the mean of the ends of its edge and of the points of "
    "the faces on both sides, or on a boundary of the ends alone, which makes {made} of them; the "
    "first one is {point}."};
constexpr Sentence vertexStep{
    "catmull-clark.vertices", "Level {level}: vertex points",
    "Vertex points at level {level}: a vertex of n faces moves to F plus 2 R plus n minus 3 times "
    "itself, all of it divided by n, F being the mean of its face points and R that of the middles "
    "of its edges; on a boundary it keeps three quarters of itself. The first one moves from "
    "{before} to {point}."};
constexpr Sentence levelStep{
    "catmull-clark.level", "Level {level} of {levels}",
    "After level {level} of {levels} the mesh has {vertices} vertices, {edges} edges and {faces} "
    "faces, and all of them are quads."};

/// With so many vertices, the weights of a whole level are shown as a matrix.
constexpr std::size_t mostMatrixColumns = 30;
/// A face of more vertices is written with dots.
constexpr std::size_t mostTerms = 6;

/// A level of the mesh, the next one, and how points are read.
struct Step {
    const Mesh& mesh;
    const Mesh& finer;
    Reading places;
    int dimension;
    std::size_t number;

    [[nodiscard]] std::size_t firstFace() const { return mesh.points().size(); }
    [[nodiscard]] std::size_t firstEdge() const { return firstFace() + mesh.faces().count(); }
    [[nodiscard]] std::span<const Vec3> made(std::size_t from, std::size_t count) const {
        return finer.points().subspan(from, count);
    }
    [[nodiscard]] std::string text(const Vec3& p) const { return readable(p, dimension, places); }
    [[nodiscard]] std::string note(const Vec3& p) const { return noted(p, dimension, places); }
};

// ---- Pictures ----------------------------------------------------------------------------------

void addMesh(TraceFrame& frame, const Mesh& mesh) {
    frame.points.assign(mesh.points().begin(), mesh.points().end());
    for (const MeshEdge& edge : mesh.edges()) frame.edges.push_back({edge.v0, edge.v1});
}

void addPoints(TraceFrame& frame, std::span<const Vec3> points) {
    frame.points.insert(frame.points.end(), points.begin(), points.end());
}

/// So many of the last points are what this step has made.
void markLast(TraceFrame& frame, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        frame.marked.push_back(frame.points.size() - count + i);
    }
}

// ---- Face points -------------------------------------------------------------------------------

/// a + b + c, of a long list the first ones and the last.
std::string sumOf(const std::vector<std::string>& terms) {
    std::string text;
    for (std::size_t i = 0; i < terms.size(); ++i) {
        if (terms.size() > mostTerms && i == mostTerms - 2) {
            text += "+\\cdots ";
            i = terms.size() - 1;
        }
        text += (i > 0 ? "+" : "") + terms[i];
    }
    return text;
}

std::string meanFormula(const std::string& name, const std::vector<std::string>& terms,
                        const std::vector<std::string>& numbers, const std::string& result) {
    const std::string count = std::to_string(terms.size());
    return name + "&=&" + fraction(sumOf(terms), count) + "=" + fraction(sumOf(numbers), count) +
           "=" + result;
}

TraceFrame faceFrame(const Step& step) {
    const FaceRows faces = step.mesh.faces();
    const auto made = step.made(step.firstFace(), faces.count());
    TraceFrame frame = tell(faceStep, {{"level", readable(step.number)},
                                       {"made", readable(made.size())},
                                       {"point", step.text(made.front())}});
    addMesh(frame, step.mesh);
    addPoints(frame, made);
    markLast(frame, made.size());
    NotedRows rows;
    for (std::size_t f = 0; f < faces.count(); ++f) {
        std::vector<std::string> terms;
        std::vector<std::string> numbers;
        for (const std::uint32_t v : faces[f]) {
            frame.edges.push_back({v, step.firstFace() + f});
            terms.push_back(indexedTerm("v", v));
            numbers.push_back(step.note(step.mesh.points()[v]));
        }
        rows.add(meanFormula(indexedTerm("f", f), terms, numbers, step.note(made[f])));
    }
    const std::size_t size = faces[0].size();
    frame.weights.assign(size, 1 / static_cast<double>(size));
    frame.formula = mathml(rows.table());
    return frame;
}

// ---- Edge points -------------------------------------------------------------------------------

TraceFrame edgeFrame(const Step& step) {
    const auto edges = step.mesh.edges();
    const auto made = step.made(step.firstEdge(), edges.size());
    TraceFrame frame = tell(edgeStep, {{"level", readable(step.number)},
                                       {"made", readable(made.size())},
                                       {"point", step.text(made.front())}});
    addMesh(frame, step.mesh);
    addPoints(frame, step.made(step.firstFace(), step.mesh.faces().count() + made.size()));
    markLast(frame, made.size());
    NotedRows rows;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const MeshEdge& edge = edges[e];
        std::vector<std::string> terms{indexedTerm("v", edge.v0), indexedTerm("v", edge.v1)};
        std::vector<std::string> numbers{step.note(step.mesh.points()[edge.v0]),
                                         step.note(step.mesh.points()[edge.v1])};
        if (!edge.onBoundary()) {
            for (const std::uint32_t face : {edge.f0, edge.f1}) {
                const std::size_t point = step.firstFace() + face;
                frame.edges.push_back({point, step.firstEdge() + e});
                terms.push_back(indexedTerm("f", face));
                numbers.push_back(step.note(step.finer.points()[point]));
            }
        }
        rows.add(meanFormula(indexedTerm("e", e), terms, numbers, step.note(made[e])));
    }
    const bool allOnBoundary = std::all_of(edges.begin(), edges.end(),
                                           [](const MeshEdge& edge) { return edge.onBoundary(); });
    frame.weights.assign(allOnBoundary ? 2 : 4, allOnBoundary ? 0.5 : 0.25);
    frame.formula = mathml(rows.table());
    return frame;
}

// ---- Vertex points -----------------------------------------------------------------------------

/// What is around a vertex.
struct Around {
    Vec3 facePoints{0};  ///< their sum
    Vec3 middles{0};     ///< of its edges, their sum
    Vec3 beside{0};      ///< the sum of its neighbours along the boundary
    double faces = 0;
    double edges = 0;
    double boundaryEdges = 0;
};

std::vector<Around> lookAround(const Step& step) {
    const auto points = step.mesh.points();
    std::vector<Around> around(points.size());
    const FaceRows faces = step.mesh.faces();
    for (std::size_t f = 0; f < faces.count(); ++f) {
        for (const std::uint32_t v : faces[f]) {
            around[v].facePoints += step.finer.points()[step.firstFace() + f];
            around[v].faces += 1;
        }
    }
    for (const MeshEdge& edge : step.mesh.edges()) {
        for (const auto& ends : {std::pair(edge.v0, edge.v1), std::pair(edge.v1, edge.v0)}) {
            Around& at = around[ends.first];
            at.middles += 0.5 * (points[edge.v0] + points[edge.v1]);
            at.edges += 1;
            if (!edge.onBoundary()) continue;
            at.beside += points[ends.second];
            at.boundaryEdges += 1;
        }
    }
    return around;
}

std::string vertexFormula(const Step& step, const Around& around, std::size_t v) {
    const std::string own = indexedTerm("v", v);
    const std::string number = step.note(step.mesh.points()[v]);
    const std::string result = step.note(step.finer.points()[v]);
    const std::string name = levelTerm("v", v, step.number) + "&=&";
    if (around.faces == 0) return name + own + "=" + result;
    if (around.boundaryEdges > 0) {
        const Vec3 mean = around.beside / around.boundaryEdges;
        return name + fraction("3" + own + "+B", "4") + "=" +
               fraction("3\\cdot " + number + "+" + step.note(mean), "4") + "=" + result;
    }
    const double n = around.faces;
    const std::string count = noted(n);
    const std::string factor = noted(n - 3);
    return name + fraction("F+2R+" + (n < 3 ? "(" + factor + ")" : factor) + own, count) + "=" +
           fraction(step.note(around.facePoints / n) + "+2\\cdot " +
                        step.note(around.middles / around.edges) + "+" +
                        (n < 3 ? "(" + factor + ")" : factor) + "\\cdot " + number,
                    count) +
           "=" + result;
}

TraceFrame vertexFrame(const Step& step) {
    const auto points = step.mesh.points();
    const auto made = step.made(0, points.size());
    TraceFrame frame = tell(vertexStep, {{"level", readable(step.number)},
                                         {"before", step.text(points.front())},
                                         {"point", step.text(made.front())}});
    addMesh(frame, step.mesh);
    addPoints(frame, made);
    markLast(frame, made.size());
    const std::vector<Around> around = lookAround(step);
    NotedRows rows;
    for (std::size_t v = 0; v < points.size(); ++v) {
        frame.edges.push_back({v, points.size() + v});
        rows.add(vertexFormula(step, around[v], v));
    }
    const auto inner = std::find_if(around.begin(), around.end(), [](const Around& a) {
        return a.faces > 0 && a.boundaryEdges == 0;
    });
    if (inner == around.end()) {
        frame.weights = {0.75, 0.25};
    } else {
        frame.weights = {1 / inner->faces, 2 / inner->faces, (inner->faces - 3) / inner->faces};
    }
    frame.formula = mathml(rows.table());
    return frame;
}

// ---- Levels ------------------------------------------------------------------------------------

SentenceValues countsOf(const Mesh& mesh) {
    const MeshCounts counts = mesh.counts();
    return {{"vertices", readable(counts.vertices)},
            {"edges", readable(counts.edges)},
            {"faces", readable(counts.faces)}};
}

/// Row by row, how much every vertex of a mesh counts for each of the finer one.
std::vector<std::vector<double>> weightsOf(const Mesh& mesh) {
    const std::size_t columns = mesh.points().size();
    std::vector<std::vector<double>> rows;
    for (std::size_t column = 0; column < columns; column += 3) {  // three unknowns a point
        std::vector<Vec3> units(columns, Vec3{0});
        for (std::size_t axis = 0; axis < 3 && column + axis < columns; ++axis) {
            units[column + axis][static_cast<int>(axis)] = 1;
        }
        std::vector<std::uint32_t> corners(mesh.corners().begin(), mesh.corners().end());
        std::vector<std::uint32_t> starts(mesh.faceStarts().begin(), mesh.faceStarts().end());
        const Mesh unit = mesh.uniformSize() != 0
                              ? Mesh::trusted(units, std::move(corners), mesh.uniformSize())
                              : Mesh::trusted(units, std::move(corners), std::move(starts));
        const auto finer = subdivide(unit, MeshScheme::catmullClark, 1);
        rows.resize(finer->points().size());
        for (std::size_t row = 0; row < rows.size(); ++row) {
            for (std::size_t axis = 0; axis < 3 && column + axis < columns; ++axis) {
                rows[row].push_back(finer->points()[row][static_cast<int>(axis)]);
            }
        }
    }
    return rows;
}

TraceFrame levelFrame(const Step& step, int levels) {
    SentenceValues values = countsOf(step.finer);
    values.insert(values.end(), {{"level", readable(step.number)},
                                 {"levels", std::to_string(levels)}});
    TraceFrame frame = tell(levelStep, std::move(values));
    addMesh(frame, step.finer);
    if (step.mesh.points().size() <= mostMatrixColumns) frame.matrix = weightsOf(step.mesh);
    return frame;
}

int dimensionOf(std::span<const Vec3> points) {
    const bool planar = std::all_of(points.begin(), points.end(),
                                    [](const Vec3& p) { return p.z == 0; });
    return planar ? 2 : 3;
}

}  // namespace

Result<Trace> traceCatmullClark(const Mesh& mesh, int levels) {
    TraceWriter writer("catmull-clark");
    TraceFrame first = tell(begin, countsOf(mesh));
    addMesh(first, mesh);
    writer.add(std::move(first));
    Mesh coarse = mesh;
    for (int level = 1; level <= levels && !writer.full(); ++level) {
        const auto finer = subdivide(coarse, MeshScheme::catmullClark, 1);
        if (!finer) return finer.error();
        const Step step{coarse, *finer, readingOf(mesh.points()), dimensionOf(mesh.points()),
                        static_cast<std::size_t>(level)};
        writer.add(faceFrame(step));
        writer.add(edgeFrame(step));
        writer.add(vertexFrame(step));
        writer.add(levelFrame(step, levels));
        coarse = *finer;
    }
    return std::move(writer).finish("levels");
}

}  // namespace knotwork::scene
