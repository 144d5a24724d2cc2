#include "bindings/marshal_fit.hpp"

#include "bindings/marshal.hpp"
#include "bindings/marshal_lists.hpp"
#include "geometry/named.hpp"
#include "scene/fields.hpp"
#include "scene/fit_fields.hpp"
#include "scene/fit_specs.hpp"
#include "scene/form_names.hpp"
#include "scene/json_values.hpp"
#include "scene/validation.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
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

using Kind = CborItem::Kind;

// ---- What crosses nearly always ----------------------------------------------------------------

bool takeInteger(const CborItem& item, int least, int most, int& value) {
    if (item.kind != Kind::number || !(item.number >= least && item.number <= most)) return false;
    value = static_cast<int>(item.number);
    return value == item.number;
}

bool takeForm(const CborItem& item, Form& form) {
    const auto named = item.kind == Kind::text ? scene::formNamed(item.text()) : std::nullopt;
    if (named) form = *named;
    return named.has_value();
}

bool takePoints(const CborItem& item, LongList<Vec3>& points) {
    auto found = findPoints(item, maxDataCount);
    if (found) points = *std::move(found);
    return found.has_value();
}

bool takeParameters(const CborItem& item, FitInput& input) {
    if (item.kind == Kind::text) {
        const auto named = scene::parametrisationNamed(item.text());
        if (named) input.request.parameters = *named;
        return named.has_value();
    }
    auto found = findNumbers(item, maxDataCount);
    if (!found) return false;
    input.parameters = *std::move(found);
    input.request.parameters = input.parameters.all;
    return true;
}

bool takeOption(std::string_view key, const CborItem& item, LeastSquares& options) {
    if (key == "interpolateEnds") {
        options.interpolateEnds = item.number != 0;
        return item.kind == Kind::flag;
    }
    options.smoothing = item.number;
    return key == "smoothing" && item.kind == Kind::number && item.number >= 0 &&
           item.number <= maxSmoothing;
}

bool take(std::string_view key, const CborItem& item, FitInput& input) {
    FitRequest& request = input.request;
    if (key == "points") return takePoints(item, input.points);
    if (key == "degree") return takeInteger(item, 1, maxDegree, request.degree);
    if (key == "form") return takeForm(item, request.form);
    if (key == "parameters") return takeParameters(item, input);
    if (key == "count") return takeInteger(item, 2, maxPointCount, request.count);
    if (key == "knots") {
        return readNumbers(item, maxDataCount, request.knots) && !request.knots.empty();
    }
    return takeOption(key, item, request.options);
}

/// A request without anything unusual, whose fields are all in the table; else nothing.
std::optional<FitInput> readPlain(std::span<const std::uint8_t> bytes,
                                  std::span<const Field> table) {
    FitInput input;
    auto missing = std::count_if(table.begin(), table.end(),
                                 [](const Field& field) { return field.required; });
    CborCursor cursor(bytes);
    const bool taken = takeFields(cursor, [&](std::string_view key) {
        const Field* field = findNamed(table, &Field::name, key);
        if (field == nullptr || !take(key, cursor.next(), input)) return false;
        if (field->required) --missing;
        return true;
    });
    return taken && missing == 0 ? std::optional<FitInput>(std::move(input)) : std::nullopt;
}

std::optional<SphereMethod> methodNamed(std::string_view name) {
    if (name == "minimal") return SphereMethod::minimal;
    if (name == "ritter") return SphereMethod::ritter;
    if (name == "incremental") return SphereMethod::incremental;
    return std::nullopt;
}

std::optional<SphereInput> readPlainSphere(std::span<const std::uint8_t> bytes) {
    SphereInput input;
    bool points = false;
    CborCursor cursor(bytes);
    const bool taken = takeFields(cursor, [&](std::string_view key) {
        const CborItem item = cursor.next();
        if (key == "points") return points = takePoints(item, input.points);
        const auto method = item.kind == Kind::text ? methodNamed(item.text()) : std::nullopt;
        if (method) input.method = *method;
        return key == "method" && method.has_value();
    });
    return taken && points ? std::optional<SphereInput>(std::move(input)) : std::nullopt;
}

// ---- By the tables -----------------------------------------------------------------------------

LongList<Vec3> pointsOf(const Json& fields) {
    std::vector<Vec3> points;
    for (const Json& point : *scene::member(fields, "points")) {
        points.push_back(scene::vec3Of(point));
    }
    return copied(std::move(points));
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
    if (auto plain = readPlain(bytes, table)) return *std::move(plain);
    const auto tree = readCbor(bytes);
    if (!tree) return tree.error();
    const auto fields = readFields(*tree, table);
    if (!fields) return fields.error();
    FitInput input;
    input.points = pointsOf(*fields);
    input.request = scene::fitRequestOf(*fields);
    if (const Json& given = *scene::member(*fields, "parameters"); given.is_array()) {
        input.parameters = copied(scene::numbersOf(given));
        input.request.parameters = input.parameters.all;
    }
    if (scene::member(*fields, "knots") != nullptr && input.request.knots.empty()) {
        return refuse(Code::knotsCount, "knots",
                      "the list of knots is empty; leave it out for the default knots");
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
    if (auto plain = readPlainSphere(bytes)) return *std::move(plain);
    const auto tree = readCbor(bytes);
    if (!tree) return tree.error();
    const auto fields = scene::readGroup(*tree, sphereFields);
    if (!fields) return fields.error();
    return SphereInput{pointsOf(*fields), *methodNamed(scene::stringOr(*fields, "method", ""))};
}

}  // namespace knotwork::bindings
