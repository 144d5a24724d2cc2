#include "scene/trace.hpp"

#include "geometry/named.hpp"
#include "scene/json_values.hpp"
#include "scene/mesh_specs.hpp"
#include "scene/specs.hpp"
#include "scene/surface_specs.hpp"
#include "scene/trace_algorithms.hpp"
#include "scene/validation.hpp"


namespace knotwork::scene {

namespace {

constexpr Field algorithmField{.name = "algorithm", .label = "Algorithm", .kind = FieldKind::text,
                               .help = "What is traced.", .required = true};
constexpr Field curveField{.name = "curve", .label = "Curve", .kind = FieldKind::curve,
                           .help = "The curve that the algorithm works on.", .required = true};
constexpr Field pointsField{.name = "points", .label = "Points", .kind = FieldKind::points,
                            .help = "The polygon.", .required = true};
constexpr Field closedField{.name = "closed", .label = "Closed", .kind = FieldKind::flag,
                            .help = "Whether the last point is joined to the first.",
                            .defaultJson = "false"};
constexpr Field levelsField{.name = "levels", .label = "Levels", .kind = FieldKind::integer,
                            .help = "How often the polygon is refined.", .min = 0,
                            .max = maxSubdivisionLevels, .maxIsSize = true, .defaultJson = "1"};

constexpr std::array parameterFields{
    algorithmField, curveField,
    Field{.name = "t", .label = "Parameter", .kind = FieldKind::number,
          .help = "Where the curve is evaluated.", .required = true}};
constexpr std::array placeFields{
    algorithmField,
    Field{.name = "surface", .label = "Surface", .kind = FieldKind::surface,
          .help = "The surface that the algorithm works on.", .required = true},
    Field{.name = "u", .label = "u", .kind = FieldKind::number,
          .help = "Where the surface is evaluated.", .required = true},
    Field{.name = "v", .label = "v", .kind = FieldKind::number,
          .help = "Where the surface is evaluated.", .required = true}};
constexpr std::array knotFields{
    algorithmField, curveField,
    Field{.name = "knot", .label = "Knot", .kind = FieldKind::number,
          .help = "The knot that is put in.", .required = true}};
constexpr std::array knotsFields{
    algorithmField, curveField,
    Field{.name = "knots", .label = "Knots", .kind = FieldKind::numbers,
          .help = "All knots of the refined curve, of one period where it is closed.",
          .required = true}};
constexpr std::array laneFields{
    algorithmField, pointsField, closedField,
    Field{.name = "degree", .label = "Degree", .kind = FieldKind::integer,
          .help = "The degree of the spline that is the limit.", .min = 1, .max = maxDegree,
          .maxIsSize = true, .defaultJson = "3"},
    levelsField};
constexpr std::array fourPointFields{
    algorithmField, pointsField, closedField,
    Field{.name = "tension", .label = "Tension", .kind = FieldKind::number,
          .help = "How much the outer neighbours count.", .min = -1, .max = 1,
          .defaultJson = "0.0625"},
    levelsField};

/// Beside `mesh`, which makeMesh() checks.
constexpr std::array meshFields{
    algorithmField,
    Field{.name = "levels", .label = "Levels", .kind = FieldKind::integer,
          .help = "How often the mesh is refined.", .min = 0, .max = maxSubdivisionLevels,
          .maxIsSize = true, .defaultJson = "1"}};

/// The curve behind the field, of the kind that the algorithm works on.
template <class Kind>
Result<Curve> curveFrom(const Json& arguments, std::string_view type) {
    const Json& spec = *member(arguments, "curve");
    auto made = makeCurve(spec);
    if (!made) return made.error().under("curve");
    if (made->value.template as<Kind>() != nullptr) return std::move(made->value);
    return refuse(Code::notSupported, "curve.type",
                  "This algorithm works on a " + std::string(type) + "; the curve given is a " +
                      stringOr(spec, "type", "") + ".");
}

template <class Kind>
Result<Trace> traceAt(const Json& arguments, std::string_view type,
                      Result<Trace> (*trace)(const Kind&, double)) {
    const auto curve = curveFrom<Kind>(arguments, type);
    if (!curve) return curve.error();
    const auto t = parameterInDomain(*curve, numberOr(arguments, "t", 0));
    if (!t) return t.error();
    return trace(*curve->template as<Kind>(), *t);
}

constexpr std::string_view spline = "bspline-curve";

Result<Trace> boehmOf(const Json& arguments) {
    const auto curve = curveFrom<BsplineCurve>(arguments, spline);
    if (!curve) return curve.error();
    return traceBoehm(*curve->as<BsplineCurve>(), numberOr(arguments, "knot", 0));
}

Result<Trace> osloOf(const Json& arguments) {
    const auto curve = curveFrom<BsplineCurve>(arguments, spline);
    if (!curve) return curve.error();
    return traceOslo(*curve->as<BsplineCurve>(), numbersOf(*member(arguments, "knots")));
}

Result<Trace> blendSurfaceOf(const Json& arguments) {
    const Json& spec = *member(arguments, "surface");
    const auto made = makeSurface(spec);
    if (!made) return made.error().under("surface");
    const auto* blend = made->value.as<BlendingSurface>();
    if (blend == nullptr) {
        return refuse(Code::notSupported, "surface.type",
                      "This algorithm works on a blending-surface; the surface given is a " +
                          stringOr(spec, "type", "") + ".");
    }
    const auto at =
        placeInDomain(made->value, numberOr(arguments, "u", 0), numberOr(arguments, "v", 0));
    if (!at) return at.error();
    return traceBlend(*blend, *at);
}

CurveSubdivision subdivisionOf(const Json& arguments, CurveScheme scheme) {
    CurveSubdivision input{.scheme = scheme, .points = {}};
    input.closed = flagOr(arguments, "closed", false);
    input.levels = static_cast<int>(numberOr(arguments, "levels", 1));
    input.degree = static_cast<int>(numberOr(arguments, "degree", input.degree));
    input.tension = numberOr(arguments, "tension", input.tension);
    for (const Json& point : *member(arguments, "points")) input.points.push_back(vec3Of(point));
    return input;
}

Result<Trace> catmullClarkOf(const Json& given) {
    const Json* spec = member(given, "mesh");
    if (spec == nullptr) {
        return refuse(Code::wrongType, "mesh",
                      "The field \"mesh\" is missing: The mesh that the algorithm works on.");
    }
    Json rest = given;
    rest.erase("mesh");
    const auto arguments = readGroup(rest, FieldTable(meshFields).all());
    if (!arguments) return arguments.error();
    const auto mesh = makeMesh(*spec);
    if (!mesh) return mesh.error().under("mesh");
    if (!mesh->value.creases().empty()) {
        return refuse(Code::notSupported, "mesh.creases",
                      "The steps shown are those of a mesh without creases; leave them out.");
    }
    return traceCatmullClark(mesh->value, static_cast<int>(numberOr(*arguments, "levels", 1)));
}

/// In the order in which refusals list them.
struct Algorithm {
    std::string_view name;
    FieldTable fields;  ///< none where the function reads what is given itself
    Result<Trace> (*trace)(const Json& arguments);
};

constexpr std::array algorithms{
    Algorithm{"de-boor", parameterFields,
              [](const Json& a) { return traceAt<BsplineCurve>(a, spline, traceDeBoor); }},
    Algorithm{"cox-de-boor", parameterFields,
              [](const Json& a) { return traceAt<BsplineCurve>(a, spline, traceCoxDeBoor); }},
    Algorithm{"factor-matrices", parameterFields,
              [](const Json& a) { return traceAt<BsplineCurve>(a, spline, traceFactorMatrices); }},
    Algorithm{"boehm", knotFields, boehmOf},
    Algorithm{"oslo", knotsFields, osloOf},
    Algorithm{"lane-riesenfeld", laneFields,
              [](const Json& a) {
                  return traceLaneRiesenfeld(subdivisionOf(a, CurveScheme::laneRiesenfeld));
              }},
    Algorithm{"four-point", fourPointFields,
              [](const Json& a) {
                  return traceFourPoint(subdivisionOf(a, CurveScheme::fourPoint));
              }},
    Algorithm{"blend", parameterFields,
              [](const Json& a) {
                  return traceAt<BlendingCurve>(a, "blending-curve", traceBlend);
              }},
    Algorithm{"catmull-clark", {}, catmullClarkOf},
};

/// What `blend` does with a surface instead of a curve.
constexpr Algorithm surfaceBlend{"blend", placeFields, blendSurfaceOf};

std::string algorithmNames() {
    std::string names;
    for (const Algorithm& algorithm : algorithms) {
        if (!names.empty()) names += ", ";
        names += algorithm.name;
    }
    return names;
}

Result<const Algorithm*> algorithmOf(const Json& given) {
    if (!given.is_object()) {
        return refuse(Code::wrongType, "",
                      "Expected an object such as { \"algorithm\": \"de-boor\", … }, got " +
                          describeValue(given) + ".");
    }
    const Json* name = member(given, "algorithm");
    if (name == nullptr || !name->is_string()) {
        return refuse(Code::wrongType, "algorithm",
                      "A trace needs the name of its algorithm, one of " + algorithmNames() + ".");
    }
    const auto& text = name->get_ref<const std::string&>();
    if (const Algorithm* found = findNamed(algorithms, &Algorithm::name, text)) {
        const bool ofSurface = text == surfaceBlend.name && member(given, "surface") != nullptr;
        return ofSurface ? &surfaceBlend : found;
    }
    return refuse(Code::unknownName, "algorithm",
                  "\"" + text + "\" is not known here; choose one of " + algorithmNames() + ".");
}

Json frameJson(const TraceFrame& frame) {
    Json json{{"title", frame.title}, {"text", frame.text}};
    Json& points = json["points"] = Json::array();
    for (const Vec3& point : frame.points) points.push_back(pointJson(point, 3));
    Json& edges = json["edges"] = Json::array();
    for (const auto& edge : frame.edges) edges.push_back(Json::array({edge[0], edge[1]}));
    json["marked"] = frame.marked;
    if (!frame.weights.empty()) json["weights"] = listOf(frame.weights);
    if (!frame.matrix.empty()) {
        Json& rows = json["matrix"] = Json::array();
        for (const auto& row : frame.matrix) rows.push_back(listOf(row));
    }
    if (!frame.formula.empty()) json["formula"] = frame.formula;
    json["key"] = frame.key;
    Json& values = json["values"] = Json::object();
    for (const auto& value : frame.values) values[std::string(value.first)] = value.second;
    return json;
}

}  // namespace

Result<Trace> makeTrace(const Json& given) {
    const auto algorithm = algorithmOf(given);
    if (!algorithm) return algorithm.error();
    if ((*algorithm)->fields.all().empty()) return (*algorithm)->trace(given);
    const auto arguments = readGroup(given, (*algorithm)->fields.all());
    if (!arguments) return arguments.error();
    return (*algorithm)->trace(*arguments);
}

Json traceJson(const Trace& trace) {
    Json frames = Json::array();
    for (const TraceFrame& frame : trace.frames) frames.push_back(frameJson(frame));
    return {{"algorithm", trace.algorithm}, {"frames", std::move(frames)}};
}

}  // namespace knotwork::scene
