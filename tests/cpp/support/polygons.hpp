// Polygons and their subdivision as tests make them: whole numbers, whole final polygons.
#pragma once

#include "geometry/curve_subdivision.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace knotwork::test {

/// Whole numbers up to 50 in size, so that a few levels are exact.
inline std::vector<Vec3> wholePoints(std::size_t count, unsigned seed) {
    std::mt19937 engine(seed);
    std::uniform_int_distribution<int> coordinate(-50, 50);
    std::vector<Vec3> points(count);
    for (Vec3& point : points) {
        for (int axis = 0; axis < 3; ++axis) point[axis] = coordinate(engine);
    }
    return points;
}

inline std::vector<Vec3> square() { return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}; }

inline CurveSubdivision laneRiesenfeld(int degree, std::vector<Vec3> points, bool closed,
                                       int levels) {
    return {CurveScheme::laneRiesenfeld, std::move(points), closed, levels, degree};
}

inline CurveSubdivision chaikin(std::vector<Vec3> points, bool closed, int levels) {
    return {CurveScheme::chaikin, std::move(points), closed, levels};
}

inline CurveSubdivision fourPoint(double tension, std::vector<Vec3> points, bool closed,
                                  int levels) {
    return {CurveScheme::fourPoint, std::move(points), closed, levels, 3, tension};
}

inline std::vector<Vec3> subdivided(const CurveSubdivision& subdivision) {
    const FinalPolygon polygon(subdivision);
    std::vector<double> xyz(3 * polygon.size());
    polygon.points(0, xyz);
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < xyz.size(); i += 3) points.emplace_back(xyz[i], xyz[i + 1], xyz[i + 2]);
    return points;
}

inline double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double largest = a.size() == b.size() ? 0 : HUGE_VAL;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        largest = std::max(largest, glm::length(a[i] - b[i]));
    }
    return largest;
}

}  // namespace knotwork::test
