#include "render/triangle_vertices.hpp"

#include <algorithm>
#include <cmath>

namespace knotwork::render {
namespace {

Vec3 tripleAt(std::span<const double> positions, std::size_t i) {
    return {positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]};
}

void append(std::vector<double>& into, const Vec3& p) {
    into.push_back(p.x);
    into.push_back(p.y);
    into.push_back(p.z);
}

void appendTriangle(std::vector<double>& into, const Vec3& a, const Vec3& b, const Vec3& c) {
    append(into, a);
    append(into, b);
    append(into, c);
}

/// The trapezium between a piece of graph that does not cross the line and the line.
void appendTrapezium(std::vector<double>& into, const Vec3& a, const Vec3& b, double base) {
    const Vec3 footOfA(a.x, base, a.z);
    const Vec3 footOfB(b.x, base, b.z);
    if (a.y != base) appendTriangle(into, footOfA, a, b.y != base ? b : footOfB);
    if (b.y != base) appendTriangle(into, footOfA, b, footOfB);
}

/// Keeps what of a convex polygon lies where side(p) >= 0 (Sutherland and Hodgman, 1974).
template <class Side>
void keepSide(const std::vector<Vec3>& polygon, std::vector<Vec3>& kept, const Side& side) {
    kept.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3& a = polygon[i];
        const Vec3& b = polygon[(i + 1) % polygon.size()];
        const double sideOfA = side(a);
        const double sideOfB = side(b);
        if (sideOfA >= 0) kept.push_back(a);
        if ((sideOfA < 0) != (sideOfB < 0)) {
            kept.push_back(a + sideOfA / (sideOfA - sideOfB) * (b - a));
        }
    }
}

}  // namespace

void appendAreaUnder(std::span<const double> graph, double base, std::vector<double>& into) {
    for (std::size_t i = 0; i + 1 < graph.size() / 3; ++i) {
        const Vec3 a = tripleAt(graph, i);
        const Vec3 b = tripleAt(graph, i + 1);
        if ((a.y - base) * (b.y - base) >= 0) {
            appendTrapezium(into, a, b, base);
            continue;
        }
        const Vec3 crossing = a + (base - a.y) / (b.y - a.y) * (b - a);
        const Vec3 onBase(crossing.x, base, crossing.z);
        appendTrapezium(into, a, onBase, base);
        appendTrapezium(into, onBase, b, base);
    }
}

void TriangleVertices::add(const Projection& projection, std::span<const double> positions,
                           ColourBytes colour) {
    const double halfX = 0.5 * projection.pane().width + 2;
    const double halfY = 0.5 * projection.pane().height + 2;
    for (std::size_t i = 0; i + 2 < positions.size() / 3; i += 3) {
        polygon_.clear();
        for (std::size_t k = i; k < i + 3; ++k) {
            polygon_.push_back(projection.toPane(tripleAt(positions, k)));
        }
        if (!std::all_of(polygon_.begin(), polygon_.end(), isFinite)) continue;
        keepSide(polygon_, clipped_, [=](const Vec3& p) { return p.x + halfX; });
        keepSide(clipped_, polygon_, [=](const Vec3& p) { return halfX - p.x; });
        keepSide(polygon_, clipped_, [=](const Vec3& p) { return p.y + halfY; });
        keepSide(clipped_, polygon_, [=](const Vec3& p) { return halfY - p.y; });
        for (std::size_t k = 1; k + 1 < polygon_.size(); ++k) {
            for (const std::size_t corner : {std::size_t{0}, k, k + 1}) {
                const Vec3& p = polygon_[corner];
                records_.push_back({static_cast<float>(p.x), static_cast<float>(p.y),
                                    static_cast<float>(p.z), colour});
            }
        }
    }
}

}  // namespace knotwork::render
