#include "geometry/subdivision_curve.hpp"

#include "geometry/bspline_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace knotwork {

namespace {

/// 32w³ + 4w − 1 = 0: from here on the four-point scheme has no tangents.
constexpr double smoothTension = 0.19272924926481202;

std::vector<Vec3> finalVertices(const CurveSubdivision& subdivision) {
    const FinalPolygon polygon(subdivision);
    std::vector<Vec3> vertices(polygon.size());
    std::array<double, 3 * 512> xyz{};
    for (std::size_t done = 0; done < vertices.size(); done += 512) {
        const std::size_t count = std::min<std::size_t>(512, vertices.size() - done);
        polygon.points(done, {xyz.data(), 3 * count});
        for (std::size_t i = 0; i < count; ++i) {
            vertices[done + i] = {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]};
        }
    }
    return vertices;
}

/// Where the first vertex of a polygon with this distance of parameters stands.
double firstParameter(const CurveSubdivision& subdivision, double spacing) noexcept {
    const int degree = splineDegree(subdivision);
    if (degree == 0) return 0;
    return (subdivision.closed ? 0 : degree) - (degree - 1) * spacing / 2;
}

/// Small closed polygons go round as often as it takes to have more points than the degree.
std::vector<Vec3> repeated(const CurveSubdivision& subdivision) {
    std::vector<Vec3> points = subdivision.points;
    while (subdivision.closed && points.size() <= static_cast<std::size_t>(splineDegree(subdivision))) {
        points.insert(points.end(), subdivision.points.begin(), subdivision.points.end());
    }
    return points;
}

}  // namespace

Result<SubdivisionCurve> SubdivisionCurve::make(CurveSubdivision subdivision) {
    if (auto checked = checkSubdivision(subdivision, maxSubdivisionCurvePoints); !checked) {
        return checked.error();
    }
    return SubdivisionCurve(std::move(subdivision));
}

SubdivisionCurve::SubdivisionCurve(CurveSubdivision subdivision)
    : subdivision_(std::move(subdivision)),
      vertices_(finalVertices(subdivision_)),
      spacing_(std::ldexp(1.0, -subdivision_.levels)),
      first_(firstParameter(subdivision_, spacing_)),
      dimension_(std::all_of(subdivision_.points.begin(), subdivision_.points.end(),
                             [](const Vec3& p) { return p.z == 0; })
                     ? 2
                     : 3) {
    const Interval whole = domain();
    const double before = std::ceil((whole.start - first_) / spacing_);
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
        const double t = first_ + (before + static_cast<double>(i)) * spacing_;
        if (closed() ? t < whole.end : t <= whole.end) breaks_.push_back(t);
    }
}

Interval SubdivisionCurve::domain() const noexcept {
    const auto count = static_cast<double>(subdivision_.points.size());
    if (closed()) return {0, count};
    const int degree = splineDegree(subdivision_);
    return degree == 0 ? Interval{0, count - 1} : Interval{static_cast<double>(degree), count};
}

struct SubdivisionCurve::Leg {
    const Vec3& from;
    const Vec3& to;
    double share;  ///< how much of it lies behind

    /// Exact at both ends; and what both ends agree in, every point between has to the bit.
    [[nodiscard]] Vec3 point() const noexcept {
        return share < 0.5 ? from + share * (to - from) : to - (1 - share) * (to - from);
    }
};

SubdivisionCurve::Leg SubdivisionCurve::legAt(double t, Side side) const noexcept {
    const double inside = closed() ? wrapParameter(domain(), t, side) : t;
    const double at = (inside - first_) / spacing_;  // exact but for what t itself lacks
    const auto count = static_cast<double>(vertices_.size());
    const double before = side == Side::left ? std::ceil(at) - 1 : std::floor(at);
    const double leg = closed() ? before : std::clamp(before, 0.0, count - 2);
    const auto i = static_cast<std::size_t>(leg) % vertices_.size();
    return {vertices_[i], vertices_[(i + 1) % vertices_.size()], at - leg};
}

void SubdivisionCurve::evaluate(double t, Side side, std::span<Vec3> rows) const noexcept {
    const Leg leg = legAt(t, side);
    std::fill(rows.begin(), rows.end(), Vec3(0));
    if (!rows.empty()) rows[0] = leg.point();
    if (rows.size() > 1) rows[1] = (leg.to - leg.from) / spacing_;
}

// ---- Limits ------------------------------------------------------------------------------------

/// The derivatives of this order of the B-spline that is the limit.
std::vector<Vec3> SubdivisionCurve::limitRows(std::size_t order) const {
    std::vector<Vec3> points = repeated(subdivision_);
    const Form form = closed() ? Form::closed : Form::open;
    const int count = static_cast<int>(points.size());
    auto knots = KnotVector::uniform(splineDegree(subdivision_), count, form).value();
    const auto spline = BsplineCurve::make(std::move(knots), std::move(points), 3).value();
    const Interval whole = spline.domain();
    const double first = firstParameter(subdivision_, 1);
    std::vector<Vec3> limits(subdivision_.points.size());
    std::array<Vec3, 2> rows;
    for (std::size_t i = 0; i < limits.size(); ++i) {
        const double t = first + static_cast<double>(i);
        const double inside = closed() ? t : std::clamp(t, whole.start, whole.end);
        spline.derivatives(inside, inside == whole.end ? Side::left : Side::right, rows);
        limits[i] = rows[order];
    }
    return limits;
}

std::vector<Vec3> SubdivisionCurve::limitPoints() const {
    return splineDegree(subdivision_) == 0 ? subdivision_.points : limitRows(0);
}

Result<std::vector<Vec3>> SubdivisionCurve::limitTangents() const {
    const int degree = splineDegree(subdivision_);
    if (degree == 1) {
        return refuse(Code::notSupported, "degree",
                      "Degree 1 keeps the corners of the polygon; tangents begin with degree 2.");
    }
    if (degree > 1) return limitRows(1);
    const double w = subdivision_.tension;
    if (!(w > 0 && w < smoothTension)) {
        return refuse(Code::notSupported, "tension",
                      "With the tension " + formatNumber(w) +
                          " the limit has no tangents; it has them between 0 and 0.19273.");
    }
    std::vector<Vec3> tangents(subdivision_.points.size());
    for (std::size_t k = 0; k < tangents.size(); ++k) {
        const auto i = static_cast<std::ptrdiff_t>(k);
        const auto at = [&](std::ptrdiff_t j) { return continuedVertex(subdivision_, i + j); };
        tangents[k] = (0.5 * (at(1) - at(-1)) - w * (at(2) - at(-2))) / (1 - 4 * w);
    }
    return tangents;
}

}  // namespace knotwork
