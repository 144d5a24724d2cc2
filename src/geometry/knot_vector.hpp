// Knot vectors: checked once when made, total afterwards.
//
// Degree d, n points. An open or clamped curve has the n+d+1 knots t_0 … t_{n+d} and the domain
// [t_d, t_n]. A closed one is given by one period, the n+1 knots K_0 … K_n with K_{i+n} = K_i + T;
// span j of it uses the points j … j+d modulo n. Everything below computes with the *extended*
// vector, which is the given one where the curve is not closed, and K_{-d} … K_{n+d} where it is:
// so span i of the extended vector always uses the points i-d … i (modulo n).
#pragma once

#include "geometry/interval.hpp"
#include "geometry/result.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace knotwork {

inline constexpr int maxDegree = 25;
inline constexpr int maxPointCount = 100'000;

/// clamped: both end knots d+1 times, so that the curve begins and ends in its end points.
/// open: any knots, no end conditions. closed: periodic.
enum class Form { clamped, open, closed };

/// t moved by whole periods into [start, end) for the right side, (start, end] for the left.
/// Parameters that are there already do not change.
[[nodiscard]] double wrapParameter(const Interval& period, double t, Side side) noexcept;

class KnotVector {
public:
    /// Checks knots in the form described above. Refusals: OUT_OF_RANGE or TOO_LARGE `degree`
    /// (1 … 25); WRONG_LENGTH or TOO_LARGE `points` (d+1 … 100 000); KNOTS_COUNT `knots`; and for
    /// single knots `knots[i]` NOT_FINITE, OUT_OF_RANGE (|t| ≤ 1e9; gaps are 0 or at least 1e-12
    /// of the domain and 8 ulp), KNOTS_DECREASING, KNOTS_MULTIPLICITY (at most d+1 equal ones;
    /// exactly d+1 at both ends of a clamped vector); OUT_OF_RANGE `knots` for a domain shorter
    /// than 1e-6 or than 1e-9 of the largest knot.
    [[nodiscard]] static Result<KnotVector> make(std::vector<double> knots, int degree,
                                                 int pointCount, Form form);

    /// Unit spans: open 0 … n+d with domain [d, n]; clamped with domain [0, n-d]; closed 0 … n.
    [[nodiscard]] static Result<KnotVector> uniform(int degree, int pointCount, Form form);

    /// How many numbers make() wants: n+d+1, or n+1 for a closed curve.
    [[nodiscard]] static std::size_t knotCount(int degree, int pointCount, Form form) noexcept;

    [[nodiscard]] int degree() const noexcept { return degree_; }
    [[nodiscard]] int pointCount() const noexcept { return pointCount_; }
    [[nodiscard]] Form form() const noexcept { return form_; }
    [[nodiscard]] bool closed() const noexcept { return form_ == Form::closed; }

    /// As given: all knots, or one period of a closed vector.
    [[nodiscard]] std::span<const double> knots() const noexcept;
    /// All knots that have a part in the domain: n+d+1, or n+2d+1 of a closed vector.
    [[nodiscard]] std::span<const double> extended() const noexcept { return extended_; }

    [[nodiscard]] Interval domain() const noexcept;
    /// Length of the domain; the period T of a closed vector.
    [[nodiscard]] double period() const noexcept { return domain().length(); }

    /// The index i of the extended vector with t_i ≤ t < t_{i+1} (right) or t_i < t ≤ t_{i+1}
    /// (left), never an empty span. Beyond an end of the domain, and on the side of an end where
    /// there is nothing, the last span of that end. O(log n).
    [[nodiscard]] std::size_t findSpan(double t, Side side = Side::right) const noexcept;

    /// How many knots equal t (modulo the period of a closed vector).
    [[nodiscard]] int multiplicity(double t) const noexcept;

    /// A closed vector: wrapParameter() into the domain. Others: t itself.
    [[nodiscard]] double wrap(double t, Side side = Side::right) const noexcept;

    /// The point of the control polygon that active function j (0 … d) of a span belongs to.
    [[nodiscard]] std::size_t pointIndex(std::size_t span, std::size_t j) const noexcept {
        const std::size_t index = span - static_cast<std::size_t>(degree_) + j;
        const auto count = static_cast<std::size_t>(pointCount_);
        return index < count ? index : index - count;
    }

    /// Greville abscissae (t_{i+1} + … + t_{i+d}) / d, one per point; those of a closed vector
    /// are moved into the domain.
    [[nodiscard]] std::vector<double> grevilles() const;

    friend bool operator==(const KnotVector&, const KnotVector&) = default;

private:
    KnotVector(std::vector<double> knots, int degree, int pointCount, Form form);

    [[nodiscard]] std::size_t firstDomainIndex() const noexcept;
    [[nodiscard]] std::size_t lastDomainIndex() const noexcept;

    std::vector<double> extended_;
    int degree_;
    int pointCount_;
    Form form_;
};

}  // namespace knotwork
