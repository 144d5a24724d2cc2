// Questions about B-spline curves that are asked seldom.
#include "bindings/queries.hpp"
#include "geometry/bezier_piece.hpp"
#include "geometry/bspline_operations.hpp"
#include "geometry/degree_elevation.hpp"
#include "geometry/factor_matrices.hpp"
#include "geometry/hodograph.hpp"
#include "geometry/knot_removal.hpp"
#include "geometry/oslo.hpp"
#include "geometry/refinement.hpp"
#include "scene/json_values.hpp"

#include <array>
#include <limits>

namespace knotwork::bindings {

using scene::Field;
using scene::FieldKind;
using scene::Json;

namespace {

/// Of a matrix that a program can still look through: 32 MiB.
constexpr std::size_t mostNumbers = 4'000'000;

constexpr std::array knotsField{
    Field{.name = "knots", .label = "Knots", .kind = FieldKind::numbers, .required = true}};
constexpr std::array parameterField{
    Field{.name = "t", .label = "Parameter", .kind = FieldKind::number, .required = true}};
constexpr std::array removalFields{
    Field{.name = "t", .label = "Knot", .kind = FieldKind::number, .required = true},
    Field{.name = "tolerance", .label = "Tolerance", .kind = FieldKind::number, .min = 0,
          .required = true}};
constexpr std::array byField{
    Field{.name = "by", .label = "By", .kind = FieldKind::integer, .min = 1, .max = 24,
          .maxIsSize = true, .required = true}};

/// Only the facade of B-spline curves asks.
const BsplineCurve& splineOf(const Curve& curve) { return *curve.as<BsplineCurve>(); }

Result<Answer> answerCurve(Result<BsplineCurve> made) {
    if (!made) return made.error();
    Answer answer;
    answer.curves.emplace_back(std::move(*made));
    return answer;
}

Result<Answer> matrixOf(const Curve& curve, const Json& arguments) {
    const KnotVector& knots = splineOf(curve).knotVector();
    const auto refined = refinedKnots(knots, scene::numbersOf(arguments["knots"]));
    if (!refined) return refined.error();
    const auto rows = static_cast<std::size_t>(refined->pointCount());
    const auto columns = static_cast<std::size_t>(knots.pointCount());
    if (rows * columns > mostNumbers) {
        return refuse(Code::tooLarge, "knots",
                      "The matrix would have " + std::to_string(rows) + " rows of " +
                          std::to_string(columns) + " numbers; refine() needs no matrix.");
    }
    Answer answer;
    answer.json["columns"] = columns;
    answer.numbers = osloMatrix(knots, *refined);
    return answer;
}

Result<Answer> removed(const Curve& curve, const Json& arguments) {
    auto removal = removeKnot(splineOf(curve), scene::numberOr(arguments, "t", 0),
                              scene::numberOr(arguments, "tolerance", 0));
    if (!removal) return removal.error();
    Answer answer;
    answer.json["deviation"] = removal->deviation;
    answer.json["removed"] = removal->removed;
    answer.curves.emplace_back(std::move(removal->curve));
    return answer;
}

Result<Answer> elevated(const Curve& curve, const Json& arguments) {
    return answerCurve(
        elevateDegree(splineOf(curve), static_cast<int>(scene::numberOr(arguments, "by", 1))));
}

Json pieceJson(const BezierPiece& piece, int dimension, bool weighted) {
    Json points = Json::array();
    Json weights = Json::array();
    for (const Homogeneous& point : piece.points) {
        const Vec3 position = weighted ? Vec3(point) / point.w : Vec3(point);
        points.push_back(scene::pointJson(position, dimension));
        weights.push_back(point.w);
    }
    Json spec{{"type", "bezier-curve"}, {"points", std::move(points)}};
    if (weighted) spec["weights"] = std::move(weights);
    spec["domain"] = Json::array({piece.interval.start, piece.interval.end});
    return spec;
}

Result<Answer> pieces(const Curve& curve, const Json&) {
    const BsplineCurve& spline = splineOf(curve);
    Answer answer;
    Json& list = answer.json["pieces"] = Json::array();
    for (const BezierPiece& piece : bezierPieces(spline)) {
        list.push_back(pieceJson(piece, spline.dimension(), !spline.weights().empty()));
    }
    return answer;
}

Result<Answer> factors(const Curve& curve, const Json& arguments) {
    const auto t = parameterInDomain(curve, scene::numberOr(arguments, "t", 0));
    if (!t) return t.error();
    Answer answer;
    for (const std::vector<double>& matrix : factorMatrices(splineOf(curve).knotVector(), *t)) {
        answer.numbers.insert(answer.numbers.end(), matrix.begin(), matrix.end());
    }
    return answer;
}

Result<Answer> derivativeOf(const Curve& curve, const Json&) {
    return answerCurve(derivativeCurve(splineOf(curve)));
}

Result<Answer> parts(const Curve& curve, const Json& arguments) {
    auto halves = split(splineOf(curve), scene::numberOr(arguments, "t", 0));
    if (!halves) return halves.error();
    Answer answer;
    for (BsplineCurve& half : *halves) answer.curves.emplace_back(std::move(half));
    return answer;
}

Result<Answer> backwards(const Curve& curve, const Json&) {
    return answerCurve(reversed(splineOf(curve)));
}

constexpr std::array queries{
    CurveQuery{"osloMatrix", knotsField, matrixOf},
    CurveQuery{"removeKnot", removalFields, removed},
    CurveQuery{"elevateDegree", byField, elevated},
    CurveQuery{"bezierPieces", {}, pieces},
    CurveQuery{"factorMatrices", parameterField, factors},
    CurveQuery{"derivativeCurve", {}, derivativeOf},
    CurveQuery{"split", parameterField, parts},
    CurveQuery{"reversed", {}, backwards},
};

}  // namespace

std::span<const CurveQuery> bsplineQueries() noexcept { return queries; }

}  // namespace knotwork::bindings
