#include "geometry/bezier_piece.hpp"

#include "geometry/oslo_kernels.hpp"

#include <algorithm>

namespace knotwork {

void bezierWeights(std::span<const double> knots, std::size_t degree, std::size_t span,
                   const Interval& part, std::size_t j, std::span<double> weights) noexcept {
    std::array<double, maxDegree> arguments{};
    std::fill_n(arguments.begin(), degree - j, part.start);
    std::fill_n(arguments.begin() + static_cast<std::ptrdiff_t>(degree - j), j, part.end);
    kernels::discreteBsplines<double>(knots, degree, span, arguments, weights);
}

namespace {

BezierPiece pieceOf(const KnotVector& knots, std::span<const Homogeneous> points,
                    std::size_t span) {
    const auto all = knots.extended();
    const auto degree = static_cast<std::size_t>(knots.degree());
    BezierPiece piece{{all[span], all[span + 1]}, std::vector<Homogeneous>(degree + 1)};
    std::array<double, maxDegree + 1> weights{};
    for (std::size_t j = 0; j <= degree; ++j) {
        bezierWeights(all, degree, span, piece.interval, j, weights);
        Homogeneous sum(0);
        for (std::size_t k = 0; k <= degree; ++k) {
            sum += weights[k] * points[knots.pointIndex(span, k)];
        }
        piece.points[j] = sum;
    }
    return piece;
}

}  // namespace

std::vector<BezierPiece> bezierPieces(const BsplineCurve& curve) {
    const KnotVector& knots = curve.knotVector();
    const auto all = knots.extended();
    const std::vector<Homogeneous> points = homogeneousPoints(curve);
    const std::size_t last = knots.findSpan(knots.domain().end, Side::left);
    std::vector<BezierPiece> pieces;
    for (std::size_t span = knots.findSpan(knots.domain().start); span <= last; ++span) {
        if (all[span] < all[span + 1]) pieces.push_back(pieceOf(knots, points, span));
    }
    return pieces;
}

}  // namespace knotwork
