// Which of many sorted parameters fall into which span.
#pragma once

#include "geometry/knot_vector.hpp"

#include <cstddef>
#include <limits>
#include <span>

namespace knotwork {

/// The parameters of one span, which follow each other.
struct Run {
    std::size_t first = 0;
    std::size_t count = 0;
};

/// Best asked for one span after the other. Knots and parameters, which lie in the domain and do not
/// decrease, must stay where they are.
class SpanRuns {
public:
    SpanRuns(const KnotVector& knots, std::span<const double> parameters)
        : knots_(knots), parameters_(parameters) {}

    /// Those in [t_i, t_{i+1}), in the last span with its end; none of an empty span. O(log m), and
    /// for the span after the last one asked for O(log k), k the difference of their counts.
    [[nodiscard]] Run of(std::size_t span);

private:
    [[nodiscard]] std::size_t firstFrom(std::size_t from, std::size_t guess, double t) const;

    const KnotVector& knots_;
    std::span<const double> parameters_;
    double nextKnot_ = std::numeric_limits<double>::infinity();
    std::size_t next_ = 0;   // the first parameter not less than nextKnot_
    std::size_t count_ = 0;  // of the last run, which the next one's is often near
};

}  // namespace knotwork
