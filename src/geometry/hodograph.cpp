#include "geometry/hodograph.hpp"

#include "geometry/bezier_piece.hpp"
#include "geometry/bspline_indexing.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace knotwork {

namespace {

// --- polynomial curves ------------------------------------------------------------------------

/// Points and knots, the latter one period with both its ends where closed.
struct Parts {
    std::vector<double> knots;
    std::vector<Vec3> points;
};

/// Point j of the derivative begins at knot j+1 and ends at knot j+d+1. Where these are equal, at a
/// gap, it stands nowhere and goes, with one of the knots.
bool isNowhere(const KnotVector& knots, std::ptrdiff_t j) {
    return knotAt(knots, j + 1) == knotAt(knots, j + 1 + knots.degree());
}

Vec3 differenceAt(const BsplineCurve& curve, std::ptrdiff_t j) {
    const KnotVector& knots = curve.knotVector();
    const auto points = curve.points();
    const Vec3 step = points[cyclic(j + 1, points.size())] - points[cyclic(j, points.size())];
    return step * (curve.degree() / (knotAt(knots, j + 1 + curve.degree()) - knotAt(knots, j + 1)));
}

Parts differences(const BsplineCurve& curve) {
    const KnotVector& knots = curve.knotVector();
    const std::ptrdiff_t count = knots.pointCount();
    Parts parts;
    for (std::ptrdiff_t j = 0; j < count - 1; ++j) {
        if (isNowhere(knots, j)) continue;
        parts.knots.push_back(knotAt(knots, j + 1));
        parts.points.push_back(differenceAt(curve, j));
    }
    for (std::ptrdiff_t j = count - 1; j < count - 1 + knots.degree(); ++j) {
        parts.knots.push_back(knotAt(knots, j + 1));
    }
    return parts;
}

/// From the first knot of the period on, those repeated at its end included, so that no run of equal
/// knots is cut; knots and points are then turned to where they stand in a period of degree d-1.
Parts periodDifferences(const BsplineCurve& curve) {
    const KnotVector& knots = curve.knotVector();
    const auto seam = static_cast<std::ptrdiff_t>(seamIndex(knots));
    Parts parts;
    for (std::ptrdiff_t j = seam - 1; j < seam - 1 + knots.pointCount(); ++j) {
        if (isNowhere(knots, j)) continue;
        parts.knots.push_back(knotAt(knots, j + 1));
        parts.points.push_back(differenceAt(curve, j));
    }
    // The first of these knots begins the period; the point that begins there has index d-1.
    parts.knots.push_back(knots.domain().end);
    std::vector<Vec3> turned(parts.points.size());
    for (std::size_t i = 0; i < turned.size(); ++i) {
        turned[(i + static_cast<std::size_t>(knots.degree()) - 1) % turned.size()] =
            parts.points[i];
    }
    parts.points = std::move(turned);
    return parts;
}

// --- pieces that are put together -------------------------------------------------------------

/// A curve of which every knot has d or d+1 equal ones, from its Bézier pieces.
class Assembly {
public:
    explicit Assembly(std::size_t degree) : degree_(degree) {}

    /// The next piece; `joined` where it begins at the point in which the last one ended.
    void add(const BezierPiece& piece, bool joined) {
        knots_.insert(knots_.end(), degree_ + (joined ? 0 : 1), piece.interval.start);
        points_.insert(points_.end(), piece.points.begin() + (joined ? 1 : 0),
                       piece.points.end());
        end_ = piece.interval.end;
    }

    /// `seamJoined` where a closed curve ends in the point in which it began.
    [[nodiscard]] Result<BsplineCurve> finish(const BsplineCurve& like, bool weighted,
                                              bool seamJoined) && {
        const bool closed = like.closed();
        if (closed && seamJoined) {
            points_.erase(points_.begin());
            knots_.erase(knots_.begin());
        }
        knots_.insert(knots_.end(), closed ? 1 : degree_ + 1, end_);
        if (closed) {
            // The point that the period's first knot leads to has the index of the degree.
            const auto shift = static_cast<std::ptrdiff_t>(degree_ % points_.size());
            std::rotate(points_.rbegin(), points_.rbegin() + shift, points_.rend());
        }
        auto knots = KnotVector::make(std::move(knots_), static_cast<int>(degree_),
                                      static_cast<int>(points_.size()),
                                      like.knotVector().form());
        if (!knots) return knots.error();
        return fromHomogeneous(std::move(*knots), points_, like.dimension(), weighted);
    }

private:
    std::size_t degree_;
    std::vector<double> knots_;
    std::vector<Homogeneous> points_;
    double end_ = 0;
};

Result<BsplineCurve> constants(const BsplineCurve& curve) {
    Assembly assembly(1);
    for (const BezierPiece& piece : bezierPieces(curve)) {
        // Weights that are all the same have come into the points.
        const Homogeneous slope = (piece.points[1] - piece.points[0]) /
                                  (piece.points[0].w * piece.interval.length());
        assembly.add({piece.interval, {slope, slope}}, false);
    }
    return std::move(assembly).finish(curve, false, false);
}

// --- rational curves --------------------------------------------------------------------------

using Row = std::vector<double>;

/// binomial(n, 0 … n).
Row binomials(std::size_t n) {
    Row row{1};
    for (std::size_t k = 1; k <= n; ++k) {
        row.push_back(row.back() * static_cast<double>(n + 1 - k) / static_cast<double>(k));
    }
    return row;
}

/// The product of polynomials in Bernstein form.
template <class Value>
std::vector<Value> product(std::span<const Value> f, std::span<const double> g) {
    const Row inF = binomials(f.size() - 1);
    const Row inG = binomials(g.size() - 1);
    const Row in = binomials(f.size() + g.size() - 2);
    std::vector<Value> result(in.size(), Value(0));
    for (std::size_t i = 0; i < f.size(); ++i) {
        for (std::size_t k = 0; k < g.size(); ++k) {
            result[i + k] += inF[i] * inG[k] / in[i + k] * g[k] * f[i];
        }
    }
    return result;
}

template <class Value>
std::vector<Value> derivative(std::span<const Value> f, double length) {
    std::vector<Value> slopes;
    for (std::size_t i = 0; i + 1 < f.size(); ++i) {
        slopes.push_back((f[i + 1] - f[i]) * (static_cast<double>(f.size() - 1) / length));
    }
    return slopes;
}

/// (P' w - P w', w²) / scale. P is taken from a point of the piece, which changes nothing but the
/// rounding.
BezierPiece quotientOf(const BezierPiece& piece, double scale) {
    const Vec3 origin = Vec3(piece.points.front()) / piece.points.front().w;
    std::vector<Vec3> p;
    Row w;
    for (const Homogeneous& point : piece.points) {
        p.push_back(Vec3(point) - point.w * origin);
        w.push_back(point.w);
    }
    const double length = piece.interval.length();
    const auto dp = derivative<Vec3>(p, length);
    const Row dw = derivative<double>(w, length);
    const auto rising = product<Vec3>(dp, w);
    const auto falling = product<Vec3>(p, dw);
    const Row square = product<double>(w, w);
    BezierPiece quotient{piece.interval, {}};
    // The numerator has degree 2d-1 and is raised to that of w².
    const std::size_t degree = square.size() - 1;
    for (std::size_t k = 0; k <= degree; ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(degree);
        Vec3 sum(0);
        if (k > 0) sum += share * (rising[k - 1] - falling[k - 1]);
        if (k < degree) sum += (1 - share) * (rising[k] - falling[k]);
        quotient.points.emplace_back(sum / scale, square[k] / scale);
    }
    return quotient;
}

Result<BsplineCurve> rationalDerivative(const BsplineCurve& curve) {
    const int degree = curve.degree();
    if (2 * degree > maxDegree) {
        return refuse(Code::notSupported, "degree",
                      "the derivative of a rational curve of degree " + std::to_string(degree) +
                          " has degree " + std::to_string(2 * degree) +
                          ", and 25 is the highest; curves up to degree 12 have one");
    }
    const auto [least, most] =
        std::minmax_element(curve.weights().begin(), curve.weights().end());
    const double scale = *least * *most;
    Assembly assembly(static_cast<std::size_t>(2 * degree));
    const auto joinedAt = [&](double t) { return curve.knotVector().multiplicity(t) < degree; };
    bool first = true;
    for (const BezierPiece& piece : bezierPieces(curve)) {
        assembly.add(quotientOf(piece, scale), !first && joinedAt(piece.interval.start));
        first = false;
    }
    auto made =
        std::move(assembly).finish(curve, true, curve.closed() && joinedAt(curve.domain().start));
    if (made) return made;
    return refuse(Code::notSupported, made.error().path,
                  "the derivative is no B-spline curve that can be made: " + made.error().message);
}

}  // namespace

Result<BsplineCurve> derivativeCurve(const BsplineCurve& curve) {
    if (curve.rational()) return rationalDerivative(curve);
    if (curve.degree() == 1) return constants(curve);
    Parts parts = curve.closed() ? periodDifferences(curve) : differences(curve);
    auto knots = KnotVector::make(std::move(parts.knots), curve.degree() - 1,
                                  static_cast<int>(parts.points.size()),
                                  curve.knotVector().form());
    if (!knots) return knots.error();
    return BsplineCurve::make(std::move(*knots), std::move(parts.points), curve.dimension());
}

}  // namespace knotwork
