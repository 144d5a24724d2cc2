// A drawing that is made again and again, of which only what changed is made anew.
//
// The shapes of an object depend on the object itself (which is immutable), on its body as effects
// bend it, on where they place it and on the options. Objects are compared by address and kept alive
// meanwhile, so a moved point of one object leaves all the others as they are. Its own plots depend
// on knots and B-functions only and stay as well. An object that is only carried about is not sampled
// anew: its sketch, in its own coordinates, is placed once more.
#pragma once

#include "drawing/drawing.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace knotwork::drawing {

class DrawingCache {
public:
    DrawingCache();
    ~DrawingCache();
    DrawingCache(DrawingCache&&) noexcept;
    DrawingCache& operator=(DrawingCache&&) noexcept;

    /// What draw() answers; good until the next call.
    const Drawing& draw(const scene::State& state, const Options& options);
    [[nodiscard]] const Drawing& drawing() const noexcept { return drawing_; }
    void forget();

    /// How much was made anew, over all calls.
    struct Made {
        std::uint64_t figures = 0;  ///< sketched: sampled, measured
        std::uint64_t plots = 0;
        std::uint64_t placed = 0;   ///< only carried to another place or into another colour
        friend bool operator==(const Made&, const Made&) = default;
    };
    [[nodiscard]] const Made& made() const noexcept { return made_; }

private:
    struct Entry;
    void drawFigure(Entry& entry, const scene::Placed& placed, bool known, int number,
                    std::vector<Shape>& former);
    void drawPlots(Entry& entry, const scene::Placed& placed, bool known, int number,
                   std::vector<Shape>& former);

    Drawing drawing_;
    std::vector<std::unique_ptr<Entry>> entries_;
    Made made_;
};

}  // namespace knotwork::drawing
