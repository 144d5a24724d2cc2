// Paints the figure of a view with the renderer.
#pragma once

#include "app/figure.hpp"
#include "render/renderer.hpp"

namespace knotwork::app {

struct Canvas {
    int width = 0;   ///< device pixels
    int height = 0;
    double pixelRatio = 1;
    ui::ThemeName theme = ui::ThemeName::light;
};

/// `figure` null paints the background alone.
void paintFigure(render::Renderer& renderer, const Figure* figure, const Canvas& canvas);

}  // namespace knotwork::app
