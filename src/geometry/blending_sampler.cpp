#include "geometry/blending_sampler.hpp"

#include "geometry/polynomial_kernels.hpp"
#include "geometry/polynomial_piece.hpp"
#include "geometry/triples.hpp"

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

/// An affine map as three rows of four numbers: what is done for every point is plain arithmetic.
using Rows4 = std::array<double, 12>;

Rows4 rowsOf(const Affine& map) noexcept {
    Rows4 rows;
    for (int row = 0; row < 3; ++row) {
        const auto at = static_cast<std::size_t>(4 * row);
        for (int column = 0; column < 3; ++column) {
            rows[at + static_cast<std::size_t>(column)] = map.linear[column][row];
        }
        rows[at + 3] = map.offset[row];
    }
    return rows;
}

inline double rowAt(const Rows4& map, std::size_t row, double x, double y, double z) noexcept {
    const double* m = &map[4 * row];
    return m[0] * x + m[1] * y + m[2] * z + m[3];
}

/// How many of the first parameters lie in [start, end).
std::size_t leading(std::span<const double> ts, double start, double end) noexcept {
    simd::Double2 least = simd::splat(ts.front());
    simd::Double2 largest = simd::splat(ts.back());
    for (std::size_t i = 0; i + 2 <= ts.size(); i += 2) {
        const simd::Double2 t = simd::load(&ts[i]);
        least = simd::smaller(least, t);
        largest = simd::larger(largest, t);
    }
    // Most often all of them do.
    const bool all = std::min({simd::first(least), simd::second(least), ts.back()}) >= start &&
                     std::max({simd::first(largest), simd::second(largest), ts.front()}) < end;
    if (all) return ts.size();
    const auto inside = [=](double t) { return start <= t && t < end; };
    return static_cast<std::size_t>(std::find_if_not(ts.begin(), ts.end(), inside) - ts.begin());
}

}  // namespace

// Parameters that follow each other in one piece.
struct BlendingSampler::Run {
    std::span<const double> ts{};
    Block us;       // in [-1, 1] where polynomials are blended
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
        samplerOf(span.second);
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

/// The piece of the first parameter, and in the run all that follow it there. Null where a parameter
/// stands alone: both ends are met exactly, and what lies outside a closed curve is wrapped.
const BlendingSampler::Piece* BlendingSampler::begin(std::span<const double> ts,
                                                     Run& run) const noexcept {
    const Interval whole = curve_.domain();
    const double t = ts.front();
    run.ts = ts.first(1);
    if (t == whole.start || t == whole.end || (curve_.closed() && !whole.contains(t))) {
        return nullptr;
    }
    const Piece& piece = pieceAt(t);
    const std::size_t count = leading(ts, piece.start, std::min(piece.end, whole.end));
    run.ts = ts.first(std::max<std::size_t>(count, 1));  // what lies outside comes one by one
    return &piece;
}

void BlendingSampler::points(std::span<const double> ts, std::span<double> xyz) const noexcept {
    Run run;
    for (std::size_t i = 0; i < ts.size(); i += run.ts.size()) {
        const auto next = ts.subspan(i, std::min(blockSize, ts.size() - i));
        if (const Piece* piece = begin(next, run)) {
            blend(*piece, run, &xyz[3 * i]);
            continue;
        }
        Vec3 point;
        const Side side = ts[i] == curve_.domain().end ? Side::left : Side::right;
        curve_.evaluate(ts[i], side, {&point, 1});
        write(point, &xyz[3 * i]);
    }
}

void BlendingSampler::blend(const Piece& piece, Run& run, double* xyz) const noexcept {
    if (piece.method == Method::one) return local(piece.span.first, 0, run, xyz);
    locate(piece, run);
    const std::span<double> weights(run.weights.data(), run.ts.size());
    curve_.blend().sample(weights, weights);
    if (piece.method == Method::placements) return placements(piece, run, xyz);
    if (piece.method == Method::any) return any(piece, run, xyz);
    const double* c = &coefficients_[piece.offset];
    if (components_ == 2) {
        kernels::blendBlock<2>(c, piece.degree, run.us.data(), run.weights.data(), run.ts.size(),
                               xyz);
    } else {
        kernels::blendBlock<3>(c, piece.degree, run.us.data(), run.weights.data(), run.ts.size(),
                               xyz);
    }
}

/// w in [0, 1] and u = 2w − 1 for every t of the run.
void BlendingSampler::locate(const Piece& piece, Run& run) const noexcept {
    const simd::Double2 start = simd::splat(piece.span.start);
    const simd::Double2 perLength = simd::splat(1 / piece.span.length);
    const auto put = [&](std::size_t i, simd::Double2 t) {
        const simd::Double2 w = (t - start) * perLength;
        simd::store(&run.weights[i], w);
        simd::store(&run.us[i], w + w - simd::splat(1));
    };
    std::size_t i = 0;
    for (; i + 2 <= run.ts.size(); i += 2) put(i, simd::load(&run.ts[i]));
    for (; i % 4 != 0 || i < run.ts.size(); i += 2) put(i, simd::splat(run.ts.back()));
}

/// The source of local j at t − shift for every t of the run, not posed.
void BlendingSampler::local(std::size_t j, double shift, const Run& run,
                            double* xyz) const noexcept {
    const LocalCurve& curve = curve_.locals()[j];
    Block parameters;
    for (std::size_t i = 0; i < run.ts.size(); ++i) {
        parameters[i] = curve.sourceParameter(run.ts[i] - shift);
    }
    samplers_[samplerOf_[j]].at({parameters.data(), run.ts.size()}, 0, {xyz, 3 * run.ts.size()});
    if (curve.pose().isIdentity()) return;
    const Rows4 placement = rowsOf(curve.placement());
    for (double* at = xyz; at != xyz + 3 * run.ts.size(); at += 3) {
        const double x = at[0];
        const double y = at[1];
        const double z = at[2];
        for (std::size_t row = 0; row < 3; ++row) at[row] = rowAt(placement, row, x, y, z);
    }
}

void BlendingSampler::placements(const Piece& piece, Run& run, double* xyz) const noexcept {
    const LocalCurve& first = curve_.locals()[piece.span.first];
    const Rows4 from = rowsOf(first.placement());
    const Rows4 to = rowsOf(curve_.locals()[piece.span.second].placement());
    Rows4 step;
    for (std::size_t k = 0; k < step.size(); ++k) step[k] = to[k] - from[k];
    Block parameters;
    for (std::size_t i = 0; i < run.ts.size(); ++i) parameters[i] = first.sourceParameter(run.ts[i]);
    samplers_[samplerOf_[piece.span.first]].at({parameters.data(), run.ts.size()}, 0,
                                               {xyz, 3 * run.ts.size()});
    for (std::size_t i = 0; i < run.ts.size(); ++i) {
        double* at = xyz + 3 * i;
        const double x = at[0];
        const double y = at[1];
        const double z = at[2];
        for (std::size_t row = 0; row < 3; ++row) {
            at[row] = rowAt(from, row, x, y, z) + run.weights[i] * rowAt(step, row, x, y, z);
        }
    }
}

void BlendingSampler::any(const Piece& piece, Run& run, double* xyz) const noexcept {
    std::array<double, 3 * blockSize> others;
    local(piece.span.first, 0, run, xyz);
    local(piece.span.second, piece.span.shift, run, others.data());
    for (std::size_t i = 0; i < run.ts.size(); ++i) {
        const double weight = run.weights[i];
        for (std::size_t axis = 3 * i; axis < 3 * i + 3; ++axis) {
            xyz[axis] = (1 - weight) * xyz[axis] + weight * others[axis];
        }
    }
}

// ---- Derivatives -------------------------------------------------------------------------------

namespace {

constexpr std::size_t mostOrders = BlendingSampler::mostDerivatives + 1;
constexpr std::size_t rowBlock = 64;

/// binomial(j, l) for j up to 3.
constexpr std::array<std::array<double, mostOrders>, mostOrders> binomials{
    {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}}};

}  // namespace

/// x, y, z of the points of a run, then of the first derivatives there, …
struct BlendingSampler::Rows {
    std::array<double, 3 * mostOrders * rowBlock> at;
};

void BlendingSampler::rows(std::span<const double> ts, int derivatives,
                           std::span<double> xyz) const noexcept {
    const std::size_t orders = static_cast<std::size_t>(derivatives) + 1;
    Run run;
    for (std::size_t i = 0; i < ts.size(); i += run.ts.size()) {
        const auto next = ts.subspan(i, std::min(rowBlock, ts.size() - i));
        if (const Piece* piece = begin(next, run)) {
            blendRows(*piece, run, orders, 3 * ts.size(), &xyz[3 * i]);
            continue;
        }
        std::array<Vec3, mostOrders> single;
        const Side side = ts[i] == curve_.domain().end ? Side::left : Side::right;
        curve_.evaluate(ts[i], side, {single.data(), orders});
        for (std::size_t k = 0; k < orders; ++k) write(single[k], &xyz[3 * (k * ts.size() + i)]);
    }
}

/// C^(j) = c^(j) + Σ binomial(j, l) B^(l) h^(−l) (c_next − c)^(j−l).
void BlendingSampler::blendRows(const Piece& piece, const Run& run, std::size_t orders,
                                std::size_t stride, double* xyz) const noexcept {
    const std::size_t n = run.ts.size();
    std::array<double, rowBlock> ws;
    std::array<double, mostOrders * rowBlock> b;
    for (std::size_t i = 0; i < n; ++i) ws[i] = (run.ts[i] - piece.span.start) / piece.span.length;
    curve_.blend().sampleDerivatives({ws.data(), n}, {b.data(), orders * n});
    double power = 1;
    for (std::size_t l = 0; l < orders; ++l) {
        for (std::size_t i = 0; i < n; ++i) b[l * n + i] *= power;
        power /= piece.span.length;
    }
    Rows first;
    Rows step;
    if (piece.method == Method::polynomials) {
        polynomialRows(piece, run, orders, first, step);
    } else {
        localRows(piece.span.first, 0, run, orders, first);
        localRows(piece.span.second, piece.span.shift, run, orders, step);
        for (std::size_t k = 0; k < 3 * orders * n; ++k) step.at[k] -= first.at[k];
    }
    for (std::size_t j = 0; j < orders; ++j) {
        double* to = xyz + j * stride;
        std::copy_n(&first.at[3 * j * n], 3 * n, to);
        for (std::size_t l = 0; l <= j; ++l) {
            const double* from = &step.at[3 * (j - l) * n];
            for (std::size_t i = 0; i < n; ++i) {
                const double weight = binomials[j][l] * b[l * n + i];
                for (std::size_t axis = 3 * i; axis < 3 * i + 3; ++axis) {
                    to[axis] += weight * from[axis];
                }
            }
        }
    }
}

void BlendingSampler::localRows(std::size_t j, double shift, const Run& run, std::size_t orders,
                                Rows& rows) const noexcept {
    const LocalCurve& curve = curve_.locals()[j];
    const std::size_t n = run.ts.size();
    std::array<double, rowBlock> parameters;
    for (std::size_t i = 0; i < n; ++i) parameters[i] = curve.sourceParameter(run.ts[i] - shift);
    samplers_[samplerOf_[j]].at({parameters.data(), n}, static_cast<int>(orders) - 1,
                                {rows.at.data(), 3 * orders * n});
    Rows4 placement = rowsOf(curve.placement());
    for (std::size_t k = 0; k < orders; ++k) {
        if (k == 1) placement[3] = placement[7] = placement[11] = 0;
        if (k > 0) for (double& entry : placement) entry *= curve.rate();
        for (std::size_t i = 3 * k * n; i < 3 * (k + 1) * n; i += 3) {
            double* at = &rows.at[i];
            const double x = at[0];
            const double y = at[1];
            const double z = at[2];
            for (std::size_t row = 0; row < 3; ++row) at[row] = rowAt(placement, row, x, y, z);
        }
    }
}

/// Horner's rule with derivatives, for P and Q − P at once.
void BlendingSampler::polynomialRows(const Piece& piece, const Run& run, std::size_t orders,
                                     Rows& first, Rows& step) const noexcept {
    const std::size_t n = run.ts.size();
    const double perHalf = 2 / piece.span.length;
    const double* c = &coefficients_[piece.offset];
    const std::size_t width = 2 * components_;
    first.at.fill(0);
    step.at.fill(0);
    for (std::size_t i = 0; i < n; ++i) {
        const double u = (run.ts[i] - piece.span.start) * perHalf - 1;
        for (std::size_t column = 0; column < width; ++column) {
            std::array<double, mostOrders> sums{};
            for (std::size_t k = piece.degree + 1; k-- > 0;) {
                for (std::size_t l = orders; l-- > 1;) sums[l] = sums[l] * u + sums[l - 1];
                sums[0] = sums[0] * u + c[k * width + column];
            }
            const bool isStep = column >= components_;
            const std::size_t axis = isStep ? column - components_ : column;
            double factor = 1;  // l! (2/h)^l
            for (std::size_t l = 0; l < orders; ++l) {
                (isStep ? step : first).at[3 * (l * n + i) + axis] = factor * sums[l];
                factor *= perHalf * static_cast<double>(l + 1);
            }
        }
    }
}

}  // namespace knotwork
