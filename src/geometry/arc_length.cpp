#include "geometry/arc_length.hpp"

#include "geometry/quadrature.hpp"
#include "geometry/smooth_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace knotwork {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
/// Two rules agree when they differ by this much of the whole length. At a cusp the better one is
/// about four times closer than that, elsewhere far closer.
constexpr double agreement = 1e-14;
/// Rounding of C′ that no halving removes: so many ulp of the coordinates over each smooth piece.
constexpr double noise = 16;
/// Beyond so many panels none is halved. A curve of 10⁵ spans takes as many.
constexpr std::size_t mostPanels = std::size_t{1} << 20;
/// A length a caller computed may exceed the total by this share of it.
constexpr double excess = 1e-12;

/// The speed at the nodes of a rule, its integral, and how large the coordinates are.
struct Panel {
    double start;
    double end;
    double integral;
    double disagreement;
    double reach;
    double pieceLength;

    [[nodiscard]] double length() const noexcept { return end - start; }
};

template <std::size_t N>
struct Nodes {
    std::array<double, N> ts;
    std::array<double, 6 * N> xyz;

    [[nodiscard]] double speed(std::size_t i) const noexcept {
        const double* slope = xyz.data() + 3 * (N + i);
        const double found = glm::length(Vec3(slope[0], slope[1], slope[2]));
        return std::isfinite(found) ? found : 0;
    }
    [[nodiscard]] double reach() const noexcept {
        double largest = 0;
        for (std::size_t i = 0; i < 3 * N; ++i) {
            if (std::isfinite(xyz[i])) largest = std::max(largest, std::abs(xyz[i]));
        }
        return largest;
    }
};

/// ∫ |C′| by N nodes, which are left in `nodes`.
template <std::size_t N>
double integrateSpeed(const CurveSampler& sampler, double a, double b, Nodes<N>& nodes) noexcept {
    constexpr auto rule = gaussNodes<N>();
    for (std::size_t i = 0; i < N; ++i) nodes.ts[i] = (a + b) / 2 + (b - a) / 2 * rule[i].x;
    sampler.at(nodes.ts, 1, nodes.xyz);
    double sum = 0;
    for (std::size_t i = 0; i < N; ++i) sum += rule[i].weight * nodes.speed(i);
    return (b - a) / 2 * sum;
}

Panel panelOf(const CurveSampler& sampler, double a, double b, double pieceLength) noexcept {
    Nodes<16> fine;
    Nodes<8> coarse;
    const double better = integrateSpeed(sampler, a, b, fine);
    const double other = integrateSpeed(sampler, a, b, coarse);
    return {a, b, better, std::abs(better - other), fine.reach(), pieceLength};
}

bool agrees(const Panel& panel, double whole) noexcept {
    const double rounding = noise * epsilon * panel.reach * panel.length() / panel.pieceLength;
    return panel.disagreement <= agreement * whole + rounding;
}

/// Whether there is a parameter inside at which to cut.
bool divisible(const Panel& panel) noexcept {
    const double size = std::max(std::abs(panel.start), std::abs(panel.end));
    return panel.length() > 4 * epsilon * size && panel.length() > 1e-300;
}

/// The panels of one smooth piece after the other, halved until they agree, ascending.
std::vector<Panel> refined(const CurveSampler& sampler, std::vector<Panel> open) {
    double whole = 0;
    for (const Panel& panel : open) whole += panel.integral;
    std::reverse(open.begin(), open.end());
    std::vector<Panel> done;
    while (!open.empty()) {
        const Panel top = open.back();
        open.pop_back();
        const bool full = open.size() + done.size() >= mostPanels;
        if (agrees(top, whole) || full || !divisible(top)) {
            done.push_back(top);
            continue;
        }
        const double middle = (top.start + top.end) / 2;
        open.push_back(panelOf(sampler, middle, top.end, top.pieceLength));
        open.push_back(panelOf(sampler, top.start, middle, top.pieceLength));
    }
    return done;
}

Error outside(const char* path, double given, const Interval& allowed, const char* what) {
    return refuse(Code::outOfRange, path,
                  std::string(what) + formatNumber(given) + " lies outside [" +
                      formatNumber(allowed.start) + ", " + formatNumber(allowed.end) + "].");
}

Result<double> checkEnd(const Curve& curve, double t, const char* path) {
    if (!std::isfinite(t)) {
        return refuse(Code::notFinite, path,
                      "The parameter is " + formatNumber(t) + "; give a finite number.");
    }
    if (isClosed(curve) || domain(curve).contains(t)) return t;
    return outside(path, t, domain(curve), "The parameter ");
}

}  // namespace

ArcLength::ArcLength(const Curve& curve) : curve_(curve), sampler_(curve) {
    std::vector<Panel> pieces;
    for (const Interval& piece : smoothPieces(curve)) {
        pieces.push_back(panelOf(sampler_, piece.start, piece.end, piece.length()));
    }
    ends_.push_back(domain(curve).start);
    upTo_.push_back(0);
    double carried = 0;  // what the sum has lost to rounding so far (Kahan)
    for (const Panel& panel : refined(sampler_, std::move(pieces))) {
        const double added = panel.integral - carried;
        const double sum = upTo_.back() + added;
        carried = (sum - upTo_.back()) - added;
        ends_.push_back(panel.end);
        upTo_.push_back(sum);
    }
}

std::size_t ArcLength::panelAt(double t) const noexcept {
    const auto after = std::upper_bound(ends_.begin() + 1, ends_.end() - 1, t);
    return static_cast<std::size_t>(after - ends_.begin()) - 1;
}

double ArcLength::inPanel(double a, double b) const noexcept {
    Nodes<16> nodes;
    return a < b ? integrateSpeed(sampler_, a, b, nodes) : 0;
}

double ArcLength::between(double a, double b) const noexcept {
    const std::size_t first = panelAt(a);
    const std::size_t last = panelAt(b);
    if (first == last) return inPanel(a, b);
    const double head = a == ends_[first] ? upTo_[first + 1] - upTo_[first]
                                          : inPanel(a, ends_[first + 1]);
    const double tail = b == ends_[last + 1] ? upTo_[last + 1] - upTo_[last]
                                             : inPanel(ends_[last], b);
    return head + (upTo_[last] - upTo_[first + 1]) + tail;
}

double ArcLength::parameterAt(double s) const noexcept {
    const auto found = std::lower_bound(upTo_.begin() + 1, upTo_.end() - 1, s);
    const auto panel = static_cast<std::size_t>(found - upTo_.begin()) - 1;
    const double start = ends_[panel];
    const double wanted = s - upTo_[panel];
    const double length = upTo_[panel + 1] - upTo_[panel];
    if (wanted <= 0) return start;
    if (wanted >= length) return ends_[panel + 1];
    double low = start;
    double high = ends_[panel + 1];
    double t = low + (high - low) * (wanted / length);
    for (int i = 0; i < 100; ++i) {
        const double missing = wanted - inPanel(start, t);
        (missing > 0 ? low : high) = t;
        std::array<Vec3, 2> rows{};
        evaluate(curve_, t, Side::right, rows);
        const double newton = t + missing / glm::length(rows[1]);
        const double next = low <= newton && newton <= high ? newton : low + (high - low) / 2;
        const double step = std::abs(next - t);
        t = next;
        if (step <= 2 * epsilon * std::max(std::abs(t), high - low)) break;
    }
    return t;
}

Result<double> lengthBetween(const ArcLength& lengths, std::optional<double> a,
                             std::optional<double> b) {
    const Curve& curve = lengths.curve();
    const Interval whole = domain(curve);
    const auto from = checkEnd(curve, a.value_or(whole.start), "a");
    if (!from) return from;
    const auto to = checkEnd(curve, b.value_or(whole.end), "b");
    if (!to) return to;
    if (whole.contains(*from) && whole.contains(*to) && *from <= *to) {
        return lengths.between(*from, *to);
    }
    if (!isClosed(curve)) {
        return refuse(Code::outOfRange, "b",
                      "The end " + formatNumber(*to) + " lies before the beginning " +
                          formatNumber(*from) + "; give the smaller parameter first.");
    }
    double ahead = (*to - *from) / whole.length();
    if (ahead < 0) ahead += std::ceil(-ahead);
    const double start = parameterInDomain(curve, *from).value();
    const double end = parameterInDomain(curve, *to).value();
    const double turns = std::round(ahead - (end - start) / whole.length());
    const double part = start <= end ? lengths.between(start, end) : -lengths.between(end, start);
    return turns * lengths.total() + part;
}

Result<double> parameterAtLength(const ArcLength& lengths, double s) {
    if (!std::isfinite(s)) {
        return refuse(Code::notFinite, "s",
                      "The length is " + formatNumber(s) + "; give a finite number.");
    }
    const double total = lengths.total();
    const double slack = excess * total;
    if (-slack <= s && s <= total + slack) return lengths.parameterAt(std::clamp(s, 0.0, total));
    if (isClosed(lengths.curve()) && total > 0) {
        return lengths.parameterAt(std::clamp(s - std::floor(s / total) * total, 0.0, total));
    }
    return outside("s", s, {0, total}, "The length ");
}

}  // namespace knotwork
