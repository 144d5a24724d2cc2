// Rectangles and positions on a view, in CSS pixels with the origin at the top left.
#pragma once

namespace knotwork::ui {

struct Pixel {
    double x = 0;
    double y = 0;
};

struct Box {
    double x = 0;
    double y = 0;
    double width = 0;
    double height = 0;

    [[nodiscard]] constexpr double right() const noexcept { return x + width; }
    [[nodiscard]] constexpr double bottom() const noexcept { return y + height; }
    [[nodiscard]] constexpr Pixel centre() const noexcept {
        return {x + width / 2, y + height / 2};
    }
    [[nodiscard]] constexpr bool contains(const Pixel& p) const noexcept {
        return x <= p.x && p.x < right() && y <= p.y && p.y < bottom();
    }
    friend constexpr bool operator==(const Box&, const Box&) = default;
};

/// How much is left free at each side of a box.
struct Margins {
    double left = 0;
    double top = 0;
    double right = 0;
    double bottom = 0;
};

/// The box inside the margins; never of negative size.
[[nodiscard]] constexpr Box inside(const Box& box, const Margins& m) noexcept {
    const double width = box.width - m.left - m.right;
    const double height = box.height - m.top - m.bottom;
    return {box.x + m.left, box.y + m.top, width > 0 ? width : 0, height > 0 ? height : 0};
}

}  // namespace knotwork::ui
