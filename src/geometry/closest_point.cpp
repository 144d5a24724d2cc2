#include "geometry/closest_point.hpp"

#include "geometry/checks.hpp"
#include "geometry/smooth_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

namespace knotwork {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::size_t terms = 7;
/// Pieces are halved so often in all, which only a curve without derivatives comes near to.
constexpr int mostHalvings = 100'000;

using Series = std::array<double, terms>;
using Rows = std::array<Vec3, terms>;

/// f = ±|C − p|² up to a constant, as |Q|² − 2 Q·q with Q = C − o, q = p − o: the origin o is p
/// itself where p is near, and in the midst of the curve where it is far away and squares of
/// distances would hide the curve.
class Objective {
public:
    Objective(const Curve& curve, const Vec3& p, double sign)
        : curve_(curve), p_(p), sign_(sign) {
        const Interval whole = domain(curve);
        constexpr std::size_t samples = 9;
        std::array<Vec3, samples> points;
        Vec3 sum(0);
        for (std::size_t i = 0; i < samples; ++i) {
            points[i] = pointAt(curve, uniformParameter(whole, i, samples));
            sum += points[i];
            reach_ = std::max(reach_, glm::length(points[i]));
        }
        const Vec3 middle = sum / static_cast<double>(samples);
        for (const Vec3& point : points) size_ = std::max(size_, glm::length(point - middle));
        origin_ = glm::length(p - middle) > 8 * size_ ? middle : p;
        q_ = p - origin_;
    }

    /// f and its derivatives from those of the curve.
    [[nodiscard]] Series of(const Rows& rows) const noexcept {
        Rows q = rows;
        q[0] -= origin_;
        Series f{};
        for (std::size_t k = 0; k < terms; ++k) {
            double binomial = 1;
            double sum = -2 * glm::dot(q[k], q_);
            for (std::size_t j = 0; j <= k; ++j) {
                sum += binomial * glm::dot(q[j], q[k - j]);
                binomial = binomial * static_cast<double>(k - j) / static_cast<double>(j + 1);
            }
            f[k] = sign_ * sum;
        }
        return f;
    }

    [[nodiscard]] Series at(double t, Side side, Vec3& point) const noexcept {
        Rows rows;
        evaluate(curve_, t, side, rows);
        point = rows[0];
        return of(rows);
    }

    /// How far rounding may have moved f at a point of this distance.
    [[nodiscard]] double rounding(double distance) const noexcept {
        const double moved = epsilon * reach_;
        const double squares = origin_ == p_ ? distance * distance : size_ * (size_ + distance);
        return 8 * (epsilon * squares + moved * (distance + moved));
    }

    [[nodiscard]] const Curve& curve() const noexcept { return curve_; }
    [[nodiscard]] double distance(const Vec3& point) const noexcept {
        return glm::length(point - p_);
    }

private:
    const Curve& curve_;
    Vec3 p_;
    double sign_;
    Vec3 origin_{0};
    Vec3 q_{0};
    double reach_ = 0;
    double size_ = 0;
};

struct Probe {
    double t;
    Series f;
};

/// Σ |f^(k)| r^(k−from)/(k−from)! over k > from, the last once more for what comes after it.
double variation(const Series& f, std::size_t from, double r) noexcept {
    double power = 1;
    double sum = 0;
    for (std::size_t k = from + 1; k < terms; ++k) {
        power *= r / static_cast<double>(k - from);
        sum += std::abs(f[k]) * power * (k + 1 == terms ? 2 : 1);
    }
    return std::isfinite(sum) ? sum : infinite;
}

/// A part of a smooth piece: what f and f″ can come down to on it. The infinities of curves that
/// have no derivatives come out as a bound that rules nothing out.
struct Stretch {
    Probe start;
    Probe middle;
    Probe end;
    double least = infinite;
    double leastSecond = infinite;

    /// `shortLength` is how long a stretch may be for its probes to stand for it where it has no
    /// derivatives (beside a vertical tangent of a root they overflow).
    Stretch(const Probe& a, const Probe& m, const Probe& b, double shortLength) noexcept
        : start(a), middle(m), end(b) {
        const double r = (b.t - a.t) / 4;
        for (const Probe* at : {&a, &m, &b}) {
            least = lower(least, at->f[0] - variation(at->f, 0, r));
            leastSecond = lower(leastSecond, at->f[2] - variation(at->f, 2, r));
        }
        const double excess = distrust(a, m, r) + distrust(m, b, r);
        least -= 8 * r * r * excess;
        leastSecond -= excess;
        if (std::isnan(least)) least = -infinite;
        if (least == -infinite && b.t - a.t <= shortLength) {
            const auto [low, high] = std::minmax({a.f[0], m.f[0], b.f[0]});
            least = low - 4 * (high - low);
        }
    }

    /// What is no number bounds nothing.
    static double lower(double a, double b) noexcept {
        return std::isnan(b) ? -infinite : std::min(a, b);
    }

    /// By how much more f″ differs between two probes than their higher derivatives allow: the
    /// curve is less smooth there than its pieces promise.
    static double distrust(const Probe& a, const Probe& b, double r) noexcept {
        const double allowed = variation(a.f, 2, r) + variation(b.f, 2, r);
        const double excess = 2 * (std::abs(b.f[2] - a.f[2]) - allowed);
        return excess > 0 ? excess : 0;
    }

    [[nodiscard]] bool convex() const noexcept { return leastSecond > 0; }
    [[nodiscard]] bool divisible() const noexcept {
        return end.t - start.t > 8 * epsilon * std::max(std::abs(start.t), std::abs(end.t)) &&
               end.t - start.t > 1e-300;
    }
    /// For a queue that gives the least bound first, and of equal ones the first on the curve.
    friend bool operator<(const Stretch& a, const Stretch& b) noexcept {
        return a.least != b.least ? a.least > b.least : a.start.t > b.start.t;
    }
};

class Search {
public:
    Search(const Curve& curve, const Vec3& p, double sign)
        : objective_(curve, p, sign), shortLength_(0x1p-40 * domain(curve).length()) {}

    [[nodiscard]] PointOnCurve run() {
        for (const Interval& piece : smoothPieces(objective_.curve())) {
            const Probe start = probe(piece.start, Side::right);
            queue_.push(between(start, probe(piece.end, Side::left)));
        }
        for (int halvings = 0; !queue_.empty() && halvings < mostHalvings; ++halvings) {
            const Stretch top = queue_.top();
            if (top.least >= best_ - objective_.rounding(found_.distance)) break;
            queue_.pop();
            if (top.convex()) {
                settle(top);
            } else if (top.divisible()) {
                push(between(top.start, top.middle));
                push(between(top.middle, top.end));
            }
        }
        return found_;
    }

private:
    [[nodiscard]] Probe probe(double t, Side side) {
        Vec3 point;
        const Probe made{t, objective_.at(t, side, point)};
        const double f = made.f[0];
        if (!std::isfinite(f)) return made;
        const double slack = best_ < infinite ? objective_.rounding(found_.distance) : 0;
        if (f < best_ - slack || (f <= best_ + slack && t < found_.t) || best_ == infinite) {
            found_ = {t, point, objective_.distance(point)};
            best_ = f;
        }
        return made;
    }

    [[nodiscard]] Stretch between(const Probe& a, const Probe& b) {
        return {a, probe(a.t + (b.t - a.t) / 2, Side::right), b, shortLength_};
    }

    void push(const Stretch& stretch) {
        if (stretch.least < best_ - objective_.rounding(found_.distance)) queue_.push(stretch);
    }

    /// The one minimum where f is convex; at an end it has been seen.
    void settle(const Stretch& on) {
        if (on.start.f[1] >= 0 || on.end.f[1] <= 0) return;
        double low = on.start.t;
        double high = on.end.t;
        Probe at = on.middle;
        for (int i = 0; i < 100; ++i) {
            (at.f[1] < 0 ? low : high) = at.t;
            const double newton = at.t - at.f[1] / at.f[2];
            const double next = low <= newton && newton <= high ? newton : low + (high - low) / 2;
            const double step = std::abs(next - at.t);
            Vec3 point;
            at = {next, objective_.at(next, Side::right, point)};
            if (step <= 2 * epsilon * std::abs(next) || step < 1e-300) break;
        }
        accept(at);
    }

    /// As probe(), but what Newton's method found is preferred to the samples that are as good: at
    /// the minimum f is flat, and only its slope tells parameters apart.
    void accept(const Probe& at) {
        const double slack = objective_.rounding(found_.distance);
        const bool same = at.f[0] <= best_ + slack;
        const bool beside = same && std::abs(at.t - found_.t) <=
                                        1e-6 * domain(objective_.curve()).length();
        if (at.f[0] < best_ - slack || (same && at.t < found_.t) || beside) {
            Vec3 point;
            static_cast<void>(objective_.at(at.t, Side::right, point));
            found_ = {at.t, point, objective_.distance(point)};
            best_ = at.f[0];
        }
    }

    Objective objective_;
    double shortLength_;
    std::priority_queue<Stretch> queue_;
    PointOnCurve found_;
    double best_ = infinite;
};

}  // namespace

Result<PointOnCurve> closestPoint(const Curve& curve, const Vec3& p) {
    for (int axis = 0; axis < 3; ++axis) {
        const std::string path = indexed("p", static_cast<std::size_t>(axis));
        if (!std::isfinite(p[axis])) {
            return refuse(Code::notFinite, path,
                          "The coordinate is " + formatNumber(p[axis]) + "; give a finite number.");
        }
        if (std::abs(p[axis]) > largestCoordinate) {
            return refuse(Code::outOfRange, path,
                          "The coordinate is " + formatNumber(p[axis]) +
                              "; coordinates lie within ±1e12.");
        }
    }
    return Search(curve, p, 1).run();
}

PointOnCurve farthestPoint(const Curve& curve, const Vec3& p) {
    return Search(curve, p, -1).run();
}

}  // namespace knotwork
