#include "scene/mesh_specs.hpp"

#include "geometry/solids.hpp"
#include "scene/fields.hpp"
#include "scene/obj.hpp"
#include "scene/parameter_fields.hpp"
#include "scene/validation.hpp"

#include <array>
#include <cmath>
#include <limits>
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

/// The specification with the creases that are asked for.
Result<Made<Mesh>> creased(Made<Mesh> made, const Json& given) {
    const Json* list = member(given, "creases");
    if (list == nullptr) return made;
    auto mesh = withCreases(made.value, *list);
    if (!mesh) return mesh.error();
    made.value = std::move(*mesh);
    if (!made.value.creases().empty()) made.spec["creases"] = describeCreases(made.value);
    return made;
}

Result<Made<Mesh>> makeNamed(const Json& given) {
    Json rest = given;
    rest.erase("creases");
    auto spec = readGroup(rest, solidFields);
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
    return creased({std::move(canonical), std::move(*mesh)}, given);
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
    rest.erase("creases");
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
    return creased({std::move(canonical), std::move(*mesh)}, given);
}

// ---- Creases -----------------------------------------------------------------------------------

Error wrongCrease(Code code, std::string path, const Json& given, const std::string& wanted) {
    return refuse(code, std::move(path), wanted + ", not " + describeValue(given) + ".");
}

Result<std::uint32_t> readEnd(const Json& given, std::string path) {
    const std::string wanted = "An edge names two vertices by their numbers";
    if (!given.is_number()) return wrongCrease(Code::wrongType, std::move(path), given, wanted);
    const double index = given.get<double>();
    if (!std::isfinite(index)) return wrongCrease(Code::notFinite, std::move(path), given, wanted);
    if (index != std::floor(index)) {
        return wrongCrease(Code::notInteger, std::move(path), given, wanted);
    }
    if (index < 0 || index > maxMeshVertices) {
        return wrongCrease(Code::outOfRange, std::move(path), given, wanted);
    }
    return static_cast<std::uint32_t>(index);
}

Result<double> readSharpness(const Json& crease, std::string path) {
    const std::string wanted = "A crease has a sharpness, a number up to 10 or \"infinite\"";
    const Json* given = member(crease, "sharpness");
    if (given == nullptr) return refuse(Code::wrongType, std::move(path), wanted + ".");
    if (*given == "infinite") return std::numeric_limits<double>::infinity();
    if (!given->is_number()) return wrongCrease(Code::wrongType, std::move(path), *given, wanted);
    const double sharpness = given->get<double>();
    if (!std::isfinite(sharpness)) {
        return wrongCrease(Code::notFinite, std::move(path), *given, wanted);
    }
    return sharpness;
}

Result<MeshCrease> readCrease(const Json& given, const std::string& path) {
    if (!given.is_object()) {
        return wrongCrease(Code::wrongType, path, given, "A crease is { edge, sharpness }");
    }
    for (const auto& item : given.items()) {
        if (item.key() == "edge" || item.key() == "sharpness") continue;
        return refuse(Code::unknownField, path + "." + item.key(),
                      "A crease has no field \"" + item.key() + "\"; it has edge and sharpness.");
    }
    const Json* edge = member(given, "edge");
    if (edge == nullptr || !edge->is_array() || edge->size() != 2) {
        return wrongCrease(Code::wrongType, path + ".edge", edge == nullptr ? Json() : *edge,
                           "A crease has an edge, the numbers of two vertices");
    }
    const auto v0 = readEnd((*edge)[0], path + ".edge[0]");
    if (!v0) return v0.error();
    const auto v1 = readEnd((*edge)[1], path + ".edge[1]");
    if (!v1) return v1.error();
    const auto sharpness = readSharpness(given, path + ".sharpness");
    if (!sharpness) return sharpness.error();
    return MeshCrease{*v0, *v1, *sharpness};
}

}  // namespace

Result<Mesh> withCreases(const Mesh& mesh, const Json& list) {
    if (!list.is_array()) {
        return wrongCrease(Code::wrongType, "creases", list,
                           "A mesh has a list of creases, each { edge, sharpness }");
    }
    std::vector<MeshCrease> creases;
    creases.reserve(list.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
        const auto crease = readCrease(list[i], indexed("creases", i));
        if (!crease) return crease.error();
        creases.push_back(*crease);
    }
    return mesh.withCreases(std::move(creases));
}

Json describeCreases(const Mesh& mesh) {
    Json list = Json::array();
    for (const MeshCrease& crease : mesh.creases()) {
        const Json sharpness =
            std::isfinite(crease.sharpness) ? Json(crease.sharpness) : Json("infinite");
        list.push_back({{"edge", Json::array({crease.v0, crease.v1})}, {"sharpness", sharpness}});
    }
    return list;
}

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
    Json spec{{"vertices", std::move(vertices)}, {"faces", std::move(faces)}};
    if (!mesh.creases().empty()) spec["creases"] = describeCreases(mesh);
    return spec;
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
