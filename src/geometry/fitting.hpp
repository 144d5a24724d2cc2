// Curves through and near points: parameters, knots and then least squares.
#pragma once

#include "geometry/bspline_curve.hpp"
#include "geometry/knot_vector.hpp"
#include "geometry/least_squares_curve.hpp"
#include "geometry/parametrisation.hpp"
#include "geometry/result.hpp"
#include "geometry/vec.hpp"

#include <span>
#include <variant>
#include <vector>

namespace knotwork {

/// How parameters are found, or the parameters themselves, which must stay while they are used.
using Parameters = std::variant<Parametrisation, std::span<const double>>;

struct FitRequest {
    int degree = 3;
    int count = 4;  ///< of control points
    Form form = Form::clamped;
    Parameters parameters = Parametrisation::chord;
    /// As KnotVector::make() wants them. Empty: uniformKnots() over the parameterRange(), but
    /// averagedKnots() where the count is that of the points.
    std::vector<double> knots{};
    LeastSquares options{};
};

struct Fit {
    BsplineCurve curve;
    std::vector<double> parameters;  ///< that were found; none where they were given
    Residuals residuals;
};

/// leastSquaresCurve() with parameters and knots found as the request says. Refuses also what
/// parametersOf() and KnotVector::make() refuse, a count of no more than the degree (OUT_OF_RANGE
/// `count`) or of more than 100 000 (TOO_LARGE), and parameters of one's own that span less than
/// 1e-6 where knots are to be made for them (OUT_OF_RANGE `parameters`).
[[nodiscard]] Result<Fit> fitCurve(std::span<const Vec3> points, FitRequest request);

/// The curve through all the points, one control point each: fitCurve() with as many control
/// points as points, averagedKnots() and no smoothing. WRONG_LENGTH `points` for no more of them
/// than the degree.
[[nodiscard]] Result<Fit> interpolateCurve(std::span<const Vec3> points, int degree, Form form,
                                           Parameters parameters = Parametrisation::chord);

}  // namespace knotwork
