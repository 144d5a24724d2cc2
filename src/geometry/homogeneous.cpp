#include "geometry/homogeneous.hpp"

#include <utility>

namespace knotwork {

std::vector<Homogeneous> homogeneousPoints(const BsplineCurve& curve) {
    std::vector<Homogeneous> points;
    points.reserve(curve.points().size());
    for (std::size_t i = 0; i < curve.points().size(); ++i) {
        const double weight = curve.weights().empty() ? 1 : curve.weights()[i];
        points.emplace_back(weight * curve.points()[i], weight);
    }
    return points;
}

Result<BsplineCurve> fromHomogeneous(KnotVector knots, std::span<const Homogeneous> points,
                                     int dimension, bool weighted) {
    std::vector<Vec3> positions;
    std::vector<double> weights;
    positions.reserve(points.size());
    weights.reserve(weighted ? points.size() : 0);
    for (const Homogeneous& point : points) {
        positions.push_back(weighted ? Vec3(point) / point.w : Vec3(point));
        if (weighted) weights.push_back(point.w);
    }
    return BsplineCurve::make(std::move(knots), std::move(positions), dimension,
                              std::move(weights));
}

}  // namespace knotwork
