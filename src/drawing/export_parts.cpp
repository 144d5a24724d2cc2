#include "drawing/export_parts.hpp"

#include "drawing/extent.hpp"
#include "drawing/normals.hpp"
#include "geometry/surface_tessellation.hpp"
#include "geometry/tessellation.hpp"
#include "geometry/triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace knotwork::drawing {

namespace {

constexpr double curveShare = 1e-4;
constexpr double surfaceShare = 1e-3;
constexpr std::size_t graphChords = 256;

class PartMaker {
public:
    PartMaker(const scene::State& state, const ExportOptions& options)
        : state_(state), options_(options) {}

    Result<std::vector<ExportPart>> make() {
        const double size = options_.tolerance ? 0 : roughSize(state_, options_.moment);
        curveTolerance_ = options_.tolerance.value_or(curveShare * size);
        surfaceTolerance_ = options_.tolerance.value_or(surfaceShare * size);
        for (const scene::Placed& placed : scene::place(state_, options_.moment)) {
            auto added = add(placed);
            if (!added) return added.error();
        }
        return std::move(parts_);
    }

private:
    Result<Done> add(const scene::Placed& placed) {
        const scene::Body& body = placed.body;
        if (body.curve() != nullptr) return curve(placed, *body.curve());
        if (body.surface() != nullptr) return surface(placed, *body.surface());
        if (body.subdivision() != nullptr) mesh(placed, body.subdivision()->refined);
        if (body.graph() != nullptr) graph(placed, *body.graph());
        if (body.cloud() == nullptr) return Done{};
        points(placed, body.cloud()->points);
        return body.cloud()->fit ? curve(placed, body.cloud()->fit->curve) : Done{};
    }

    ExportPart& begin(const scene::Placed& placed, ExportPart::Kind kind) {
        ExportPart part;
        part.name = placed.object->id;
        part.kind = kind;
        part.colour = placed.colour;
        parts_.push_back(std::move(part));
        return parts_.back();
    }

    static void place(ExportPart& part, const scene::Placed& placed, const Vec3& p) {
        const Vec3 at = placed.placement.point(p);
        part.xyz.insert(part.xyz.end(), {at.x, at.y, at.z});
    }

    Result<Done> curve(const scene::Placed& placed, const Curve& curve) {
        auto line = polylineWithin(curve, curveTolerance_);
        if (!line) return line.error();
        bool going = false;
        for (std::size_t i = 0; i < line->parameters.size(); ++i) {
            const double* xyz = line->xyz.data() + 3 * i;
            const Vec3 p(xyz[0], xyz[1], xyz[2]);
            const bool jumps = i > 0 && line->parameters[i] == line->parameters[i - 1];
            if (isFinite(p) && (!going || jumps)) begin(placed, ExportPart::Kind::line);
            going = isFinite(p);
            if (!going) continue;
            place(parts_.back(), placed, p);
            parts_.back().parameters.push_back(line->parameters[i]);
        }
        return Done{};
    }

    /// As far as the function has values.
    void graph(const scene::Placed& placed, const scene::FunctionGraph& graph) {
        bool going = false;
        for (std::size_t i = 0; i <= graphChords; ++i) {
            const double t = uniformParameter({0, 1}, i, graphChords + 1);
            const double value = graph.candidate.value(t);
            if (std::isfinite(value) && !going) begin(placed, ExportPart::Kind::line);
            going = std::isfinite(value);
            if (!going) continue;
            place(parts_.back(), placed, graph.at + graph.size * Vec3(t, value, 0));
            parts_.back().parameters.push_back(t);
        }
    }

    void points(const scene::Placed& placed, const std::vector<Vec3>& points) {
        if (points.empty()) return;
        ExportPart& part = begin(placed, ExportPart::Kind::points);
        for (const Vec3& p : points) place(part, placed, p);
    }

    Result<Done> surface(const scene::Placed& placed, const Surface& surface) {
        auto made = trianglesWithin(surface, surfaceTolerance_);
        if (!made) return made.error();
        ExportPart& part = begin(placed, ExportPart::Kind::faces);
        for (std::size_t i = 0; i < made->positions.size(); i += 3) {
            const double* p = made->positions.data() + i;
            place(part, placed, {p[0], p[1], p[2]});
        }
        part.normals = std::move(made->normals);
        part.parameters = std::move(made->parameters);
        part.triangles = std::move(made->triangles);
        part.corners = part.triangles;
        orient(part, placed.placement.linear);
        return Done{};
    }

    void mesh(const scene::Placed& placed, const Mesh& mesh) {
        ExportPart& part = begin(placed, ExportPart::Kind::faces);
        for (const Vec3& p : mesh.points()) place(part, placed, p);
        const FaceRows faces = mesh.faces();
        part.corners.assign(faces.corners.begin(), faces.corners.end());
        for (std::size_t f = 0; f <= faces.count(); ++f) {
            part.starts.push_back(static_cast<std::uint32_t>(faces.begin(f)));
        }
        part.triangles = triangleIndices(mesh);
        part.normals.resize(3 * mesh.points().size());
        vertexNormals(mesh, part.normals);
        orient(part, placed.placement.linear);
    }

    /// Turns the normals with the object, and the faces where a reflection has turned them over.
    static void orient(ExportPart& part, const Mat3& map) {
        turnNormals(part.normals, map);
        completeNormals(part.normals);  // formats have no place for none
        if (!mirrors(map)) return;
        reverseFaces(part.triangles, {});
        reverseFaces(part.corners, part.starts);
    }

    static void reverseFaces(std::vector<std::uint32_t>& corners,
                             const std::vector<std::uint32_t>& starts) {
        const std::size_t faces = starts.empty() ? corners.size() / 3 : starts.size() - 1;
        for (std::size_t f = 0; f < faces; ++f) {
            const std::size_t from = starts.empty() ? 3 * f : starts[f];
            const std::size_t to = starts.empty() ? from + 3 : starts[f + 1];
            std::reverse(corners.begin() + static_cast<std::ptrdiff_t>(from),
                         corners.begin() + static_cast<std::ptrdiff_t>(to));
        }
    }

    const scene::State& state_;
    const ExportOptions& options_;
    double curveTolerance_ = 0;
    double surfaceTolerance_ = 0;
    std::vector<ExportPart> parts_;
};

}  // namespace

Result<std::vector<ExportPart>> exportParts(const scene::State& state,
                                            const ExportOptions& options) {
    return PartMaker(state, options).make();
}

}  // namespace knotwork::drawing
