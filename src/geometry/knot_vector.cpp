#include "geometry/knot_vector.hpp"

#include "geometry/simd.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace knotwork {

namespace {

constexpr double largestKnot = 1e9;
constexpr double shortestDomain = 1e-6;
constexpr double shortestDomainRelative = 1e-9;  // of the largest |t|
constexpr double smallestGap = 1e-12;            // of the domain
constexpr double smallestGapUlps = 8;

using MaybeError = std::optional<Error>;

Error refuseKnot(Code code, std::size_t index, std::string message) {
    return refuse(code, indexed("knots", index), std::move(message));
}

MaybeError checkSizes(int degree, int pointCount) {
    if (degree < 1) {
        return refuse(Code::outOfRange, "degree",
                      "degree is " + std::to_string(degree) + "; it must be 1 to 25");
    }
    if (degree > maxDegree) {
        return refuse(Code::tooLarge, "degree",
                      "degree is " + std::to_string(degree) + "; at most 25 is supported");
    }
    if (pointCount > maxPointCount) {
        return refuse(Code::tooLarge, "points",
                      std::to_string(pointCount) + " points; at most 100000 are supported");
    }
    if (pointCount <= degree) {
        return refuse(Code::wrongLength, "points",
                      std::to_string(pointCount) + " points are too few for degree " +
                          std::to_string(degree) + "; give at least " + std::to_string(degree + 1) +
                          " or lower the degree");
    }
    return {};
}

MaybeError checkCount(std::size_t given, int degree, int pointCount, Form form) {
    const std::size_t needed = KnotVector::knotCount(degree, pointCount, form);
    if (given == needed) return {};
    const char* rule = form == Form::closed ? "points + 1, one period" : "points + degree + 1";
    return refuse(Code::knotsCount, "knots",
                  std::to_string(given) + " knots given, " + std::to_string(needed) + " needed (" +
                      rule + ")");
}

MaybeError checkValues(std::span<const double> knots) {
    for (std::size_t i = 0; i < knots.size(); ++i) {
        if (!std::isfinite(knots[i])) {
            return refuseKnot(Code::notFinite, i,
                              formatNumber(knots[i]) + " is not a finite number");
        }
        if (std::abs(knots[i]) > largestKnot) {
            return refuseKnot(Code::outOfRange, i,
                              formatNumber(knots[i]) + " is out of range; knots lie in ±1e9");
        }
    }
    for (std::size_t i = 1; i < knots.size(); ++i) {
        if (knots[i] < knots[i - 1]) {
            return refuseKnot(Code::knotsDecreasing, i,
                              formatNumber(knots[i]) + " is less than the knot before it, " +
                                  formatNumber(knots[i - 1]) +
                                  "; knots must not decrease: sort them");
        }
    }
    return {};
}

MaybeError refuseMultiplicity(std::size_t index, double knot, int degree) {
    return refuseKnot(Code::knotsMultiplicity, index,
                      formatNumber(knot) + " stands more than " + std::to_string(degree + 1) +
                          " times; at most degree + 1 knots may be equal");
}

// Runs that reach over the seam of a closed vector are counted whole: the last knot is the first.
MaybeError checkMultiplicity(std::span<const double> knots, int degree, bool closed) {
    const auto most = static_cast<std::size_t>(degree) + 1;
    for (std::size_t i = most; i < knots.size(); ++i) {
        if (knots[i] == knots[i - most]) return refuseMultiplicity(i, knots[i], degree);
    }
    if (!closed) return {};
    const auto isFirst = [&](double knot) { return knot == knots.front(); };
    const auto isLast = [&](double knot) { return knot == knots.back(); };
    const auto atStart = std::find_if_not(knots.begin(), knots.end(), isFirst) - knots.begin();
    const auto atEnd = std::find_if_not(knots.rbegin(), knots.rend(), isLast) - knots.rbegin();
    if (static_cast<std::size_t>(atStart + atEnd - 1) > most) {
        return refuseMultiplicity(knots.size() - 1, knots.back(), degree);
    }
    return {};
}

Error refuseUnclamped(std::span<const double> knots, std::size_t index, std::size_t end,
                      int degree) {
    return refuseKnot(Code::knotsMultiplicity, index,
                      formatNumber(knots[index]) + " is not the " +
                          (end == 0 ? "first" : "last") + " knot " + formatNumber(knots[end]) +
                          "; a clamped curve begins and ends with degree + 1 = " +
                          std::to_string(degree + 1) +
                          " equal knots: repeat the end knot or use the form 'open'");
}

MaybeError checkClampedEnds(std::span<const double> knots, int degree) {
    const auto d = static_cast<std::size_t>(degree);
    const std::size_t last = knots.size() - 1;
    for (std::size_t i = 1; i <= d; ++i) {
        if (knots[i] != knots[0]) return refuseUnclamped(knots, i, 0, degree);
    }
    for (std::size_t i = last - d; i < last; ++i) {
        if (knots[i] != knots[last]) return refuseUnclamped(knots, i, last, degree);
    }
    return {};
}

Interval domainOf(std::span<const double> knots, int degree, Form form) noexcept {
    if (form == Form::closed) return {knots.front(), knots.back()};
    const auto d = static_cast<std::size_t>(degree);
    return {knots[d], knots[knots.size() - 1 - d]};
}

MaybeError checkDomain(std::span<const double> knots, const Interval& domain) {
    const double largest = std::max(std::abs(knots.front()), std::abs(knots.back()));
    const double shortest = std::max(shortestDomain, shortestDomainRelative * largest);
    if (domain.length() >= shortest) return {};
    return refuse(Code::outOfRange, "knots",
                  "the domain [" + formatNumber(domain.start) + ", " + formatNumber(domain.end) +
                      "] is too short; it must be at least " + formatNumber(shortest) + " long");
}

MaybeError checkGaps(std::span<const double> knots, const Interval& domain) {
    constexpr double ulp = std::numeric_limits<double>::epsilon();
    for (std::size_t i = 1; i < knots.size(); ++i) {
        const double gap = knots[i] - knots[i - 1];
        const double largest = std::max(std::abs(knots[i]), std::abs(knots[i - 1]));
        const double smallest =
            std::max(smallestGap * domain.length(), smallestGapUlps * ulp * largest);
        if (gap > 0 && gap < smallest) {
            return refuseKnot(Code::outOfRange, i,
                              formatNumber(knots[i]) + " is only " + formatNumber(gap) +
                                  " after the knot before it; make them equal or at least " +
                                  formatNumber(smallest) + " apart");
        }
    }
    return {};
}

/// Whether one look at each knot is enough to see that none of them is to be refused by itself.
bool isPlain(std::span<const double> knots, const Interval& domain, int degree) noexcept {
    const double largest = std::max(std::abs(knots.front()), std::abs(knots.back()));
    if (!(largest <= largestKnot)) return false;
    const double smallest =
        std::max(smallestGap * domain.length(),
                 smallestGapUlps * std::numeric_limits<double>::epsilon() * largest);
    const auto most = static_cast<std::size_t>(degree) + 1;
    // Nothing of this holds where there is a NaN.
    const auto plainGap = [&](std::size_t i) {
        const double gap = knots[i] - knots[i - 1];
        return gap == 0 || gap >= smallest;
    };
    std::size_t i = 1;
    for (; i < most; ++i) {
        if (!plainGap(i)) return false;
    }
    simd::Truth2 plain = simd::splat(0) == simd::splat(0);
    for (; i + 1 < knots.size(); i += 2) {
        const simd::Double2 pair = simd::load(&knots[i]);
        const simd::Double2 gap = pair - simd::load(&knots[i - 1]);
        plain = plain & ((gap == simd::splat(0)) | (gap >= simd::splat(smallest))) &
                (pair > simd::load(&knots[i - most]));
    }
    if (i < knots.size() && !(plainGap(i) && knots[i] > knots[i - most])) return false;
    return simd::inBoth(plain);
}

MaybeError checkAll(std::span<const double> knots, int degree, int pointCount, Form form) {
    if (auto error = checkSizes(degree, pointCount)) return error;
    if (auto error = checkCount(knots.size(), degree, pointCount, form)) return error;
    const Interval domain = domainOf(knots, degree, form);
    const bool plain = isPlain(knots, domain, degree);
    if (!plain) {
        if (auto error = checkValues(knots)) return error;
    }
    if (!plain || form == Form::closed) {
        if (auto error = checkMultiplicity(knots, degree, form == Form::closed)) return error;
    }
    if (form == Form::clamped) {
        if (auto error = checkClampedEnds(knots, degree)) return error;
    }
    if (auto error = checkDomain(knots, domain)) return error;
    return plain ? MaybeError() : checkGaps(knots, domain);
}

// K_{-d} … K_{n+d}. Differences are taken first, so that knots equal to a seam stay equal to it.
std::vector<double> extendPeriod(std::span<const double> period, std::size_t degree) {
    const std::size_t n = period.size() - 1;
    std::vector<double> extended;
    extended.reserve(n + 2 * degree + 1);
    for (std::size_t m = degree; m >= 1; --m) {
        extended.push_back(period[0] - (period[n] - period[n - m]));
    }
    extended.insert(extended.end(), period.begin(), period.end());
    for (std::size_t m = 1; m <= degree; ++m) {
        extended.push_back(period[n] + (period[m] - period[0]));
    }
    return extended;
}

}  // namespace

double wrapParameter(const Interval& period, double t, Side side) noexcept {
    if (period.start < t && t < period.end) return t;
    double inside = t;
    if (!period.contains(t)) {
        double past = std::fmod(t - period.start, period.length());
        if (past < 0) past += period.length();
        inside = std::clamp(period.start + past, period.start, period.end);
    }
    if (side == Side::right) return inside == period.end ? period.start : inside;
    return inside == period.start ? period.end : inside;
}

KnotVector::KnotVector(std::vector<double> knots, int degree, int pointCount, Form form)
    : extended_(form == Form::closed ? extendPeriod(knots, static_cast<std::size_t>(degree))
                                     : std::move(knots)),
      degree_(degree),
      pointCount_(pointCount),
      form_(form) {}

std::size_t KnotVector::knotCount(int degree, int pointCount, Form form) noexcept {
    const auto points = static_cast<std::size_t>(pointCount);
    return form == Form::closed ? points + 1 : points + static_cast<std::size_t>(degree) + 1;
}

Result<KnotVector> KnotVector::make(std::vector<double> knots, int degree, int pointCount,
                                    Form form) {
    if (auto error = checkAll(knots, degree, pointCount, form)) return *std::move(error);
    return KnotVector(std::move(knots), degree, pointCount, form);
}

Result<KnotVector> KnotVector::uniform(int degree, int pointCount, Form form) {
    if (auto error = checkSizes(degree, pointCount)) return *std::move(error);
    std::vector<double> knots(knotCount(degree, pointCount, form));
    for (std::size_t i = 0; i < knots.size(); ++i) {
        const double step = static_cast<double>(i);
        knots[i] = form == Form::clamped
                       ? std::clamp(step - degree, 0.0, static_cast<double>(pointCount - degree))
                       : step;
    }
    return KnotVector(std::move(knots), degree, pointCount, form);
}

std::span<const double> KnotVector::knots() const noexcept {
    const std::span<const double> all = extended_;
    if (!closed()) return all;
    return all.subspan(firstDomainIndex(), static_cast<std::size_t>(pointCount_) + 1);
}

std::size_t KnotVector::firstDomainIndex() const noexcept {
    return static_cast<std::size_t>(degree_);
}

std::size_t KnotVector::lastDomainIndex() const noexcept {
    return extended_.size() - 1 - static_cast<std::size_t>(degree_);
}

Interval KnotVector::domain() const noexcept {
    return {extended_[firstDomainIndex()], extended_[lastDomainIndex()]};
}

std::size_t KnotVector::findSpan(double t, Side side) const noexcept {
    const Interval all = domain();
    const auto begin = extended_.begin();
    // A NaN fails both comparisons and stays in the first span.
    const bool fromLeft = t >= all.end || (side == Side::left && t > all.start);
    const double inside = t >= all.end ? all.end : (t > all.start ? t : all.start);
    const auto after = fromLeft ? std::lower_bound(begin, extended_.end(), inside)
                                : std::upper_bound(begin, extended_.end(), inside);
    return static_cast<std::size_t>(after - begin) - 1;
}

int KnotVector::multiplicity(double t) const noexcept {
    const double inside = wrap(t);
    const auto [first, last] = std::equal_range(extended_.begin(), extended_.end(), inside);
    return static_cast<int>(last - first);
}

double KnotVector::wrap(double t, Side side) const noexcept {
    return closed() ? wrapParameter(domain(), t, side) : t;
}

std::vector<double> KnotVector::grevilles() const {
    const auto d = static_cast<std::size_t>(degree_);
    std::vector<double> averages(static_cast<std::size_t>(pointCount_));
    for (std::size_t i = 0; i < averages.size(); ++i) {
        const double first = extended_[i + 1];
        double rest = 0;
        for (std::size_t j = 1; j < d; ++j) rest += extended_[i + 1 + j] - first;
        averages[i] = wrap(first + rest / degree_);
    }
    return averages;
}

}  // namespace knotwork
