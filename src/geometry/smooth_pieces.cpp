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

void addBreaks(const Curve& curve, const Interval& part, std::vector<double>& breaks);

/// The knots of a local curve's source inside a part of the blending curve's parameter, which lies
/// `shift` before the local's own.
void addBreaksOf(const LocalCurve& local, const Interval& part, double shift,
                 std::vector<double>& breaks) {
    const auto into = [&](double t) { return local.rate() * (t - shift) + local.shift(); };
    std::vector<double> own;
    addBreaks(local.source(), {into(part.start), into(part.end)}, own);
    for (const double s : own) breaks.push_back((s - local.shift()) / local.rate() + shift);
}

/// Inside one turn of a closed blending curve, or anywhere of an open one.
void addBreaksOf(const BlendingCurve& blend, const Interval& part, double turn,
                 std::vector<double>& breaks) {
    const std::vector<double>& knots = blend.knots();
    const std::vector<LocalCurve>& locals = blend.locals();
    std::vector<double> corners = kinks(blend.blend());
    if (corners.size() * knots.size() > mostKinks) corners.clear();
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        const double h = knots[i + 1] - knots[i];
        if (!(h > 0)) continue;
        const bool wraps = blend.closed() && i + 1 == locals.size();
        const bool before = !blend.closed() && i == 0;
        const bool after = !blend.closed() && i + 2 == knots.size();
        const Interval span{before ? part.start : std::max(part.start, knots[i] + turn),
                            after ? part.end : std::min(part.end, knots[i + 1] + turn)};
        if (!(span.length() > 0)) continue;
        for (const double x : corners) breaks.push_back(knots[i] + x * h + turn);
        addBreaksOf(locals[i], span, turn, breaks);
        const double period = knots.back() - knots.front();
        addBreaksOf(locals[wraps ? 0 : i + 1], span, wraps ? turn + period : turn, breaks);
    }
}

void addBreaks(const Curve& curve, const Interval& part, std::vector<double>& breaks) {
    const std::vector<double> own = breakParameters(curve, part);
    breaks.insert(breaks.end(), own.begin(), own.end());
    const auto* blend = curve.as<BlendingCurve>();
    if (blend == nullptr) return;
    if (!blend->closed()) return addBreaksOf(*blend, part, 0, breaks);
    const Interval whole = blend->domain();
    const double period = whole.length();
    const double last = std::floor((part.end - whole.start) / period);
    for (double k = std::floor((part.start - whole.start) / period); k <= last; ++k) {
        addBreaksOf(*blend, part, k * period, breaks);
    }
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

std::vector<Interval> smoothPieces(const Curve& curve, const Interval& part) {
    std::vector<double> breaks;
    addBreaks(curve, part, breaks);
    tidy(breaks, part);
    breaks.push_back(part.end);
    const bool polynomial = curve.as<BsplineCurve>() != nullptr;
    const double longest = polynomial ? std::numeric_limits<double>::infinity()
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
