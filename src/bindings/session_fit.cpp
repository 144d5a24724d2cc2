// The part of the session that fits curves to points, and spheres around them.
#include "bindings/marshal_fit.hpp"
#include "bindings/session.hpp"

#include <utility>

namespace knotwork::bindings {

int Session::holdFit(Result<Fit> fit) {
    if (!fit) return refuse(fit.error());
    const int handle = holdCurve({Curve(std::move(fit->curve)), std::nullopt, std::nullopt, {}});
    block_[curveTraits] = fit->residuals.sumOfSquares;
    block_[curveTraits + 1] = fit->residuals.rms;
    block_[curveTraits + 2] = fit->residuals.max;
    block_[curveTraits + 3] = static_cast<double>(fit->parameters.size());
    bulk_ = std::move(fit->parameters);
    return handle;
}

int Session::fit(unsigned bytes) {
    const auto input = readFit(inputBytes(bytes));
    return input ? holdFit(fitCurve(input->points, input->request)) : refuse(input.error());
}

int Session::interpolate(unsigned bytes) {
    auto input = readInterpolation(inputBytes(bytes));
    if (!input) return refuse(input.error());
    return holdFit(interpolateCurve(input->points, input->request.degree, input->request.form,
                                    std::move(input->request.parameters)));
}

bool Session::enclosingSphere(unsigned bytes) {
    const auto input = readSphere(inputBytes(bytes));
    if (!input) return refuse(input.error());
    const auto sphere = knotwork::enclosingSphere(input->points, input->method);
    if (!sphere) return refuse(sphere.error());
    block_[0] = sphere->center.x;
    block_[1] = sphere->center.y;
    block_[2] = sphere->center.z;
    block_[3] = sphere->radius;
    return true;
}

}  // namespace knotwork::bindings
