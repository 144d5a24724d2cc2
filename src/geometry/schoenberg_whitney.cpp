#include "geometry/schoenberg_whitney.hpp"

#include "geometry/span_runs.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

namespace knotwork {

namespace {

/// The functions first … last are not zero at a parameter; counted on and on, not modulo n.
struct Active {
    std::size_t first = 0;
    std::size_t last = 0;
};

Active activeAt(const KnotVector& knots, std::size_t span, double u) {
    const std::span<const double> t = knots.extended();
    const auto d = static_cast<std::size_t>(knots.degree());
    Active active{span - d, span};
    // A knot of multiplicity m leaves d+1-m of them, one of full multiplicity the one that is 1.
    for (std::size_t m = 0; m < d && t[span - m] == u; ++m) --active.last;
    for (std::size_t m = 0; m < d && t[span + 1 + m] == u; ++m) ++active.first;
    return active;
}

/// Sums over the parameters' functions: begun[j] of them begin at or before function j, ended[j]
/// end before it. Of a periodic spline the line of functions goes on for two periods, and every
/// parameter has a copy in each period, one before the line included.
struct Counts {
    std::vector<std::ptrdiff_t> begun;
    std::vector<std::ptrdiff_t> ended;
    std::size_t parameters = 0;  ///< different ones
};

void count(Counts& counts, const Active& active, std::ptrdiff_t shift) {
    const auto size = static_cast<std::ptrdiff_t>(counts.begun.size());
    const auto place = [&](std::size_t j) {
        return std::max<std::ptrdiff_t>(0, static_cast<std::ptrdiff_t>(j) + shift);
    };
    const std::ptrdiff_t first = place(active.first);
    const std::ptrdiff_t after = place(active.last + 1);
    if (first < size) ++counts.begun[static_cast<std::size_t>(first)];
    if (after < size) ++counts.ended[static_cast<std::size_t>(after)];
}

/// Calls visit(span, u) for different parameters, at most d+3 of a span, which are as good as all of
/// them: only d+1 can serve its functions, and those at its ends come besides.
template <class Visit>
void visitParameters(const KnotVector& knots, std::span<const double> parameters, Visit visit) {
    const auto d = static_cast<std::size_t>(knots.degree());
    SpanRuns runs(knots, parameters);
    for (std::size_t span = d; span + d + 1 < knots.extended().size(); ++span) {
        const Run run = runs.of(span);
        const std::size_t end = run.first + run.count;
        std::size_t at = run.first;
        for (std::size_t seen = 0; at < end && seen < d + 2; ++seen) {
            const double u = parameters[at];
            visit(span, u);
            while (at < end && parameters[at] == u) ++at;
        }
        if (at < end) visit(span, parameters[end - 1]);
    }
}

Counts countParameters(const KnotVector& knots, std::span<const double> parameters) {
    const auto n = static_cast<std::size_t>(knots.pointCount());
    const auto period = static_cast<std::ptrdiff_t>(n);
    const std::size_t length = knots.closed() ? 2 * n : n;
    Counts counts{std::vector<std::ptrdiff_t>(length), std::vector<std::ptrdiff_t>(length)};
    const bool seam = knots.closed() && parameters.front() == knots.domain().start;
    visitParameters(knots, parameters, [&](std::size_t span, double u) {
        // Both sides of a seam are one.
        if (seam && u == knots.domain().end) return;
        const Active active = activeAt(knots, span, u);
        ++counts.parameters;
        for (const std::ptrdiff_t shift : {-period, std::ptrdiff_t{0}, period}) {
            if (shift == 0 || knots.closed()) count(counts, active, shift);
        }
    });
    std::partial_sum(counts.begun.begin(), counts.begun.end(), counts.begun.begin());
    std::partial_sum(counts.ended.begin(), counts.ended.end(), counts.ended.begin());
    return counts;
}

}  // namespace

// By Hall's theorem it is enough to look at runs of neighbouring functions i … j: begun[j] -
// ended[i] parameters touch one of them, which must be j - i + 1 at least.
std::optional<std::size_t> starvedFunction(const KnotVector& knots,
                                           std::span<const double> parameters) {
    if (parameters.empty()) return 0;
    const auto n = static_cast<std::size_t>(knots.pointCount());
    const Counts counts = countParameters(knots, parameters);
    for (std::size_t i = 0; i < n; ++i) {
        if (counts.begun[i] == counts.ended[i]) return i;
    }
    std::ptrdiff_t most = 0;  // of ended[i] - i, so far
    for (std::size_t j = 0; j < counts.begun.size(); ++j) {
        const auto place = static_cast<std::ptrdiff_t>(j);
        most = std::max(most, counts.ended[j] - place);
        if (most > counts.begun[j] - place - 1) return j % n;
    }
    if (counts.parameters < n) return counts.parameters;
    return std::nullopt;
}

Error refuseStarved(std::size_t function) {
    return refuse(Code::rankDeficient, indexed("controlPoints", function),
                  "the data do not determine control point " + std::to_string(function) +
                      ": too few different parameters lie where its basis function is not zero. "
                      "Give more points there, fewer control points, other knots or smoothing");
}

}  // namespace knotwork
