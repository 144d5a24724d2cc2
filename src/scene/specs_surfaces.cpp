// The builders of B-spline and parametric surfaces.
#include "scene/form_names.hpp"
#include "scene/json_values.hpp"
#include "scene/parameter_fields.hpp"
#include "scene/surface_builders.hpp"

#include <utility>
#include <vector>

namespace knotwork::scene {

namespace {

/// Nothing where all rows have the same length; otherwise WRONG_LENGTH at the row that differs.
std::optional<Error> checkRows(const Json& rows, std::size_t columns, std::string_view list) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].size() == columns) continue;
        return refuse(Code::wrongLength, indexed(list, i),
                      std::to_string(rows[i].size()) + " in this row, " + std::to_string(columns) +
                          " needed: all rows of the net are equally long");
    }
    return {};
}

/// Along direction 0 (u) or 1 (v), for so many points.
Result<KnotVector> knotsAlong(const Json& spec, std::size_t direction, std::size_t count) {
    if (count > static_cast<std::size_t>(maxPointCount)) {
        return refuse(Code::tooLarge, "points",
                      std::to_string(count) +
                          " points in one direction; a surface has at most 100000 in all");
    }
    const Form form =
        *formNamed((*member(spec, "form"))[direction].get_ref<const std::string&>());
    const auto degree = static_cast<int>((*member(spec, "degree"))[direction].get<double>());
    const Json* given = member(spec, "knots");
    auto knots = given != nullptr
                     ? KnotVector::make(numbersOf((*given)[direction]), degree,
                                        static_cast<int>(count), form)
                     : KnotVector::uniform(degree, static_cast<int>(count), form);
    if (!knots) return ofDirection(knots.error(), direction);
    return knots;
}

/// The weights row by row; none where none are given.
Result<std::vector<double>> weightsOf(const Json& spec, std::size_t rows, std::size_t columns) {
    std::vector<double> weights;
    const Json* given = member(spec, "weights");
    if (given == nullptr) return weights;
    if (given->size() != rows) {
        return refuse(Code::wrongLength, "weights",
                      std::to_string(given->size()) + " rows of weights given, " +
                          std::to_string(rows) + " needed: one a point");
    }
    if (auto error = checkRows(*given, columns, "weights")) return *std::move(error);
    for (const Json& row : *given) {
        for (const Json& weight : row) weights.push_back(weight.get<double>());
    }
    return weights;
}

/// Flat numbers as rows of `columns`.
Json rowsOf(std::span<const double> numbers, std::size_t columns) {
    Json rows = Json::array();
    for (std::size_t at = 0; at < numbers.size(); at += columns) {
        rows.push_back(listOf(numbers.subspan(at, columns)));
    }
    return rows;
}

}  // namespace

Result<Surface> buildBsplineSurface(Json& spec) {
    const Json& net = *member(spec, "points");
    const std::size_t columns = net.empty() ? 0 : net.front().size();
    if (auto error = checkRows(net, columns, "points")) return *std::move(error);
    auto knotsU = knotsAlong(spec, 0, net.size());
    if (!knotsU) return knotsU.error();
    auto knotsV = knotsAlong(spec, 1, columns);
    if (!knotsV) return knotsV.error();
    auto weights = weightsOf(spec, net.size(), columns);
    if (!weights) return weights.error();
    std::vector<Vec3> points;
    points.reserve(net.size() * columns);
    for (const Json& row : net) {
        for (const Json& point : row) points.push_back(vec3Of(point));
    }
    if (member(spec, "knots") == nullptr) {
        spec["knots"] = Json::array({listOf(knotsU->knots()), listOf(knotsV->knots())});
    }
    auto surface = BsplineSurface::make(std::move(*knotsU), std::move(*knotsV), std::move(points),
                                        std::move(*weights));
    if (!surface) return surface.error();
    return Surface(std::move(*surface));
}

Result<Surface> buildParametricSurface(Json& spec) {
    const auto parameters = namedValues(*member(spec, "parameters"));
    auto surface = ParametricSurface::make(stringOr(spec, "name", ""), parameters);
    if (!surface) return surface.error();
    return Surface(std::move(*surface));
}

Json specOf(const BsplineSurface& surface) {
    const std::size_t columns = surface.columnCount();
    Json points = Json::array();
    for (std::size_t i = 0; i < surface.rowCount(); ++i) {
        Json row = Json::array();
        for (std::size_t j = 0; j < columns; ++j) {
            row.push_back(pointJson(surface.points()[i * columns + j], 3));
        }
        points.push_back(std::move(row));
    }
    const KnotVector& u = surface.knotsU();
    const KnotVector& v = surface.knotsV();
    Json spec{{"type", "bspline-surface"},
              {"degree", Json::array({static_cast<double>(u.degree()),
                                      static_cast<double>(v.degree())})},
              {"form", Json::array({formName(u.form()), formName(v.form())})},
              {"points", std::move(points)},
              {"knots", Json::array({listOf(u.knots()), listOf(v.knots())})}};
    if (!surface.weights().empty()) spec["weights"] = rowsOf(surface.weights(), columns);
    return spec;
}

Json specOf(const ParametricSurface& surface) {
    Json parameters = Json::object();
    for (std::size_t i = 0; i < surface.parameters().size(); ++i) {
        parameters[std::string(surface.description().parameters[i].name)] = surface.parameters()[i];
    }
    return {{"type", "parametric-surface"},
            {"name", surface.name()},
            {"parameters", std::move(parameters)}};
}

}  // namespace knotwork::scene
