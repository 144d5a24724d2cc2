// What the traces of B-spline algorithms share: a parameter in its span, and points with weights.
#pragma once

#include "geometry/bspline_curve.hpp"
#include "geometry/homogeneous.hpp"
#include "scene/trace_parts.hpp"

#include <span>
#include <vector>

namespace knotwork::scene {

/// As drawn: divided by their weights where these matter.
[[nodiscard]] Vec3 drawn(const Homogeneous& point, bool weighted) noexcept;
[[nodiscard]] std::vector<Vec3> drawn(std::span<const Homogeneous> points, bool weighted);

/// A parameter, and the span of the extended knots in which curve.point() evaluates it.
struct SplineSpan {
    SplineSpan(const BsplineCurve& of, double parameter);

    [[nodiscard]] double weight(std::size_t k, std::size_t i) const;
    /// The point that function i of the extended vector belongs to.
    [[nodiscard]] std::size_t pointOf(std::size_t i) const noexcept;
    [[nodiscard]] std::vector<Homogeneous> activePoints() const;
    /// Levels 0 … d of de Boor's algorithm: level r has d+1-r points.
    [[nodiscard]] std::vector<std::vector<Homogeneous>> levels() const;
    /// `t`, `span` (its number among the extended knots, as in the formulae), `from`, `to`,
    /// `degree`, `count`, `active`, `first` and `last`.
    [[nodiscard]] SentenceValues values() const;
    [[nodiscard]] std::string text(const Vec3& point) const;
    [[nodiscard]] std::string text(double knot) const { return readable(knot, parameters); }

    const BsplineCurve* curve;
    std::span<const double> knots;
    std::size_t degree;
    double t;
    std::size_t index;
    Reading parameters;
    Reading places;
};

/// The whole control polygon, those points marked that act on the span.
void drawPolygon(TraceFrame& frame, const SplineSpan& span);

/// (t - t_i) / (t_{i+k} - t_i), in notation, with symbols and with numbers.
[[nodiscard]] std::string ratioSymbols(std::size_t k, std::size_t i);
[[nodiscard]] std::string ratioNumbers(std::span<const double> knots, std::size_t k, std::size_t i,
                                       double t, const Reading& reading);

}  // namespace knotwork::scene
