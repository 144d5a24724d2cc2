#include "scene/mesh_specs.hpp"

#include "geometry/solids.hpp"
#include "scene/fields.hpp"
#include "scene/obj.hpp"
#include "scene/parameter_fields.hpp"
#include "scene/validation.hpp"

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace knotwork::scene {

namespace {

constexpr std::array solidFields{
    Field{.name = "solid", .label = "Solid", .kind = FieldKind::text,
          .help = "The name of a solid such as \"cube\".", .required = true},
    Field{.name = "parameters", .label = "Parameters", .kind = FieldKind::namedNumbers,
          .help = "The numbers of its faces.", .defaultJson = "{}"},
};
constexpr std::array objFields{
    Field{.name = "obj", .label = "OBJ", .kind = FieldKind::text,
          .help = "The text of an OBJ file.", .required = true},
};
constexpr std::array verticesFields{
    Field{.name = "vertices", .label = "Vertices", .kind = FieldKind::points,
          .help = "The points of the mesh.", .required = true},
};

// ---- Solids and OBJ ----------------------------------------------------------------------------

Result<Made<Mesh>> makeNamed(const Json& given) {
    auto spec = readGroup(given, solidFields);
    if (!spec) return spec.error();
    const std::string name = stringOr(*spec, "solid", "");
    const std::vector<NamedValue> parameters = namedValues(*member(*spec, "parameters"));
    auto mesh = makeSolid(name, parameters);
    if (!mesh) return mesh.error();
    Json canonical{{"solid", name}};
    for (const ParameterDescription& parameter : findSolid(name)->parameters) {
        canonical["parameters"][std::string(parameter.name)] =
            numberOr((*spec)["parameters"], parameter.name, parameter.defaultValue);
    }
    return Made<Mesh>{std::move(canonical), std::move(*mesh)};
}

Result<Made<Mesh>> makeFromObj(const Json& given) {
    const auto spec = readGroup(given, objFields);
    if (!spec) return spec.error();
    auto mesh = readObj(stringOr(*spec, "obj", ""));
    if (!mesh) return mesh.error();
    Json canonical = specOf(*mesh);
    return Made<Mesh>{std::move(canonical), std::move(*mesh)};
}

// ---- Vertices and faces ------------------------------------------------------------------------

Error noIndex(Code code, std::size_t face, std::size_t corner, const std::string& what) {
    return refuse(code, indexed(indexed("faces", face), corner),
                  what + "; a face names vertices by their numbers, counted from 0.");
}

Result<std::uint32_t> readIndex(const Json& given, std::size_t face, std::size_t corner) {
    if (!given.is_number()) {
        return noIndex(Code::wrongType, face, corner, "This is " + describeValue(given));
    }
    const double index = given.get<double>();
    const std::string what = "The index is " + formatNumber(index);
    if (!std::isfinite(index)) return noIndex(Code::notFinite, face, corner, what);
    if (index != std::floor(index)) return noIndex(Code::notInteger, face, corner, what);
    if (index < 0 || index > maxMeshVertices) return noIndex(Code::outOfRange, face, corner, what);
    return static_cast<std::uint32_t>(index);
}

struct Faces {
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> starts{0};
};

Result<Faces> readFaces(const Json& given) {
    constexpr std::string_view wanted = "A mesh has a list of faces, each a list of vertices";
    if (!given.is_array()) {
        return refuse(Code::wrongType, "faces",
                      std::string(wanted) + ", not " + describeValue(given) + ".");
    }
    Faces faces;
    for (std::size_t f = 0; f < given.size(); ++f) {
        if (!given[f].is_array()) {
            return refuse(Code::wrongType, indexed("faces", f),
                          std::string(wanted) + ", not " + describeValue(given[f]) + ".");
        }
        for (std::size_t j = 0; j < given[f].size(); ++j) {
            const auto index = readIndex(given[f][j], f, j);
            if (!index) return index.error();
            faces.corners.push_back(*index);
        }
        faces.starts.push_back(static_cast<std::uint32_t>(faces.corners.size()));
    }
    return faces;
}

std::vector<Vec3> pointsOf(const Json& list) {
    std::vector<Vec3> points;
    points.reserve(list.size());
    for (const Json& p : list) {
        points.emplace_back(p[0].get<double>(), p[1].get<double>(),
                            p.size() > 2 ? p[2].get<double>() : 0.0);
    }
    return points;
}

Result<Made<Mesh>> makeExplicit(const Json& given) {
    Json rest = given;
    rest.erase("faces");
    const auto spec = readGroup(rest, verticesFields);
    if (!spec) {
        Error error = spec.error();
        if (error.code == Code::unknownField) {
            error.message = "A mesh has vertices and faces, or it is a solid with parameters, or "
                            "it is read from obj; it has no field \"" + error.path + "\" here.";
        }
        return error;
    }
    const Json* list = member(given, "faces");
    if (list == nullptr) {
        return refuse(Code::wrongType, "faces", "The field \"faces\" is missing.");
    }
    auto faces = readFaces(*list);
    if (!faces) return faces.error();
    auto mesh = Mesh::make(pointsOf(*member(*spec, "vertices")), std::move(faces->corners),
                           std::move(faces->starts));
    if (!mesh) return mesh.error();
    Json canonical = specOf(*mesh);
    return Made<Mesh>{std::move(canonical), std::move(*mesh)};
}

}  // namespace

Result<Made<Mesh>> makeMesh(const Json& spec) {
    if (!spec.is_object()) {
        return refuse(Code::wrongType, "",
                      "A mesh is an object such as { \"solid\": \"cube\" } or { \"vertices\": […], "
                      "\"faces\": […] }, not " + describeValue(spec) + ".");
    }
    if (member(spec, "solid") != nullptr) return makeNamed(spec);
    if (member(spec, "obj") != nullptr) return makeFromObj(spec);
    return makeExplicit(spec);
}

Json specOf(const Mesh& mesh) {
    Json::array_t vertices;
    vertices.reserve(mesh.points().size());
    for (const Vec3& p : mesh.points()) vertices.push_back(Json::array({p.x, p.y, p.z}));
    Json::array_t faces;
    for (std::size_t f = 0; f < mesh.faces().count(); ++f) {
        Json::array_t face;
        for (const std::uint32_t v : mesh.faces()[f]) face.emplace_back(v);
        faces.emplace_back(std::move(face));
    }
    return {{"vertices", std::move(vertices)}, {"faces", std::move(faces)}};
}

Json describeSolids() {
    Json list = Json::array();
    for (const SolidDescription& solid : solids()) {
        list.push_back({{"name", solid.name},
                        {"label", solid.label},
                        {"parameters", describeParameters(solid.parameters)}});
    }
    return list;
}

}  // namespace knotwork::scene
