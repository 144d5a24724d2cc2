// The families of B-functions and their parameters: the one source for the checks in BFunction, the
// fields of the scene, the list that programs see, and the panels.
#pragma once

#include "geometry/parameter.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string_view>

namespace knotwork {

enum class BFamily {
    linear,
    trigonometric,
    polynomial,
    rational,
    expoRational,
    logistic,
    tabulated,
    formula,
    dual,
    symmetrised,
    composed,
    mixed,
};

/// A field that holds `count` B-functions (an object for one, a list for two).
struct OperandDescription {
    std::string_view name;
    std::string_view label;
    int count = 1;
};

struct BFamilyDescription {
    BFamily family;
    std::string_view name;     ///< as in documents: `expo-rational`
    std::string_view label;    ///< for people
    std::string_view formula;  ///< B(t) in one line of text
    std::span<const ParameterDescription> parameters;
    std::span<const OperandDescription> operands;
    bool tabulated = false;   ///< takes a list `values`
    bool expression = false;  ///< takes a text `expression`
};

namespace b_function::described {

inline constexpr std::array trigonometric{
    ParameterDescription{.name = "order",
                         .label = "order m",
                         .min = 1,
                         .max = 20,
                         .defaultValue = 1,
                         .low = 1,
                         .high = 8,
                         .help = "derivatives that vanish at both ends",
                         .integer = true}};

inline constexpr std::array polynomial{ParameterDescription{.name = "p",
                                                            .label = "p",
                                                            .min = 0,
                                                            .max = 20,
                                                            .defaultValue = 1,
                                                            .low = 0,
                                                            .high = 8,
                                                            .help = "derivatives that vanish at 0",
                                                            .integer = true},
                                       ParameterDescription{.name = "q",
                                                            .label = "q",
                                                            .min = 0,
                                                            .max = 20,
                                                            .defaultValue = 1,
                                                            .low = 0,
                                                            .high = 8,
                                                            .help = "derivatives that vanish at 1",
                                                            .integer = true}};

inline constexpr std::array rational{
    ParameterDescription{.name = "m",
                         .label = "power m",
                         .min = 1,
                         .max = 50,
                         .defaultValue = 2,
                         .low = 1,
                         .high = 10,
                         .help = "slope at the middle; 1 is linear"},
    ParameterDescription{.name = "c",
                         .label = "weight c",
                         .min = 0,
                         .max = 1000,
                         .defaultValue = 1,
                         .low = 0.1,
                         .high = 10,
                         .help = "1 is symmetric, more is later",
                         .minOpen = true}};

inline constexpr std::array expoRational{
    ParameterDescription{.name = "alpha",
                         .label = "α, flatness",
                         .min = 0,
                         .max = 4,
                         .defaultValue = 1,
                         .low = 0.1,
                         .high = 4,
                         .help = "how fast the ends become flat",
                         .minOpen = true},
    ParameterDescription{.name = "beta",
                         .label = "β, steepness",
                         .min = 0,
                         .max = 100,
                         .defaultValue = 1,
                         .low = 0.05,
                         .high = 20,
                         .help = "near 0 linear, large a step",
                         .minOpen = true},
    ParameterDescription{.name = "gamma",
                         .label = "γ, asymmetry",
                         .min = 0,
                         .max = 4,
                         .defaultValue = 1,
                         .low = 0.1,
                         .high = 4,
                         .help = "flatness at 1 relative to that at 0",
                         .minOpen = true},
    ParameterDescription{.name = "lambda",
                         .label = "λ, centre",
                         .min = 0,
                         .max = 1,
                         .defaultValue = 0.5,
                         .low = 0.05,
                         .high = 0.95,
                         .help = "where the slope is largest",
                         .minOpen = true,
                         .maxOpen = true}};

inline constexpr std::array logistic{ParameterDescription{.name = "c",
                                                          .label = "steepness c",
                                                          .min = 0,
                                                          .max = 1000,
                                                          .defaultValue = 1,
                                                          .low = 0.1,
                                                          .high = 5,
                                                          .help = "slope at the middle is 2c",
                                                          .minOpen = true}};

inline constexpr std::array mixed{
    ParameterDescription{.name = "weight",
                         .label = "weight of the first",
                         .min = 0,
                         .max = 1,
                         .defaultValue = 0.5,
                         .low = 0,
                         .high = 1,
                         .help = "1 is the first alone, 0 the second"}};

inline constexpr std::array single{OperandDescription{"of", "of", 1}};
inline constexpr std::array pair{OperandDescription{"of", "of", 2}};
inline constexpr std::array chain{OperandDescription{"outer", "outer", 1},
                                  OperandDescription{"inner", "inner", 1}};

inline constexpr std::array<BFamilyDescription, 12> families{{
    {BFamily::linear, "linear", "Linear", "t", {}, {}},
    {BFamily::trigonometric,
     "trigonometric",
     "Trigonometric",
     "∫ sin^m(πs) ds, normalised",
     trigonometric,
     {}},
    {BFamily::polynomial,
     "polynomial",
     "Polynomial (Beta)",
     "∫ s^p (1−s)^q ds, normalised",
     polynomial,
     {}},
    {BFamily::rational, "rational", "Rational", "t^m / (t^m + c (1−t)^m)", rational, {}},
    {BFamily::expoRational,
     "expo-rational",
     "Expo-rational (ERB)",
     "∫ exp(−β |s−λ|^(α(1+γ)) / (s (1−s)^γ)^α) ds, normalised",
     expoRational,
     {}},
    {BFamily::logistic, "logistic", "Logistic", "1 / (1 + exp(c (1/t − 1/(1−t))))", logistic, {}},
    {BFamily::tabulated, "tabulated", "Tabulated", "monotone cubics through values", {}, {}, true},
    {BFamily::formula, "formula", "Formula", "an expression in t of your own", {}, {}, false, true},
    {BFamily::dual, "dual", "Dual", "1 − B(1−t)", {}, single},
    {BFamily::symmetrised, "symmetrised", "Symmetrised", "(B(t) + 1 − B(1−t)) / 2", {}, single},
    {BFamily::composed, "composed", "Composed", "outer(inner(t))", {}, chain},
    {BFamily::mixed, "mixed", "Mixed", "weight · first + (1−weight) · second", mixed, pair},
}};

}  // namespace b_function::described

/// All families, in the order of BFamily.
[[nodiscard]] constexpr std::span<const BFamilyDescription> bFunctionFamilies() noexcept {
    return b_function::described::families;
}

/// The description with this name, or nullptr.
[[nodiscard]] constexpr const BFamilyDescription* findBFamily(std::string_view name) noexcept {
    for (const BFamilyDescription& family : bFunctionFamilies()) {
        if (family.name == name) return &family;
    }
    return nullptr;
}

}  // namespace knotwork
