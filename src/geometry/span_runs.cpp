#include "geometry/span_runs.hpp"

#include <algorithm>

namespace knotwork {

Run SpanRuns::of(std::size_t span) {
    const std::span<const double> t = knots_.extended();
    if (!(t[span] < t[span + 1])) return {};
    const std::size_t from = t[span] == nextKnot_ ? next_ : firstFrom(0, t[span]);
    const bool last = t[span + 1] == knots_.domain().end;
    next_ = last ? parameters_.size() : firstFrom(from, t[span + 1]);
    nextKnot_ = t[span + 1];
    return {from, next_ - from};
}

/// The first parameter from this one on that is not less than t, in steps that double.
std::size_t SpanRuns::firstFrom(std::size_t from, double t) const {
    const std::size_t size = parameters_.size();
    std::size_t low = from;
    std::size_t high = from;
    for (std::size_t step = 1; high < size && parameters_[high] < t; step *= 2) {
        low = high + 1;
        high += step;
    }
    const auto rest = parameters_.subspan(low, std::min(high, size) - low);
    return low + static_cast<std::size_t>(std::lower_bound(rest.begin(), rest.end(), t) -
                                          rest.begin());
}

}  // namespace knotwork
