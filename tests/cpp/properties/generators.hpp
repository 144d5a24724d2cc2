// Random B-splines, B-functions and blending curves of every form, and where they are looked at.
//
// Each case prints as the object that kw.curve() or kw.bFunction() takes, so that what fails can be
// pasted into a page. Knots are single, multiple or *nearly* equal, down to the gaps that the
// limits allow.
#pragma once

#include "geometry/b_function.hpp"
#include "geometry/blending_curve.hpp"
#include "geometry/bspline_curve.hpp"
#include "geometry/curve.hpp"

#include <rapidcheck.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace knotwork::test {

/// A whole number, smaller ones tried first when a failure is made small.
rc::Gen<int> whole(int from, int to);
/// A number of 30 bits in [−size, size], towards 0 when made small.
rc::Gen<double> real(double size = 1);
rc::Gen<Vec3> spacePoint(double size, int dimension);

// As they are written in what kw.curve() takes.
std::string text(const std::vector<double>& values);
std::string text(const Vec3& p);
std::string text(Form form);
/// The fields of a pose.
std::string text(const Pose& pose);

struct KnotsCase {
    int degree = 1;
    Form form = Form::clamped;
    int count = 2;  ///< of the points of one line
    std::vector<double> knots;

    [[nodiscard]] KnotVector knotVector() const;
};
rc::Gen<KnotsCase> anyKnots(int maxDegree, int maxSpans, bool nearlyEqual = true);

struct SplineCase {
    int degree = 1;
    Form form = Form::clamped;
    std::vector<double> knots;
    std::vector<Vec3> points;
    std::vector<double> weights;
    int dimension = 3;

    [[nodiscard]] BsplineCurve curve() const;
    [[nodiscard]] KnotVector knotVector() const;
};
void showValue(const SplineCase& spline, std::ostream& out);

struct SplineOptions {
    int maxDegree = 7;
    double size = 1;  ///< of the coordinates
    bool rational = true;
    bool nearlyEqualKnots = true;
};
rc::Gen<SplineCase> anySpline(const SplineOptions& options = {});

struct BFunctionCase {
    BFunction function;
    std::string spec;
};
void showValue(const BFunctionCase& blend, std::ostream& out);

/// Every family over the whole range of its parameters.
rc::Gen<BFunctionCase> anyFamily();
/// Families that make no narrow peaks, in operations up to `depth` deep.
rc::Gen<BFunctionCase> anyBFunction(int depth = 2);

struct BlendingCase {
    Curve model;
    std::string modelSpec;
    std::size_t count = 2;
    BlendForm form = BlendForm::open;
    BFunctionCase blend;
    std::vector<double> knots;
    std::vector<Pose> poses;

    [[nodiscard]] BlendingCurve curve() const;
};
void showValue(const BlendingCase& blending, std::ostream& out);
rc::Gen<BlendingCase> anyBlending(bool doubleKnots = true);

/// One time in three the identity.
rc::Gen<Pose> somePose();
/// One knot a local (and the end of a period), over the domain.
rc::Gen<std::vector<double>> blendingKnots(const Interval& domain, std::size_t number,
                                           bool doubleKnots = true);

/// Both ends, every knot, the floating-point neighbours of each inside the domain, and `between`
/// others.
rc::Gen<std::vector<double>> parametersOf(const Interval& domain, std::vector<double> knots,
                                          int between = 6);
/// Those of this very case, for a curve with these knots.
[[nodiscard]] inline std::vector<double> parametersOf(const KnotVector& knots) {
    const auto given = knots.knots();
    return *parametersOf(knots.domain(), {given.begin(), given.end()});
}

}  // namespace knotwork::test
