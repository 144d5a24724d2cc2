// What subdivision curves are asked about their limits.
#include "bindings/queries.hpp"

#include <array>

namespace knotwork::bindings {

namespace {

using scene::Json;

Result<Answer> listed(const std::vector<Vec3>& points) {
    Answer answer;
    answer.numbers.reserve(3 * points.size());
    for (const Vec3& p : points) answer.numbers.insert(answer.numbers.end(), {p.x, p.y, p.z});
    return answer;
}

Error notOfThisKind() {
    return refuse(Code::notSupported, "", "Only a subdivision curve answers this.");
}

Result<Answer> limitPoints(const Curve& curve, const Json&) {
    const auto* subdivision = curve.as<SubdivisionCurve>();
    return subdivision ? listed(subdivision->limitPoints()) : Result<Answer>(notOfThisKind());
}

Result<Answer> limitTangents(const Curve& curve, const Json&) {
    const auto* subdivision = curve.as<SubdivisionCurve>();
    if (!subdivision) return notOfThisKind();
    const auto tangents = subdivision->limitTangents();
    return tangents ? listed(*tangents) : Result<Answer>(tangents.error());
}

constexpr std::array queries{
    CurveQuery{"limitPoints", {}, limitPoints},
    CurveQuery{"limitTangents", {}, limitTangents},
};

}  // namespace

std::span<const CurveQuery> subdivisionQueries() noexcept { return queries; }

}  // namespace knotwork::bindings
