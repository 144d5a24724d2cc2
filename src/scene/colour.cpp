#include "scene/colour.hpp"

#include "geometry/vec.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace knotwork::scene {

namespace {

int hexDigit(char c) noexcept {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

double fromLinear(double c) noexcept {
    c = std::clamp(c, 0.0, 1.0);
    return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

// Björn Ottosson, "A perceptual color space for image processing", 2020: linear sRGB to the cone
// responses, their cube roots to lightness and two opponent axes, and the way back.
Vec3 toOklab(const Colour& colour) noexcept {
    const double r = linearLight(colour.red);
    const double g = linearLight(colour.green);
    const double b = linearLight(colour.blue);
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

Colour fromOklab(const Vec3& lab, double alpha) noexcept {
    const auto cube = [](double x) { return x * x * x; };
    const double l = cube(lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z);
    const double m = cube(lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z);
    const double s = cube(lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z);
    return {fromLinear(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            fromLinear(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            fromLinear(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s), alpha};
}

/// Below this chroma a colour is grey and has no hue of its own.
constexpr double greyChroma = 1e-4;

}  // namespace

double linearLight(double component) noexcept {
    return component <= 0.04045 ? component / 12.92 : std::pow((component + 0.055) / 1.055, 2.4);
}

Result<Colour> parseColour(std::string_view text) {
    std::array<int, 6> digits{};
    bool valid = text.size() == 7 && text[0] == '#';
    for (std::size_t i = 0; valid && i < digits.size(); ++i) {
        digits[i] = hexDigit(text[i + 1]);
        valid = digits[i] >= 0;
    }
    if (!valid) {
        return refuse(Code::syntax, "",
                      "\"" + std::string(text) + "\" is no colour; write it as #rrggbb.");
    }
    const auto component = [&](std::size_t i) { return (16 * digits[i] + digits[i + 1]) / 255.0; };
    return Colour{component(0), component(2), component(4), 1};
}

std::string formatColour(const Colour& colour) {
    const auto byte = [](double c) {
        return static_cast<unsigned>(std::lround(255 * std::clamp(c, 0.0, 1.0)));
    };
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", byte(colour.red), byte(colour.green),
                  byte(colour.blue));
    return text.data();
}

Colour mixColours(const Colour& a, const Colour& b, double s) noexcept {
    if (s <= 0) return a;
    if (s >= 1) return b;
    const Vec3 from = toOklab(a);
    const Vec3 to = toOklab(b);
    const double chromaFrom = std::hypot(from.y, from.z);
    const double chromaTo = std::hypot(to.y, to.z);
    double hueFrom = std::atan2(from.z, from.y);
    double hueTo = std::atan2(to.z, to.y);
    if (chromaFrom < greyChroma) hueFrom = hueTo;
    if (chromaTo < greyChroma) hueTo = hueFrom;
    const double turn = std::remainder(hueTo - hueFrom, 2 * std::numbers::pi);
    const double hue = hueFrom + s * turn;
    const double chroma = (1 - s) * chromaFrom + s * chromaTo;
    return fromOklab({(1 - s) * from.x + s * to.x, chroma * std::cos(hue), chroma * std::sin(hue)},
                     (1 - s) * a.alpha + s * b.alpha);
}

}  // namespace knotwork::scene
