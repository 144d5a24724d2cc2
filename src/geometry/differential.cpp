#include "geometry/differential.hpp"

#include "geometry/smooth_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace knotwork {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
/// Derivatives count as zero below so many ulp of what they are on this part of the curve.
constexpr double noise = 64;
/// Rows that are looked at where the first ones vanish: limits of curvature up to C′ of order 6.
constexpr std::size_t mostRows = 13;
constexpr double windowsOfDomain = 32;

using Rows = std::array<Vec3, mostRows>;

struct Place {
    double t;
    Side side;
};

/// Without squares, which are 0 for the derivatives of a very small curve.
double lengthOf(const Vec3& v) noexcept { return std::hypot(v.x, v.y, v.z); }

Vec3 unit(const Vec3& v) noexcept { return v / lengthOf(v); }

/// The part of the curve around a parameter from which the sizes of derivatives are taken: the span
/// between two knots, or a small part of the domain.
Interval windowAround(const Curve& curve, const Place& at) {
    const Interval whole = domain(curve);
    const double reach = whole.length() / windowsOfDomain;
    Interval window{std::max(whole.start, at.t - reach), std::min(whole.end, at.t + reach)};
    const std::span<const double> knots =
        std::visit([](const auto& kind) { return kind.breaks(); }, curve.kind());
    const auto above = at.side == Side::right ? std::upper_bound(knots.begin(), knots.end(), at.t)
                                              : std::lower_bound(knots.begin(), knots.end(), at.t);
    const bool polynomial =
        curve.as<BsplineCurve>() != nullptr || curve.as<BezierCurve>() != nullptr;
    if (above != knots.begin() && (polynomial || *(above - 1) > window.start)) {
        window.start = std::max(whole.start, *(above - 1));
    }
    if (above != knots.end() && (polynomial || *above < window.end)) {
        window.end = std::min(whole.end, *above);
    }
    return window.length() > 0 ? window : whole;
}

/// Below which size the derivatives of each order are nothing but rounding.
class Sizes {
public:
    Sizes(const Curve& curve, const Place& at, std::span<const Vec3> here, std::size_t rows)
        : window_(windowAround(curve, at)) {
        add(here);
        Rows found;
        const std::span<Vec3> some(found.data(), rows);
        for (const double share : {0.07, 0.5, 0.93}) {
            evaluate(curve, window_.start + share * window_.length(), Side::right, some);
            add(some);
        }
        const double size = 2 * epsilon * std::abs(at.t);
        double factor = 1;
        for (std::size_t k = 1; k < rows; ++k) {
            factor *= static_cast<double>(k) / window_.length();
            const double ofParameter = k + 1 < rows ? size * largest_[k + 1] : 0;
            zero_[k] = noise * epsilon * (largest_[k] + factor * largest_[0]) + ofParameter;
        }
    }

    [[nodiscard]] bool vanishes(const Vec3& v, std::size_t order) const noexcept {
        return !(lengthOf(v) > zero_[order]) || !isFinite(v);
    }
    [[nodiscard]] const Interval& window() const noexcept { return window_; }

private:
    void add(std::span<const Vec3> rows) noexcept {
        for (std::size_t k = 0; k < rows.size(); ++k) {
            if (isFinite(rows[k])) largest_[k] = std::max(largest_[k], lengthOf(rows[k]));
        }
    }

    Interval window_;
    std::array<double, mostRows> largest_{};
    std::array<double, mostRows> zero_{};
};

Vec3 across(const Vec3& v, const Vec3& tangent) noexcept {
    return v - glm::dot(v, tangent) * tangent;
}

/// What the derivatives at one place say about the curve next to it.
struct Local {
    Vec3 point{0};
    Vec3 tangent{1, 0, 0};
    bool hasTangent = false;
    Vec3 normal{0};  // the limit of the direction of curvature, as far as there is one
    bool hasNormal = false;
    Vec3 curvature{0};  // as a vector
    double torsion = 0;
};

double parity(std::size_t order, Side side) noexcept {
    return side == Side::left && order % 2 == 1 ? -1 : 1;
}

/// The direction in which the curve leaves the place, to the side: that of the first derivative
/// that does not vanish; its order, or 0.
std::size_t findTangent(std::span<const Vec3> rows, const Sizes& sizes, Side side, Local& local) {
    for (std::size_t m = 1; m < rows.size(); ++m) {
        if (!isFinite(rows[m])) return 0;
        if (sizes.vanishes(rows[m], m)) continue;
        local.tangent = parity(m - 1, side) * unit(rows[m]);
        local.hasTangent = true;
        return m;
    }
    return 0;
}

/// With C ~ a x^m/m! along the tangent, the deviation b x^k/k! across it has, for k = 2m, the
/// curvature 2 (b/k!) / (a/m!)²; for k < 2m an infinite one and for k > 2m none.
void findNormal(std::span<const Vec3> rows, const Sizes& sizes, Side side, std::size_t m,
                Local& local) {
    double factor = 1;  // (m!)² / k!
    for (std::size_t k = 2; k <= m; ++k) factor *= static_cast<double>(k);
    for (std::size_t k = m + 1; k < rows.size(); ++k) {
        factor /= static_cast<double>(k);
        const Vec3 sideways = across(rows[k], local.tangent);
        if (sizes.vanishes(sideways, k)) continue;
        local.normal = parity(k, side) * unit(sideways);
        local.hasNormal = true;
        if (k == 2 * m) {
            const double speed = lengthOf(rows[m]);
            local.curvature = 2 * factor * (sideways / speed) / speed;
        }
        return;
    }
}

double torsionOf(std::span<const Vec3> rows) noexcept {
    const double speed = lengthOf(rows[1]);
    const Vec3 turning = glm::cross(rows[1] / speed, rows[2]);
    const double squared = glm::dot(turning, turning);
    return squared > 0 ? glm::dot(turning, rows[3]) / squared / speed : 0;
}

Local lookAt(const Curve& curve, const Place& at) {
    Rows found;
    Local local;
    for (const std::size_t count : {std::size_t{4}, mostRows}) {
        const std::span<Vec3> rows(found.data(), count);
        evaluate(curve, at.t, at.side, rows);
        const Sizes sizes(curve, at, rows, count);
        local = {};
        local.point = rows[0];
        const std::size_t m = findTangent(rows, sizes, at.side, local);
        if (m == 0) continue;
        // Of order m = 1 the curvature is that of k = 2, at which even four rows have come to.
        findNormal(rows, sizes, at.side, m, local);
        if (m == 1 && glm::dot(local.curvature, local.curvature) > 0) {
            local.torsion = torsionOf(rows);
        }
        if (m == 1 && local.hasNormal) break;
    }
    return local;
}

/// The first direction of the curve away from a place where all derivatives vanish or are infinite:
/// that of C′ near by, on the side first, then anywhere.
Vec3 tangentNearby(const Curve& curve, const Place& at) {
    const Interval window = windowAround(curve, at);
    const double forward = at.side == Side::right ? 1 : -1;
    const auto tangentAt = [&](double t) {
        const Local local = lookAt(curve, {t, Side::right});
        return local.hasTangent ? std::optional(local.tangent) : std::nullopt;
    };
    for (const double direction : {forward, -forward}) {
        for (const int halvings : {30, 20, 10, 5, 2, 1}) {
            const double t = at.t + direction * std::ldexp(window.length(), -halvings);
            if (t <= window.start || t >= window.end) continue;
            if (const auto tangent = tangentAt(t)) return *tangent;
        }
    }
    const std::vector<Interval> pieces = smoothPieces(curve);
    std::optional<Vec3> nearest;
    double distance = std::numeric_limits<double>::infinity();
    for (const Interval& piece : pieces) {
        const double t = piece.start + piece.length() / 2;
        const double away = std::abs(t - at.t);
        if (away >= distance) continue;
        if (const auto tangent = tangentAt(t)) {
            nearest = tangent;
            distance = away;
        }
    }
    return nearest.value_or(Vec3(1, 0, 0));
}

Vec3 tangentAt(const Curve& curve, const Place& at) {
    const Local local = lookAt(curve, at);
    return local.hasTangent ? local.tangent : tangentNearby(curve, at);
}

/// A direction at right angles to the tangent that depends on it alone; for a tangent in the plane
/// z = 0 the left normal.
Vec3 anyNormal(const Vec3& tangent) noexcept {
    const Vec3 sizes = glm::abs(tangent);
    Vec3 axis(0, 0, 1);
    if (sizes.z > sizes.x || sizes.z > sizes.y) {
        axis = sizes.x <= sizes.y ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    }
    return glm::normalize(glm::cross(axis, tangent));
}

/// v after the least rotation that takes one tangent to another; unchanged where it turns back.
Vec3 carried(const Vec3& v, const Vec3& from, const Vec3& to) noexcept {
    const Vec3 axis = glm::cross(from, to);
    const double cosine = glm::dot(from, to);
    if (1 + cosine < 1e-12) return v;
    return cosine * v + glm::cross(axis, v) + axis * (glm::dot(axis, v) / (1 + cosine));
}

/// The normal on a straight part, brought there over the pieces from where one is known.
class Carrier {
public:
    Carrier(const Curve& curve, const Place& at, const Vec3& tangent)
        : curve_(curve), tangent_(tangent), pieces_(smoothPieces(curve)) {
        const auto starts = [](double t, const Interval& piece) { return t < piece.start; };
        const auto ends = [](const Interval& piece, double t) { return piece.end < t; };
        const auto found =
            at.side == Side::right
                ? std::upper_bound(pieces_.begin(), pieces_.end(), at.t, starts) - 1
                : std::lower_bound(pieces_.begin(), pieces_.end(), at.t, ends);
        own_ = std::clamp<std::ptrdiff_t>(found - pieces_.begin(), 0, last());
    }

    [[nodiscard]] Vec3 normal() const {
        for (std::ptrdiff_t i = own_ - 1; i >= 0; --i) {
            const Local end = lookAt(curve_, {piece(i).end, Side::left});
            if (bends(piece(i)) && end.hasNormal) return forwards(i + 1, end.tangent, end.normal);
        }
        for (std::ptrdiff_t i = own_ + 1; i <= last(); ++i) {
            const Local start = lookAt(curve_, {piece(i).start, Side::right});
            if (bends(piece(i)) && start.hasNormal) {
                return backwards(i - 1, start.tangent, start.normal);
            }
        }
        const Vec3 first = tangentAt(curve_, {piece(0).start, Side::right});
        return forwards(0, first, anyNormal(first));
    }

private:
    [[nodiscard]] std::ptrdiff_t last() const noexcept { return std::ssize(pieces_) - 1; }
    [[nodiscard]] const Interval& piece(std::ptrdiff_t i) const noexcept {
        return pieces_[static_cast<std::size_t>(i)];
    }

    [[nodiscard]] bool bends(const Interval& part) const {
        return lookAt(curve_, {part.start + 0.41 * part.length(), Side::right}).hasNormal;
    }

    /// From the start of piece i, where a normal belongs to a tangent, to the place.
    [[nodiscard]] Vec3 forwards(std::ptrdiff_t i, Vec3 tangent, Vec3 normal) const {
        for (; i < own_; ++i) {
            for (const Place& at : {Place{piece(i).start, Side::right}, {piece(i).end, Side::left}}) {
                const Vec3 next = tangentAt(curve_, at);
                normal = carried(normal, tangent, next);
                tangent = next;
            }
        }
        return carried(normal, tangent, tangent_);
    }

    [[nodiscard]] Vec3 backwards(std::ptrdiff_t i, Vec3 tangent, Vec3 normal) const {
        for (; i > own_; --i) {
            for (const Place& at : {Place{piece(i).end, Side::left}, {piece(i).start, Side::right}}) {
                const Vec3 next = tangentAt(curve_, at);
                normal = carried(normal, tangent, next);
                tangent = next;
            }
        }
        return carried(normal, tangent, tangent_);
    }

    const Curve& curve_;
    Vec3 tangent_;
    std::vector<Interval> pieces_;
    std::ptrdiff_t own_ = 0;
};

double finite(double value) noexcept {
    constexpr double largest = std::numeric_limits<double>::max();
    return std::isnan(value) ? 0 : std::clamp(value, -largest, largest);
}

/// On the curve itself: past the seam of a closed one, and inside at the ends of any other.
Place placeOn(const Curve& curve, double t, Side side) noexcept {
    const Interval whole = domain(curve);
    if (isClosed(curve)) {
        if (t == whole.end && side == Side::right) return {whole.start, side};
        if (t == whole.start && side == Side::left) return {whole.end, side};
        return {t, side};
    }
    if (t == whole.end) return {t, Side::left};
    return {t, t == whole.start ? Side::right : side};
}

}  // namespace

Frame frameAt(const Curve& curve, double t, Side side) {
    const Place at = placeOn(curve, t, side);
    const Local local = lookAt(curve, at);
    Frame frame;
    frame.point = local.point;
    frame.tangent = local.hasTangent ? local.tangent : tangentNearby(curve, at);
    if (dimension(curve) == 2) {
        frame.normal = {-frame.tangent.y, frame.tangent.x, 0};
        frame.curvature = finite(glm::dot(local.curvature, frame.normal));
        return frame;
    }
    const Vec3 normal = local.hasTangent && local.hasNormal
                            ? local.normal
                            : Carrier(curve, at, frame.tangent).normal();
    frame.normal = glm::normalize(across(normal, frame.tangent));
    frame.binormal = glm::cross(frame.tangent, frame.normal);
    frame.curvature = finite(glm::length(local.curvature));
    frame.torsion = finite(local.torsion);
    return frame;
}

std::optional<Vec3> centreOfCurvature(const Frame& frame) noexcept {
    if (frame.curvature == 0) return std::nullopt;
    const Vec3 centre = frame.point + frame.normal / frame.curvature;
    return isFinite(centre) ? std::optional(centre) : std::nullopt;
}

Vec3 combPoint(const Frame& frame, double scale) noexcept {
    return frame.point - scale * frame.curvature * frame.normal;
}

}  // namespace knotwork
