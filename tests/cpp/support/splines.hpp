// Random splines with fixed seeds, and the parameters at which they are tested.
#pragma once

#include "geometry/bspline_curve.hpp"

#include <algorithm>
#include <random>
#include <vector>

namespace knotwork::test {

struct SplineKind {
    int minDegree = 1;
    int maxDegree = 7;
    double size = 1;  // of coordinates
    int dimension = 3;
    bool rational = false;
    bool multipleKnots = true;  // interior multiplicities up to degree + 1
};

class RandomSplines {
public:
    explicit RandomSplines(unsigned seed) : engine_(seed) {}

    double real(double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(engine_);
    }
    int integer(int from, int to) { return std::uniform_int_distribution<int>(from, to)(engine_); }

    Form form() { return static_cast<Form>(integer(0, 2)); }

    std::vector<double> knots(int degree, int count, Form form, bool multiple) {
        // One run after the other, each short enough to leave d+1 equal knots at most.
        std::vector<double> values;
        double t = real(-3, 3);
        const int total = static_cast<int>(KnotVector::knotCount(degree, count, form));
        while (static_cast<int>(values.size()) < total) {
            const bool end = values.empty() || static_cast<int>(values.size()) + 1 == total;
            const bool clampedStart = form == Form::clamped && values.empty();
            const int left = total - static_cast<int>(values.size());
            int run = multiple && !end && integer(0, 2) == 0 ? integer(1, degree + 1) : 1;
            if (clampedStart) run = degree + 1;
            if (form == Form::clamped && !clampedStart) {
                run = left == degree + 1 ? left : std::min(run, left - degree - 1);
            }
            if (form == Form::closed) run = std::min(run, std::max(left - 1, 1));
            values.insert(values.end(), static_cast<std::size_t>(std::min(run, left)), t);
            t += real(0.2, 2);
        }
        return values;
    }

    KnotVector knotVector(int degree, Form form, bool multiple = true) {
        // Open vectors can come out without a domain: try again.
        for (;;) {
            const int count = integer(degree + 1, degree + 12);
            auto made = KnotVector::make(knots(degree, count, form, multiple), degree, count, form);
            if (made.ok()) return std::move(made).value();
        }
    }

    BsplineCurve curve(Form form, const SplineKind& kind = {}) {
        KnotVector vector =
            knotVector(integer(kind.minDegree, kind.maxDegree), form, kind.multipleKnots);
        std::vector<Vec3> points;
        std::vector<double> weights;
        for (int i = 0; i < vector.pointCount(); ++i) {
            const auto coordinate = [&] { return real(-kind.size, kind.size); };
            points.emplace_back(coordinate(), coordinate(), kind.dimension == 3 ? coordinate() : 0);
            if (kind.rational) weights.push_back(real(0.3, 3));
        }
        return BsplineCurve::make(std::move(vector), std::move(points), kind.dimension,
                                  std::move(weights))
            .value();
    }

private:
    std::mt19937 engine_;
};

/// Both ends, every knot of the domain, and some parameters between.
inline std::vector<double> telltaleParameters(const KnotVector& knots, RandomSplines& random,
                                              int between = 20) {
    const Interval domain = knots.domain();
    std::vector<double> ts{domain.start, domain.end};
    for (const double t : knots.knots()) {
        if (domain.contains(t)) ts.push_back(t);
    }
    for (int i = 0; i < between; ++i) ts.push_back(random.real(domain.start, domain.end));
    std::sort(ts.begin(), ts.end());
    ts.erase(std::unique(ts.begin(), ts.end()), ts.end());
    return ts;
}

/// The point as it is seen from one side of a knot.
[[nodiscard]] inline Vec3 pointOf(const BsplineCurve& curve, double t, Side side) {
    Vec3 point;
    curve.derivatives(t, side, {&point, 1});
    return point;
}

inline constexpr Form allForms[] = {Form::clamped, Form::open, Form::closed};
inline constexpr Side bothSides[] = {Side::left, Side::right};

}  // namespace knotwork::test
