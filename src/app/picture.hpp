// The drawing of a view, made again only when something that it depends on has changed.
#pragma once

#include "drawing/drawing_cache.hpp"
#include "drawing/screen.hpp"
#include "scene/scene.hpp"

#include <optional>

namespace knotwork::app {

/// The chord error that nobody sees at this scale: between 0.075 and 0.15 device pixels. It goes in
/// steps of 2, so that zooming does not sample everything anew in every frame.
[[nodiscard]] double toleranceAt(double devicePixelsPerUnit) noexcept;
/// About how many world units a device pixel is where that is the tolerance.
[[nodiscard]] double pixelAt(double tolerance) noexcept;

/// The bounds of all that moves, over a whole loop, so that nothing leaves a view that fits them, as
/// they are after the orientation.
[[nodiscard]] drawing::Bounds loopBounds(
    const scene::State& state,
    const drawing::Orientation& orientation = drawing::planeOrientation());

class Picture {
public:
    struct Key {
        std::uint64_t revision = 0;
        double phase = 0;  ///< 0 where nothing moves
        double tolerance = 0;
        bool dark = false;
        drawing::Panes panes;
        double pixel = 0;  ///< world units a CSS pixel, in steps as the tolerance
        friend bool operator==(const Key&, const Key&) = default;
    };

    const drawing::Drawing& get(const scene::State& state, const Key& key,
                                const scene::Moment& moment);
    /// For another scene.
    void forget() {
        key_.reset();
        drawings_.forget();
    }
    /// How many drawings have been made.
    [[nodiscard]] std::uint64_t made() const noexcept { return made_; }

private:
    std::optional<Key> key_;
    drawing::DrawingCache drawings_;
    std::uint64_t made_ = 0;
};

}  // namespace knotwork::app
