#include "drawing/palette.hpp"

#include <algorithm>
#include <array>

namespace knotwork::drawing {

namespace {

constexpr Colour rgb(unsigned hex) noexcept {
    return {(hex >> 16U & 0xffU) / 255.0, (hex >> 8U & 0xffU) / 255.0, (hex & 0xffU) / 255.0, 1};
}

constexpr std::array lightCycle{rgb(0x0072b2), rgb(0xd55e00), rgb(0x009a70), rgb(0x7a3f6c),
                                rgb(0xa87d10), rgb(0x2f83b5), rgb(0x5a3596), rgb(0x777777)};
constexpr std::array darkCycle{rgb(0x56b4e9), rgb(0xff9a4d), rgb(0x2fc99e), rgb(0xf7c9e8),
                               rgb(0xcfa114), rgb(0x8ecdf5), rgb(0x9a7df5), rgb(0xc9c9c9)};

/// Contrast of more than 4 : 1 against our dark background (#12161f or so, luminance 0.008).
constexpr double leastLuminance = 0.2;

}  // namespace

Colour roleColour(Role role, bool dark) noexcept {
    switch (role) {
        case Role::polygon: return dark ? rgb(0x6f7f99) : rgb(0x8a97ab);
        case Role::points: return dark ? rgb(0xf2a65a) : rgb(0xc4561b);
        case Role::knots: return dark ? rgb(0xff7b7b) : rgb(0xc02f3a);
        case Role::local: return dark ? rgb(0x4cc29a) : rgb(0x2a8f6a);
        case Role::handle: return dark ? rgb(0x58d0a7) : rgb(0x1f7a59);
        case Role::comb: return dark ? rgb(0xb09cff) : rgb(0x6d4fc2);
        case Role::hull: return dark ? rgb(0x8b95a7) : rgb(0x9aa5b5);
        case Role::sphere: return dark ? rgb(0x8ecdf5) : rgb(0x2f86b8);
        case Role::residual: return dark ? rgb(0xff7b7b) : rgb(0xc02f3a);
        case Role::trace: return dark ? rgb(0xe6c229) : rgb(0xa87800);
        default: return dark ? rgb(0xc9d4e5) : rgb(0x33415c);
    }
}

Colour cycleColour(std::size_t i, bool dark) noexcept {
    return dark ? darkCycle[i % darkCycle.size()] : lightCycle[i % lightCycle.size()];
}

double luminance(const Colour& colour) noexcept {
    return 0.2126 * scene::linearLight(colour.red) + 0.7152 * scene::linearLight(colour.green) +
           0.0722 * scene::linearLight(colour.blue);
}

std::optional<Colour> objectColour(Role role, const Colour& colour, bool dark) noexcept {
    const Colour own = onBackground(colour, dark);
    if (role == Role::curve || role == Role::surface) return own;
    if (role != Role::isoline && role != Role::wireframe) return std::nullopt;
    Colour line = scene::mixColours(own, dark ? Colour{1, 1, 1, 1} : Colour{0, 0, 0, 1}, 0.45);
    line.alpha = 1;
    return line;
}

Colour onBackground(const Colour& colour, bool dark) noexcept {
    if (!dark) return colour;
    const Colour white{1, 1, 1, colour.alpha};
    Colour lifted = colour;
    for (int step = 1; step <= 8 && luminance(lifted) < leastLuminance; ++step) {
        lifted = scene::mixColours(colour, white, step / 10.0);
    }
    return lifted;
}

double contrastOf(const Colour& a, const Colour& b) noexcept {
    const auto [less, more] = std::minmax({luminance(a), luminance(b)});
    return (more + 0.05) / (less + 0.05);
}

Colour withContrast(const Colour& colour, const Colour& ground,
                           double contrast) noexcept {
    if (contrastOf(colour, ground) >= contrast) return colour;
    // Black and white are equally far from this luminance.
    const double end = luminance(ground) > 0.179 ? 0 : 1;
    const auto towards = [&](double share) {
        Colour mixed = scene::mixColours(colour, {end, end, end, colour.alpha}, share);
        mixed.alpha = colour.alpha;
        return mixed;
    };
    double less = 0;
    double enough = 1;
    for (int step = 0; step < 10; ++step) {
        const double middle = 0.5 * (less + enough);
        (contrastOf(towards(middle), ground) < contrast ? less : enough) = middle;
    }
    return towards(enough);
}

}  // namespace knotwork::drawing
