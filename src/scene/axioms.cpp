#include "scene/axioms.hpp"

#include "scene/spec_builders.hpp"
#include "scene/validation.hpp"

#include <array>
#include <cmath>

namespace knotwork::scene {

namespace {

constexpr std::array<std::string_view, 5> statements{
    "B is a homeomorphism of [0, 1] onto itself",
    "B(0) = 0",
    "B(1) = 1",
    "B is monotone: B′(t) ≥ 0",
    "B is symmetric: B(t) + B(1 − t) = 1",
};

/// Four digits are enough for a sentence; 0.1 + 1e-17 is 0.1 to whoever reads it.
std::string readable(double number) {
    if (!std::isfinite(number)) return formatNumber(number);
    const double rounded = std::round(number * 1e4) / 1e4;
    return formatNumber(rounded == 0 && std::abs(number) > 1e-9 ? number : rounded);
}

std::string valueAt(const AxiomBreach& breach) {
    return "B(" + readable(breach.t) + ") = " + readable(breach.found);
}

/// What D1 says also fails where another axiom does that it includes.
std::string whyNoHomeomorphism(const AxiomBreaches& breaches) {
    const auto& [inside, start, end, slope, symmetry] = breaches;
    if (inside) {
        const bool rests = inside->found >= 0 && inside->found <= 1;
        return rests ? "it rests at " + readable(inside->found) + " from t = " +
                           readable(inside->t) + " on"
                     : "it leaves [0, 1]: " + valueAt(*inside);
    }
    if (slope) return "it falls at t = " + readable(slope->t) + ", so it takes values twice";
    return start ? "it does not begin in 0" : "it does not end in 1";
}

/// Of an axiom that does not hold.
std::string whyNot(std::size_t axiom, const AxiomBreaches& breaches) {
    if (axiom == 0) return whyNoHomeomorphism(breaches);
    const auto& breach = breaches[axiom];
    if (axiom < 3) return valueAt(*breach);
    const std::string t = readable(breach->t);
    if (axiom == 4) return "B(t) + B(1 − t) = " + readable(breach->found) + " at t = " + t;
    return breach->found < 0 ? "its slope at t = " + t + " is " + readable(breach->found)
                             : "it has fallen before t = " + t;
}

}  // namespace

double Candidate::value(double t) const noexcept {
    return std::visit([t](const auto& function) { return function.value(t); }, function_);
}

Result<Made<Candidate>> makeCandidate(const Json& spec) {
    auto canonical = readBFunction(spec);
    if (!canonical) return canonical.error();
    if (stringOr(*canonical, "family", "") == "formula") {
        auto formula = Formula::make(stringOr(*canonical, "expression", ""), "expression");
        if (!formula) return formula.error();
        return Made<Candidate>{std::move(*canonical), std::move(*formula)};
    }
    auto blend = buildBFunction(*canonical);
    if (!blend) return blend.error();
    return Made<Candidate>{std::move(*canonical), std::move(*blend)};
}

Json describeAxioms(const Candidate& candidate) {
    const AxiomBreaches& breaches = candidate.breaches();
    const auto holds = axiomsThatHold(breaches);
    Json list = Json::array();
    for (std::size_t k = 0; k < breaches.size(); ++k) {
        Json entry{{"axiom", axiomNames[k]}, {"statement", statements[k]}, {"holds", holds[k]}};
        const auto& breach = k == 0 && !breaches[0] ? breaches[3] : breaches[k];
        if (!holds[k] && breach) {
            entry["t"] = breach->t;
            if (std::isfinite(breach->found)) entry["found"] = breach->found;
        }
        entry["text"] = holds[k] ? std::string(statements[k]) + "."
                                 : "Not so: " + whyNot(k, breaches) + ".";
        list.push_back(std::move(entry));
    }
    return list;
}

}  // namespace knotwork::scene
