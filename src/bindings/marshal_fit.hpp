// What is asked of a fit, of an interpolation and of an enclosing sphere, as values of the core.
#pragma once

#include "bindings/marshal_lists.hpp"
#include "geometry/enclosing_sphere.hpp"
#include "geometry/fitting.hpp"
#include "geometry/result.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace knotwork::bindings {

struct FitInput {
    LongList<Vec3> points;
    LongList<double> parameters;  ///< those that are given, which the request refers to
    FitRequest request;           ///< of an interpolation: without count, knots and options
};

/// { points, degree, count, form?, parameters?, knots?, interpolateEnds?, smoothing? }: straight
/// from the bytes, which must stay, where nothing is unusual, else by a table of fields. What is
/// refused has the codes and paths of that.
[[nodiscard]] Result<FitInput> readFit(std::span<const std::uint8_t> bytes);
/// { points, degree, form?, parameters? }.
[[nodiscard]] Result<FitInput> readInterpolation(std::span<const std::uint8_t> bytes);

struct SphereInput {
    LongList<Vec3> points;
    SphereMethod method = SphereMethod::minimal;
};

/// { points, method? }.
[[nodiscard]] Result<SphereInput> readSphere(std::span<const std::uint8_t> bytes);

// What the geometry refuses of these inputs as the caller knows it: the coordinate that is NaN, and
// not only its point.
[[nodiscard]] Error placedInFit(Error error, std::span<const std::uint8_t> bytes);
[[nodiscard]] Error placedInInterpolation(Error error, std::span<const std::uint8_t> bytes);
[[nodiscard]] Error placedInSphere(Error error, std::span<const std::uint8_t> bytes);

}  // namespace knotwork::bindings
