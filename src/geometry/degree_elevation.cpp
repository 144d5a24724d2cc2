#include "geometry/degree_elevation.hpp"

#include "geometry/homogeneous.hpp"
#include "geometry/oslo.hpp"
#include "geometry/oslo_kernels.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace knotwork {

namespace {

/// Every knot once more than before, the new copy after the others.
std::vector<double> raisedMultiplicities(std::span<const double> knots) {
    std::vector<double> raised;
    for (std::size_t i = 0; i < knots.size(); ++i) {
        raised.push_back(knots[i]);
        if (i + 1 == knots.size() || knots[i + 1] != knots[i]) raised.push_back(knots[i]);
    }
    return raised;
}

/// d+1 knots before the last copy of the start of the domain, and as many after the first copy of
/// its end, which is what degree d+1 needs.
std::vector<double> raisedOpen(const KnotVector& knots) {
    const std::vector<double> raised = raisedMultiplicities(knots.knots());
    const Interval domain = knots.domain();
    const std::ptrdiff_t needed = knots.degree() + 1;
    const auto start = std::upper_bound(raised.begin(), raised.end(), domain.start) - 1;
    const auto end = std::lower_bound(raised.begin(), raised.end(), domain.end);
    return {start - needed, end + needed + 1};
}

/// Both ends of a period are the same knot: the new copy stands at its start.
std::vector<double> raisedPeriod(const KnotVector& knots) {
    const auto period = knots.knots();
    std::vector<double> raised = raisedMultiplicities(period);
    raised.pop_back();
    return raised;
}

Result<KnotVector> raisedKnots(const KnotVector& knots) {
    std::vector<double> raised = knots.closed() ? raisedPeriod(knots) : raisedOpen(knots);
    const int degree = knots.degree() + 1;
    const int count = static_cast<int>(raised.size()) - (knots.closed() ? 1 : degree + 1);
    auto made = KnotVector::make(std::move(raised), degree, count, knots.form());
    if (!made) return refuse(made.error().code, "by", made.error().message);
    return made;
}

/// The weights of the active points in the mean over all arguments but one.
void meanWeights(const OsloKnots& knots, std::size_t span, std::span<const double> arguments,
                 std::span<double> mean) {
    const std::size_t degree = knots.degree();
    std::array<double, maxDegree> rest{};
    std::array<double, maxDegree + 1> weights{};
    std::fill(mean.begin(), mean.end(), 0.0);
    for (std::size_t leftOut = 0; leftOut <= degree; ++leftOut) {
        for (std::size_t k = 0; k < degree; ++k) rest[k] = arguments[k < leftOut ? k : k + 1];
        kernels::discreteBsplines<double>(knots.all(), degree, span, rest, weights);
        for (std::size_t k = 0; k <= degree; ++k) mean[k] += weights[k];
    }
    for (std::size_t k = 0; k <= degree; ++k) mean[k] /= static_cast<double>(degree + 1);
}

Result<BsplineCurve> elevatedOnce(const BsplineCurve& curve) {
    auto raised = raisedKnots(curve.knotVector());
    if (!raised) return raised.error();
    const OsloKnots knots(curve.knotVector());
    const std::size_t degree = knots.degree();
    const std::vector<Homogeneous> points = homogeneousPoints(curve);
    const std::vector<Homogeneous> ordered =
        knots.inOrder(std::span<const Homogeneous>(points));
    std::vector<Homogeneous> out(static_cast<std::size_t>(raised->pointCount()));
    forEachOsloRow(knots, *raised, [&](std::size_t j, std::size_t span, auto arguments) {
        std::array<double, maxDegree + 1> mean{};
        meanWeights(knots, span, arguments, std::span(mean).first(degree + 1));
        Homogeneous sum(0);
        for (std::size_t k = 0; k <= degree; ++k) sum += mean[k] * ordered[span - degree + k];
        out[j] = sum;
    });
    return fromHomogeneous(std::move(*raised), out, curve.dimension(), !curve.weights().empty());
}

}  // namespace

Result<BsplineCurve> elevateDegree(const BsplineCurve& curve, int by) {
    if (by < 1) {
        return refuse(Code::outOfRange, "by",
                      "the degree would be raised by " + std::to_string(by) +
                          "; it is raised by at least 1");
    }
    if (by > maxDegree - curve.degree()) {
        return refuse(Code::tooLarge, "by",
                      "degree " + std::to_string(curve.degree()) + " raised by " +
                          std::to_string(by) + " is more than 25");
    }
    auto raised = elevatedOnce(curve);
    for (int i = 1; i < by && raised; ++i) raised = elevatedOnce(*raised);
    return raised;
}

}  // namespace knotwork
