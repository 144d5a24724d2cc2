#include "geometry/curve_sphere.hpp"

#include "geometry/closest_point.hpp"
#include "geometry/smooth_pieces.hpp"

#include <algorithm>
#include <vector>

namespace knotwork {

namespace {

/// The sphere to begin with needs no more points than this; the search finds the others.
constexpr std::size_t firstPoints = 256;
/// How far the curve may reach out of the sphere, of the radius.
constexpr double outside = 1e-13;
constexpr int mostRounds = 100;

std::vector<Vec3> samples(const Curve& curve) {
    std::vector<Vec3> points;
    const std::vector<Interval> pieces = smoothPieces(curve);
    const std::size_t stride = 1 + pieces.size() / (firstPoints / 2);
    for (std::size_t i = 0; i < pieces.size(); i += stride) {
        for (const double share : {0.0, 0.5}) {
            Vec3 point;
            evaluate(curve, pieces[i].start + share * pieces[i].length(), Side::right, {&point, 1});
            if (isFinite(point)) points.push_back(point);
        }
    }
    points.push_back(pointAt(curve, domain(curve).end));
    return points;
}

}  // namespace

Sphere enclosingSphere(const Curve& curve) {
    std::vector<Vec3> points = samples(curve);
    Sphere sphere;
    for (int round = 0; round < mostRounds; ++round) {
        const auto around = enclosingSphere(points);
        if (!around) return sphere;
        sphere = *around;
        const PointOnCurve farthest = farthestPoint(curve, sphere.center);
        const bool inside = farthest.distance <= sphere.radius * (1 + outside);
        sphere.radius = std::max(sphere.radius, farthest.distance);
        if (inside) break;
        points.push_back(farthest.point);
    }
    return sphere;
}

}  // namespace knotwork
