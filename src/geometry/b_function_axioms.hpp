// The axioms of B-functions, looked at one by one for whatever a person types:
//   D1  B is a homeomorphism of [0, 1] onto itself: it stays there, and takes no value twice
//   D2  B(0) = 0
//   D3  B(1) = 1
//   D4  B is monotone: B′ ≥ 0
//   D5  B is symmetric: B(t) + B(1 − t) = 1. It may be missing.
// (A. Lakså, A method for sparse-matrix computation of B-spline curves and surfaces, 2009.)
#pragma once

#include "geometry/b_function.hpp"
#include "geometry/formula.hpp"

#include <array>
#include <optional>
#include <string_view>

namespace knotwork {

inline constexpr std::array<std::string_view, 5> axiomNames{"D1", "D2", "D3", "D4", "D5"};

/// Where an axiom is broken, and by what: the value there, or the slope for D4.
struct AxiomBreach {
    double t = 0;
    double found = 0;
};

/// For each axiom in turn the first place where it is broken; nothing where it holds as far as
/// 2 600 parameters and the minima of the slope between them tell, to 1e-12 for values and 1e-9 for
/// slopes.
using AxiomBreaches = std::array<std::optional<AxiomBreach>, 5>;

/// Of a formula in t that need not be a B-function.
[[nodiscard]] AxiomBreaches axiomBreaches(const Formula& formula);
/// Of a B-function, which breaks at most D5.
[[nodiscard]] AxiomBreaches axiomBreaches(const BFunction& blend);

/// Which of them hold. D1 says what the next three say, and more, so it fails where one of them
/// does.
[[nodiscard]] std::array<bool, 5> axiomsThatHold(const AxiomBreaches& breaches) noexcept;

}  // namespace knotwork
