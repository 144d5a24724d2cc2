// Any numbers at all as knots: refused with a place and a reason, or a basis that is a partition of
// unity and agrees with de Boor's algorithm from both sides of every knot.
#include "fuzz/input.hpp"

#include "geometry/bspline_basis.hpp"
#include "geometry/piecewise_polynomial.hpp"

#include <array>

using namespace knotwork;

namespace {

// The gates of the tests hold for moderate knots; these for whatever is not refused, up to
// degree 25.
constexpr double rounding = 1e-12;
constexpr double sampled = 1e-9;

void checkBasis(const BsplineCurve& curve, double t, Side side) {
    const KnotVector& knots = curve.knotVector();
    std::vector<double> row(curve.points().size());
    basisRows(knots, t, side, 0, row);
    double sum = 0;
    double weights = 0;
    Vec3 made(0);
    for (std::size_t i = 0; i < row.size(); ++i) {
        fuzz::check(row[i] >= 0, "basis functions are not negative", row[i]);
        const double weight = curve.weights().empty() ? 1 : curve.weights()[i];
        sum += row[i];
        weights += row[i] * weight;
        made += row[i] * weight * curve.points()[i];
    }
    fuzz::checkWithin(std::abs(sum - 1), rounding, "the basis is a partition of unity");
    std::array<Vec3, 4> rows;
    curve.derivatives(t, side, rows);
    fuzz::checkWithin(glm::length(made / weights - rows[0]), rounding, "the basis makes the curve");
    for (int axis = 0; axis < 3; ++axis) {
        fuzz::checkWithin(std::abs(rows[0][axis]), 1 + rounding, "the curve lies in the hull");
    }
    if (side == Side::right) {
        const double apart = glm::length(rows[0] - curve.point(t));
        fuzz::checkWithin(apart, rounding, "de Boor's algorithm gives the same point");
    }
}

void checkSamples(const BsplineCurve& curve, std::span<const double> ts) {
    std::vector<double> xyz(3 * ts.size());
    BsplineSampler(curve).at(ts, 0, xyz);
    for (std::size_t i = 0; i < ts.size(); ++i) {
        const Vec3 found(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]);
        fuzz::checkWithin(glm::length(found - curve.point(ts[i])), sampled, "samples are points");
    }
}

void checkCurve(fuzz::Input& input, const BsplineCurve& curve) {
    const auto ts = fuzz::parametersOf(input, curve.domain(), curve.knotVector().knots());
    for (const double t : ts) {
        for (const Side side : {Side::left, Side::right}) checkBasis(curve, t, side);
    }
    checkSamples(curve, ts);
    for (int i = 0; i < 3; ++i) {
        const double t = input.anyNumber();
        const std::size_t span = curve.knotVector().findSpan(t);
        const auto all = curve.knotVector().extended();
        fuzz::check(span + 1 < all.size() && all[span] < all[span + 1],
                    "every span found is a span");
    }
}

void anyKnots(fuzz::Input& input) {
    const int degree = input.whole(-1, 27);
    const auto form = static_cast<Form>(input.whole(0, 2));
    const int count = input.whole(0, 40);
    const int length = input.whole(0, 70);
    std::vector<double> knots;
    for (int i = 0; i < length; ++i) {
        const bool again = !knots.empty() && input.whole(0, 2) > 0;
        knots.push_back(again ? knots.back() + input.gap(1e-14) : input.anyNumber());
    }
    const auto made = KnotVector::make(knots, degree, count, form);
    if (!made) {
        fuzz::check(!made.error().path.empty() && made.error().message.size() > 10,
                    "a refusal says where and why");
        return;
    }
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) points.emplace_back(input.real(), input.real(), 0);
    checkCurve(input, BsplineCurve::make(*made, points, 3).value());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Input input(data, size);
    if (input.whole(0, 1) == 0) {
        anyKnots(input);
    } else if (const auto curve = fuzz::splineOf(input, 25)) {
        checkCurve(input, *curve);
    }
    return 0;
}
