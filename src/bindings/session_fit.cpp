// The part of the session that fits curves to points, and spheres around them.
#include "bindings/marshal_fit.hpp"
#include "bindings/session.hpp"

#include <utility>

namespace knotwork::bindings {

int Session::holdFit(Fit fit) {
    const int handle = holdCurve({Curve(std::move(fit.curve)), std::nullopt, std::nullopt, {}});
    block_[curveTraits] = fit.residuals.sumOfSquares;
    block_[curveTraits + 1] = fit.residuals.rms;
    block_[curveTraits + 2] = fit.residuals.max;
    const std::size_t parameters = fit.parameters.size();
    block_[curveTraits + 3] = leave(std::move(fit.parameters), parameters);
    return handle;
}

int Session::fit(unsigned bytes) {
    const auto given = inputBytes(bytes);
    auto input = readFit(given);
    if (!input) return refuse(input.error());
    auto fit = fitCurve(input->points, std::move(input->request));
    return fit ? holdFit(std::move(*fit)) : refuse(placedInFit(fit.error(), given));
}

int Session::interpolate(unsigned bytes) {
    const auto given = inputBytes(bytes);
    auto input = readInterpolation(given);
    if (!input) return refuse(input.error());
    auto fit = interpolateCurve(input->points, input->request.degree, input->request.form,
                                std::move(input->request.parameters));
    return fit ? holdFit(std::move(*fit)) : refuse(placedInInterpolation(fit.error(), given));
}

bool Session::enclosingSphere(unsigned bytes) {
    const auto given = inputBytes(bytes);
    const auto input = readSphere(given);
    if (!input) return refuse(input.error());
    const auto sphere = knotwork::enclosingSphere(input->points, input->method);
    if (!sphere) return refuse(placedInSphere(sphere.error(), given));
    block_[0] = sphere->center.x;
    block_[1] = sphere->center.y;
    block_[2] = sphere->center.z;
    block_[3] = sphere->radius;
    return true;
}

}  // namespace knotwork::bindings
