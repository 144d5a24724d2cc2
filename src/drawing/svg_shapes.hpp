// The shapes of a pane as SVG.
#pragma once

#include "drawing/screen.hpp"
#include "drawing/svg.hpp"
#include "drawing/xml.hpp"
#include "geometry/sliced_work.hpp"

#include <algorithm>
#include <vector>

namespace knotwork::drawing {

/// A pane where it stands in the picture.
struct PanePicture {
    Pane pane = Pane::curve;
    Affine screen;  ///< from the pane's world to pixels
    SvgTheme theme = SvgTheme::light;
    int object = -1;  ///< only this one, or all
    int index = -1;   ///< only the shapes with this index, or all
    Frame frame = {};  ///< in which labels stay; empty: anywhere
    std::vector<int> besides = {};  ///< objects that are compared with it

    [[nodiscard]] bool shows(const Shape& shape) const noexcept {
        const bool compared =
            std::find(besides.begin(), besides.end(), shape.object) != besides.end();
        const bool wanted = object < 0 || shape.object == object || compared;
        return shape.pane == pane && wanted && (index < 0 || shape.index == index);
    }
};

/// Has a group written for each run of shapes of one object, and in it one for each run of one role.
/// What it is given by reference, but for the picture, must outlive the work.
void planShapes(SlicedWork& work, XmlWriter& xml, const Drawing& drawing,
                const scene::State& state, const PanePicture& picture);
/// The same at once.
void writeShapes(XmlWriter& xml, const Drawing& drawing, const scene::State& state,
                 const PanePicture& picture);

}  // namespace knotwork::drawing
