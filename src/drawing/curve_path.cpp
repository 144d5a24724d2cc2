#include "drawing/curve_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace knotwork::drawing {

namespace {

constexpr int notPolynomial = 4;
constexpr std::size_t mostSteps = std::size_t{1} << 15;
/// Enough for a root at an end, which is half as steep after two halvings.
constexpr int deepest = 40;
/// Where a cubic is compared with its curve: not where a wave with a whole number of half periods
/// hides.
constexpr std::array looks{0.137, 0.293, 0.5, 0.711, 0.859};
constexpr std::size_t rowCount = 5;

int degreeOf(const BsplineCurve& curve) noexcept {
    return curve.rational() ? notPolynomial : std::min(curve.degree(), notPolynomial);
}
int degreeOf(const BezierCurve& curve) noexcept {
    return curve.rational() ? notPolynomial
                            : static_cast<int>(std::min<std::size_t>(curve.degree(), notPolynomial));
}
int degreeOf(const LineCurve&) noexcept { return 1; }
int degreeOf(const SubdivisionCurve&) noexcept { return 1; }
template <class Other>
int degreeOf(const Other&) noexcept { return notPolynomial; }

double distanceInPicture(const Vec3& a, const Vec3& b) noexcept {
    return std::hypot(a.x - b.x, a.y - b.y);
}

/// A place of the curve with what a cubic needs to begin or end there.
struct End {
    double t = 0;
    Vec3 point{0.0};
    Vec3 derivative{0.0};
};

struct Cubic {
    Vec3 p0, p1, p2, p3;

    [[nodiscard]] Vec3 at(double s) const noexcept {
        const double r = 1 - s;
        return r * r * r * p0 + 3 * r * r * s * p1 + 3 * r * s * s * p2 + s * s * s * p3;
    }
};

Cubic cubicBetween(const End& a, const End& b) noexcept {
    const double third = (b.t - a.t) / 3;
    return {a.point, a.point + third * a.derivative, b.point - third * b.derivative, b.point};
}

class PathMaker {
public:
    PathMaker(const CurvePart& part, double tolerance) : part_(part), tolerance_(tolerance) {}

    std::vector<PathStep> make() {
        const int degree = polynomialDegree(part_.curve);
        std::vector<double> stops = breakParameters(part_.curve, part_.part);
        stops.push_back(part_.part.end);
        double from = part_.part.start;
        for (const double to : stops) {
            const End a = endAt(from, Side::right);
            const End b = endAt(to, Side::left);
            moveTo(a.point);
            if (degree == 1) line(b.point);
            else if (degree < notPolynomial) cubic(cubicBetween(a, b));
            else approach(a, b, deepest);
            from = to;
        }
        return std::move(steps_);
    }

private:
    [[nodiscard]] End endAt(double t, Side side) const noexcept {
        std::array<Vec3, 2> rows{};
        evaluate(part_.curve, t, side, rows);
        return {t, part_.placement.point(rows[0]), part_.placement.vector(rows[1])};
    }

    /// Whether the cubic is the curve to the tolerance: by what is seen in some places, and by what
    /// the fourth derivative there says about the places between.
    [[nodiscard]] bool fits(const End& a, const End& b, const Cubic& cubic) const noexcept {
        const double h = b.t - a.t;
        for (const double s : looks) {
            std::array<Vec3, rowCount> rows{};
            evaluate(part_.curve, a.t + s * h, Side::right, rows);
            const Vec3 off = cubic.at(s) - part_.placement.point(rows[0]);
            const Vec3 fourth = part_.placement.vector(rows[4]);
            const double bound = h * h * h * h / 384 * std::hypot(fourth.x, fourth.y);
            if (!(std::hypot(off.x, off.y) <= tolerance_) || !(bound <= 2 * tolerance_)) return false;
        }
        return true;
    }

    void approach(const End& a, const End& b, int depth) {
        const Cubic whole = cubicBetween(a, b);
        if (fits(a, b, whole)) return cubic(whole);
        const double middle = a.t + (b.t - a.t) / 2;
        if (depth == 0 || steps_.size() >= mostSteps || !(a.t < middle && middle < b.t)) {
            return line(b.point);
        }
        const End between = endAt(middle, Side::right);
        approach(a, between, depth - 1);
        approach(between, b, depth - 1);
    }

    /// Where the path stands already it goes on.
    void moveTo(const Vec3& p) {
        if (!isFinite(p)) return;
        if (!steps_.empty() && distanceInPicture(steps_.back().end, p) <= tolerance_ / 1000) return;
        steps_.push_back({PathStep::Kind::move, {}, {}, p});
    }

    void line(const Vec3& p) {
        if (!isFinite(p)) return;
        const auto kind = steps_.empty() ? PathStep::Kind::move : PathStep::Kind::line;
        steps_.push_back({kind, {}, {}, p});
    }

    void cubic(const Cubic& c) {
        if (isFinite(c.p1) && isFinite(c.p2)) {
            steps_.push_back({PathStep::Kind::cubic, c.p1, c.p2, c.p3});
        } else {
            line(c.p3);
        }
    }

    const CurvePart& part_;
    double tolerance_;
    std::vector<PathStep> steps_;
};

}  // namespace

int polynomialDegree(const Curve& curve) noexcept {
    return std::visit([](const auto& kind) { return degreeOf(kind); }, curve.kind());
}

std::vector<PathStep> curvePath(const CurvePart& part, double tolerance) {
    return PathMaker(part, tolerance).make();
}

}  // namespace knotwork::drawing
