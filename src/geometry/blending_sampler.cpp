#include "geometry/blending_sampler.hpp"

#include "geometry/polynomial_kernels.hpp"
#include "geometry/polynomial_piece.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace knotwork {

namespace {

constexpr std::size_t blockSize = 256;  // parameters at a time, well inside the first cache
constexpr std::size_t noSampler = std::numeric_limits<std::size_t>::max();
constexpr double infinity = std::numeric_limits<double>::infinity();

// With room for the kernels to read whole groups of four.
using Block = std::array<double, blockSize + 4>;

/// The degree of a curve that is one polynomial, small enough for the power form; otherwise 0.
std::size_t polynomialDegree(const Curve& curve) noexcept {
    if (curve.as<LineCurve>() != nullptr) return 1;
    const auto* bezier = curve.as<BezierCurve>();
    const bool usual = bezier != nullptr && !bezier->rational() && bezier->degree() <= maxPowerDegree;
    return usual ? bezier->degree() : 0;
}

/// c_k = C^(k)(centre) halfWidth^k / k!, posed.
void powerForm(const LocalCurve& local, double centre, double halfWidth,
               std::span<Vec3> c) noexcept {
    local.evaluate(centre, Side::right, c);
    double factor = 1;
    for (std::size_t k = 1; k < c.size(); ++k) {
        factor *= halfWidth / static_cast<double>(k);
        c[k] *= factor;
    }
}

void store(const Vec3& point, double* xyz) noexcept {
    xyz[0] = point.x;
    xyz[1] = point.y;
    xyz[2] = point.z;
}

}  // namespace

// A run of parameters in one piece.
struct BlendingSampler::Run {
    std::size_t count = 0;
    Block ts;
    Block weights;  // w at first, then B(w)
};

BlendingSampler::BlendingSampler(const BlendingCurve& curve)
    : curve_(curve), samplerOf_(curve.locals().size(), noSampler),
      components_(curve.dimension() == 2 ? 2 : 3) {
    const std::vector<double>& knots = curve_.knots();
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        if (knots[i] < knots[i + 1]) addPiece(curve_.spanAt(knots[i], Side::right));
    }
    if (curve_.closed()) return;
    pieces_.front().start = -infinity;
    pieces_.back().end = infinity;
}

void BlendingSampler::addPiece(const BlendingCurve::Span& span) {
    const LocalCurve& first = curve_.locals()[span.first];
    const LocalCurve& second = curve_.locals()[span.second];
    Piece piece{span.start, span.start + span.length, span, Method::any, 0, coefficients_.size()};
    // The end of one piece is the start of the next to the bit.
    piece.end = *std::upper_bound(curve_.knots().begin(), curve_.knots().end(), span.start);
    if (span.shift == 0 && first.runsWith(second)) {
        const bool same = first.placement() == second.placement();
        piece.method = same ? Method::one : Method::placements;
        samplerOf(span.first);
    } else if (polynomialDegree(first.source()) > 0 && polynomialDegree(second.source()) > 0) {
        addPolynomials(span, piece);
    } else {
        samplerOf(span.first);
        samplerOf(span.second);
    }
    pieces_.push_back(piece);
}

void BlendingSampler::addPolynomials(const BlendingCurve::Span& span, Piece& piece) {
    const LocalCurve& first = curve_.locals()[span.first];
    const LocalCurve& second = curve_.locals()[span.second];
    piece.method = Method::polynomials;
    piece.degree = std::max(polynomialDegree(first.source()), polynomialDegree(second.source()));
    std::array<Vec3, maxPowerDegree + 1> p;
    std::array<Vec3, maxPowerDegree + 1> q;
    const double half = span.length / 2;
    const double centre = span.start + half;
    powerForm(first, centre, half, {p.data(), piece.degree + 1});
    powerForm(second, centre - span.shift, half, {q.data(), piece.degree + 1});
    for (std::size_t k = 0; k <= piece.degree; ++k) {
        for (std::size_t c = 0; c < components_; ++c) {
            coefficients_.push_back(p[k][static_cast<int>(c)]);
        }
        for (std::size_t c = 0; c < components_; ++c) {
            coefficients_.push_back(q[k][static_cast<int>(c)] - p[k][static_cast<int>(c)]);
        }
    }
}

/// The sampler of a local curve's source; neighbours that share it share its sampler.
std::size_t BlendingSampler::samplerOf(std::size_t local) {
    std::size_t& own = samplerOf_[local];
    if (own != noSampler) return own;
    const auto& source = curve_.locals()[local].sharedSource();
    if (local > 0 && samplerOf_[local - 1] != noSampler &&
        curve_.locals()[local - 1].sharedSource() == source) {
        return own = samplerOf_[local - 1];
    }
    samplers_.emplace_back(*source);
    return own = samplers_.size() - 1;
}

const BlendingSampler::Piece& BlendingSampler::pieceAt(double t) const noexcept {
    const auto after = std::upper_bound(pieces_.begin() + 1, pieces_.end(), t,
                                        [](double at, const Piece& p) { return at < p.start; });
    return *(after - 1);
}

void BlendingSampler::points(std::span<const double> ts, std::span<double> xyz) const noexcept {
    for (std::size_t i = 0; i < ts.size();) i += run(ts, i, &xyz[3 * i]);
}

/// One piece's parameters from `first` on, at most a block of them; answers how many.
std::size_t BlendingSampler::run(std::span<const double> ts, std::size_t first,
                                 double* xyz) const noexcept {
    const Interval whole = curve_.domain();
    const double t = ts[first];
    // Both ends are met exactly; what lies outside a closed curve is wrapped.
    if (t == whole.start || t == whole.end || (curve_.closed() && !whole.contains(t))) {
        Vec3 point;
        curve_.evaluate(t, t == whole.end ? Side::left : Side::right, {&point, 1});
        store(point, xyz);
        return 1;
    }
    const Piece& piece = pieceAt(t);
    Run run;
    const std::size_t most = std::min(blockSize, ts.size() - first);
    for (; run.count < most; ++run.count) {
        const double next = ts[first + run.count];
        if (!(piece.start <= next && next < piece.end) || next == whole.end) break;
        run.ts[run.count] = next;
    }
    std::fill_n(&run.ts[run.count], 4, piece.span.start);
    blend(piece, run, xyz);
    return run.count;
}

void BlendingSampler::blend(const Piece& piece, Run& run, double* xyz) const noexcept {
    if (piece.method == Method::one) return local(piece.span.first, 0, run, xyz);
    const double perLength = 1 / piece.span.length;
    for (std::size_t i = 0; i < run.count + 4; ++i) {
        run.weights[i] = (run.ts[i] - piece.span.start) * perLength;
    }
    if (piece.method == Method::polynomials) {
        // u = 2w − 1; the parameters themselves are no longer needed.
        for (std::size_t i = 0; i < run.count + 4; ++i) run.ts[i] = 2 * run.weights[i] - 1;
    }
    const std::span<double> weights(run.weights.data(), run.count);
    curve_.blend().sample(weights, weights);
    if (piece.method == Method::placements) return placements(piece, run, xyz);
    if (piece.method == Method::any) return any(piece, run, xyz);
    const double* c = &coefficients_[piece.offset];
    if (components_ == 2) {
        kernels::blendBlock<2>(c, piece.degree, run.ts.data(), run.weights.data(), run.count, xyz);
    } else {
        kernels::blendBlock<3>(c, piece.degree, run.ts.data(), run.weights.data(), run.count, xyz);
    }
}

/// The source of local j at t − shift for every t of the run, not posed.
void BlendingSampler::local(std::size_t j, double shift, const Run& run,
                            double* xyz) const noexcept {
    const LocalCurve& curve = curve_.locals()[j];
    Block parameters;
    for (std::size_t i = 0; i < run.count; ++i) {
        parameters[i] = curve.sourceParameter(run.ts[i] - shift);
    }
    samplers_[samplerOf_[j]].at({parameters.data(), run.count}, 0, {xyz, 3 * run.count});
    if (curve.pose().isIdentity()) return;
    const Affine placement = curve.placement();
    for (std::size_t i = 0; i < run.count; ++i) {
        double* at = xyz + 3 * i;
        store(placement.point({at[0], at[1], at[2]}), at);
    }
}

void BlendingSampler::placements(const Piece& piece, Run& run, double* xyz) const noexcept {
    const LocalCurve& first = curve_.locals()[piece.span.first];
    const Affine from = first.placement();
    const Affine to = curve_.locals()[piece.span.second].placement();
    const Affine step{to.linear - from.linear, to.offset - from.offset};
    Block parameters;
    for (std::size_t i = 0; i < run.count; ++i) parameters[i] = first.sourceParameter(run.ts[i]);
    samplers_[samplerOf_[piece.span.first]].at({parameters.data(), run.count}, 0,
                                               {xyz, 3 * run.count});
    for (std::size_t i = 0; i < run.count; ++i) {
        double* at = xyz + 3 * i;
        const Vec3 point(at[0], at[1], at[2]);
        store(from.point(point) + run.weights[i] * step.point(point), at);
    }
}

void BlendingSampler::any(const Piece& piece, Run& run, double* xyz) const noexcept {
    std::array<double, 3 * blockSize> others;
    local(piece.span.first, 0, run, xyz);
    local(piece.span.second, piece.span.shift, run, others.data());
    for (std::size_t i = 0; i < run.count; ++i) {
        const double weight = run.weights[i];
        for (std::size_t axis = 3 * i; axis < 3 * i + 3; ++axis) {
            xyz[axis] = (1 - weight) * xyz[axis] + weight * others[axis];
        }
    }
}

}  // namespace knotwork
