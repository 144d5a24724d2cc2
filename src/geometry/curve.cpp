#include "geometry/curve.hpp"

#include "geometry/blending_sampler.hpp"
#include "geometry/piecewise_polynomial.hpp"
#include "geometry/uniform_parameters.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace knotwork {

namespace {

/// Parameters are handled in blocks of this size, so that what lies between stays in cache.
constexpr std::size_t blockSize = 256;

}  // namespace

Interval domain(const Curve& curve) noexcept {
    return std::visit([](const auto& kind) { return kind.domain(); }, curve.kind());
}

bool isClosed(const Curve& curve) noexcept {
    return std::visit([](const auto& kind) { return kind.closed(); }, curve.kind());
}

int dimension(const Curve& curve) noexcept {
    return std::visit([](const auto& kind) { return kind.dimension(); }, curve.kind());
}

Result<double> parameterInDomain(const Curve& curve, double t) {
    const Interval whole = domain(curve);
    if (!std::isfinite(t)) {
        return refuse(Code::notFinite, "t",
                      "The parameter is " + formatNumber(t) + "; give a finite number.");
    }
    if (whole.contains(t)) return t;
    if (isClosed(curve)) {
        const double turns = std::floor((t - whole.start) / whole.length());
        return std::clamp(t - turns * whole.length(), whole.start, whole.end);
    }
    return refuse(Code::outOfRange, "t",
                  "The parameter " + formatNumber(t) + " lies outside the domain [" +
                      formatNumber(whole.start) + ", " + formatNumber(whole.end) + "].");
}

void evaluate(const Curve& curve, double t, Side side, std::span<Vec3> rows) noexcept {
    std::visit([&](const auto& kind) { kind.evaluate(t, side, rows); }, curve.kind());
}

Vec3 pointAt(const Curve& curve, double t) noexcept {
    if (const auto* parametric = curve.as<ParametricCurve>()) return parametric->point(t);
    Vec3 point;
    evaluate(curve, t, t == domain(curve).end ? Side::left : Side::right, {&point, 1});
    return point;
}

/// A closed curve that is gone round oftener than this is not looked at piece by piece.
constexpr double mostBreaks = 1e6;

std::vector<double> breakParameters(const Curve& curve, const Interval& part) {
    const std::span<const double> knots =
        std::visit([](const auto& kind) { return kind.breaks(); }, curve.kind());
    std::vector<double> breaks;
    if (knots.empty()) return breaks;
    const double period = isClosed(curve) ? domain(curve).length() : 0;
    const auto turnAt = [&](double t) {
        return period > 0 ? std::floor((t - domain(curve).start) / period) : 0;
    };
    const double turns = turnAt(part.end) - turnAt(part.start) + 1;
    if (turns * static_cast<double>(knots.size()) > mostBreaks) return breaks;
    for (double turn = turnAt(part.start); turn <= turnAt(part.end); ++turn) {
        const auto first = std::lower_bound(knots.begin(), knots.end(), part.start - turn * period);
        for (auto knot = first; knot != knots.end(); ++knot) {
            const double t = *knot + turn * period;
            if (t >= part.end) break;
            if (t > part.start && (breaks.empty() || t > breaks.back())) breaks.push_back(t);
        }
    }
    return breaks;
}

/// A B-spline's or Bézier curve's pieces are made once; the others are sampled as they are.
struct CurveSampler::Prepared {
    explicit Prepared(const Curve& of) : curve(of) {
        if (const auto* spline = of.as<BsplineCurve>()) pieces.emplace(*spline);
        if (const auto* bezier = of.as<BezierCurve>()) {
            if (const auto same = asBspline(*bezier)) pieces.emplace(*same);
        }
        if (const auto* blending = of.as<BlendingCurve>()) blend.emplace(*blending);
    }

    void block(std::span<const double> ts, std::span<Vec3> out) const noexcept {
        if (const auto* parametric = curve.as<ParametricCurve>()) {
            parametric->samplePoints(ts, out);
        } else {
            const double end = domain(curve).end;
            std::visit(
                [&](const auto& kind) {
                    for (std::size_t i = 0; i < ts.size(); ++i) {
                        const Side side = ts[i] == end ? Side::left : Side::right;
                        kind.evaluate(ts[i], side, out.subspan(i, 1));
                    }
                },
                curve.kind());
        }
    }

    void points(std::span<const double> ts, double* xyz) const noexcept {
        if (blend) return blend->points(ts, {xyz, 3 * ts.size()});
        std::array<Vec3, blockSize> block;
        for (std::size_t done = 0; done < ts.size(); done += blockSize) {
            const std::size_t count = std::min(blockSize, ts.size() - done);
            this->block(ts.subspan(done, count), {block.data(), count});
            for (std::size_t i = 0; i < count; ++i) {
                *xyz++ = block[i].x;
                *xyz++ = block[i].y;
                *xyz++ = block[i].z;
            }
        }
    }

    void rows(std::span<const double> ts, std::size_t orders, double* xyz) const noexcept {
        std::array<Vec3, 26> rows{};
        const double end = domain(curve).end;
        for (std::size_t i = 0; i < ts.size(); ++i) {
            const Side side = ts[i] == end ? Side::left : Side::right;
            evaluate(curve, ts[i], side, {rows.data(), orders});
            for (std::size_t k = 0; k < orders; ++k) {
                double* at = xyz + 3 * (k * ts.size() + i);
                at[0] = rows[k].x;
                at[1] = rows[k].y;
                at[2] = rows[k].z;
            }
        }
    }

    Curve curve;
    std::optional<BsplineSampler> pieces;
    std::optional<BlendingSampler> blend;
};

CurveSampler::CurveSampler(const Curve& curve)
    : prepared_(std::make_unique<const Prepared>(curve)) {}
CurveSampler::~CurveSampler() = default;
CurveSampler::CurveSampler(CurveSampler&&) noexcept = default;
CurveSampler& CurveSampler::operator=(CurveSampler&&) noexcept = default;

void CurveSampler::uniform(std::size_t first, std::size_t count, std::size_t total,
                           std::span<double> xyz) const noexcept {
    if (prepared_->pieces) {
        prepared_->pieces->uniform(first, count, total, xyz);
        return;
    }
    const Interval whole = domain(prepared_->curve);
    std::array<double, blockSize> ts{};
    for (std::size_t done = 0; done < count; done += blockSize) {
        const std::size_t part = std::min(blockSize, count - done);
        uniformParameters(whole, first + done, total, {ts.data(), part});
        prepared_->points({ts.data(), part}, xyz.data() + 3 * done);
    }
}

void CurveSampler::at(std::span<const double> ts, int derivatives,
                      std::span<double> xyz) const noexcept {
    if (prepared_->pieces) {
        prepared_->pieces->at(ts, derivatives, xyz);
    } else if (derivatives == 0) {
        prepared_->points(ts, xyz.data());
    } else if (prepared_->blend && derivatives <= BlendingSampler::mostDerivatives) {
        prepared_->blend->rows(ts, derivatives, xyz);
    } else {
        prepared_->rows(ts, static_cast<std::size_t>(derivatives) + 1, xyz.data());
    }
}

}  // namespace knotwork
