// Points as the point program reads them.
#pragma once

#include "drawing/colour_bytes.hpp"
#include "render/projection.hpp"

#include <array>
#include <vector>

namespace knotwork::render {

using drawing::ColourBytes;

struct PointVertex {
    float x = 0;  ///< device pixels from the middle of the pane
    float y = 0;
    float z = 0;
    float radius = 4;  ///< device pixels; of a square half its side
    float border = 0;  ///< width outside the radius, device pixels
    float halo = 0;    ///< width outside the border, device pixels
    float square = 0;  ///< 1 for a square, 0 for a disc
    ColourBytes fill{};
    ColourBytes borderColour{};
    ColourBytes haloColour{};
    std::array<float, 2> unused{};  // three texels a record
};
static_assert(sizeof(PointVertex) == 48);

class PointVertices {
public:
    void clear() noexcept { records_.clear(); }
    [[nodiscard]] bool empty() const noexcept { return records_.empty(); }
    [[nodiscard]] const std::vector<PointVertex>& records() const noexcept { return records_; }

    /// What is nearer covers what is farther; equally far points keep their order.
    void sortFarthestFirst();
    /// Adds the point with the looks of `looks`, unless it cannot be seen in the pane. z of `looks`
    /// is how much nearer than it is the point is set.
    void add(const Projection& projection, const Vec3& at, PointVertex looks);

private:
    std::vector<PointVertex> records_;
};

}  // namespace knotwork::render
