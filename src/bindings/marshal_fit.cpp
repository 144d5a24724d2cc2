#include "bindings/marshal_fit.hpp"

#include "bindings/marshal.hpp"
#include "bindings/marshal_lists.hpp"
#include "scene/fields.hpp"
#include "scene/form_names.hpp"
#include "scene/fit_fields.hpp"
#include "scene/json_values.hpp"
#include "scene/object_builders.hpp"
#include "scene/validation.hpp"

#include <array>
#include <string>
#include <utility>

namespace knotwork::bindings {

using scene::Choice;
using scene::Field;
using scene::FieldKind;
using scene::Json;

namespace {

constexpr std::array methodChoices{Choice{"minimal", "Smallest"}, Choice{"ritter", "Ritter"},
                                   Choice{"incremental", "Incremental"}};

constexpr Field pointsField{.name = "points", .label = "Points", .kind = FieldKind::points,
                            .help = "The data, a list of points.", .required = true};

constexpr std::array fitFields{pointsField,
                               scene::fitDegreeField,
                               scene::fitCountField,
                               scene::fitFormField,
                               scene::fitParametersField,
                               scene::fitKnotsField,
                               scene::fitEndsField,
                               scene::fitSmoothingField};
constexpr std::array interpolationFields{pointsField, scene::fitDegreeField, scene::fitFormField,
                                         scene::fitParametersField};
constexpr std::array sphereFields{
    pointsField, Field{.name = "method", .label = "Method", .kind = FieldKind::choice,
                       .help = "The smallest sphere, or one of two that are found sooner.",
                       .defaultJson = "\"minimal\"", .choices = methodChoices}};

/// An object's lists that crossed as packed numbers; the tree has empty lists in their places.
struct Packed {
    Json rest = Json::object();
    std::optional<std::vector<Vec3>> points{};
    std::optional<std::vector<double>> parameters{};
    std::optional<std::vector<double>> knots{};
};

bool takePoints(const CborItem& item, Packed& packed) {
    std::vector<Vec3> points;
    if (!readPoints(item, maxDataCount, points)) return false;
    packed.points = std::move(points);
    return true;
}

bool takeNumbers(const CborItem& item, std::optional<std::vector<double>>& list) {
    std::vector<double> numbers;
    if (!readNumbers(item, maxDataCount, numbers)) return false;
    list = std::move(numbers);
    return true;
}

bool take(std::string_view key, const CborItem& item, Packed& packed) {
    if (key == "points") return takePoints(item, packed);
    if (key == "parameters") return takeNumbers(item, packed.parameters);
    return key == "knots" && takeNumbers(item, packed.knots);
}

Result<Packed> unpack(std::span<const std::uint8_t> bytes) {
    CborCursor cursor(bytes);
    Packed packed;
    bool whole = cursor.next().kind == CborItem::Kind::map;
    while (whole) {
        const CborItem key = cursor.next();
        if (key.kind == CborItem::Kind::close) return packed;
        const CborItem item = cursor.next();
        Json value = Json::array();
        whole = key.kind == CborItem::Kind::text &&
                (take(key.text(), item, packed) || readValue(cursor, item, value));
        packed.rest[std::string(key.text())] = std::move(value);
    }
    // No object, then: the tables say so.
    auto tree = readCbor(bytes);
    if (!tree) return tree.error();
    return Packed{std::move(*tree)};
}

std::vector<Vec3> pointsOf(Packed& packed, const Json& fields) {
    if (packed.points) return *std::move(packed.points);
    std::vector<Vec3> points;
    for (const Json& point : *scene::member(fields, "points")) {
        points.push_back(scene::vec3Of(point));
    }
    return points;
}

Parameters parametersOf(Packed& packed, const Json& fields) {
    if (packed.parameters) return *std::move(packed.parameters);
    const Json& given = *scene::member(fields, "parameters");
    if (given.is_array()) return scene::numbersOf(given);
    return scene::parametrisationNamed(given.get<std::string>());
}

/// By the table, in which `parameters` are a list of numbers where a list is given.
Result<Json> readFields(const Json& given, std::span<const Field> table) {
    std::vector<Field> fields(table.begin(), table.end());
    const Json* parameters = given.is_object() ? scene::member(given, "parameters") : nullptr;
    for (Field& field : fields) {
        const bool list = parameters != nullptr && parameters->is_array();
        if (field.name == "parameters" && list) field.kind = FieldKind::numbers;
    }
    return scene::readGroup(given, fields);
}

Result<FitInput> readRequest(std::span<const std::uint8_t> bytes, std::span<const Field> table) {
    auto packed = unpack(bytes);
    if (!packed) return packed.error();
    const auto fields = readFields(packed->rest, table);
    if (!fields) return fields.error();
    FitInput input;
    input.points = pointsOf(*packed, *fields);
    FitRequest& request = input.request;
    request.degree = static_cast<int>(scene::numberOr(*fields, "degree", 0));
    request.count = static_cast<int>(scene::numberOr(*fields, "count", 0));
    request.form = *scene::formNamed(scene::stringOr(*fields, "form", ""));
    request.parameters = parametersOf(*packed, *fields);
    request.options.smoothing = scene::numberOr(*fields, "smoothing", 0);
    request.options.interpolateEnds = scene::flagOr(*fields, "interpolateEnds", false);
    if (const Json* knots = scene::member(*fields, "knots")) {
        request.knots = packed->knots ? *std::move(packed->knots) : scene::numbersOf(*knots);
        if (request.knots.empty()) {
            return refuse(Code::knotsCount, "knots",
                          "the list of knots is empty; leave it out for the default knots");
        }
    }
    return input;
}

/// A refusal of the geometry, which sees points and not their coordinates: NaN and infinities have
/// the path that the tables give them.
Error placed(Error error, std::span<const std::uint8_t> bytes, std::span<const Field> table) {
    if (error.code != Code::notFinite) return error;
    const auto tree = readCbor(bytes);
    const auto fields = tree ? readFields(*tree, table) : Result<Json>(error);
    return fields ? error : fields.error();
}

}  // namespace

Error placedInFit(Error error, std::span<const std::uint8_t> bytes) {
    return placed(std::move(error), bytes, fitFields);
}

Error placedInInterpolation(Error error, std::span<const std::uint8_t> bytes) {
    return placed(std::move(error), bytes, interpolationFields);
}

Error placedInSphere(Error error, std::span<const std::uint8_t> bytes) {
    return placed(std::move(error), bytes, sphereFields);
}

Result<FitInput> readFit(std::span<const std::uint8_t> bytes) {
    return readRequest(bytes, fitFields);
}

Result<FitInput> readInterpolation(std::span<const std::uint8_t> bytes) {
    return readRequest(bytes, interpolationFields);
}

Result<SphereInput> readSphere(std::span<const std::uint8_t> bytes) {
    auto packed = unpack(bytes);
    if (!packed) return packed.error();
    const auto fields = scene::readGroup(packed->rest, sphereFields);
    if (!fields) return fields.error();
    const std::string method = scene::stringOr(*fields, "method", "");
    return SphereInput{pointsOf(*packed, *fields),
                       method == "ritter"        ? SphereMethod::ritter
                       : method == "incremental" ? SphereMethod::incremental
                                                 : SphereMethod::minimal};
}

}  // namespace knotwork::bindings
