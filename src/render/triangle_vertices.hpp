// Triangles as the triangle program reads them, and areas under graphs as triangles.
#pragma once

#include "drawing/colour_bytes.hpp"
#include "render/projection.hpp"

#include <span>
#include <vector>

namespace knotwork::render {

using drawing::ColourBytes;

struct TriangleVertex {
    float x = 0;  ///< device pixels from the middle of the pane
    float y = 0;
    float z = 0;
    ColourBytes colour{};
};
static_assert(sizeof(TriangleVertex) == 16);

/// The x,y,z triples of triangles between a graph (x,y,z triples with x ascending) and the line
/// y = base, appended to `into`. Where the graph crosses the line the area is cut there.
void appendAreaUnder(std::span<const double> graph, double base, std::vector<double>& into);

class TriangleVertices {
public:
    void clear() noexcept { records_.clear(); }
    [[nodiscard]] bool empty() const noexcept { return records_.empty(); }
    [[nodiscard]] const std::vector<TriangleVertex>& records() const noexcept { return records_; }

    /// Triangles of x,y,z triples, three to each, clipped to the neighbourhood of the pane.
    void add(const Projection& projection, std::span<const double> positions, ColourBytes colour);

private:
    std::vector<TriangleVertex> records_;
    std::vector<Vec3> polygon_;
    std::vector<Vec3> clipped_;
};

}  // namespace knotwork::render
