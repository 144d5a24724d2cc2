#include "geometry/b_function_erb_table.hpp"

#include "geometry/quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace knotwork::b_function {

namespace {

constexpr std::size_t points = OctaveTable::degree;  // Gauss nodes a cell
// Bounds on a cell's error, far from reached: over the parameters' whole range 3e-15 absolute and
// 3e-12 relative were measured; the promise is 2e-13 and 1e-9.
constexpr double absoluteTolerance = 1e-14;
constexpr double relativeTolerance = 1e-10;
constexpr double negligible = 1e-18;  // of the whole, far below the rounding of 1 − B
constexpr double smallestKey = 1e-290;
constexpr std::uint32_t largestCellCount = 512;

using Matrix = std::array<std::array<double, points>, points>;
using Cell = OctaveTable::Cell;

/// Row j: the weights that take values at the Gauss nodes to the coefficient of the Legendre
/// polynomial P_j of the interpolating polynomial: (2j+1)/2 · w_i P_j(x_i).
constexpr Matrix legendreFromValues() noexcept {
    Matrix matrix{};
    constexpr auto nodes = gaussNodes<points>();
    for (std::size_t i = 0; i < points; ++i) {
        double previous = 0;
        double current = 1;
        for (std::size_t j = 0; j < points; ++j) {
            const double n = static_cast<double>(j);
            matrix[j][i] = (n + 0.5) * nodes[i].weight * current;
            const double next = ((2 * n + 1) * nodes[i].x * current - n * previous) / (n + 1);
            previous = std::exchange(current, next);
        }
    }
    return matrix;
}

/// Row j: the coefficients of P_j in powers of x.
constexpr Matrix legendrePowers() noexcept {
    Matrix powers{};
    powers[0][0] = 1;
    powers[1][1] = 1;
    for (std::size_t j = 1; j + 1 < points; ++j) {
        const double n = static_cast<double>(j);
        for (std::size_t k = 0; k < points; ++k) {
            const double shifted = k > 0 ? powers[j][k - 1] : 0;
            powers[j + 1][k] = ((2 * n + 1) * shifted - n * powers[j - 1][k]) / (n + 1);
        }
    }
    return powers;
}

constexpr Matrix toLegendre = legendreFromValues();
constexpr Matrix toPowers = legendrePowers();

struct Fit {
    Cell integral;    // ∫ from the cell's left end
    double error;     // of the integrand, measured
    double smallest;  // value of the integrand
};

/// Interpolates a monotone f at the Gauss nodes of [a, b] and integrates: exact like Gauss at b.
/// The error is that at the two ends, where the first polynomial left out is largest.
template <class F>
Fit fitCell(const F& f, double a, double b) noexcept {
    std::array<double, points> legendre{};
    const double middle = 0.5 * (a + b);
    const double half = 0.5 * (b - a);
    constexpr auto nodes = gaussNodes<points>();
    for (std::size_t i = 0; i < points; ++i) {
        const double value = f(middle + half * nodes[i].x);
        for (std::size_t j = 0; j < points; ++j) legendre[j] += toLegendre[j][i] * value;
    }
    Fit fit{};
    auto& c = fit.integral.coefficients;
    double atStart = 0;
    double atEnd = 0;
    for (std::size_t j = 0; j < points; ++j) {
        for (std::size_t k = 0; k <= j; ++k) {
            c[k + 1] += half * legendre[j] * toPowers[j][k] / static_cast<double>(k + 1);
        }
        atStart += j % 2 == 0 ? legendre[j] : -legendre[j];
        atEnd += legendre[j];
    }
    for (std::size_t k = 1; k < c.size(); ++k) c[0] += k % 2 == 0 ? -c[k] : c[k];
    const double start = f(a);
    const double end = f(b);
    fit.error = std::max(std::abs(atStart - start), std::abs(atEnd - end));
    fit.smallest = std::min(start, end);
    return fit;
}

/// Bounds on a cell's error: its width times the integrand's at most `absolute`, and the
/// integrand's at most relativeTolerance of its value from the key `relativeFrom` on.
struct Bounds {
    double absolute;
    double relativeFrom;
};

bool meets(const Fit& fit, double a, double b, const Bounds& bounds) noexcept {
    return fit.error * (b - a) <= bounds.absolute &&
           (a < bounds.relativeFrom || fit.error <= relativeTolerance * fit.smallest);
}

/// Appends the block [low, high) with as few cells as meet the bounds.
template <class F>
void appendBlock(OctaveTable& table, const F& f, double low, double high, const Bounds& bounds) {
    const std::size_t first = table.cells.size();
    for (std::uint32_t count = 1;; count *= 2) {
        table.cells.resize(first);
        bool good = true;
        const double width = (high - low) / count;
        for (std::uint32_t i = 0; i < count && (good || count == largestCellCount); ++i) {
            const double a = low + width * i;
            const Fit fit = fitCell(f, a, a + width);
            table.cells.push_back(fit.integral);
            good = meets(fit, a, a + width, bounds);
        }
        if (good || count == largestCellCount) {
            table.blocks.push_back({low, count / (high - low), static_cast<std::uint32_t>(first)});
            return;
        }
    }
}

double blockLow(std::uint64_t number) noexcept { return __builtin_bit_cast(double, number << 49U); }

/// Covers [low, high), both at the border of a block.
template <class F>
OctaveTable makeTable(const F& f, double low, double high, const Bounds& bounds) {
    OctaveTable table;
    table.firstBlock = OctaveTable::blockNumber(low);
    const std::uint64_t end = OctaveTable::blockNumber(high);
    for (std::uint64_t number = table.firstBlock; number < end; ++number) {
        appendBlock(table, f, blockLow(number), blockLow(number + 1), bounds);
    }
    return table;
}

}  // namespace

double ErbSide::density(double s, double e) const noexcept {
    const double near = s / e;
    const double far = width * s / (1 - width + width * s);
    const double power = endPower == 1 && farPower == 1
                             ? near * far
                             : std::exp(endPower * std::log(near) + farPower * std::log(far));
    return std::exp(-beta * power);
}

// φ decreases in s, so ∫_0^1 φ is at least the largest of s φ(s); s = 2^-k come within a factor 2
// of it, and nothing below s can beat what is above s already.
ErbIntegral::Peak ErbIntegral::findPeak() const noexcept {
    Peak peak{0.5, 0};
    for (double s = 0.5; s > peak.area && s > smallestKey; s *= 0.5) {
        const double area = s * side_.density(s, 1 - s);
        if (area > peak.area) peak = {s, area};
    }
    return peak;
}

void ErbIntegral::placeEnds(double area) noexcept {
    const double bound = negligible * area;
    const auto outerRest = [&](double e) { return e * side_.density(1 - e, e); };
    const auto innerRest = [&](double s) { return side_.density(s, 1 - s); };
    std::uint64_t number = OctaveTable::blockNumber(0.5);
    if (innerRest(0.5) > bound) {
        while (blockLow(number) > smallestKey && outerRest(blockLow(number)) > bound) --number;
        outerStart_ = blockLow(number);
        return;
    }
    while (innerRest(blockLow(number - 1)) <= bound) --number;
    innerEnd_ = blockLow(number);
}

// ∫_0^e φ with x = log of e over the point: e φ(e) ∫_0^∞ exp(−x − X(x) + X(0)) dx, whose integrand
// decays from the start at the rate 1 + X′(0), later at least like exp(−x). Where both are large and
// e is not, it hardly bends, and Gauss–Laguerre misses by 1e-12 at most; elsewhere panels that double
// cover all scales.
double ErbIntegral::tailIntegral(double e) const noexcept {
    const double start = side_.density(1 - e, e);
    if (start == 0 || e == 0) return 0;
    const auto integrand = [&](double x) {
        const double distance = e * std::exp(-x);
        return distance * side_.density(1 - distance, distance);
    };
    const double exponent = -std::log(start);
    const double far = side_.farPower * e / (1 - e);
    const double nearer = 1 - side_.width;  // of the far factor's slope, (1 − L)/(1 − L + L s) is left
    const double slope = side_.endPower / (1 - e) + far * nearer / (nearer + side_.width * (1 - e));
    const double rate = 1 + slope * exponent;
    if (e < 0.5 && std::min(exponent, rate) > 35) return integrateLaguerre(integrand, rate);
    double sum = 0;
    double a = 0;
    for (double width = 1 / (rate + far * exponent);; width *= 2) {
        const double panel = integrateGauss<8>(integrand, a, a + width);
        sum += panel;
        a += width;
        if (panel <= 1e-13 * sum || a > 800) return sum;
    }
}

// Polynomials so far hold ∫ from the left end of their cell; add what lies further out.
void ErbIntegral::accumulate() noexcept {
    double sum = 0;
    if (tail_ == Tail::exact) sum = tailIntegral(outerStart_ < 1 ? outerStart_ : 1 - innerEnd_);
    for (Cell& cell : outer_.cells) {
        cell.coefficients[0] += sum;
        sum = cell.at(1);
    }
    const auto addInner = [&sum](Cell& cell) {
        const double atLow = sum + cell.at(1);
        for (double& c : cell.coefficients) c = -c;
        cell.coefficients[0] += atLow;
        sum = atLow;
    };
    for (std::size_t i = inner_.cells.size(); i-- > 0;) addInner(inner_.cells[i]);
    addInner(innermost_);
    total_ = sum;
}

ErbIntegral::ErbIntegral(const ErbSide& side, Tail tail) : side_(side), tail_(tail) {
    const auto inside = [this](double s) { return side_.density(s, 1 - s); };
    const auto outside = [this](double e) { return side_.density(1 - e, e); };
    const Peak peak = findPeak();
    placeEnds(peak.area);

    // Up to the peak G is of the size of the whole (φ never falls faster than s^-40), so an
    // absolute bound is a relative one; beyond, small values of B need their own.
    constexpr double never = std::numeric_limits<double>::infinity();
    const double absolute = absoluteTolerance * peak.area;
    const Bounds inner{absolute, tail == Tail::exact ? peak.at : never};
    const Bounds outer{absolute, tail == Tail::exact ? 0 : never};
    for (innerLow_ = innerEnd_; innerLow_ > smallestKey; innerLow_ *= 0.5) {
        const Fit fit = fitCell(inside, 0, innerLow_);
        innermost_ = fit.integral;
        if (innerLow_ <= peak.at && meets(fit, 0, innerLow_, inner)) break;
    }
    perInnerLow_ = 1 / innerLow_;
    inner_ = makeTable(inside, innerLow_, innerEnd_, inner);
    if (outerStart_ < 1) outer_ = makeTable(outside, outerStart_, 0.5, outer);
    accumulate();
}

void ErbIntegral::multiply(double factor) noexcept {
    for (OctaveTable* table : {&inner_, &outer_}) {
        for (Cell& cell : table->cells) {
            for (double& c : cell.coefficients) c *= factor;
        }
    }
    for (double& c : innermost_.coefficients) c *= factor;
    scale_ *= factor;
}

ErbTable::ErbTable(double alpha, double beta, double gamma, double lambda)
    : lambda_(std::max(lambda, 1e-300)),  // below, only t < 1e-300 would feel the difference
      perLeft_(1 / lambda_),
      perRight_(1 / (1 - lambda_)),
      symmetric_(gamma == 1 && lambda == 0.5),
      left_({beta, alpha, alpha * gamma, lambda_}, ErbIntegral::Tail::exact),
      right_(symmetric_
                 ? left_.withTail(ErbIntegral::Tail::negligible)
                 : ErbIntegral({beta, alpha * gamma, alpha, 1 - lambda_},
                               ErbIntegral::Tail::negligible)),
      scale_(1 / (lambda_ * left_.total() + (1 - lambda_) * right_.total())) {
    left_.multiply(scale_ * lambda_);
    right_.multiply(scale_ * (1 - lambda_));
    const auto values = [this](double t) { return fine(t); };
    cells_ = symmetric_ ? Cells::ofSymmetric(values) : Cells::of(lambda_, values);
}

void ErbTable::sample(std::span<const double> ts, std::span<double> values) const noexcept {
    std::size_t i = 0;
    while (i + 2 <= ts.size()) {
        const Cells::Place place = cells_.find(simd::load(&ts[i]));
        if (place.first == place.second) {
            const std::size_t done = cells_.run(place.first, ts.subspan(i), values.subspan(i));
            i += done;
            if (done > 0) continue;
        }
        const simd::Double2 fast = cells_.at(place);
        if (simd::areNumbers(fast)) {
            simd::store(&values[i], fast);
        } else {
            values[i] = either(simd::first(fast), ts[i]);
            values[i + 1] = either(simd::second(fast), ts[i + 1]);
        }
        i += 2;
    }
    if (i < ts.size()) values[i] = value(ts[i]);
}

}  // namespace knotwork::b_function
