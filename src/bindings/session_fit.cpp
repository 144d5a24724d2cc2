// The part of the session that fits curves to points, and spheres around them.
#include "bindings/marshal_fit.hpp"
#include "bindings/session.hpp"

#include <utility>

namespace knotwork::bindings {

/// Parameters that were given are left where they crossed, or where they were copied to.
int Session::holdFit(Fit fit) {
    const int handle = holdCurve({Curve(std::move(fit.curve)), std::nullopt, std::nullopt, {}});
    block_[curveTraits] = fit.residuals.sumOfSquares;
    block_[curveTraits + 1] = fit.residuals.rms;
    block_[curveTraits + 2] = fit.residuals.max;
    bulk_ = std::move(fit.parameters);
    list_ = bulk_.data();
    block_[curveTraits + 3] = static_cast<double>(bulk_.size());
    return handle;
}

int Session::fit(unsigned bytes) {
    const auto given = inputBytes(bytes);
    auto input = readFit(given);
    if (!input) return refuse(input.error());
    auto fit = fitCurve(input->points.all, std::move(input->request));
    if (!fit) return refuse(placedInFit(fit.error(), given));
    return holdFit(std::move(*fit));
}

int Session::interpolate(unsigned bytes) {
    const auto given = inputBytes(bytes);
    auto input = readInterpolation(given);
    if (!input) return refuse(input.error());
    const FitRequest& request = input->request;
    auto fit = interpolateCurve(input->points.all, request.degree, request.form,
                                request.parameters);
    if (!fit) return refuse(placedInInterpolation(fit.error(), given));
    return holdFit(std::move(*fit));
}

bool Session::enclosingSphere(unsigned bytes) {
    const auto given = inputBytes(bytes);
    const auto input = readSphere(given);
    if (!input) return refuse(input.error());
    const auto sphere = knotwork::enclosingSphere(input->points.all, input->method);
    if (!sphere) return refuse(placedInSphere(sphere.error(), given));
    block_[0] = sphere->center.x;
    block_[1] = sphere->center.y;
    block_[2] = sphere->center.z;
    block_[3] = sphere->radius;
    return true;
}

}  // namespace knotwork::bindings
