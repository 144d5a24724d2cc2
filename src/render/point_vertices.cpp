#include "render/point_vertices.hpp"

#include <algorithm>
#include <cmath>

namespace knotwork::render {

void PointVertices::sortFarthestFirst() {
    std::stable_sort(records_.begin(), records_.end(),
                     [](const PointVertex& a, const PointVertex& b) { return a.z > b.z; });
}

void PointVertices::add(const Projection& projection, const Vec3& at, PointVertex looks) {
    const Vec3 p = projection.toPane(at);
    if (!isFinite(p)) return;
    // a corner of a square reaches sqrt 2 times as far as its side
    const double reach = 1.5 * static_cast<double>(looks.radius + looks.border + looks.halo) + 1;
    if (std::abs(p.x) > 0.5 * projection.pane().width + reach) return;
    if (std::abs(p.y) > 0.5 * projection.pane().height + reach) return;
    looks.x = static_cast<float>(p.x);
    looks.y = static_cast<float>(p.y);
    looks.z = static_cast<float>(p.z) - looks.z;
    records_.push_back(looks);
}

}  // namespace knotwork::render
