// What a person proposes as a B-function, and how it stands with the axioms.
#pragma once

#include "geometry/b_function_axioms.hpp"
#include "scene/specs.hpp"

#include <variant>

namespace knotwork::scene {

/// A B-function, or a formula that need not be one, looked at when it is made. Immutable.
class Candidate {
public:
    Candidate(BFunction blend) : breaches_(axiomBreaches(blend)), function_(std::move(blend)) {}
    Candidate(Formula formula) : breaches_(axiomBreaches(formula)), function_(std::move(formula)) {}

    [[nodiscard]] double value(double t) const noexcept;
    [[nodiscard]] const AxiomBreaches& breaches() const noexcept { return breaches_; }

private:
    AxiomBreaches breaches_;
    std::variant<BFunction, Formula> function_;
};

/// Of any specification of a B-function. A formula is read and not judged: what it breaks is said by
/// describeAxioms().
[[nodiscard]] Result<Made<Candidate>> makeCandidate(const Json& spec);

/// The checklist: [{ axiom, statement, holds, t?, found?, text }] from D1 to D5, with a sentence
/// for each, and where an axiom is broken the place and what was found there (the value, the slope
/// for D4, B(t) + B(1 − t) for D5).
[[nodiscard]] Json describeAxioms(const Candidate& candidate);

}  // namespace knotwork::scene
