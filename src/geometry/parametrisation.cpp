#include "geometry/parametrisation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace knotwork {

namespace {

// Below it the squares of coordinates have lost digits to underflow.
constexpr double shortestLength = 1e-140;

double power(double chord, Parametrisation how) noexcept {
    return how == Parametrisation::centripetal ? std::sqrt(chord) : chord;
}

/// Leaves the sums of the first k powers in u[k] and answers the sum of all.
template <class Length>
double accumulate(std::span<const Vec3> points, Parametrisation how, bool closed,
                  std::span<double> u, Length length) {
    double sum = 0;
    u[0] = 0;
    for (std::size_t k = 1; k < points.size(); ++k) {
        sum += power(length(points[k] - points[k - 1]), how);
        u[k] = sum;
    }
    return closed ? sum + power(length(points.front() - points.back()), how) : sum;
}

std::vector<double> uniformParameters(std::size_t count, bool closed) {
    std::vector<double> u(count);
    for (std::size_t k = 0; k < count; ++k) {
        u[k] = closed ? static_cast<double>(k) / static_cast<double>(count)
                      : uniformParameter({0, 1}, k, count);
    }
    return u;
}

}  // namespace

Result<std::vector<double>> parametersOf(std::span<const Vec3> points, Parametrisation how,
                                         bool closed) {
    if (points.size() < 2) {
        return refuse(Code::wrongLength, "points",
                      std::to_string(points.size()) + " points given; at least 2 are needed");
    }
    if (how == Parametrisation::uniform) return uniformParameters(points.size(), closed);
    std::vector<double> u(points.size());
    double total = accumulate(points, how, closed, u, [](const Vec3& v) { return glm::length(v); });
    if (!(total > shortestLength)) {
        total = accumulate(points, how, closed, u,
                           [](const Vec3& v) { return std::hypot(v.x, v.y, v.z); });
    }
    if (!(total > 0)) {
        return refuse(Code::outOfRange, "points",
                      "all points are equal, and their distances give no parameters; use "
                      "'uniform' ones or give others");
    }
    for (double& value : u) value = std::min(value / total, 1.0);
    if (!closed) u.back() = 1;
    return u;
}

Interval parameterRange(std::span<const double> parameters, bool closed) {
    const Interval range{parameters.front(), parameters.back()};
    if (!closed) return range;
    if (range.start >= 0 && range.end < 1) return {0, 1};
    return {range.start,
            range.end + range.length() / static_cast<double>(parameters.size() - 1)};
}

std::vector<double> uniformKnots(const Interval& range, int degree, int count, Form form) {
    const int spans = form == Form::closed ? count : count - degree;
    const int before = form == Form::closed ? 0 : degree;
    const double step = range.length() / spans;
    std::vector<double> knots(KnotVector::knotCount(degree, count, form));
    for (std::size_t i = 0; i < knots.size(); ++i) {
        int index = static_cast<int>(i) - before;
        if (form == Form::clamped) index = std::clamp(index, 0, spans);
        const bool inside = 0 <= index && index <= spans;
        knots[i] = inside ? uniformParameter(range, static_cast<std::size_t>(index),
                                             static_cast<std::size_t>(spans) + 1)
                          : (index < 0 ? range.start + index * step
                                       : range.end + (index - spans) * step);
    }
    return knots;
}

std::vector<double> averagedKnots(std::span<const double> parameters, int degree, Form form) {
    const std::size_t n = parameters.size();
    const auto d = static_cast<std::size_t>(degree);
    const Interval range = parameterRange(parameters, form == Form::closed);
    if (form != Form::closed) {
        std::vector<double> knots = uniformKnots(range, degree, static_cast<int>(n), form);
        for (std::size_t j = 1; j + d < n; ++j) {
            double sum = 0;
            for (std::size_t k = j; k < j + d; ++k) sum += parameters[k];
            knots[j + d] = sum / degree;
        }
        return knots;
    }
    std::vector<double> knots(parameters.begin(), parameters.end());
    if (d % 2 == 0) {
        const double gap = range.length() - (parameters.back() - parameters.front());
        knots[0] = parameters.front() - gap / 2;
        for (std::size_t k = 1; k < n; ++k) knots[k] = (parameters[k - 1] + parameters[k]) / 2;
    }
    knots.push_back(knots.front() + range.length());
    return knots;
}

}  // namespace knotwork
