// The short way from bytes to a subdivision, as marshal_bspline.cpp has it for curves: whatever is in
// any way unusual is left to the scene's validation, which says what is wrong with it.
#include "bindings/marshal.hpp"
#include "bindings/marshal_cbor.hpp"
#include "geometry/knot_vector.hpp"

#include <cmath>

namespace knotwork::bindings {

using Kind = CborItem::Kind;

namespace {

struct Parts {
    CurveSubdivision subdivision;
    bool hasScheme = false;
    bool hasDegree = false;
    bool hasTension = false;
};

bool readScheme(std::string_view name, Parts& parts) noexcept {
    parts.hasScheme = true;
    if (name == "lane-riesenfeld") parts.subdivision.scheme = CurveScheme::laneRiesenfeld;
    else if (name == "chaikin") parts.subdivision.scheme = CurveScheme::chaikin;
    else if (name == "four-point") parts.subdivision.scheme = CurveScheme::fourPoint;
    else parts.hasScheme = false;
    return parts.hasScheme;
}

bool readWhole(const CborItem& item, int& value) noexcept {
    constexpr double most = 1000;  // more than any of them may be
    if (item.kind != Kind::number || !(std::abs(item.number) <= most)) return false;
    value = static_cast<int>(item.number);
    return item.number == value;
}

bool readField(CborCursor& cursor, std::string_view key, Parts& parts) {
    CurveSubdivision& subdivision = parts.subdivision;
    const CborItem value = cursor.next();
    if (key == "points") return readPoints(value, maxPointCount, subdivision.points);
    if (key == "scheme") return value.kind == Kind::text && readScheme(value.text(), parts);
    if (key == "type") return value.kind == Kind::text && value.text() == "subdivision-curve";
    if (key == "levels") return readWhole(value, subdivision.levels);
    if (key == "degree") {
        parts.hasDegree = true;
        return readWhole(value, subdivision.degree);
    }
    if (key == "tension") {
        parts.hasTension = true;
        subdivision.tension = value.number;
        return value.kind == Kind::number;
    }
    subdivision.closed = value.number != 0;
    return key == "closed" && value.kind == Kind::flag;
}

bool readParts(CborCursor& cursor, Parts& parts) {
    const auto take = [&](std::string_view key) { return readField(cursor, key, parts); };
    return takeFields(cursor, take) && cursor.finished() && parts.hasScheme;
}

}  // namespace

std::optional<CurveSubdivision> readUsualSubdivision(std::span<const std::uint8_t> bytes) {
    CborCursor cursor(bytes);
    Parts parts;
    if (!readParts(cursor, parts)) return std::nullopt;
    const CurveScheme scheme = parts.subdivision.scheme;
    if (parts.hasDegree && scheme != CurveScheme::laneRiesenfeld) return std::nullopt;
    if (parts.hasTension && scheme != CurveScheme::fourPoint) return std::nullopt;
    if (!checkSubdivision(parts.subdivision, maxSubdividedPoints)) return std::nullopt;
    return std::move(parts.subdivision);
}

}  // namespace knotwork::bindings
