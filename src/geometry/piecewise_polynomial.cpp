#include "geometry/piecewise_polynomial.hpp"

#include "geometry/bspline_kernels.hpp"
#include "geometry/polynomial_kernels.hpp"
#include "geometry/polynomial_piece.hpp"
#include "geometry/simd.hpp"
#include "geometry/uniform_parameters.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace knotwork {

namespace {

constexpr std::size_t blockSize = 512;  // parameters at a time: 4 KB, well inside the first cache

// Local parameters u, with room for the kernels to read whole groups of four.
using Block = std::array<double, blockSize + 4>;

}  // namespace

// The coefficients of one piece or of a derivative of it.
struct BsplineSampler::Terms {
    Coefficients values;
    std::size_t degree;
    double scale;
};

// ---- The sampler -------------------------------------------------------------------------------

BsplineSampler::BsplineSampler(const BsplineCurve& curve)
    : domain_(curve.domain()),
      startPoint_(curve.point(domain_.start)),
      endPoint_(curve.point(domain_.end)),
      degree_(static_cast<std::size_t>(curve.degree())),
      components_(curve.rational()         ? 4
                  : curve.dimension() == 2 ? 2
                                           : 3),
      // Weights may differ by 18 orders of magnitude: only sums of positive terms stand that.
      bernstein_(curve.rational() || degree_ > maxPowerDegree),
      closed_(curve.closed()) {
    const auto knots = curve.knotVector().extended();
    const std::size_t last = knots.size() - 1 - degree_;
    pieces_.reserve(last - degree_);
    coefficients_.reserve((last - degree_) * (degree_ + 1) * components_);
    for (std::size_t span = degree_; span < last; ++span) {
        if (knots[span] < knots[span + 1]) addPiece(curve, span);
    }
    if (closed_) return;
    pieces_.front().start = -std::numeric_limits<double>::infinity();
    pieces_.back().end = std::numeric_limits<double>::infinity();
}

void BsplineSampler::addPiece(const BsplineCurve& curve, std::size_t span) {
    const auto knots = curve.knotVector().extended();
    const double start = knots[span];
    const double end = knots[span + 1];
    const double width = end - start;
    Coefficients c;
    if (bernstein_) {
        pieces_.push_back({start, end, start, 1 / width});
        bernsteinCoefficients(curve, span, components_, c);
    } else {
        pieces_.push_back({start, end, start + width / 2, 2 / width});
        powerCoefficients(curve, span, components_, c);
    }
    const auto size = static_cast<std::ptrdiff_t>((degree_ + 1) * components_);
    coefficients_.insert(coefficients_.end(), c.begin(), c.begin() + size);
}

std::size_t BsplineSampler::pieceAt(double t) const noexcept {
    const auto after = std::upper_bound(pieces_.begin() + 1, pieces_.end(), t,
                                        [](double at, const Piece& p) { return at < p.start; });
    return static_cast<std::size_t>(after - pieces_.begin()) - 1;
}

BsplineSampler::Terms BsplineSampler::termsOf(std::size_t piece) const noexcept {
    Terms terms;
    const std::size_t size = (degree_ + 1) * components_;
    std::copy_n(&coefficients_[piece * size], size, terms.values.begin());
    terms.degree = degree_;
    terms.scale = pieces_[piece].scale;
    return terms;
}

void BsplineSampler::evaluate(const Terms& terms, const double* us, std::size_t count,
                              double* xyz) const noexcept {
    const double* c = terms.values.data();
    if (!bernstein_) {
        std::array<double, 6 * (maxPowerDegree + 1)> twice;
        for (std::size_t k = 0; k <= terms.degree; ++k) {
            const double* const term = c + k * components_;
            const double z = components_ == 2 ? 0 : term[2];
            const std::array<double, 6> row{term[0], term[1], z, term[0], term[1], z};
            std::copy(row.begin(), row.end(), &twice[6 * k]);
        }
        return kernels::powerBlock(twice.data(), terms.degree, us, count, xyz);
    }
    Coefficients weighted;
    std::copy_n(c, (terms.degree + 1) * components_, weighted.begin());
    multiplyBinomials(weighted, terms.degree, components_);
    c = weighted.data();
    if (components_ == 2) return kernels::bernsteinBlock<2>(c, terms.degree, us, count, xyz);
    if (components_ == 3) return kernels::bernsteinBlock<3>(c, terms.degree, us, count, xyz);
    return kernels::bernsteinBlock<4>(c, terms.degree, us, count, xyz);
}

// The ends are met exactly, and a closed curve's last sample is its first.
void BsplineSampler::fixEnd(double t, double* xyz) const noexcept {
    if (t != domain_.start && t != domain_.end) return;
    const Vec3& end = t == domain_.start ? startPoint_ : endPoint_;
    for (int axis = 0; axis < 3; ++axis) xyz[axis] = end[axis];
}

// ---- Uniform samples ---------------------------------------------------------------------------

namespace {

// The first i with uniformParameter(domain, i, total) ≥ t; total where there is none.
std::size_t firstIndexFrom(const Interval& domain, double t, std::size_t total) noexcept {
    const double intervals = static_cast<double>(total - 1);
    const double guess = std::ceil((t - domain.start) / domain.length() * intervals);
    auto i = static_cast<std::size_t>(std::clamp(guess, 0.0, intervals + 1));
    while (i > 0 && uniformParameter(domain, i - 1, total) >= t) --i;
    while (i < total && uniformParameter(domain, i, total) < t) ++i;
    return i;
}

// The local parameters of samples first, first+1, …, from the very parameters of
// uniformParameter(): steps of a rounded width would drift away from them. All of a block before the
// first point: with the divisions among its products a point takes a third longer.
void fillUniform(Block& us, std::size_t count, const Interval& domain, std::size_t first,
                 std::size_t total, double origin, double scale) noexcept {
    const simd::Double2 from = simd::splat(origin);
    const simd::Double2 by = simd::splat(scale);
    UniformPairs pairs(domain, first, total);
    for (std::size_t k = 0; k < count; k += 2) simd::store(&us[k], (pairs.next() - from) * by);
}

}  // namespace

void BsplineSampler::uniform(std::size_t first, std::size_t count, std::size_t total,
                             std::span<double> xyz) const noexcept {
    const std::size_t end = first + count;
    if (total < 2) {
        for (std::size_t k = 0; k < count; ++k) fixEnd(domain_.start, &xyz[3 * k]);
        return;
    }
    for (std::size_t i = first; i < end;) {
        const std::size_t piece = pieceAt(uniformParameter(domain_, i, total));
        const std::size_t next = firstIndexFrom(domain_, pieces_[piece].end, total);
        // A closed curve's last sample belongs to no piece: it is the first one again.
        const std::size_t stop = std::min(std::max(next, i + 1), end);
        uniformRun(piece, i, stop - i, total, &xyz[3 * (i - first)]);
        i = stop;
    }
    if (count > 0 && first == 0) fixEnd(domain_.start, &xyz[0]);
    if (count > 0 && end == total) fixEnd(domain_.end, &xyz[3 * (count - 1)]);
}

void BsplineSampler::uniformRun(std::size_t piece, std::size_t first, std::size_t count,
                                std::size_t total, double* xyz) const noexcept {
    const Piece& p = pieces_[piece];
    const Terms terms = termsOf(piece);
    Block us;
    for (std::size_t done = 0; done < count; done += blockSize) {
        const std::size_t size = std::min(blockSize, count - done);
        fillUniform(us, size, domain_, first + done, total, p.origin, p.scale);
        std::fill_n(&us[size], 4, 0.0);
        evaluate(terms, us.data(), size, xyz + 3 * done);
    }
}

// ---- Any parameters ----------------------------------------------------------------------------

void BsplineSampler::at(std::span<const double> ts, int derivatives,
                        std::span<double> xyz) const noexcept {
    for (std::size_t i = 0; i < ts.size();) i += run(ts, i, derivatives, xyz);
}

// One piece's parameters from `first` on, at most a block of them; answers how many.
std::size_t BsplineSampler::run(std::span<const double> ts, std::size_t first, int derivatives,
                                std::span<double> xyz) const noexcept {
    const double t = closed_ ? wrapParameter(domain_, ts[first], Side::right) : ts[first];
    const std::size_t piece = pieceAt(t);
    const Piece& p = pieces_[piece];
    Block us;
    us[0] = (t - p.origin) * p.scale;
    const std::size_t most = t == ts[first] ? std::min(blockSize, ts.size() - first) : 1;
    std::size_t count = 1;
    for (; count < most; ++count) {
        const double next = ts[first + count];
        if (!(p.start <= next && next < p.end)) break;
        us[count] = (next - p.origin) * p.scale;
    }
    std::fill_n(&us[count], 4, 0.0);
    if (components_ == 4 && derivatives > 0) {
        rationalRows(piece, us.data(), count, derivatives, 3 * ts.size(), &xyz[3 * first]);
    } else {
        rows(piece, us.data(), count, derivatives, 3 * ts.size(), &xyz[3 * first]);
    }
    if (piece == 0 || piece + 1 == pieces_.size()) {
        fixEnd(t, &xyz[3 * first]);
        for (std::size_t k = 1; k < count; ++k) fixEnd(ts[first + k], &xyz[3 * (first + k)]);
    }
    return count;
}

void BsplineSampler::rows(std::size_t piece, const double* us, std::size_t count, int derivatives,
                          std::size_t stride, double* xyz) const noexcept {
    Terms terms = termsOf(piece);
    for (std::size_t order = 0; order <= static_cast<std::size_t>(derivatives); ++order) {
        if (order > degree_) {
            std::fill_n(xyz + order * stride, 3 * count, 0.0);
            continue;
        }
        evaluate(terms, us, count, xyz + order * stride);
        if (terms.degree == 0) continue;
        if (bernstein_) {
            differentiateBernstein(terms.values, terms.degree, components_, terms.scale);
        } else {
            differentiatePower(terms.values, terms.degree, components_, terms.scale);
        }
        --terms.degree;
    }
}

namespace {

// Row k at to + k · stride becomes the k-th derivative of numerator over weight.
void rationalPoint(Coefficients b, std::size_t degree, double scale, double u, std::size_t rowCount,
                   std::size_t stride, double* to) noexcept {
    std::array<double, maxTerms> weights{};
    for (std::size_t order = 0; order < rowCount; ++order) {
        std::array<double, 4> lifted{};
        if (order <= degree) {
            Coefficients weighted = b;
            multiplyBinomials(weighted, degree - order, 4);
            lifted = kernels::bernsteinPoint(weighted.data(), degree - order, u);
            weights[order] = lifted[3];
            differentiateBernstein(b, degree - order, 4, scale);
        }
        std::copy_n(lifted.begin(), 3, to + order * stride);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        kernels::quotientRule(rowCount, std::span<const double>(weights).first(degree + 1),
                              [&](std::size_t k) -> double& { return to[k * stride + axis]; });
    }
}

}  // namespace

void BsplineSampler::rationalRows(std::size_t piece, const double* us, std::size_t count,
                                  int derivatives, std::size_t stride, double* xyz) const noexcept {
    const Terms terms = termsOf(piece);
    const auto rowCount = static_cast<std::size_t>(derivatives) + 1;
    for (std::size_t point = 0; point < count; ++point) {
        rationalPoint(terms.values, terms.degree, terms.scale, us[point], rowCount, stride,
                      xyz + 3 * point);
    }
}

}  // namespace knotwork
