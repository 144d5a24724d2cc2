// The stencil of a point of the next level: the vertices that make it, each joined to it and labelled
// with how much it counts.
#include "drawing/annotations.hpp"
#include "scene/json_values.hpp"
#include "scene/mesh_stencils.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace knotwork::drawing {

namespace {

std::optional<MeshStencil> stencilShown(const Sketch& sketch) {
    const scene::SubdivisionSurface* surface = sketch.body().subdivision();
    if (surface == nullptr) return std::nullopt;
    auto made = scene::stencilOf(sketch.object().spec, *surface);
    if (!made) return std::nullopt;  // an effect does not change what a document was checked for
    return std::move(*made);
}

/// The letter by which textbooks call the new point of a vertex, an edge, a face or a corner.
std::string letterOf(const scene::Json& spec) {
    constexpr std::array letters{"v′", "e", "f", "c"};
    const auto of = scene::stringOr(*scene::member(spec, "stencil"), "of", "");
    return letters[static_cast<std::size_t>(scene::meshElementNamed(of))];
}

/// `3/8` where a weight is a fraction of whole numbers that a mask could have, else three digits.
std::string weightText(double weight) {
    const std::string sign = weight < 0 ? "−" : "";
    const double size = std::abs(weight);
    // Convergents of its continued fraction.
    double before = 0;
    double denominator = 1;
    double rest = size;
    while (denominator < 4096) {
        const double numerator = std::round(size * denominator);
        if (std::abs(numerator / denominator - size) < 1e-13) {
            std::string text = sign + std::to_string(static_cast<int>(numerator));
            if (denominator > 1) text += "/" + std::to_string(static_cast<int>(denominator));
            return text;
        }
        rest = 1 / (rest - std::floor(rest));
        const double next = std::floor(rest) * denominator + before;
        before = denominator;
        denominator = next;
    }
    std::array<char, 32> digits{};
    std::snprintf(digits.data(), digits.size(), "%.3g", size);
    return sign + digits.data();
}

}  // namespace

void drawStencil(Sketch& sketch) {
    const auto stencil = stencilShown(sketch);
    if (!stencil) return;
    const auto points = sketch.body().subdivision()->control.points();
    Shape& lines = sketch.add(Role::trace, Kind::polyline, 1.5F);
    for (const StencilWeight& part : stencil->weights) {
        appendSegment(lines, stencil->point, points[part.vertex]);
    }
    Shape& parts = sketch.add(Role::trace, Kind::points, 7);
    for (const StencilWeight& part : stencil->weights) append(parts, points[part.vertex]);
    Shape& made = sketch.add(Role::trace, Kind::points, 10);
    made.index = 1;
    append(made, stencil->point);
}

std::vector<Wanted> stencilLabels(const Sketch& sketch) {
    const auto stencil = stencilShown(sketch);
    if (!stencil) return {};
    std::vector<Wanted> wanted{{letterOf(sketch.object().spec), stencil->point, Role::trace}};
    const auto points = sketch.body().subdivision()->control.points();
    for (const StencilWeight& part : stencil->weights) {
        wanted.push_back({weightText(part.weight), points[part.vertex], Role::trace});
    }
    return wanted;
}

}  // namespace knotwork::drawing
