#include "drawing/drawing_cache.hpp"

#include "drawing/sketch.hpp"

#include <iterator>
#include <span>
#include <utility>

namespace knotwork::drawing {

namespace {

using scene::Body;

/// Whether both are one body: copies share what they hold.
bool isSame(const Body& a, const Body& b) noexcept {
    if (a.curve() != nullptr && b.curve() != nullptr) return &a.curve()->kind() == &b.curve()->kind();
    if (a.surface() != nullptr && b.surface() != nullptr) {
        return &a.surface()->kind() == &b.surface()->kind();
    }
    return a.curve() == nullptr && a.surface() == nullptr && b.curve() == nullptr &&
           b.surface() == nullptr && a.subdivision() == b.subdivision() && a.cloud() == b.cloud() &&
           a.graph() == b.graph();
}

/// Whether the functions behind two bodies are the same.
bool haveSameFunctions(const Body& a, const Body& b) noexcept {
    const auto* spline = a.as<BsplineCurve>();
    const auto* otherSpline = b.as<BsplineCurve>();
    if (spline != nullptr && otherSpline != nullptr) {
        return spline->knotVector() == otherSpline->knotVector();
    }
    const auto* blend = a.as<BlendingCurve>();
    const auto* otherBlend = b.as<BlendingCurve>();
    if (blend != nullptr && otherBlend != nullptr) {
        return blend->knots() == otherBlend->knots() && blend->closed() == otherBlend->closed() &&
               blend->locals().size() == otherBlend->locals().size() &&
               blend->blend() == otherBlend->blend();
    }
    return isSame(a, b);
}

bool plotAlike(const scene::Object& a, const scene::Object& b) noexcept {
    return a.show.basis == b.show.basis && a.show.knots == b.show.knots &&
           a.show.bFunction == b.show.bFunction && a.style.colour == b.style.colour &&
           a.style.dashed == b.style.dashed;
}

/// Whether they ask for the same of an object at rest; the moment is in its body and its place.
bool askAlike(const Options& a, const Options& b) noexcept {
    return a.tolerance == b.tolerance && a.dark == b.dark && a.panes == b.panes &&
           a.pixel == b.pixel && a.combScale == b.combScale;
}

/// A part of the list of all shapes.
struct Run {
    std::size_t first = 0;
    std::size_t count = 0;
};

Run appendTo(std::vector<Shape>& all, std::span<Shape> shapes) {
    const Run run{all.size(), shapes.size()};
    all.insert(all.end(), std::make_move_iterator(shapes.begin()),
               std::make_move_iterator(shapes.end()));
    return run;
}

std::span<Shape> shapesOf(std::vector<Shape>& all, const Run& run) noexcept {
    return std::span<Shape>(all).subspan(run.first, run.count);
}

}  // namespace

struct DrawingCache::Entry {
    std::shared_ptr<const scene::Object> object;  ///< kept, so that its address stays its own
    Body body;
    Options options = {};  ///< with the tolerance in the object's own units
    Affine placement = {};
    Colour colour = {};
    Run figure = {};
    Run plots = {};
    Bounds bounds = {};
    /// The sketch of an object that is carried about; of one at rest its shapes are their own.
    std::vector<Shape> sketch = {};

    [[nodiscard]] bool sketches(const scene::Object* wanted, const Body& as,
                                const Options& own) const noexcept {
        return object.get() == wanted && isSame(body, as) && askAlike(options, own);
    }
    [[nodiscard]] bool plotsAs(const scene::Object& wanted, const Body& as,
                               const Options& own) const noexcept {
        return plotAlike(*object, wanted) && haveSameFunctions(body, as) &&
               options.dark == own.dark && options.panes == own.panes;
    }
};

DrawingCache::DrawingCache() = default;
DrawingCache::~DrawingCache() = default;
DrawingCache::DrawingCache(DrawingCache&&) noexcept = default;
DrawingCache& DrawingCache::operator=(DrawingCache&&) noexcept = default;

void DrawingCache::forget() {
    drawing_ = {};
    entries_.clear();
}

/// Moves or makes the figure of an object, and says where it lies now.
void DrawingCache::drawFigure(Entry& entry, const scene::Placed& placed, bool known, int number,
                              std::vector<Shape>& former) {
    const bool stays = known && entry.placement == placed.placement;
    const bool looksAlike = known && entry.colour == placed.colour;
    const bool rests = placed.placement == Affine{};
    std::vector<Shape> made;
    if (stays) {
        const std::span<Shape> old = shapesOf(former, entry.figure);
        made.assign(std::make_move_iterator(old.begin()), std::make_move_iterator(old.end()));
        if (!looksAlike) placeShapes(made, {}, placed.colour, entry.options.dark);
        if (!looksAlike) ++made_.placed;
    } else {
        if (!known || entry.sketch.empty()) {
            entry.sketch = sketchFigure(*entry.object, placed.body, number, entry.options);
            ++made_.figures;
        } else {
            ++made_.placed;
        }
        made = rests ? std::move(entry.sketch) : entry.sketch;
        if (rests) entry.sketch.clear();
        placeShapes(made, placed.placement, placed.colour, entry.options.dark);
        entry.bounds = {};
        for (const Shape& shape : made) entry.bounds.add(shape);
    }
    entry.figure = appendTo(drawing_.shapes, made);
}

void DrawingCache::drawPlots(Entry& entry, const scene::Placed& placed, bool known, int number,
                             std::vector<Shape>& former) {
    if (known) {
        entry.plots = appendTo(drawing_.shapes, shapesOf(former, entry.plots));
        return;
    }
    std::vector<Shape> made = sketchPlots(*entry.object, placed.body, number, entry.options);
    ++made_.plots;
    entry.plots = appendTo(drawing_.shapes, made);
}

const Drawing& DrawingCache::draw(const scene::State& state, const Options& options) {
    std::vector<Shape> former = std::move(drawing_.shapes);
    drawing_ = {};
    const std::vector<scene::Placed> all = scene::place(state, options.moment);
    entries_.resize(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const scene::Placed& placed = all[i];
        Options own = options;
        own.tolerance = ownTolerance(options.tolerance, placed.placement);
        std::unique_ptr<Entry>& entry = entries_[i];
        const bool figureKnown = entry && entry->sketches(placed.object, placed.body, own);
        const bool plotsKnown = entry && entry->plotsAs(*placed.object, placed.body, own);
        if (!entry) entry = std::make_unique<Entry>(Entry{state.objects[i], placed.body});
        entry->object = state.objects[i];
        entry->body = placed.body;
        entry->options = own;
        drawFigure(*entry, placed, figureKnown, static_cast<int>(i), former);
        drawPlots(*entry, placed, plotsKnown, static_cast<int>(i), former);
        entry->placement = placed.placement;
        entry->colour = placed.colour;
        drawing_.bounds.add(entry->bounds);
    }
    return drawing_;
}

}  // namespace knotwork::drawing
