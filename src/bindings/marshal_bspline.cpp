// The short way from bytes to a B-spline curve: no tree of JSON in between, which for a small curve
// costs more than all the samples taken of it. Whatever is in any way unusual is left to the
// scene's validation, which says what is wrong with it.
#include "bindings/marshal.hpp"
#include "bindings/marshal_cbor.hpp"
#include "bindings/marshal_lists.hpp"
#include "scene/form_names.hpp"

#include <algorithm>
#include <cmath>

namespace knotwork::bindings {

using Kind = CborItem::Kind;

namespace {

struct Parts {
    bool isBspline = false;
    double degree = 0;
    std::optional<Form> form = Form::clamped;
    std::vector<Vec3> points;
    std::vector<double> knots;
    std::vector<double> weights;
};

bool readSome(const CborItem& item, std::vector<double>& numbers) {
    return readNumbers(item, 2 * maxPointCount, numbers) && !numbers.empty();
}

bool readField(CborCursor& cursor, std::string_view key, Parts& parts) {
    const CborItem value = cursor.next();
    if (key == "points") return readPoints(value, maxPointCount, parts.points);
    if (key == "knots") return readSome(value, parts.knots);
    if (key == "weights") return readSome(value, parts.weights);
    if (key == "degree") {
        parts.degree = value.number;
        return value.kind == Kind::number;
    }
    if (value.kind != Kind::text) return false;
    if (key == "type") return parts.isBspline = value.text() == "bspline-curve";
    if (key == "form") return (parts.form = scene::formNamed(value.text())).has_value();
    return false;
}

bool readParts(CborCursor& cursor, Parts& parts) {
    const auto take = [&](std::string_view key) { return readField(cursor, key, parts); };
    return takeFields(cursor, take) && cursor.finished() && parts.isBspline;
}

}  // namespace

std::optional<Curve> readUsualBspline(std::span<const std::uint8_t> bytes) {
    CborCursor cursor(bytes);
    Parts parts;
    if (!readParts(cursor, parts)) return std::nullopt;
    if (!(parts.degree >= 1 && parts.degree <= maxDegree)) return std::nullopt;
    if (parts.degree != std::floor(parts.degree)) return std::nullopt;
    const int degree = static_cast<int>(parts.degree);
    const int count = static_cast<int>(parts.points.size());
    auto knots = parts.knots.empty()
                     ? KnotVector::uniform(degree, count, *parts.form)
                     : KnotVector::make(std::move(parts.knots), degree, count, *parts.form);
    if (!knots) return std::nullopt;
    const bool planar = std::all_of(parts.points.begin(), parts.points.end(),
                                    [](const Vec3& p) { return p.z == 0; });
    auto curve = BsplineCurve::make(std::move(*knots), std::move(parts.points), planar ? 2 : 3,
                                    std::move(parts.weights));
    if (!curve) return std::nullopt;
    return Curve(std::move(*curve));
}

}  // namespace knotwork::bindings
