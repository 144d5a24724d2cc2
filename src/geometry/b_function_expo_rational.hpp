// The expo-rational B-function: B = S ∫_0^t φ, φ(t) = exp(−β |t−λ|^(α(1+γ)) / (t (1−t)^γ)^α).
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <span>

namespace knotwork::b_function {

class ErbTable;

/// Values from a table of polynomials that is made with the value and shared by its copies;
/// derivatives from φ itself. Error of value(): 2e-13, and 1e-9 of B where B is small.
class ExpoRational {
public:
    /// Parameters in the ranges of the description. Cost: a few thousand evaluations of φ.
    ExpoRational(double alpha, double beta, double gamma, double lambda);

    [[nodiscard]] double value(double t) const noexcept;
    void sample(std::span<const double> ts, std::span<double> values) const noexcept;
    void derivatives(double t, std::span<double> rows) const noexcept;
    [[nodiscard]] std::array<double, 2> powers() const noexcept {
        return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    }
    [[nodiscard]] bool symmetric() const noexcept { return gamma_ == 1 && lambda_ == 0.5; }
    /// φ has all derivatives at λ only if α(1+γ) is an even integer.
    [[nodiscard]] bool smooth() const noexcept;

private:
    double alpha_;
    double beta_;
    double gamma_;
    double lambda_;
    std::shared_ptr<const ErbTable> table_;
};

}  // namespace knotwork::b_function
