#include "geometry/parametric_curve.hpp"

#include "geometry/checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace knotwork {

namespace {

using namespace parametric_model;

constexpr double twoPi = 2 * std::numbers::pi;
constexpr int largestDenominator = 64;
constexpr double ratioTolerance = 1e-9;
// "To rounding" for a seam: far above what sin and cos leave (1e-15 |t|), far below any real gap.
constexpr double seamTolerance = 1e-9;

struct Fraction {
    std::int64_t p = 0;
    std::int64_t q = 1;
    [[nodiscard]] double value() const noexcept {
        return static_cast<double>(p) / static_cast<double>(q);
    }
};

/// p/q in lowest terms: the smallest q ≤ 64 with |x − p/q| ≤ 1e-9.
std::optional<Fraction> recognise(double x) noexcept {
    for (int q = 1; q <= largestDenominator; ++q) {
        const double p = std::round(x * q);
        if (std::abs(p) > 1e15) return std::nullopt;
        if (std::abs(x - p / q) <= ratioTolerance) return Fraction{static_cast<std::int64_t>(p), q};
    }
    return std::nullopt;
}

/// A model ready to be evaluated, and what is known about where it repeats.
struct Prepared {
    Any model;
    std::optional<double> period;        ///< the smallest, where there is one
    std::optional<Interval> usual = {};  ///< the default domain, where it is not [0, 2π]
    double size = 1;                     ///< of the coordinates, for the seam
    std::string_view unrecognised = {};  ///< the parameter that leaves the period unknown
};

/// The common period of cos(kx t) and sin(ky t); of a constant it is any, and 2π is as good.
std::optional<double> commonPeriod(double kx, double ky) noexcept {
    const auto x = recognise(kx);
    const auto y = recognise(ky);
    if (!x || !y) return std::nullopt;
    const std::int64_t denominators = std::lcm(x->q, y->q);
    const std::int64_t turns = std::gcd(x->p * (denominators / x->q), y->p * (denominators / y->q));
    if (turns == 0) return twoPi;
    return twoPi * static_cast<double>(denominators) / static_cast<double>(turns);
}

Prepared prepareRose(double a, double k) noexcept {
    const auto fraction = recognise(k);
    if (!fraction) return {Rose{a, k}, std::nullopt, std::nullopt, std::abs(a), "k"};
    const bool bothOdd = fraction->p % 2 != 0 && fraction->q % 2 != 0;
    const double period = (bothOdd ? std::numbers::pi : twoPi) * static_cast<double>(fraction->q);
    return {Rose{a, fraction->value()}, period, Interval{0, period}, std::abs(a)};
}

/// The circle of radius r rolls inside that of radius R (side −1) or outside it (side +1).
Prepared prepareTrochoid(double R, double r, double d, double side) noexcept {
    const auto fraction = recognise(R / r);
    const double turns = fraction ? fraction->value() : R / r;
    const Trochoid model{R + side * r, turns + side, -side * d, -d};
    const double size = std::abs(R) + std::abs(r) + std::abs(d);
    if (!fraction) return {model, std::nullopt, std::nullopt, size, "r"};
    const double period = twoPi * static_cast<double>(fraction->q);
    return {model, period, Interval{0, period}, size};
}

Prepared prepareLissajous(double a, double b, double kx, double ky) noexcept {
    return {Lissajous{a, b, kx, ky}, commonPeriod(kx, ky), std::nullopt, std::abs(a) + std::abs(b)};
}

Prepared prepareTorusKnot(double p, double q, double R, double r) noexcept {
    return {TorusKnot{p, q, R, r}, commonPeriod(p, q), std::nullopt, std::abs(R) + std::abs(r)};
}

Prepared prepare(ParametricModel model, std::span<const double> p) noexcept {
    using enum ParametricModel;
    const double size = std::abs(p[0]);
    switch (model) {
        case circle:
            return {parametric_model::Ellipse{p[0], p[0]}, twoPi, std::nullopt, size};
        case ellipse:
            return {parametric_model::Ellipse{p[0], p[1]}, twoPi, std::nullopt,
                    size + std::abs(p[1])};
        case lissajous:
            return prepareLissajous(p[0], p[1], p[2], p[3]);
        case rose:
            return prepareRose(p[0], p[1]);
        case butterfly:
            return {Butterfly{p[0]}, 6 * twoPi, Interval{0, 6 * twoPi}, 5 * size};
        case hypotrochoid:
            return prepareTrochoid(p[0], p[1], p[2], -1);
        case epitrochoid:
            return prepareTrochoid(p[0], p[1], p[2], 1);
        case astroid:
            return {Astroid{p[0]}, twoPi, std::nullopt, size};
        case cardioid:
            return {Epicycloid{p[0], 2}, twoPi, std::nullopt, 3 * size};
        case nephroid:
            return {Epicycloid{p[0], 3}, twoPi, std::nullopt, 4 * size};
        case heart:
            return {Heart{p[0]}, twoPi, std::nullopt, 21 * size};
        case lemniscate:
            return {Lemniscate{p[0]}, twoPi, std::nullopt, size};
        case spiral:
            return {Spiral{p[0], p[1]}, std::nullopt, Interval{0, twoPi * p[2]}};
        case helix:
            return {Helix{p[0], p[1] / twoPi}, std::nullopt, Interval{0, twoPi * p[2]}};
        case viviani:
            return {Viviani{p[0]}, 2 * twoPi, Interval{0, 2 * twoPi}, 2 * size};
        case trefoil:
            return {Trefoil{p[0]}, twoPi, std::nullopt, 3 * size};
        case torusKnot:
            return prepareTorusKnot(p[0], p[1], p[2], p[3]);
    }
    return {parametric_model::Ellipse{1, 1}, twoPi};  // not reached: all models stand above
}

Vec3 toVec(const Planar<double>& p) noexcept { return {p[0], p[1], 0}; }
Vec3 toVec(const Spatial<double>& p) noexcept { return {p[0], p[1], p[2]}; }

template <std::size_t Dimension>
void writeRows(const std::array<Jet, Dimension>& jets, std::span<Vec3> rows) noexcept {
    for (std::size_t k = 0; k < rows.size(); ++k) {
        rows[k] = Vec3(0);
        for (std::size_t i = 0; i < Dimension; ++i) {
            rows[k][static_cast<int>(i)] = jets[i].derivative(static_cast<int>(k));
        }
    }
}

bool closesOn(const ParametricCurve& curve, const Prepared& prepared) noexcept {
    if (!prepared.period) return false;
    const Interval domain = curve.domain();
    const double periods = std::round(domain.length() / *prepared.period);
    if (periods < 1) return false;
    if (std::abs(domain.length() - periods * *prepared.period) > seamTolerance * domain.length()) {
        return false;
    }
    const Vec3 gap = curve.point(domain.end) - curve.point(domain.start);
    return glm::length(gap) <= seamTolerance * std::max(prepared.size, 1e-300);
}

std::string knownModels() {
    std::string names;
    for (const ParametricModelDescription& model : parametricCurveModels()) {
        if (!names.empty()) names += ", ";
        names += model.name;
    }
    return names;
}

std::optional<Error> checkRolling(ParametricModel model, std::span<const double> parameters) {
    const bool rolls =
        model == ParametricModel::hypotrochoid || model == ParametricModel::epitrochoid;
    if (!rolls || std::abs(parameters[1]) >= 1e-9) return std::nullopt;
    return refuse(Code::outOfRange, "parameters.r",
                  "r is " + formatNumber(parameters[1]) +
                      ", but a circle that rolls needs a radius of at least 1e-9");
}

}  // namespace

Result<ParametricCurve> ParametricCurve::make(std::string_view name,
                                              std::span<const NamedValue> parameters,
                                              std::optional<Interval> domain) {
    const ParametricModelDescription* description = findParametricModel(name);
    if (description == nullptr) {
        return refuse(
            Code::unknownName, "name",
            "there is no model curve \"" + std::string(name) + "\"; known: " + knownModels());
    }
    const auto values = readParameters(description->parameters, parameters, "parameters");
    if (!values) return values.error();
    if (auto error = checkRolling(description->model, *values)) return *std::move(error);
    if (domain) {
        if (auto error = checkDomain(*domain)) return *std::move(error);
    }

    const Prepared prepared = prepare(description->model, *values);
    if (!domain && !prepared.unrecognised.empty()) {
        return refuse(Code::outOfRange, joinPath("parameters", prepared.unrecognised),
                      "no fraction p/q with q up to 64 is within 1e-9, so the period is unknown; "
                      "give a domain");
    }
    ParametricCurve curve;
    curve.id_ = description->model;
    curve.model_ = prepared.model;
    std::copy(values->begin(), values->end(), curve.parameters_.begin());
    curve.domain_ = domain.value_or(prepared.usual.value_or(Interval{0, twoPi}));
    curve.ownDomain_ = domain.has_value();
    curve.closed_ = closesOn(curve, prepared);
    return curve;
}

Vec3 ParametricCurve::point(double t) const noexcept {
    return std::visit([t](const auto& model) { return toVec(model.at(t)); }, model_);
}

void ParametricCurve::derivatives(double t, std::span<Vec3> rows) const noexcept {
    if (rows.empty()) return;
    const auto computed = rows.first(std::min<std::size_t>(rows.size(), Jet::maxOrder + 1));
    std::fill(rows.begin() + static_cast<std::ptrdiff_t>(computed.size()), rows.end(), Vec3(0));
    const Jet variable = Jet::variable(t, static_cast<int>(computed.size()) - 1);
    std::visit([&](const auto& model) { writeRows(model.at(variable), computed); }, model_);
}

void ParametricCurve::samplePoints(std::span<const double> ts, std::span<Vec3> out) const noexcept {
    const std::size_t count = std::min(ts.size(), out.size());
    std::visit(
        [&](const auto& model) {
            for (std::size_t i = 0; i < count; ++i) out[i] = toVec(model.at(ts[i]));
        },
        model_);
}

void ParametricCurve::sampleUniform(std::span<Vec3> out) const noexcept {
    std::visit(
        [&](const auto& model) {
            for (std::size_t i = 0; i < out.size(); ++i) {
                out[i] = toVec(model.at(uniformParameter(domain_, i, out.size())));
            }
        },
        model_);
}

bool operator==(const ParametricCurve& a, const ParametricCurve& b) noexcept {
    return a.id_ == b.id_ && a.parameters_ == b.parameters_ && a.domain_ == b.domain_;
}

}  // namespace knotwork
