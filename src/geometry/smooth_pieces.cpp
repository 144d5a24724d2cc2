#include "geometry/smooth_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace knotwork {

namespace {

constexpr double piecesOfDomain = 32;
/// Where its B-function is not smooth in more places than this in all, a blending curve is not cut
/// there: a table of a hundred thousand values in each of ten thousand spans is not worth it.
constexpr std::size_t mostKinks = 100'000;

/// x with B(x) = y, for y in (0, 1): B is monotone.
double inverse(const BFunction& blend, double y) noexcept {
    double low = 0;
    double high = 1;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (blend.value(middle) < y ? low : high) = middle;
    }
    return high;
}

std::vector<double> kinks(const BFunction& blend);

std::vector<double> kinksOfOperands(const BFunction& blend) {
    const std::vector<BFunction> operands = blend.operands();
    std::vector<double> all;
    if (blend.family() == BFamily::composed) {
        for (const double y : kinks(operands[0])) all.push_back(inverse(operands[1], y));
        for (const double x : kinks(operands[1])) all.push_back(x);
        return all;
    }
    const bool mirrored = blend.family() == BFamily::dual || blend.family() == BFamily::symmetrised;
    for (const BFunction& operand : operands) {
        for (const double x : kinks(operand)) {
            if (blend.family() != BFamily::dual) all.push_back(x);
            if (mirrored) all.push_back(1 - x);
        }
    }
    return all;
}

/// Where in (0, 1) a derivative of B may jump.
std::vector<double> kinks(const BFunction& blend) {
    if (blend.smooth()) return {};
    std::vector<double> all;
    if (const std::size_t values = blend.values().size(); values > 2) {
        for (std::size_t i = 1; i + 1 < values; ++i) {
            all.push_back(uniformParameter({0, 1}, i, values));
        }
    } else if (blend.family() == BFamily::expoRational) {
        all.push_back(blend.parameters()[3]);  // λ
    } else {
        all = kinksOfOperands(blend);
    }
    return all;
}

/// Where between the knots of one turn the B-function of a blending curve is not smooth.
void addKinks(const BlendingCurve& blend, const Interval& part, double turn,
              std::vector<double>& breaks) {
    const std::vector<double>& knots = blend.knots();
    const std::vector<double> corners = kinks(blend.blend());
    if (corners.size() * knots.size() > mostKinks) return;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        const double h = knots[i + 1] - knots[i];
        for (const double x : corners) {
            const double t = knots[i] + x * h + turn;
            if (part.start < t && t < part.end) breaks.push_back(t);
        }
    }
}

std::vector<double> breaksOf(const Curve& curve, const Interval& part) {
    std::vector<double> breaks = breakParameters(curve, part);
    const auto* blend = curve.as<BlendingCurve>();
    if (blend == nullptr || blend->blend().smooth()) return breaks;
    const Interval whole = blend->domain();
    const auto turnOf = [&](double t) {
        return blend->closed() ? std::floor((t - whole.start) / whole.length()) : 0;
    };
    for (double k = turnOf(part.start); k <= turnOf(part.end); ++k) {
        addKinks(*blend, part, k * whole.length(), breaks);
    }
    return breaks;
}

/// Equal parameters, also those that differ by the rounding of a local's own parameter, once.
void tidy(std::vector<double>& breaks, const Interval& part) {
    std::sort(breaks.begin(), breaks.end());
    const double reach = std::max(std::abs(part.start), std::abs(part.end));
    const double least = 16 * std::numeric_limits<double>::epsilon() * reach;
    std::vector<double> kept;
    for (const double t : breaks) {
        const bool apart = kept.empty() || t - kept.back() > least;
        if (apart && t - part.start > least && part.end - t > least) kept.push_back(t);
    }
    breaks = std::move(kept);
}

void addPieces(const Interval& smooth, double longest, std::vector<Interval>& pieces) {
    const double count = std::max(1.0, std::ceil(smooth.length() / longest * (1 - 1e-9)));
    double start = smooth.start;
    for (double i = 1; i <= count; ++i) {
        const double end =
            i == count ? smooth.end : smooth.start + smooth.length() * (i / count);
        pieces.push_back({start, end});
        start = end;
    }
}

}  // namespace

bool isPiecewiseRational(const Curve& curve) noexcept {
    if (const auto* local = curve.as<LocalCurve>()) return isPiecewiseRational(local->source());
    return curve.as<BsplineCurve>() != nullptr || curve.as<BezierCurve>() != nullptr ||
           curve.as<LineCurve>() != nullptr || curve.as<SubdivisionCurve>() != nullptr;
}

std::vector<Interval> smoothPieces(const Curve& curve, const Interval& part) {
    std::vector<double> breaks = breaksOf(curve, part);
    tidy(breaks, part);
    breaks.push_back(part.end);
    const double longest = isPiecewiseRational(curve)
                               ? std::numeric_limits<double>::infinity()
                               : domain(curve).length() / piecesOfDomain;
    std::vector<Interval> pieces;
    double start = part.start;
    for (const double end : breaks) {
        addPieces({start, end}, longest, pieces);
        start = end;
    }
    return pieces;
}

std::vector<Interval> smoothPieces(const Curve& curve) {
    return smoothPieces(curve, domain(curve));
}

}  // namespace knotwork
