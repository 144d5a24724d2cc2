#include "geometry/b_function_expo_rational.hpp"

#include "geometry/b_function_erb_table.hpp"
#include "geometry/jet.hpp"

#include <algorithm>
#include <cmath>

namespace knotwork::b_function {

namespace {

/// p = α(1+γ) when it is a whole number up to rounding, else 0.
unsigned wholePower(double power) noexcept {
    const double whole = std::round(power);
    return whole >= 1 && std::abs(power - whole) <= 1e-12 ? static_cast<unsigned>(whole) : 0;
}

bool isEven(unsigned whole) noexcept { return whole != 0 && whole % 2 == 0; }

struct Density {
    double alpha;
    double beta;
    double gamma;
    double lambda;
    double scale;  // S
};

/// B′ = S φ and B″ = S φ′ without jets, for curves that ask for them at every point: with
/// E = −log φ it is φ′ = −φ E (p/(t−λ) − α/t + αγ/(1−t)).
void shortRows(const Density& of, double t, std::span<double> rows) noexcept {
    const double s = 1 - t;
    const double power = of.alpha * (1 + of.gamma);
    const unsigned whole = wholePower(power);
    const double distance = std::abs(t - of.lambda);
    const double numerator = whole != 0 ? integerPower(distance, whole) : std::pow(distance, power);
    const double flatness = of.alpha == 1 && of.gamma == 1
                                ? 1 / (t * s)
                                : std::exp(-of.alpha * (std::log(t) + of.gamma * std::log(s)));
    const double exponent = of.beta * numerator * flatness;
    const double density = of.scale * std::exp(-exponent);
    if (density == 0) return;
    rows[1] = density;
    if (rows.size() < 3) return;
    rows[2] = 0;
    if (exponent == 0) return;
    const double slope = power / (t - of.lambda) - of.alpha / t + of.alpha * of.gamma / s;
    rows[2] = -density * exponent * slope;
}

}  // namespace

ExpoRational::ExpoRational(double alpha, double beta, double gamma, double lambda)
    : alpha_(alpha),
      beta_(beta),
      gamma_(gamma),
      lambda_(lambda),
      table_(std::make_shared<const ErbTable>(alpha, beta, gamma, lambda)) {}

double ExpoRational::value(double t) const noexcept { return table_->value(t); }

void ExpoRational::sample(std::span<const double> ts, std::span<double> values) const noexcept {
    table_->sample(ts, values);
}

// φ is differentiated as exp(−β |t−λ|^p exp(−α (log t + γ log(1−t)))); an even whole p needs no
// absolute value and passes through λ. At λ itself any other p leaves the derivatives of φ below p
// zero; at p and beyond they do not exist, and the rows are 0.
void ExpoRational::derivatives(double t, std::span<double> rows) const noexcept {
    std::fill(rows.begin(), rows.end(), 0.0);
    if (rows.size() < 2 || !(t > 0 && t < 1)) return;
    const double power = alpha_ * (1 + gamma_);
    const unsigned whole = wholePower(power);
    if (t == lambda_ && !isEven(whole)) {
        rows[1] = table_->scale();
        return;
    }
    if (rows.size() > 3) {
        const Jet variable = Jet::variable(t, static_cast<int>(rows.size()) - 2);
        const Jet distance = t < lambda_ ? lambda_ - variable : variable - lambda_;
        const Jet numerator = whole != 0 ? integerPower(distance, whole) : pow(distance, power);
        const Jet flatness = alpha_ == 1 && gamma_ == 1
                                 ? 1.0 / (variable * (1.0 - variable))
                                 : exp(-alpha_ * (log(variable) + gamma_ * log(1.0 - variable)));
        const Jet density = exp(-beta_ * (numerator * flatness));
        for (std::size_t k = 1; k < rows.size() && density.value() != 0; ++k) {
            rows[k] = table_->scale() * density.derivative(static_cast<int>(k) - 1);
        }
    }
    // However many rows there are, the first ones agree.
    shortRows({alpha_, beta_, gamma_, lambda_, table_->scale()}, t, rows);
}

bool ExpoRational::smooth() const noexcept { return isEven(wholePower(alpha_ * (1 + gamma_))); }

}  // namespace knotwork::b_function
