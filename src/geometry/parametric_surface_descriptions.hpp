// The model surfaces and their parameters: the one source for the checks in ParametricSurface, the
// fields of the scene and the list that programs see.
#pragma once

#include "geometry/named.hpp"
#include "geometry/parameter.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace knotwork {

enum class SurfaceModel {
    plane,
    cylinder,
    torus,
    sphere,
    cone,
    moebius,
    klein,
    helicoid,
    seashell,
};

struct SurfaceModelDescription {
    SurfaceModel model;
    std::string_view name;     ///< as in documents
    std::string_view label;    ///< for people
    std::string_view formula;  ///< x, y, z; domain; where it is closed
    std::span<const ParameterDescription> parameters;
};

namespace surface_model::described {

/// A length: any sign, up to 1e9.
constexpr ParameterDescription length(std::string_view name, double defaultValue, double high,
                                      std::string_view help) {
    return {.name = name,
            .label = name,
            .min = -1e9,
            .max = 1e9,
            .defaultValue = defaultValue,
            .low = 0,
            .high = high,
            .help = help};
}

/// A length that is also that of the domain.
constexpr ParameterDescription extent(std::string_view name, std::string_view help) {
    return {.name = name,
            .label = name,
            .min = 1e-6,
            .max = 1e9,
            .defaultValue = 1,
            .low = 0.1,
            .high = 5,
            .help = help};
}

constexpr ParameterDescription turns(double defaultValue) {
    return {.name = "turns",
            .label = "turns",
            .min = 0.001,
            .max = 1000,
            .defaultValue = defaultValue,
            .low = 0.5,
            .high = 10,
            .help = "u runs to 2π times this"};
}

inline constexpr std::array plane{extent("width", "along x"), extent("height", "along y")};
inline constexpr std::array cylinder{length("radius", 1, 5, "of the circle"),
                                     extent("height", "along z")};
inline constexpr std::array torus{length("R", 2, 5, "from the axis to the middle of the tube"),
                                  length("r", 1, 3, "radius of the tube")};
inline constexpr std::array sphere{length("radius", 1, 5, "of the sphere")};
inline constexpr std::array cone{length("radius", 1, 5, "of the circle at the foot"),
                                 extent("height", "from the foot to the tip")};
inline constexpr std::array moebius{length("radius", 1, 5, "of the circle in the middle"),
                                    extent("width", "of the strip")};
inline constexpr std::array klein{length("R", 2, 5, "radius of the circle"),
                                  length("r", 1, 3, "size of the figure of eight that goes round")};
inline constexpr std::array helicoid{extent("radius", "from the axis to the edge"),
                                     length("pitch", 1, 5, "rise a turn"), turns(1)};
inline constexpr std::array seashell{
    length("R", 1, 5, "from the axis to the middle of the tube, at the mouth"),
    length("r", 1, 5, "radius of the tube at the mouth"),
    length("height", 3, 10, "from the middle of the mouth up to the tip"),
    ParameterDescription{.name = "growth",
                         .label = "growth",
                         .min = 1e-3,
                         .max = 1e3,
                         .defaultValue = 2,
                         .low = 1,
                         .high = 4,
                         .help = "factor of the size a turn"},
    turns(4)};

using Model = SurfaceModel;
inline constexpr std::array<SurfaceModelDescription, 9> models{{
    {Model::plane, "plane", "Plane", "(u, v, 0); 0 ≤ u ≤ width, 0 ≤ v ≤ height", plane},
    {Model::cylinder, "cylinder", "Cylinder",
     "(r cos u, r sin u, v), r the radius; 0 ≤ u ≤ 2π, 0 ≤ v ≤ height; closed in u", cylinder},
    {Model::torus, "torus", "Torus",
     "((R + r cos v) cos u, (R + r cos v) sin u, r sin v); 0 ≤ u, v ≤ 2π; closed in u and v",
     torus},
    {Model::sphere, "sphere", "Sphere",
     "(r cos v cos u, r cos v sin u, r sin v), r the radius; 0 ≤ u ≤ 2π, −π/2 ≤ v ≤ π/2; closed "
     "in u, poles at the ends of v",
     sphere},
    {Model::cone, "cone", "Cone",
     "(r(1−v/h) cos u, r(1−v/h) sin u, v), r the radius, h the height; 0 ≤ u ≤ 2π, 0 ≤ v ≤ h; "
     "closed in u, the tip at v = h",
     cone},
    {Model::moebius, "moebius", "Möbius strip",
     "((r + v cos(u/2)) cos u, (r + v cos(u/2)) sin u, v sin(u/2)), r the radius; 0 ≤ u ≤ 2π, "
     "|v| ≤ width/2; S(u + 2π, v) = S(u, −v), so that it is closed in neither direction",
     moebius},
    {Model::klein, "klein", "Klein bottle",
     "((R + w) cos u, (R + w) sin u, r(sin(u/2) sin v + cos(u/2) sin 2v)), "
     "w = r(cos(u/2) sin v − sin(u/2) sin 2v); 0 ≤ u, v ≤ 2π; a figure of eight that turns over "
     "once: S(u + 2π, v) = S(u, −v), closed in v only",
     klein},
    {Model::helicoid, "helicoid", "Helicoid",
     "(v cos u, v sin u, pitch·u/2π); 0 ≤ u ≤ 2π·turns, |v| ≤ radius", helicoid},
    {Model::seashell, "seashell", "Seashell",
     "w((R + r cos v) cos u, (R + r cos v) sin u, r sin v − height), "
     "w = growth^(u/2π − turns); 0 ≤ u ≤ 2π·turns, 0 ≤ v ≤ 2π; closed in v",
     seashell},
}};

}  // namespace surface_model::described

/// All models, in the order of SurfaceModel.
[[nodiscard]] constexpr std::span<const SurfaceModelDescription> surfaceModels() noexcept {
    return surface_model::described::models;
}

/// The description with this name, or nullptr.
[[nodiscard]] constexpr const SurfaceModelDescription* findSurfaceModel(
    std::string_view name) noexcept {
    return findNamed(surfaceModels(), &SurfaceModelDescription::name, name);
}

}  // namespace knotwork
