#include "drawing/export_parts.hpp"

#include "drawing/extent.hpp"
#include "drawing/normals.hpp"
#include "geometry/mesh_normals.hpp"
#include "geometry/surface_tessellation.hpp"
#include "geometry/tessellation.hpp"
#include "geometry/triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace knotwork::drawing {

namespace {

constexpr double curveShare = 1e-4;
constexpr double surfaceShare = 1e-3;
constexpr std::size_t graphChords = 256;

// What things weigh, in numbers written as text (sliced_work.hpp).
constexpr double numberPlaced = 0.05;
constexpr double cornerTurned = 0.5;     // the angle at a corner
constexpr double faceCut = 0.2;
constexpr double adaptive = 50'000;      // a curve or surface, made to a tolerance
constexpr double writtenAdaptive = 5000;

class PartMaker {
public:
    PartMaker(ExportRun& run, ExportNeeds needs)
        : run_(run), needs_(needs), placed_(scene::place(run.state, run.options.moment)) {
        const std::optional<double> asked = run.options.tolerance;
        const double size = asked ? 0 : roughSize(run.state, run.options.moment);
        curveTolerance_ = asked.value_or(curveShare * size);
        surfaceTolerance_ = asked.value_or(surfaceShare * size);
    }

    /// One step an object; they keep the maker.
    static void plan(const std::shared_ptr<PartMaker>& maker) {
        for (std::size_t i = 0; i < maker->placed_.size(); ++i) {
            const double weight = maker->weightOf(maker->placed_[i].body);
            maker->run_.work.step(weight, [maker, i] { maker->add(maker, maker->placed_[i]); });
        }
    }

    /// Of all that is written of the parts, about.
    [[nodiscard]] double writtenWeight() const {
        double weight = 0;
        for (const scene::Placed& placed : placed_) {
            const auto* mesh = placed.body.subdivision();
            const auto* cloud = placed.body.cloud();
            weight += mesh != nullptr ? meshNumbers(mesh->refined)
                      : cloud != nullptr ? 3.0 * static_cast<double>(cloud->points.size())
                                         : writtenAdaptive;
        }
        return weight;
    }

private:
    static double meshNumbers(const Mesh& mesh) noexcept {
        return 3.0 * static_cast<double>(mesh.points().size() + mesh.corners().size());
    }

    [[nodiscard]] double weightOf(const scene::Body& body) const {
        if (body.subdivision() == nullptr) return adaptive;
        const Mesh& mesh = body.subdivision()->refined;
        return numberPlaced * meshNumbers(mesh) +
               (needs_.normals ? cornerTurned * static_cast<double>(mesh.corners().size()) : 0);
    }

    void add(const std::shared_ptr<PartMaker>& self, const scene::Placed& placed) {
        const scene::Body& body = placed.body;
        if (body.curve() != nullptr) return curve(self, placed, *body.curve());
        if (body.surface() != nullptr) return surface(self, placed, *body.surface());
        if (body.subdivision() != nullptr) return mesh(self, placed, body.subdivision()->refined);
        if (body.graph() != nullptr) return graph(placed, *body.graph());
        if (body.cloud() == nullptr) return;
        points(placed, body.cloud()->points);
        if (body.cloud()->fit) curve(self, placed, body.cloud()->fit->curve);
    }

    ExportPart& begin(const scene::Placed& placed, ExportPart::Kind kind) {
        ExportPart part;
        part.name = placed.object->id;
        part.kind = kind;
        part.colour = placed.colour;
        run_.parts.push_back(std::move(part));
        return run_.parts.back();
    }

    static void place(ExportPart& part, const scene::Placed& placed, const Vec3& p) {
        const Vec3 at = placed.placement.point(p);
        part.xyz.insert(part.xyz.end(), {at.x, at.y, at.z});
    }

    void curve(const std::shared_ptr<PartMaker>& self, const scene::Placed& placed,
               const Curve& curve) {
        planPolyline(run_.work, curve, curveTolerance_, [self, &placed](const Result<Polyline>& line) {
            if (line) self->addLine(placed, *line);
            else self->run_.refuse(line.error());
        });
    }

    void addLine(const scene::Placed& placed, const Polyline& line) {
        bool going = false;
        for (std::size_t i = 0; i < line.parameters.size(); ++i) {
            const double* xyz = line.xyz.data() + 3 * i;
            const Vec3 p(xyz[0], xyz[1], xyz[2]);
            const bool jumps = i > 0 && line.parameters[i] == line.parameters[i - 1];
            if (isFinite(p) && (!going || jumps)) begin(placed, ExportPart::Kind::line);
            going = isFinite(p);
            if (!going) continue;
            place(run_.parts.back(), placed, p);
            run_.parts.back().parameters.push_back(line.parameters[i]);
        }
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
            place(run_.parts.back(), placed, graph.at + graph.size * Vec3(t, value, 0));
            run_.parts.back().parameters.push_back(t);
        }
    }

    void points(const scene::Placed& placed, const std::vector<Vec3>& points) {
        if (points.empty()) return;
        ExportPart& part = begin(placed, ExportPart::Kind::points);
        for (const Vec3& p : points) place(part, placed, p);
    }

    void surface(const std::shared_ptr<PartMaker>& self, const scene::Placed& placed,
                 const Surface& surface) {
        planTriangles(run_.work, surface, surfaceTolerance_,
                      [self, &placed](Result<SurfaceTriangles> made) {
                          if (made) self->addTriangles(placed, *std::move(made));
                          else self->run_.refuse(made.error());
                      });
    }

    void addTriangles(const scene::Placed& placed, SurfaceTriangles made) {
        ExportPart& part = begin(placed, ExportPart::Kind::faces);
        part.xyz.reserve(made.positions.size());
        for (std::size_t i = 0; i < made.positions.size(); i += 3) {
            const double* p = made.positions.data() + i;
            place(part, placed, {p[0], p[1], p[2]});
        }
        part.parameters = std::move(made.parameters);
        if (needs_.normals) part.normals = std::move(made.normals);
        if (needs_.triangles) part.triangles = made.triangles;
        if (needs_.corners) part.corners = std::move(made.triangles);
        orient(part, placed.placement.linear);
    }

    /// The lists of a mesh, each in a loop or step of its own.
    void mesh(const std::shared_ptr<PartMaker>& self, const scene::Placed& placed,
              const Mesh& mesh) {
        begin(placed, ExportPart::Kind::faces).xyz.reserve(3 * mesh.points().size());
        const std::size_t k = run_.parts.size() - 1;
        const auto vertices = static_cast<double>(mesh.points().size());
        const auto faces = static_cast<double>(mesh.faces().count());
        run_.work.loop(mesh.points().size(), 3 * numberPlaced * vertices,
                       [self, &placed, mesh, k](std::size_t first, std::size_t last) {
                           ExportPart& part = self->run_.parts[k];
                           for (const Vec3& p : mesh.points().subspan(first, last - first)) {
                               place(part, placed, p);
                           }
                       });
        run_.work.step(faceCut * faces, [self, mesh, k] { self->addFaces(mesh, k); });
        if (needs_.normals) addNormals(self, mesh, k);
        run_.work.step(faceCut * faces, [self, &placed, k] {
            orient(self->run_.parts[k], placed.placement.linear);
        });
    }

    void addFaces(const Mesh& mesh, std::size_t k) {
        ExportPart& part = run_.parts[k];
        if (needs_.triangles) part.triangles = triangleIndices(mesh);
        if (!needs_.corners) return;
        const FaceRows faces = mesh.faces();
        part.corners.assign(faces.corners.begin(), faces.corners.end());
        for (std::size_t f = 0; f <= faces.count(); ++f) {
            part.starts.push_back(static_cast<std::uint32_t>(faces.begin(f)));
        }
    }

    void addNormals(const std::shared_ptr<PartMaker>& self, const Mesh& mesh, std::size_t k) {
        const std::size_t vertices = mesh.points().size();
        run_.work.loop(mesh.faces().count(),
                       cornerTurned * static_cast<double>(mesh.corners().size()),
                       [self, sums = NormalSums(mesh), vertices, k](std::size_t first,
                                                                   std::size_t last) {
                           std::vector<double>& normals = self->run_.parts[k].normals;
                           normals.resize(3 * vertices);
                           sums.add(first, last, normals);
                       });
        run_.work.step(3 * numberPlaced * static_cast<double>(vertices), [self, k] {
            NormalSums::normalise(self->run_.parts[k].normals);
        });
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

    ExportRun& run_;
    ExportNeeds needs_;
    std::vector<scene::Placed> placed_;
    double curveTolerance_ = 0;
    double surfaceTolerance_ = 0;
};

}  // namespace

void planParts(ExportRun& run, ExportNeeds needs, std::function<void()> write) {
    run.work.step(0, [&run, needs, write = std::move(write)] {
        const auto maker = std::make_shared<PartMaker>(run, needs);
        PartMaker::plan(maker);
        run.work.step(maker->writtenWeight(), write);
    });
}

}  // namespace knotwork::drawing
