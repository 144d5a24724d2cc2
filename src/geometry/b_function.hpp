// B-functions: the monotone B: [0,1] → [0,1] with B(0) = 0, B(1) = 1 that blend local curves.
//
// A BFunction is a value, checked when it is made and total afterwards; copies are cheap (tables
// and operands are shared and never change). Definitions: the table in b_function_descriptions.hpp;
// Lakså, Bang, Dechevsky: Exploring expo-rational B-splines for curves and surfaces, 2005.
#pragma once

#include "geometry/b_function_descriptions.hpp"
#include "geometry/b_function_families.hpp"

#include <array>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace knotwork {

class BFunction {
public:
    /// The linear one, B(t) = t.
    BFunction() noexcept = default;

    // Each refuses with the offending parameter's name as path (`alpha`, `values[3]`): NOT_FINITE,
    // NOT_INTEGER, OUT_OF_RANGE against bFunctionFamilies(). Integers are passed as numbers.
    static Result<BFunction> makeTrigonometric(double order = 1);
    static Result<BFunction> makePolynomial(double p = 1, double q = 1);
    static Result<BFunction> makeRational(double m = 2, double c = 1);
    static Result<BFunction> makeExpoRational(double alpha = 1, double beta = 1, double gamma = 1,
                                              double lambda = 0.5);
    static Result<BFunction> makeLogistic(double c = 1);
    /// Any family given by parameters alone by its name. UNKNOWN_NAME at `family`, UNKNOWN_FIELD
    /// at the name of a parameter that the family does not have.
    static Result<BFunction> make(std::string_view family, std::span<const NamedValue> parameters);

    /// Monotone C¹ interpolation of 2 to 100 000 values on a uniform grid, the first 0, the last 1,
    /// none below the one before it. WRONG_LENGTH or TOO_LARGE at `values`.
    static Result<BFunction> makeTabulated(std::span<const double> values);

    /// The B(t) of a formula in t (see Formula), checked against the axioms; refusals at
    /// `expression`.
    static Result<BFunction> makeFormula(std::string_view expression);

    /// 1 − B(1−t); (B + dual)/2; outer(inner(t)); weight·first + (1−weight)·second. TOO_LARGE when
    /// nested deeper than 32 or when one value would take more than 1024 evaluations.
    static Result<BFunction> makeDual(const BFunction& of);
    static Result<BFunction> makeSymmetrised(const BFunction& of);
    static Result<BFunction> makeComposed(const BFunction& outer, const BFunction& inner);
    static Result<BFunction> makeMixed(const BFunction& first, const BFunction& second,
                                       double weight);

    /// B(t); 0 left and 1 right of [0,1] (and 0 for a NaN). B(0) = 0 and B(1) = 1 exactly. Error:
    /// at most 2e-13, 1e-9 relative for expo-rational tails; no allocation.
    [[nodiscard]] double value(double t) const noexcept;
    /// B, B′, B″, … into at most 26 rows; inside [0,1] one-sided at its ends, outside 0. Exact up
    /// to rounding. Where a derivative does not exist (see smooth()) or overflows, its row is 0.
    void derivatives(double t, std::span<double> rows) const noexcept;
    /// values[i] = B(ts[i]), the family looked up once. Both of the same length.
    void sample(std::span<const double> ts, std::span<double> values) const noexcept;
    /// B at values.size() uniform parameters, both ends included.
    void sampleUniform(std::span<double> values) const noexcept;
    /// rows.size() = (1 + derivatives)·ts.size(): all B, then all B′, …
    void sampleDerivatives(std::span<const double> ts, std::span<double> rows) const noexcept;

    /// Hermite orders {at 0, at 1}: the largest s with B^(l) = 0 there for l = 1 … s; may be
    /// infinite.
    [[nodiscard]] std::array<double, 2> order() const noexcept;
    /// The exponents {e0, e1} with B ~ t^e0 at 0 and 1 − B ~ (1−t)^e1 at 1; order() is ⌈e⌉ − 1.
    [[nodiscard]] std::array<double, 2> powers() const noexcept;
    /// B(t) + B(1−t) = 1.
    [[nodiscard]] bool symmetric() const noexcept;
    /// Derivatives of every order exist on all of [0,1]; otherwise warning() says where they end.
    [[nodiscard]] bool smooth() const noexcept;
    [[nodiscard]] std::string_view warning() const noexcept;

    // What it was made from.
    [[nodiscard]] BFamily family() const noexcept { return static_cast<BFamily>(form_.index()); }
    [[nodiscard]] const BFamilyDescription& description() const noexcept;
    /// In the order of description().parameters.
    [[nodiscard]] std::span<const double> parameters() const noexcept;
    /// The values of a tabulated one, else empty.
    [[nodiscard]] std::span<const double> values() const noexcept;
    /// What was typed for a formula, else empty.
    [[nodiscard]] std::string_view expression() const noexcept;
    /// In the order of description().operands; empty for a family that takes none.
    [[nodiscard]] std::vector<BFunction> operands() const;

    /// Same family, parameters, values, expression and operands.
    friend bool operator==(const BFunction& a, const BFunction& b) noexcept;

private:
    using Form = std::variant<b_function::Linear, b_function::Trigonometric, b_function::Polynomial,
                              b_function::Rational, b_function::ExpoRational, b_function::Logistic,
                              b_function::Tabulated, b_function::UserFormula, b_function::Dual,
                              b_function::Symmetrised, b_function::Composed, b_function::Mixed>;

    BFunction(Form form, std::initializer_list<double> parameters) noexcept;
    static Result<BFunction> nest(Form form, std::initializer_list<double> parameters,
                                  std::span<const BFunction* const> operands);

    Form form_;  // alternatives in the order of BFamily
    std::array<double, 4> parameters_{};
    int depth_ = 1;        // of nesting
    int evaluations_ = 1;  // of families that one value takes
};

}  // namespace knotwork
