// The short way from bytes to a B-spline surface, as marshal_bspline.cpp has it for curves.
#include "bindings/marshal.hpp"
#include "bindings/marshal_cbor.hpp"
#include "bindings/marshal_lists.hpp"
#include "scene/form_names.hpp"

#include <array>
#include <cmath>

namespace knotwork::bindings {

using Kind = CborItem::Kind;

namespace {

constexpr std::size_t mostPoints = maxPointCount;

struct Parts {
    bool isBspline = false;
    std::vector<double> degrees;
    std::array<Form, 2> forms{Form::clamped, Form::clamped};
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::vector<Vec3> points;
    std::array<std::vector<double>, 2> knots;
    std::vector<double> weights;
    std::size_t weightColumns = 0;
};

bool readNet(CborCursor& cursor, const CborItem& list, Parts& parts) {
    if (list.kind != Kind::list || list.length == 0 || list.length > mostPoints) return false;
    parts.rows = list.length;
    std::vector<Vec3> row;
    for (std::size_t i = 0; i < parts.rows; ++i) {
        if (!readPoints(cursor.next(), mostPoints, row)) return false;
        if (i == 0) parts.columns = row.size();
        if (row.size() != parts.columns || parts.rows * row.size() > mostPoints) return false;
        parts.points.reserve(parts.rows * parts.columns);
        parts.points.insert(parts.points.end(), row.begin(), row.end());
    }
    return true;
}

bool readKnots(CborCursor& cursor, const CborItem& list, Parts& parts) {
    if (list.kind != Kind::list || list.length != 2) return false;
    for (std::vector<double>& knots : parts.knots) {
        if (!readNumbers(cursor.next(), 2 * mostPoints, knots) || knots.empty()) return false;
    }
    return true;
}

bool readForms(CborCursor& cursor, const CborItem& list, Parts& parts) {
    if (list.kind != Kind::list || list.length != 2) return false;
    for (Form& form : parts.forms) {
        const CborItem name = cursor.next();
        const auto known = name.kind == Kind::text ? scene::formNamed(name.text()) : std::nullopt;
        if (!known) return false;
        form = *known;
    }
    return true;
}

/// Rows of two or three numbers cross as points do.
bool readWeights(CborCursor& cursor, const CborItem& list, Parts& parts) {
    if (list.kind == Kind::points) {
        parts.weightColumns = list.width;
        for (std::size_t i = 0; i < list.length; ++i) parts.weights.push_back(list.numberAt(i));
        return true;
    }
    if (list.kind != Kind::list) return false;
    std::vector<double> row;
    for (std::size_t i = 0; i < list.length; ++i) {
        if (!readNumbers(cursor.next(), mostPoints, row) || row.empty()) return false;
        if (i == 0) parts.weightColumns = row.size();
        if (row.size() != parts.weightColumns) return false;
        parts.weights.insert(parts.weights.end(), row.begin(), row.end());
    }
    return !parts.weights.empty();
}

bool readField(CborCursor& cursor, std::string_view key, Parts& parts) {
    const CborItem value = cursor.next();
    if (key == "points") return readNet(cursor, value, parts);
    if (key == "knots") return readKnots(cursor, value, parts);
    if (key == "weights") return readWeights(cursor, value, parts);
    if (key == "form") return readForms(cursor, value, parts);
    if (key == "degree") return readNumbers(value, 2, parts.degrees) && parts.degrees.size() == 2;
    if (key != "type" || value.kind != Kind::text) return false;
    return parts.isBspline = value.text() == "bspline-surface";
}

bool readParts(CborCursor& cursor, Parts& parts) {
    const auto take = [&](std::string_view key) { return readField(cursor, key, parts); };
    return takeFields(cursor, take) && cursor.finished() && parts.isBspline;
}

std::optional<KnotVector> knotsAlong(Parts& parts, std::size_t direction, std::size_t count) {
    const double degree = parts.degrees[direction];
    if (!(degree >= 1 && degree <= maxDegree) || degree != std::floor(degree)) return {};
    std::vector<double>& given = parts.knots[direction];
    const Form form = parts.forms[direction];
    auto knots = given.empty() ? KnotVector::uniform(static_cast<int>(degree),
                                                     static_cast<int>(count), form)
                               : KnotVector::make(std::move(given), static_cast<int>(degree),
                                                  static_cast<int>(count), form);
    if (!knots) return {};
    return std::move(*knots);
}

}  // namespace

std::optional<Surface> readUsualSurface(std::span<const std::uint8_t> bytes) {
    CborCursor cursor(bytes);
    Parts parts;
    if (!readParts(cursor, parts) || parts.degrees.empty() || parts.points.empty()) return {};
    const bool weighted = !parts.weights.empty();
    if (weighted && (parts.weightColumns != parts.columns ||
                     parts.weights.size() != parts.points.size())) {
        return {};
    }
    auto knotsU = knotsAlong(parts, 0, parts.rows);
    auto knotsV = knotsAlong(parts, 1, parts.columns);
    if (!knotsU || !knotsV) return {};
    auto surface = BsplineSurface::make(std::move(*knotsU), std::move(*knotsV),
                                        std::move(parts.points), std::move(parts.weights));
    if (!surface) return {};
    return Surface(std::move(*surface));
}

}  // namespace knotwork::bindings
