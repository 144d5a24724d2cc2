#include "geometry/boehm.hpp"

#include "geometry/bspline_indexing.hpp"
#include "geometry/bspline_kernels.hpp"

#include <algorithm>
#include <utility>

namespace knotwork {

namespace {

Homogeneous blend(const Homogeneous& from, const Homogeneous& to, double a) noexcept {
    return (1 - a) * from + a * to;
}

// b_i is c_i up to s-d, c_{i-1} from the first knot equal to t on (there a_i = 0, and c_i may lie
// past the last point), and a blend between.
std::vector<Homogeneous> insertedPoints(std::span<const double> knots, std::size_t degree,
                                        std::size_t span, std::span<const Homogeneous> points,
                                        double t) {
    std::vector<Homogeneous> refined(points.size() + 1);
    for (std::size_t i = 0; i < refined.size(); ++i) {
        if (i + degree <= span) {
            refined[i] = points[i];
        } else if (knots[i] >= t) {
            refined[i] = points[i - 1];
        } else {
            refined[i] = blend(points[i - 1], points[i], kernels::weight(knots, degree, i, t));
        }
    }
    return refined;
}

// The d blended points s-d+1 … s and the n+1-d that follow them are one period of the refined
// polygon; indices of either polygon wrap.
std::vector<Homogeneous> insertedPeriod(std::span<const double> knots, std::size_t degree,
                                        std::size_t span, std::span<const Homogeneous> points,
                                        double t) {
    const std::size_t n = points.size();
    std::vector<Homogeneous> refined(n + 1);
    const std::size_t first = span - degree + 1;
    for (std::size_t i = first; i <= first + n; ++i) {
        const Homogeneous& before = points[(i - 1) % n];
        refined[i % (n + 1)] =
            i > span ? before : blend(before, points[i % n], kernels::weight(knots, degree, i, t));
    }
    return refined;
}

/// A polygon in the making: the knots and points up to the last insertion are those of the result,
/// the others still those of the curve.
class Insertions {
public:
    Insertions(std::span<const double> knots, std::span<const Homogeneous> points,
               std::size_t degree, std::size_t expected)
        : knots_(knots), points_(points), degree_(degree) {
        merged_.reserve(expected + degree + 1);
        out_.reserve(expected);
    }

    /// Takes the knots up to t over; t itself is new unless it is the next of them.
    void advanceTo(double t) {
        while (next() < knots_.size() && knots_[next()] < t) merged_.push_back(knots_[next()]);
        if (next() < knots_.size() && knots_[next()] == t) {
            merged_.push_back(t);
        } else {
            insert(t);
        }
    }

    [[nodiscard]] std::vector<Homogeneous> finish() && {
        takePointsUpTo(points_.size() + inserted_);
        return std::move(out_);
    }

private:
    [[nodiscard]] std::size_t next() const noexcept { return merged_.size() - inserted_; }

    void takePointsUpTo(std::size_t count) {
        while (out_.size() < count && out_.size() - inserted_ < points_.size()) {
            out_.push_back(points_[out_.size() - inserted_]);
        }
    }

    void insert(double t) {
        const std::size_t span = merged_.size() - 1;
        takePointsUpTo(span + 1);
        std::size_t i = out_.size() - 1;
        out_.push_back(out_.back());
        for (; i + degree_ > span; --i) {
            const double from = merged_[i];
            const double to = knots_[i + degree_ - inserted_];
            out_[i] = from >= t ? out_[i - 1] : blend(out_[i - 1], out_[i], (t - from) / (to - from));
        }
        merged_.push_back(t);
        ++inserted_;
    }

    std::span<const double> knots_;
    std::span<const Homogeneous> points_;
    std::size_t degree_;
    std::size_t inserted_ = 0;
    std::vector<double> merged_;
    std::vector<Homogeneous> out_;
};

/// The period of a closed vector with d knots before it and 2d after it: the d points that cross
/// the seam need their knots on both sides.
struct Unrolled {
    std::vector<double> knots;
    std::vector<Homogeneous> points;
};

Unrolled unroll(const KnotVector& knots, std::span<const Homogeneous> points) {
    const auto degree = static_cast<std::ptrdiff_t>(knots.degree());
    const auto seam = static_cast<std::ptrdiff_t>(seamIndex(knots));
    Unrolled unrolled;
    for (auto i = seam - degree; i <= seam + knots.pointCount() + 2 * degree; ++i) {
        unrolled.knots.push_back(knotAt(knots, i));
        unrolled.points.push_back(points[cyclic(i, points.size())]);
    }
    return unrolled;
}

std::vector<Homogeneous> boehmClosed(const KnotVector& knots, const KnotVector& refined,
                                     std::span<const Homogeneous> points) {
    const auto degree = static_cast<std::size_t>(knots.degree());
    const auto count = static_cast<std::size_t>(refined.pointCount());
    const Unrolled unrolled = unroll(knots, points);
    Insertions insertions(unrolled.knots, unrolled.points, degree, count + 4 * degree);
    for (std::size_t i = 0; i < degree; ++i) insertions.advanceTo(unrolled.knots[i]);
    const std::size_t seam = seamIndex(refined);
    for (std::size_t i = 0; i < count + degree; ++i) {
        insertions.advanceTo(refined.extended()[seam + i]);
    }
    const std::vector<Homogeneous> all = std::move(insertions).finish();
    std::vector<Homogeneous> period(count);
    for (std::size_t i = 0; i < count; ++i) period[(seam + i) % count] = all[degree + i];
    return period;
}

}  // namespace

std::vector<Homogeneous> boehmOnce(const KnotVector& knots, std::span<const Homogeneous> points,
                                   double t) {
    const auto all = knots.extended();
    const auto degree = static_cast<std::size_t>(knots.degree());
    const auto after = std::upper_bound(all.begin(), all.end(), t) - all.begin();
    const std::size_t span = static_cast<std::size_t>(after) - 1;
    return knots.closed() ? insertedPeriod(all, degree, span, points, t)
                          : insertedPoints(all, degree, span, points, t);
}

std::vector<Homogeneous> boehm(const KnotVector& knots, const KnotVector& refined,
                               std::span<const Homogeneous> points) {
    if (knots.closed()) return boehmClosed(knots, refined, points);
    Insertions insertions(knots.extended(), points, static_cast<std::size_t>(knots.degree()),
                          static_cast<std::size_t>(refined.pointCount()));
    for (const double t : refined.extended()) insertions.advanceTo(t);
    return std::move(insertions).finish();
}

}  // namespace knotwork
