#include "geometry/fitting.hpp"

#include "geometry/schoenberg_whitney.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace knotwork {

namespace {

constexpr double shortestRange = 1e-6;  // of a domain

using MaybeError = std::optional<Error>;

MaybeError checkSizes(int degree, int count) {
    if (degree < 1 || degree > maxDegree) {
        return refuse(degree < 1 ? Code::outOfRange : Code::tooLarge, "degree",
                      "degree is " + std::to_string(degree) + "; it must be 1 to 25");
    }
    if (count > maxPointCount) {
        return refuse(Code::tooLarge, "count",
                      std::to_string(count) + " control points; at most 100000 are supported");
    }
    if (count <= degree) {
        return refuse(Code::outOfRange, "count",
                      std::to_string(count) + " control points are too few for degree " +
                          std::to_string(degree) + "; take at least " +
                          std::to_string(degree + 1));
    }
    return {};
}

/// Found ones; none where they are given.
Result<std::vector<double>> parametersFor(std::span<const Vec3> points, const Parameters& wanted,
                                          Form form) {
    if (const auto* how = std::get_if<Parametrisation>(&wanted)) {
        return parametersOf(points, *how, form == Form::closed);
    }
    if (auto error = checkParameters(std::get<std::span<const double>>(wanted), points.size())) {
        return *error;
    }
    return std::vector<double>();
}

/// The second of two data so close that knots between them would not be told apart.
std::optional<std::size_t> crowdedDatum(std::span<const double> u, const Interval& range,
                                        bool closed) {
    const double largest = std::max(std::abs(range.start), std::abs(range.end));
    const double least = std::max(4e-12 * range.length(),
                                  64 * std::numeric_limits<double>::epsilon() * largest);
    for (std::size_t k = 1; k < u.size(); ++k) {
        if (!(u[k] - u[k - 1] >= least)) return k;
    }
    if (closed && !(range.end - u.back() >= least)) return u.size() - 1;
    return std::nullopt;
}

Result<KnotVector> defaultKnots(std::span<const double> parameters, const FitRequest& request) {
    const bool closed = request.form == Form::closed;
    if (!(parameters.back() - parameters.front() >= shortestRange)) {
        return refuse(Code::outOfRange, "parameters",
                      "the parameters span less than 1e-6, which leaves no room for knots");
    }
    const Interval range = parameterRange(parameters, closed);
    const auto count = static_cast<std::size_t>(request.count);
    bool averaged = parameters.size() == count;
    if (averaged) {
        const auto crowded = crowdedDatum(parameters, range, closed);
        if (crowded && request.options.smoothing == 0) return refuseStarved(*crowded);
        averaged = !crowded;
    }
    auto knots = KnotVector::make(
        averaged ? averagedKnots(parameters, request.degree, request.form)
                 : uniformKnots(range, request.degree, request.count, request.form),
        request.degree, request.count, request.form);
    if (knots) return knots;
    return refuse(Code::outOfRange, "parameters",
                  "no knots can be made for these parameters: " + knots.error().message);
}

}  // namespace

Result<Fit> fitCurve(std::span<const Vec3> points, FitRequest request) {
    if (auto error = checkSizes(request.degree, request.count)) return *error;
    if (auto error = checkFit(points, request.options, request.form == Form::closed)) return *error;
    auto found = parametersFor(points, request.parameters, request.form);
    if (!found) return found.error();
    const auto* given = std::get_if<std::span<const double>>(&request.parameters);
    const std::span<const double> parameters = given != nullptr ? *given : *found;
    const auto knots = request.knots.empty()
                           ? defaultKnots(parameters, request)
                           : KnotVector::make(std::move(request.knots), request.degree, request.count,
                                              request.form);
    if (!knots) return knots.error();
    if (auto error = checkInside(parameters, knots->domain())) return *error;
    auto curve = checkedLeastSquares(points, parameters, *knots, request.options);
    if (!curve) return curve.error();
    const Residuals residuals = residualsOf(*curve, points, parameters);
    return Fit{std::move(*curve), std::move(*found), residuals};
}

Result<Fit> interpolateCurve(std::span<const Vec3> points, int degree, Form form,
                             Parameters parameters) {
    const int count = static_cast<int>(std::min<std::size_t>(points.size(), maxPointCount + 1));
    if (auto error = checkSizes(degree, count)) {
        if (error->path == "count") {
            error->path = "points";
            if (error->code == Code::outOfRange) error->code = Code::wrongLength;
        }
        return *error;
    }
    return fitCurve(points, {.degree = degree, .count = count, .form = form,
                             .parameters = parameters});
}

}  // namespace knotwork
