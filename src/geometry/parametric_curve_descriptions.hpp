// The model curves and their parameters: the one source for the checks in ParametricCurve, the
// fields of the scene, the list that programs see, and the panels.
#pragma once

#include "geometry/named.hpp"
#include "geometry/parameter.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace knotwork {

enum class ParametricModel {
    circle,
    ellipse,
    lissajous,
    rose,
    butterfly,
    hypotrochoid,
    epitrochoid,
    astroid,
    cardioid,
    nephroid,
    heart,
    lemniscate,
    spiral,
    helix,
    viviani,
    trefoil,
    torusKnot,
};

struct ParametricModelDescription {
    ParametricModel model;
    std::string_view name;   ///< as in documents: `torus-knot`
    std::string_view label;  ///< for people
    int dimension;           ///< 2 in the plane z = 0, else 3
    std::span<const ParameterDescription> parameters;
};

namespace parametric_model::described {

/// A length: any sign, up to 1e9.
constexpr ParameterDescription length(std::string_view name, std::string_view label,
                                      double defaultValue, double high, std::string_view help) {
    return {.name = name,
            .label = label,
            .min = -1e9,
            .max = 1e9,
            .defaultValue = defaultValue,
            .low = 0,
            .high = high,
            .help = help};
}

constexpr ParameterDescription integer(std::string_view name, std::string_view label,
                                       double defaultValue, std::string_view help) {
    return {.name = name,
            .label = label,
            .min = -1000,
            .max = 1000,
            .defaultValue = defaultValue,
            .low = 1,
            .high = 12,
            .help = help,
            .integer = true};
}

constexpr ParameterDescription frequency(std::string_view name, std::string_view label,
                                         double defaultValue, std::string_view help) {
    return {.name = name,
            .label = label,
            .min = -1000,
            .max = 1000,
            .defaultValue = defaultValue,
            .low = 1,
            .high = 12,
            .help = help};
}

inline constexpr ParameterDescription turns{.name = "turns",
                                            .label = "turns",
                                            .min = 0.001,
                                            .max = 1000,
                                            .defaultValue = 3,
                                            .low = 0.5,
                                            .high = 10,
                                            .help = "the domain is 2π times this"};

inline constexpr std::array radius{length("radius", "radius", 1, 5, "of the circle")};
inline constexpr std::array a{length("a", "a", 1, 5, "size")};
inline constexpr std::array scale{length("scale", "scale", 1, 5, "factor of both coordinates")};
inline constexpr std::array ellipse{length("a", "a", 2, 5, "half axis along x"),
                                    length("b", "b", 1, 5, "half axis along y")};
inline constexpr std::array lissajous{
    length("a", "a", 1, 5, "amplitude along x"), length("b", "b", 1, 5, "amplitude along y"),
    frequency("kx", "kx", 1, "frequency along x, an integer for a closed curve"),
    frequency("ky", "ky", 2, "frequency along y, an integer for a closed curve")};
inline constexpr std::array rose{
    length("a", "a", 1, 5, "length of a petal"),
    frequency("k", "k", 4, "p/q: p petals where p and q are odd, else 2p")};
inline constexpr std::array hypotrochoid{
    length("R", "R", 5, 10, "radius of the fixed circle"),
    length("r", "r", 3, 10, "radius of the circle that rolls inside it, not 0"),
    length("d", "d", 5, 10, "distance of the pen from the rolling centre")};
inline constexpr std::array epitrochoid{
    length("R", "R", 3, 10, "radius of the fixed circle"),
    length("r", "r", 1, 10, "radius of the circle that rolls around it, not 0"),
    length("d", "d", 2, 10, "distance of the pen from the rolling centre")};
inline constexpr std::array spiral{length("a", "a", 0, 2, "distance of the start from the centre"),
                                   length("b", "b", 0.1, 1, "growth a radian"), turns};
inline constexpr std::array helix{length("radius", "radius", 1, 5, "of the cylinder"),
                                  length("pitch", "pitch", 1, 5, "rise a turn"), turns};
inline constexpr std::array torusKnot{
    integer("p", "p", 2, "turns about the axis"), integer("q", "q", 3, "turns about the tube"),
    length("R", "R", 2, 5, "radius of the torus"), length("r", "r", 1, 3, "radius of its tube")};

using Model = ParametricModel;
inline constexpr std::array<ParametricModelDescription, 17> models{{
    {Model::circle, "circle", "Circle", 2, radius},
    {Model::ellipse, "ellipse", "Ellipse", 2, ellipse},
    {Model::lissajous, "lissajous", "Lissajous figure", 2, lissajous},
    {Model::rose, "rose", "Rose", 2, rose},
    {Model::butterfly, "butterfly", "Butterfly", 2, scale},
    {Model::hypotrochoid, "hypotrochoid", "Hypotrochoid", 2, hypotrochoid},
    {Model::epitrochoid, "epitrochoid", "Epitrochoid", 2, epitrochoid},
    {Model::astroid, "astroid", "Astroid", 2, a},
    {Model::cardioid, "cardioid", "Cardioid", 2, a},
    {Model::nephroid, "nephroid", "Nephroid", 2, a},
    {Model::heart, "heart", "Heart", 2, scale},
    {Model::lemniscate, "lemniscate", "Lemniscate", 2, a},
    {Model::spiral, "spiral", "Archimedean spiral", 2, spiral},
    {Model::helix, "helix", "Helix", 3, helix},
    {Model::viviani, "viviani", "Viviani’s curve", 3, a},
    {Model::trefoil, "trefoil", "Trefoil knot", 3, scale},
    {Model::torusKnot, "torus-knot", "Torus knot", 3, torusKnot},
}};

}  // namespace parametric_model::described

/// All models, in the order of ParametricModel.
[[nodiscard]] constexpr std::span<const ParametricModelDescription>
parametricCurveModels() noexcept {
    return parametric_model::described::models;
}

/// The description with this name, or nullptr.
[[nodiscard]] constexpr const ParametricModelDescription* findParametricModel(
    std::string_view name) noexcept {
    return findNamed(parametricCurveModels(), &ParametricModelDescription::name, name);
}

}  // namespace knotwork
