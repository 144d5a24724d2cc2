#include "app/painter.hpp"

#include "drawing/palette.hpp"
#include "ui/theme.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace knotwork::app {

namespace {

using render::Projection;
using render::Rect;
using render::Renderer;

/// A box of CSS pixels from the top left as whole device pixels from the bottom left.
Rect deviceRect(const Box& box, const Canvas& canvas) noexcept {
    const auto pixel = [&](double css) { return static_cast<int>(std::lround(css * canvas.pixelRatio)); };
    const int left = std::clamp(pixel(box.x), 0, canvas.width);
    const int right = std::clamp(pixel(box.right()), left, canvas.width);
    const int top = std::clamp(pixel(box.y), 0, canvas.height);
    const int bottom = std::clamp(pixel(box.bottom()), top, canvas.height);
    return {left, canvas.height - bottom, right - left, bottom - top};
}

/// The projection that puts a plane where the map does. The rectangle's own middle is used, since
/// its edges were rounded to whole pixels.
Projection projectionOf(const PlaneMap& map, const Rect& rect, const Canvas& canvas) noexcept {
    const double middleX = (rect.x + rect.width / 2.0) / canvas.pixelRatio;
    const double middleY = (canvas.height - rect.y - rect.height / 2.0) / canvas.pixelRatio;
    return Projection::flat(rect, map.fromPixels({middleX, middleY}),
                            1 / (map.scaleX * canvas.pixelRatio),
                            1 / (map.scaleY * canvas.pixelRatio));
}

/// The same of a pane in space. Its reach is doubled, so that nothing that people drag out of it is
/// cut off at once.
Projection projectionOf(const PaneFigure& pane, const Rect& rect, const Canvas& canvas) noexcept {
    const Pixel middle{(rect.x + rect.width / 2.0) / canvas.pixelRatio,
                       (canvas.height - rect.y - rect.height / 2.0) / canvas.pixelRatio};
    return Projection::parallel(rect, pane.sight.fromPixels(middle, pane.middle),
                                pane.sight.orientation(),
                                pane.sight.unitsPerPixel() / canvas.pixelRatio, 2 * pane.reach);
}

void paintLines(Renderer& renderer, const std::vector<ui::Lines>& all) {
    for (const ui::Lines& lines : all) {
        if (lines.segments.empty()) continue;
        render::Stroke stroke;
        stroke.colour = lines.colour;
        stroke.width = lines.width;
        stroke.dashed = lines.dashed;
        renderer.segments(lines.segments, stroke);
    }
}

/// Where more contrast is asked for, lines and points stand out as text does; what is faint beside
/// them stays a little so.
void makeClearer(render::PaintOptions& options, const Painted& painted, const ui::Theme& theme) {
    constexpr double leastOpacity = 0.7;
    scene::Colour colour =
        drawing::withContrast(painted.shape->colour, theme.background, drawing::clearContrast);
    colour.alpha = std::max(colour.alpha, leastOpacity);
    options.colour = colour;
    options.opacity = std::max(options.opacity, leastOpacity);
    options.extraWidth += 0.75;
}

void paintShape(Renderer& renderer, const Painted& painted, const ui::Theme& theme,
                std::vector<render::Highlight>& highlights,
                std::optional<render::Behind> behind = std::nullopt) {
    highlights.clear();
    for (const Mark& mark : painted.marks) highlights.push_back({mark.index, mark.strength});
    render::PaintOptions options;
    options.opacity = painted.opacity;
    options.extraWidth = painted.extraWidth;
    options.borderColour = theme.pointBorder;
    options.haloColour = theme.halo;
    options.highlights = highlights;
    options.behind = behind;
    if (ui::hasContrast(theme.name) && painted.shape->kind != drawing::Kind::triangles) {
        makeClearer(options, painted, theme);
    }
    renderer.paint(*painted.shape, options);
}

void paintPane(Renderer& renderer, const PaneFigure& pane, const Canvas& canvas,
               const ui::Theme& theme) {
    const Rect rect = deviceRect(pane.plot.box, canvas);
    if (rect.width < 1 || rect.height < 1) return;
    const scene::Colour& background =
        pane.plot.pane == Pane::curve ? theme.background : theme.plotBackground;
    const Projection projection = pane.reach > 0 ? projectionOf(pane, rect, canvas)
                                                 : projectionOf(pane.plot.map, rect, canvas);
    renderer.beginPane(rect, projection, canvas.pixelRatio, background);
    std::vector<render::Highlight> highlights;
    paintLines(renderer, pane.plot.under);
    for (const Shape& shape : pane.below) {
        paintShape(renderer, {&shape, 1, 0, {}}, theme, highlights);
    }
    for (const Painted& painted : pane.shapes) paintShape(renderer, painted, theme, highlights);
    paintLines(renderer, pane.plot.over);
    for (const auto* shapes : {&pane.above, &pane.tools}) {
        for (const Shape& shape : *shapes) {
            paintShape(renderer, {&shape, 1, 0, {}}, theme, highlights, render::Behind::shows);
        }
    }
    renderer.endPane();
}

}  // namespace

void paintFigure(Renderer& renderer, const Figure* figure, const Canvas& canvas) {
    const ui::Theme& theme = ui::theme(canvas.theme);
    renderer.beginView(canvas.width, canvas.height, theme.background);
    if (figure != nullptr) {
        for (const PaneFigure& pane : figure->panes) paintPane(renderer, pane, canvas, theme);
    }
    renderer.endView();
}

}  // namespace knotwork::app
