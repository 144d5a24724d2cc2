#include "geometry/oslo.hpp"

#include "geometry/oslo_kernels.hpp"
#include "geometry/simd.hpp"

#include <algorithm>
#include <array>
#include <type_traits>

namespace knotwork {

namespace {

using simd::Double2;
using simd::fromOn;

double fromOn(double a, double b, double reached, double before) noexcept {
    return a >= b ? reached : before;
}

template <class Number>
Number all(double value) noexcept {
    if constexpr (std::is_same_v<Number, Double2>) return simd::splat(value);
    else return value;
}

template <class Number>
Number from(const double* values) noexcept {
    if constexpr (std::is_same_v<Number, Double2>) return simd::load(values);
    else return *values;
}

/// What all rows of a span share: for each level k and each i the knots between which w_{k,i} grows
/// from 0 to 1, and the factor of its growth. Quotients cost more than all the rest of a row.
class SpanFactors {
public:
    void prepare(std::span<const double> knots, std::size_t degree, std::size_t span) noexcept {
        Ramp* ramp = ramps_.data();
        for (std::size_t k = 1; k <= degree; ++k) {
            for (std::size_t i = span + 1 - k; i <= span; ++i) {
                *ramp++ = {knots[i], knots[i + k], 1 / (knots[i + k] - knots[i])};
            }
        }
    }

    /// As kernels::discreteBsplines(), with weights that are exact at both knots, for one row (double)
    /// or for two whose arguments follow each other (Double2).
    template <class Number, class Degree>
    void weights(Degree degree, const double* arguments, Number* values) const noexcept {
        const Number one = all<Number>(1);
        const Ramp* ramp = ramps_.data();
        values[0] = one;
        for (std::size_t k = 1; k <= degree; ++k) {
            const Number t = from<Number>(arguments + (k - 1));
            Number carried = all<Number>(0);
            for (std::size_t j = 0; j < k; ++j, ++ramp) {
                const Number before = (t - all<Number>(ramp->from)) * all<Number>(ramp->growth);
                const Number w = fromOn(t, all<Number>(ramp->to), one, before);
                const Number lower = values[j];
                values[j] = carried + (one - w) * lower;
                carried = w * lower;
            }
            values[k] = carried;
        }
    }

private:
    struct Ramp {
        double from;
        double to;
        double growth;
    };
    std::array<Ramp, maxDegree*(maxDegree + 1) / 2> ramps_{};
};

template <class Degree, class Point>
void rowInto(Degree degree, const SpanFactors& factors, const double* arguments,
             const Point* active, Point& out) noexcept {
    std::array<double, maxDegree + 1> weights;
    factors.weights(degree, arguments, weights.data());
    out = weights[0] * active[0];
    for (std::size_t k = 1; k <= degree; ++k) out += weights[k] * active[k];
}

/// Two rows that follow each other, one in each lane.
template <class Degree>
void rowPairInto(Degree degree, const SpanFactors& factors, const double* arguments,
                 const Vec3* active, Vec3* out) noexcept {
    std::array<Double2, maxDegree + 1> weights;
    factors.weights(degree, arguments, weights.data());
    Double2 x = weights[0] * simd::loadSplat(&active[0].x);
    Double2 y = weights[0] * simd::loadSplat(&active[0].y);
    Double2 z = weights[0] * simd::loadSplat(&active[0].z);
    for (std::size_t k = 1; k <= degree; ++k) {
        x = x + weights[k] * simd::loadSplat(&active[k].x);
        y = y + weights[k] * simd::loadSplat(&active[k].y);
        z = z + weights[k] * simd::loadSplat(&active[k].z);
    }
    simd::storeInterleaved(&out->x, x, y, z);
}

template <class Degree, class Point>
void oslo1Into(Degree degree, const OsloKnots& knots, const KnotVector& refined,
               std::span<const Point> ordered, std::span<Point> out) noexcept {
    SpanFactors factors;
    std::size_t prepared = 0;  // no span of a curve: the first is that of its degree
    // A row waits for the next: in pairs they cost little more than one.
    const double* waiting = nullptr;
    std::size_t waitingAt = 0;
    const auto flush = [&] {
        if (waiting == nullptr) return;
        rowInto(degree, factors, waiting, ordered.data() + (prepared - degree), out[waitingAt]);
        waiting = nullptr;
    };
    forEachOsloRow(knots, refined, [&](std::size_t j, std::size_t span, auto arguments) {
        if (span != prepared) {
            flush();
            factors.prepare(knots.all(), degree, span);
            prepared = span;
        }
        if constexpr (std::is_same_v<Point, Vec3>) {
            if (waiting != nullptr && j == waitingAt + 1) {
                rowPairInto(degree, factors, waiting, ordered.data() + (span - degree),
                            &out[waitingAt]);
                waiting = nullptr;
                return;
            }
        }
        flush();
        waiting = arguments.data();
        waitingAt = j;
    });
    flush();
}

// Degrees known to the compiler: its loops over two to six weights are unrolled.
template <class Point>
std::vector<Point> oslo1Points(const KnotVector& coarse, const KnotVector& refined,
                               std::span<const Point> points) {
    const OsloKnots knots(coarse);
    const std::vector<Point> ordered = knots.inOrder(points);
    std::vector<Point> out(static_cast<std::size_t>(refined.pointCount()));
    const auto run = [&](auto degree) {
        oslo1Into<decltype(degree), Point>(degree, knots, refined, ordered, out);
    };
    switch (knots.degree()) {
        case 1: run(std::integral_constant<std::size_t, 1>{}); break;
        case 2: run(std::integral_constant<std::size_t, 2>{}); break;
        case 3: run(std::integral_constant<std::size_t, 3>{}); break;
        case 4: run(std::integral_constant<std::size_t, 4>{}); break;
        case 5: run(std::integral_constant<std::size_t, 5>{}); break;
        default: run(knots.degree());
    }
    return out;
}

}  // namespace

OsloKnots::OsloKnots(const KnotVector& knots)
    : all_(knots.extended()),
      degree_(static_cast<std::size_t>(knots.degree())),
      count_(static_cast<std::size_t>(knots.pointCount())),
      closed_(knots.closed()) {
    if (closed_) after_ = degree_;
    if (knots.form() != Form::open) return;
    before_ = degree_;
    after_ = degree_;
    const double step = knots.period();
    own_.reserve(all_.size() + 2 * degree_);
    for (std::size_t i = degree_; i >= 1; --i) {
        own_.push_back(all_.front() - step * static_cast<double>(i));
    }
    own_.insert(own_.end(), all_.begin(), all_.end());
    for (std::size_t i = 1; i <= degree_; ++i) {
        own_.push_back(all_.back() + step * static_cast<double>(i));
    }
    all_ = own_;
}

std::size_t OsloKnots::pointOf(std::size_t i) const noexcept {
    if (closed_) return i < count_ ? i : i - count_;
    return std::min(i > before_ ? i - before_ : 0, count_ - 1);
}

std::vector<double> osloMatrix(const KnotVector& coarse, const KnotVector& refined) {
    const OsloKnots knots(coarse);
    const std::size_t degree = knots.degree();
    const auto columns = static_cast<std::size_t>(coarse.pointCount());
    std::vector<double> matrix(columns * static_cast<std::size_t>(refined.pointCount()));
    forEachOsloRow(knots, refined, [&](std::size_t j, std::size_t span, auto arguments) {
        std::array<double, maxDegree + 1> weights;
        kernels::discreteBsplines<double>(knots.all(), degree, span, arguments, weights);
        for (std::size_t k = 0; k <= degree; ++k) {
            matrix[j * columns + knots.pointOf(span - degree + k)] += weights[k];
        }
    });
    return matrix;
}

std::vector<Vec3> oslo1(const KnotVector& knots, const KnotVector& refined,
                        std::span<const Vec3> points) {
    return oslo1Points(knots, refined, points);
}

std::vector<Homogeneous> oslo1(const KnotVector& knots, const KnotVector& refined,
                               std::span<const Homogeneous> points) {
    return oslo1Points(knots, refined, points);
}

std::vector<Homogeneous> oslo2(const KnotVector& coarse, const KnotVector& refined,
                               std::span<const Homogeneous> points) {
    const OsloKnots knots(coarse);
    const std::size_t degree = knots.degree();
    const std::vector<Homogeneous> ordered = knots.inOrder(points);
    std::vector<Homogeneous> out(static_cast<std::size_t>(refined.pointCount()));
    forEachOsloRow(knots, refined, [&](std::size_t j, std::size_t span, auto arguments) {
        std::array<Homogeneous, maxDegree + 1> active;
        std::copy_n(ordered.begin() + static_cast<std::ptrdiff_t>(span - degree), degree + 1,
                    active.begin());
        out[j] = kernels::blossom<double, Homogeneous>(knots.all(), degree, span, arguments,
                                                       active);
    });
    return out;
}

}  // namespace knotwork
