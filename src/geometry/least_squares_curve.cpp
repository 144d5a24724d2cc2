#include "geometry/least_squares_curve.hpp"

#include "geometry/banded_least_squares.hpp"
#include "geometry/bspline_basis.hpp"
#include "geometry/polynomial_piece.hpp"
#include "geometry/schoenberg_whitney.hpp"
#include "geometry/simd.hpp"
#include "geometry/span_rows.hpp"
#include "geometry/span_runs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace knotwork {

namespace {

constexpr double largestCoordinate = 1e12;
constexpr double largestParameter = 1e9;  // of knots
// Rows that cannot be condensed take memory: at most 1 MB.
constexpr std::size_t mostAtOnce = 4096;

using MaybeError = std::optional<Error>;

// ---- What is refused ---------------------------------------------------------------------------

bool usable(const Vec3& point) noexcept {
    // Not true of NaN.
    return std::abs(point.x) <= largestCoordinate && std::abs(point.y) <= largestCoordinate &&
           std::abs(point.z) <= largestCoordinate;
}

MaybeError checkParameter(double u) {
    if (std::abs(u) <= largestParameter) return {};
    return refuse(std::isfinite(u) ? Code::outOfRange : Code::notFinite, "",
                  formatNumber(u) + " is out of range; parameters are numbers in ±1e9");
}

/// Whether the squares of all coordinates together are less than that of the largest: most data in a
/// fraction of the time. A NaN passes into the sum.
bool allSmall(std::span<const Vec3> points) noexcept {
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    constexpr std::size_t together = 4;  // so that no sum waits for itself
    std::array<simd::Double2, 3 * together / 2> sums;
    sums.fill(simd::splat(0));
    std::size_t k = 0;
    for (; k + together <= points.size(); k += together) {
        const double* const xyz = &points[k].x;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            const simd::Double2 two = simd::load(xyz + 2 * i);
            sums[i] = sums[i] + two * two;
        }
    }
    double whole = 0;
    for (const simd::Double2 sum : sums) whole += simd::first(sum) + simd::second(sum);
    for (; k < points.size(); ++k) whole += glm::dot(points[k], points[k]);
    return whole < largestCoordinate * largestCoordinate;
}

bool ascending(std::span<const double> parameters) noexcept {
    simd::Truth2 all = simd::splat(0) == simd::splat(0);
    std::size_t k = 0;
    for (; k + 2 < parameters.size(); k += 2) {
        all = all & (simd::load(&parameters[k + 1]) >= simd::load(&parameters[k]));
    }
    const bool last = k + 1 >= parameters.size() || parameters[k] <= parameters[k + 1];
    return last && simd::inBoth(all);
}

MaybeError checkPoints(std::span<const Vec3> points) {
    if (points.empty()) return refuse(Code::wrongLength, "points", "there are no points to fit");
    if (points.size() > maxDataCount) {
        return refuse(Code::tooLarge, "points",
                      std::to_string(points.size()) + " points; at most 1000000 are fitted");
    }
    if (allSmall(points)) return {};
    const auto bad = std::find_if_not(points.begin(), points.end(), usable);
    if (bad == points.end()) return {};
    const auto path = indexed("points", static_cast<std::size_t>(bad - points.begin()));
    if (!isFinite(*bad)) return refuse(Code::notFinite, path, "a coordinate is not finite");
    return refuse(Code::outOfRange, path, "a coordinate is out of range; they lie in ±1e12");
}

MaybeError checkOptions(const LeastSquares& options, bool closed) {
    if (!(options.smoothing >= 0 && options.smoothing <= maxSmoothing)) {
        return refuse(Code::outOfRange, "smoothing",
                      "smoothing is " + formatNumber(options.smoothing) +
                          "; it must be between 0 and 1e12");
    }
    if (options.interpolateEnds && closed) {
        return refuse(Code::notSupported, "interpolateEnds",
                      "a closed curve has no ends to interpolate; leave this out");
    }
    return {};
}

// ---- The system of equations -------------------------------------------------------------------

using Constraint = BandedLeastSquares::Constraint;

/// A spline's rows put where they belong.
class System {
public:
    System(const KnotVector& knots, bool smooth)
        : knots_(knots),
          terms_(static_cast<std::size_t>(knots.degree()) + 1),
          count_(static_cast<std::size_t>(knots.pointCount())),
          equations_(count_, smooth ? std::max<std::size_t>(terms_, 3) : terms_,
                     borderOf(knots, smooth)) {}

    [[nodiscard]] const BandedLeastSquares& equations() const noexcept { return equations_; }

    /// Rows as SpanRows gives them, which are used up.
    void addSpanRows(std::size_t span, std::span<double> rows) {
        const std::size_t first = span < count_ ? span + 1 - terms_ : 0;
        const std::size_t size = terms_ + 3;
        if (equations_.rowSize() == size) {
            equations_.add(first, rows);
            return;
        }
        const std::size_t count = rows.size() / size;
        rows_.assign(count * equations_.rowSize(), 0.0);
        for (std::size_t i = 0; i < count; ++i) {
            const std::span<const double> row = rows.subspan(i * size, size);
            for (std::size_t j = 0; j < terms_; ++j) {
                put(i, knots_.pointIndex(span, j), first, row[j]);
            }
            std::copy_n(&row[terms_], 3, &rows_[(i + 1) * equations_.rowSize() - 3]);
        }
        equations_.add(first, rows_);
    }

    /// factor · (c_i - 2 c_{i+1} + c_{i+2}) = 0.
    void addDifference(std::size_t i, double factor) {
        const std::size_t first = i + 2 < count_ ? i : 0;
        rows_.assign(equations_.rowSize(), 0.0);
        put(0, i % count_, first, factor);
        put(0, (i + 1) % count_, first, -2 * factor);
        put(0, (i + 2) % count_, first, factor);
        equations_.add(first, rows_);
    }

private:
    // What reaches over the seam of a closed curve: d columns of splines, two of differences.
    static std::size_t borderOf(const KnotVector& knots, bool smooth) {
        if (!knots.closed()) return 0;
        const auto d = static_cast<std::size_t>(knots.degree());
        return smooth ? std::max<std::size_t>(d, 2) : d;
    }
    void put(std::size_t row, std::size_t column, std::size_t first, double value) {
        rows_[row * equations_.rowSize() + equations_.placeOf(column, first)] += value;
    }

    const KnotVector& knots_;
    std::size_t terms_;
    std::size_t count_;
    BandedLeastSquares equations_;
    std::vector<double> rows_;
};

/// The data whose parameters fall into one span after the other, spans in the order in which their
/// rows are cheapest to add: those around the seam first.
class DataRows {
public:
    DataRows(const KnotVector& knots, std::span<const Vec3> points,
             std::span<const double> parameters)
        : points_(points), parameters_(parameters), runs_(knots, parameters), rows_(knots) {}

    void addSpan(System& system, std::size_t span) {
        const Run run = runs_.of(span);
        const auto parameters = parameters_.subspan(run.first, run.count);
        const auto points = points_.subspan(run.first, run.count);
        const std::span<double> few = rows_.condensed(span, parameters, points);
        if (!few.empty()) return system.addSpanRows(span, few);
        for (std::size_t done = 0; done < run.count; done += mostAtOnce) {
            const std::size_t size = std::min(mostAtOnce, run.count - done);
            system.addSpanRows(span, rows_.each(span, parameters.subspan(done, size),
                                                points.subspan(done, size)));
        }
    }

    /// A point at a parameter of this span that is none of the data.
    void addPoint(System& system, std::size_t span, double t, const Vec3& point) {
        system.addSpanRows(span, rows_.each(span, {&t, 1}, {&point, 1}));
    }

private:
    std::span<const Vec3> points_;
    std::span<const double> parameters_;
    SpanRuns runs_;
    SpanRows rows_;
};

/// Both ends of the curve: their rows and what they must be.
std::vector<Constraint> endConstraints(const KnotVector& knots, std::span<const Vec3> points) {
    const auto count = static_cast<std::size_t>(knots.pointCount());
    std::vector<Constraint> ends{{std::vector<double>(count), points.front()},
                                 {std::vector<double>(count), points.back()}};
    basisRows(knots, knots.domain().start, Side::right, 0, ends[0].row);
    basisRows(knots, knots.domain().end, Side::left, 0, ends[1].row);
    return ends;
}

/// All rows, in the order of their first columns.
System assemble(std::span<const Vec3> points, std::span<const double> parameters,
                const KnotVector& knots, const LeastSquares& options) {
    const auto d = static_cast<std::size_t>(knots.degree());
    const auto count = static_cast<std::size_t>(knots.pointCount());
    const Interval domain = knots.domain();
    const double factor = std::sqrt(options.smoothing);
    System system(knots, factor > 0);
    DataRows data(knots, points, parameters);
    for (std::size_t span = count; knots.closed() && span < count + d; ++span) {
        data.addSpan(system, span);
    }
    if (knots.closed() && factor > 0) {
        for (std::size_t i = count - 2; i < count; ++i) system.addDifference(i, factor);
    }
    const std::size_t firstSpan = knots.findSpan(domain.start);
    const std::size_t lastSpan = knots.findSpan(domain.end);
    std::size_t difference = 0;
    for (std::size_t span = d; span < count; ++span) {
        data.addSpan(system, span);
        if (options.interpolateEnds && span == firstSpan) {
            data.addPoint(system, span, domain.start, points.front());
        }
        if (options.interpolateEnds && span == lastSpan) {
            data.addPoint(system, span, domain.end, points.back());
        }
        const std::size_t until = span + 1 == count ? count : span + 1 - d;
        for (; factor > 0 && difference + 2 < count && difference < until; ++difference) {
            system.addDifference(difference, factor);
        }
    }
    return system;
}

MaybeError checkRank(const KnotVector& knots, std::span<const double> parameters, bool withEnds) {
    if (!withEnds) {
        const auto starved = starvedFunction(knots, parameters);
        return starved ? MaybeError(refuseStarved(*starved)) : std::nullopt;
    }
    std::vector<double> all{knots.domain().start};
    all.insert(all.end(), parameters.begin(), parameters.end());
    all.push_back(knots.domain().end);
    return checkRank(knots, all, false);
}

// ---- Residuals ---------------------------------------------------------------------------------

struct Squares {
    double sum = 0;
    double largest = 0;

    void add(const Vec3& distance) noexcept {
        const double square = glm::dot(distance, distance);
        sum += square;
        largest = std::max(largest, square);
    }
};

using simd::Double2;

/// Two data at a time: Horner's rule on the span's polynomial. `Fixed` is the degree where it is
/// known, so that loops unroll, else 0.
template <std::size_t Fixed>
void addPairs(std::size_t given, const Coefficients& c, double centre, double scale,
              std::span<const double> parameters, const Vec3* points, Squares& squares) noexcept {
    const std::size_t degree = Fixed > 0 ? Fixed : given;
    Double2 sum = simd::splat(0);
    Double2 largest = simd::splat(0);
    for (std::size_t k = 0; k + 1 < parameters.size(); k += 2) {
        const Double2 u =
            (simd::load(&parameters[k]) - simd::splat(centre)) * simd::splat(scale);
        Double2 x = simd::splat(c[3 * degree]);
        Double2 y = simd::splat(c[3 * degree + 1]);
        Double2 z = simd::splat(c[3 * degree + 2]);
        for (std::size_t i = degree; i-- > 0;) {
            x = x * u + simd::splat(c[3 * i]);
            y = y * u + simd::splat(c[3 * i + 1]);
            z = z * u + simd::splat(c[3 * i + 2]);
        }
        const simd::Points2 q = simd::loadInterleaved(&points[k].x);
        x = x - q.x;
        y = y - q.y;
        z = z - q.z;
        const Double2 square = x * x + y * y + z * z;
        sum = sum + square;
        largest = simd::larger(largest, square);
    }
    squares.sum += simd::first(sum) + simd::second(sum);
    squares.largest =
        std::max({squares.largest, simd::first(largest), simd::second(largest)});
}

void addSquares(const BsplineCurve& curve, std::size_t span, std::span<const double> parameters,
                std::span<const Vec3> points, Squares& squares) {
    const std::span<const double> t = curve.knotVector().extended();
    const auto degree = static_cast<std::size_t>(curve.degree());
    const double centre = t[span] + (t[span + 1] - t[span]) / 2;
    const double scale = 2 / (t[span + 1] - t[span]);
    Coefficients c;
    powerCoefficients(curve, span, 3, c);
    if (degree == 3) {
        addPairs<3>(degree, c, centre, scale, parameters, points.data(), squares);
    } else {
        addPairs<0>(degree, c, centre, scale, parameters, points.data(), squares);
    }
    if (parameters.size() % 2 == 0) return;
    const double u = (parameters.back() - centre) * scale;
    Vec3 point(0);
    for (std::size_t i = degree + 1; i-- > 0;) {
        point = point * u + Vec3(c[3 * i], c[3 * i + 1], c[3 * i + 2]);
    }
    squares.add(point - points.back());
}

}  // namespace

MaybeError checkFit(std::span<const Vec3> points, const LeastSquares& options, bool closed) {
    if (auto error = checkOptions(options, closed)) return error;
    return checkPoints(points);
}

MaybeError checkParameters(std::span<const double> parameters, std::size_t pointCount) {
    if (parameters.size() != pointCount) {
        return refuse(Code::wrongLength, "parameters",
                      std::to_string(parameters.size()) + " parameters given for " +
                          std::to_string(pointCount) + " points; give one a point");
    }
    const bool ordered = !parameters.empty() && ascending(parameters);
    if (ordered && !checkParameter(parameters.front()) && !checkParameter(parameters.back())) {
        return {};
    }
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        if (auto error = checkParameter(parameters[k])) {
            error->path = indexed("parameters", k);
            return error;
        }
        if (k > 0 && parameters[k] < parameters[k - 1]) {
            return refuse(Code::outOfRange, indexed("parameters", k),
                          formatNumber(parameters[k]) +
                              " is less than the parameter before it; sort the points by their "
                              "parameters");
        }
    }
    return {};
}

MaybeError checkInside(std::span<const double> parameters, const Interval& domain) {
    const bool early = parameters.front() < domain.start;
    if (!early && parameters.back() <= domain.end) return {};
    const auto bad = early ? parameters.begin()
                           : std::upper_bound(parameters.begin(), parameters.end(), domain.end);
    return refuse(Code::outOfRange,
                  indexed("parameters", static_cast<std::size_t>(bad - parameters.begin())),
                  formatNumber(*bad) + " lies outside the domain [" + formatNumber(domain.start) +
                      ", " + formatNumber(domain.end) + "] of the knots");
}

Result<BsplineCurve> checkedLeastSquares(std::span<const Vec3> points,
                                         std::span<const double> parameters,
                                         const KnotVector& knots, const LeastSquares& options) {
    if (options.smoothing == 0) {
        if (auto error = checkRank(knots, parameters, options.interpolateEnds)) return *error;
    }
    const System system = assemble(points, parameters, knots, options);
    const BandedLeastSquares& equations = system.equations();
    if (const auto starved = equations.dependentColumn()) return refuseStarved(*starved);
    std::vector<Vec3> control = options.interpolateEnds
                                    ? equations.solve(endConstraints(knots, points))
                                    : equations.solve();
    if (options.interpolateEnds && knots.form() == Form::clamped) {
        control.front() = points.front();
        control.back() = points.back();
    }
    const bool planar = std::all_of(points.begin(), points.end(),
                                    [](const Vec3& point) { return point.z == 0; });
    auto curve = BsplineCurve::make(knots, std::move(control), planar ? 2 : 3);
    if (curve) return curve;
    Error error = curve.error();
    error.path.replace(0, std::string("points").size(), "controlPoints");
    error.message = "the fitted curve runs away here; give more points or fewer control points";
    return error;
}

Result<BsplineCurve> leastSquaresCurve(std::span<const Vec3> points,
                                       std::span<const double> parameters,
                                       const KnotVector& knots, const LeastSquares& options) {
    if (auto error = checkFit(points, options, knots.closed())) return *error;
    if (auto error = checkParameters(parameters, points.size())) return *error;
    if (auto error = checkInside(parameters, knots.domain())) return *error;
    return checkedLeastSquares(points, parameters, knots, options);
}

Residuals residualsOf(const BsplineCurve& curve, std::span<const Vec3> points,
                      std::span<const double> parameters) {
    const KnotVector& knots = curve.knotVector();
    const auto degree = static_cast<std::size_t>(knots.degree());
    Squares squares;
    if (degree > maxPowerDegree) {
        for (std::size_t k = 0; k < points.size(); ++k) {
            squares.add(curve.point(parameters[k]) - points[k]);
        }
    }
    SpanRuns runs(knots, parameters);
    const std::size_t last = knots.extended().size() - 1 - degree;
    for (std::size_t span = degree; span < last && degree <= maxPowerDegree; ++span) {
        const Run run = runs.of(span);
        if (run.count == 0) continue;
        addSquares(curve, span, parameters.subspan(run.first, run.count),
                   points.subspan(run.first, run.count), squares);
    }
    const auto count = static_cast<double>(points.size());
    return {squares.sum, std::sqrt(squares.sum / count), std::sqrt(squares.largest)};
}

}  // namespace knotwork
