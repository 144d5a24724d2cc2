#include "geometry/local_cuts.hpp"

#include "geometry/bspline_basis.hpp"
#include "geometry/quadrature.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace knotwork {

namespace {

constexpr std::size_t n = localSplinePoints;
constexpr std::size_t nodesAPiece = 16;  // exact for products of two splines of degree 7

/// An arc that would wind itself round 10^10 radians where it takes part tells of a cusp: there p′
/// is rounding (1e-16 of p″ times the length, in the models), and so is its direction.
constexpr double stillness = 1e-10;

KnotVector unitSpline(std::size_t degree) {
    std::vector<double> knots(degree, 0.0);
    const std::size_t spans = n - degree;
    for (std::size_t i = 0; i <= spans; ++i) {
        knots.push_back(static_cast<double>(i) / static_cast<double>(spans));
    }
    knots.insert(knots.end(), degree, 1.0);
    return *KnotVector::make(std::move(knots), static_cast<int>(degree), static_cast<int>(n),
                             Form::clamped);
}

/// f(x, weight) for the nodes of Gauss' rule on each of the pieces between these parameters.
template <class F>
void eachNode(std::span<const double> breaks, const F& f) {
    for (std::size_t i = 1; i < breaks.size(); ++i) {
        const double half = (breaks[i] - breaks[i - 1]) / 2;
        const double middle = breaks[i - 1] + half;
        for (const GaussNode& node : gaussNodes<nodesAPiece>()) {
            f(middle + half * node.x, half * node.weight);
        }
    }
}

std::array<double, n> basisAt(const KnotVector& knots, double u) {
    std::array<double, n> values{};
    basisRows(knots, u, Side::right, 0, values);
    return values;
}

/// The lower triangle L of A = L Lᵀ in place of A.
void factorise(std::vector<double>& a) noexcept {
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            double sum = a[i * n + j];
            for (std::size_t k = 0; k < j; ++k) sum -= a[i * n + k] * a[j * n + k];
            a[i * n + j] = i == j ? std::sqrt(sum) : sum / a[j * n + j];
        }
    }
}

void solve(const std::vector<double>& l, std::array<Vec3, n>& x) noexcept {
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < i; ++k) x[i] -= l[i * n + k] * x[k];
        x[i] /= l[i * n + i];
    }
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t k = i + 1; k < n; ++k) x[i] -= l[k * n + i] * x[k];
        x[i] /= l[i * n + i];
    }
}

Error noDerivative(double knot) {
    return refuse(Code::notFinite, "model",
                  "The model has no derivatives at " + formatNumber(knot) +
                      " that local curves of this kind could be made of; move the knot, or cut "
                      "sub-curves.");
}

}  // namespace

LocalCutter::LocalCutter(const Curve& model, const LocalCut& cut) : model_(model), cut_(cut) {
    if (cut.kind != LocalKind::bspline) return;
    const KnotVector knots = unitSpline(cut.degree);
    const auto all = knots.extended();
    unitKnots_.assign(all.begin(), all.end());
    cholesky_.assign(n * n, 0.0);
    const auto spans = std::span<const double>(unitKnots_).subspan(cut.degree, n + 1 - cut.degree);
    eachNode(spans, [&](double u, double weight) {
        const auto values = basisAt(knots, u);
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j <= i; ++j) cholesky_[i * n + j] += weight * values[i] * values[j];
        }
    });
    factorise(cholesky_);
}

Result<Curve> LocalCutter::at(double knot, Side side, const Interval& over) const {
    if (cut_.kind == LocalKind::bspline) return spline(over);
    std::array<Vec3, maxDegree + 1> rows;
    const std::size_t needed = cut_.kind == LocalKind::line  ? 2
                               : cut_.kind == LocalKind::arc ? 3
                                                             : cut_.degree + 1;
    evaluate(model_, knot, side, {rows.data(), needed});
    if (!std::all_of(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(needed), isFinite)) {
        return noDerivative(knot);
    }
    if (cut_.kind == LocalKind::bezier) {
        double factorial = 1;
        for (std::size_t k = 2; k < needed; ++k) {
            factorial *= static_cast<double>(k);
            rows[k] /= factorial;
        }
        return Curve(BezierCurve::fromTaylor({rows.data(), needed}, knot, over));
    }
    const double speed = glm::length(rows[1]);
    const bool still = needed == 3 && speed <= stillness * glm::length(rows[2]) * over.length();
    if (cut_.kind == LocalKind::line || still || speed == 0) {
        return Curve(LineCurve::tangent(knot, rows[0], rows[1], over));
    }
    auto arc = ArcCurve::make(knot, rows[0], rows[1], rows[2], over);
    if (!arc) return arc.error();
    return Curve(std::move(*arc));
}

// The normal equations of min ∫ |model − Σ c_i N_i|², over the pieces between the knots of either,
// and once more with what is left: that takes back what squaring the condition lost.
Result<Curve> LocalCutter::spline(const Interval& over) const {
    std::vector<double> knots;
    for (const double u : unitKnots_) {
        knots.push_back(u == 1 ? over.end : over.start + u * over.length());
    }
    std::vector<double> pieces = breakParameters(model_, over);
    pieces.insert(pieces.end(), knots.begin(), knots.end());
    std::sort(pieces.begin(), pieces.end());
    pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
    auto vector = KnotVector::make(std::move(knots), static_cast<int>(cut_.degree),
                                   static_cast<int>(n), Form::clamped);
    if (!vector) return vector.error().under("locals");
    std::array<Vec3, n> points{};
    for (int pass = 0; pass < 2; ++pass) {
        std::array<Vec3, n> correction{};
        eachNode(pieces, [&](double t, double weight) {
            const auto values = basisAt(*vector, t);
            Vec3 left = pointAt(model_, t);
            for (std::size_t i = 0; i < n; ++i) left -= values[i] * points[i];
            for (std::size_t i = 0; i < n; ++i) {
                correction[i] += weight / over.length() * values[i] * left;
            }
        });
        solve(cholesky_, correction);
        for (std::size_t i = 0; i < n; ++i) points[i] += correction[i];
    }
    if (!std::all_of(points.begin(), points.end(), isFinite)) return noDerivative(over.start);
    const int dimension = knotwork::dimension(model_);
    auto made = BsplineCurve::make(std::move(*vector), {points.begin(), points.end()}, dimension);
    if (!made) return made.error().under("locals");
    return Curve(std::move(*made));
}

}  // namespace knotwork
