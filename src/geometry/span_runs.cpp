#include "geometry/span_runs.hpp"

#include <algorithm>

namespace knotwork {

Run SpanRuns::of(std::size_t span) {
    const std::span<const double> t = knots_.extended();
    if (!(t[span] < t[span + 1])) return {};
    const std::size_t from = t[span] == nextKnot_ ? next_ : firstFrom(0, 0, t[span]);
    const bool last = t[span + 1] == knots_.domain().end;
    next_ = last ? parameters_.size() : firstFrom(from, from + count_, t[span + 1]);
    nextKnot_ = t[span + 1];
    count_ = next_ - from;
    return {from, count_};
}

/// The first parameter from this one on that is not less than t: around the guess, in steps that
/// double.
std::size_t SpanRuns::firstFrom(std::size_t from, std::size_t guess, double t) const {
    std::size_t low = from;                  // those before it are less
    std::size_t high = parameters_.size();  // those from it on are not
    if (guess < high && parameters_[guess] < t) {
        low = guess + 1;
        for (std::size_t step = 1; low + step <= high; step *= 2) {
            const std::size_t at = low + step - 1;
            if (!(parameters_[at] < t)) {
                high = at;
                break;
            }
            low = at + 1;
        }
    } else {
        high = std::min(guess, high);
        for (std::size_t step = 1; low + step <= high; step *= 2) {
            const std::size_t at = high - step;
            if (parameters_[at] < t) {
                low = at + 1;
                break;
            }
            high = at;
        }
    }
    const auto rest = parameters_.subspan(low, high - low);
    return low + static_cast<std::size_t>(std::lower_bound(rest.begin(), rest.end(), t) -
                                          rest.begin());
}

}  // namespace knotwork
