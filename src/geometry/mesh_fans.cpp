#include "geometry/mesh_fans.hpp"

namespace knotwork {

CornerWalk::CornerWalk(const FaceRows& faces, std::span<const std::uint32_t> cornerEdges,
                       std::size_t edges)
    : faces_(faces), twins_(cornerEdges.size(), noCorner) {
    std::vector<std::uint32_t> firstCorners;
    firstCorners.reserve(edges);
    for (std::size_t c = 0; c < cornerEdges.size(); ++c) {
        const std::uint32_t edge = cornerEdges[c];
        if (edge == firstCorners.size()) {  // edges are numbered as one meets them
            firstCorners.push_back(narrow(c));
            continue;
        }
        twins_[c] = firstCorners[edge];
        twins_[firstCorners[edge]] = narrow(c);
    }
    if (faces.uniformSize != 0) return;
    faceOf_.resize(cornerEdges.size());
    for (std::size_t f = 0; f < faces.count(); ++f) {
        for (std::size_t c = faces.begin(f); c < faces.begin(f + 1); ++c) faceOf_[c] = narrow(f);
    }
}

bool walkFan(const CornerWalk& walk, std::uint32_t first, std::vector<std::uint32_t>& corners) {
    corners.clear();
    std::uint32_t corner = first;
    do {
        corners.push_back(corner);
        corner = walk.turned(corner);
    } while (corner != noCorner && corner != first);
    return corner == first;
}

}  // namespace knotwork
