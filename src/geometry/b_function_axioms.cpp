#include "geometry/b_function_axioms.hpp"

#include "geometry/jet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace knotwork {

namespace {

enum Axiom : std::size_t { inside, startsAtZero, endsAtOne, monotone, symmetric };

constexpr double valueTolerance = 1e-12;
constexpr double slopeTolerance = 1e-9;
constexpr int uniformPoints = 2520;
constexpr int deepestPoint = 40;  // 2^-40 from an end
/// A value that is taken this long is one that is taken twice.
constexpr double longestRest = 1.0 / 256;

/// A uniform grid that comes close to both ends, where much can happen.
std::vector<double> gridPoints() {
    std::vector<double> points;
    for (int i = 1; i < uniformPoints; ++i) points.push_back(double(i) / uniformPoints);
    for (int k = 12; k <= deepestPoint; ++k) {
        points.push_back(std::ldexp(1.0, -k));
        points.push_back(1 - std::ldexp(1.0, -k));
    }
    std::sort(points.begin(), points.end());
    return points;
}

struct Sample {
    double t;
    double value;
    double slope;
    double bend;
};

Sample sampleAt(const Formula& formula, double t) noexcept {
    const Jet jet = formula.jet(Jet::variable(t, 2));
    return {t, jet[0], jet[1], jet[2]};
}

/// The value at an end, or its limit where the formula itself has none there (as 1/t in an
/// exponent).
double endValue(const Formula& formula, double end) noexcept {
    const double value = formula.value(end);
    if (std::isfinite(value)) return value;
    const double limit = formula.value(end == 0 ? 1e-300 : 1 - 0x1p-53);
    return std::abs(limit - end) <= valueTolerance ? limit : value;
}

/// Looks at samples in ascending order and keeps the first breach of each axiom.
class Inspection {
public:
    void look(const Sample& sample) {
        const double value = sample.value;
        if (!std::isfinite(value) || value < -valueTolerance || value > 1 + valueTolerance) {
            note(inside, sample.t, value);
        }
        lookAtSlope(sample);
        if (value < highest_ - valueTolerance) note(monotone, sample.t, sample.slope);
        lookForRest(sample);
        highest_ = std::max(highest_, value);
    }

    void lookAtSlope(const Sample& sample) {
        if (sample.slope < -slopeTolerance) note(monotone, sample.t, sample.slope);
    }

    void note(Axiom axiom, double t, double found) {
        if (!breaches_[axiom]) breaches_[axiom] = AxiomBreach{t, found};
    }

    /// What decreases takes values twice, and what rests does too.
    [[nodiscard]] AxiomBreaches take(const Sample& last) {
        lookForRest(last);
        if (rest_) note(inside, rest_->t, rest_->found);
        return breaches_;
    }

    [[nodiscard]] const AxiomBreaches& breaches() const noexcept { return breaches_; }

private:
    /// Near 0 and near 1 values that differ may look the same.
    void lookForRest(const Sample& sample) {
        const bool clear = sample.value > 1e-9 && sample.value < 1 - 1e-9;
        if (!clear || sample.value != resting_) {
            resting_ = sample.value;
            since_ = sample.t;
        } else if (sample.t - since_ > longestRest && !rest_) {
            rest_ = AxiomBreach{since_, sample.value};
        }
    }

    AxiomBreaches breaches_{};
    double highest_ = 0;
    double resting_ = -1;
    double since_ = 0;
    std::optional<AxiomBreach> rest_;
};

/// Where the slope has a minimum between two samples, it is looked at too.
void lookBetween(const Formula& formula, Sample a, Sample b, Inspection& inspection) {
    if (!(a.bend < 0 && b.bend > 0)) return;
    for (int i = 0; i < 30; ++i) {
        const Sample middle = sampleAt(formula, a.t + (b.t - a.t) / 2);
        inspection.lookAtSlope(middle);
        (middle.bend < 0 ? a : b) = middle;
    }
}

std::optional<AxiomBreach> asymmetry(const Formula& formula) noexcept {
    for (int i = 1; i <= uniformPoints / 2; ++i) {
        const double t = double(i) / uniformPoints;
        const double sum = formula.value(t) + formula.value(1 - t);
        if (!(std::abs(sum - 1) <= valueTolerance)) return AxiomBreach{t, sum};
    }
    return std::nullopt;
}

}  // namespace

AxiomBreaches axiomBreaches(const Formula& formula) {
    Inspection inspection;
    for (const double end : {0.0, 1.0}) {
        const double value = endValue(formula, end);
        if (!(std::abs(value - end) <= valueTolerance)) {
            inspection.note(end == 0 ? startsAtZero : endsAtOne, end, value);
        }
    }
    Sample before = sampleAt(formula, 0);
    for (const double t : gridPoints()) {
        const Sample sample = sampleAt(formula, t);
        lookBetween(formula, before, sample, inspection);
        inspection.look(sample);
        before = sample;
    }
    AxiomBreaches breaches = inspection.take(before);
    breaches[symmetric] = asymmetry(formula);
    return breaches;
}

AxiomBreaches axiomBreaches(const BFunction& blend) {
    AxiomBreaches breaches{};
    if (blend.symmetric()) return breaches;
    for (int i = 1; i <= uniformPoints / 2; ++i) {
        const double t = double(i) / uniformPoints;
        const double sum = blend.value(t) + blend.value(1 - t);
        const double off = std::abs(sum - 1);
        const auto& worst = breaches[symmetric];
        if (!worst || off > std::abs(worst->found - 1)) breaches[symmetric] = AxiomBreach{t, sum};
    }
    return breaches;
}

std::array<bool, 5> axiomsThatHold(const AxiomBreaches& breaches) noexcept {
    std::array<bool, 5> holds;
    for (std::size_t k = 0; k < holds.size(); ++k) holds[k] = !breaches[k];
    holds[inside] = holds[inside] && holds[startsAtZero] && holds[endsAtOne] && holds[monotone];
    return holds;
}

}  // namespace knotwork
