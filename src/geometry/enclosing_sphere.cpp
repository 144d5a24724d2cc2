#include "geometry/enclosing_sphere.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace knotwork {

namespace {

constexpr double largestCoordinate = 1e12;
// A pivot smaller than that, of rows scaled to 1, has no digits left.
constexpr double smallestPivot = 1e-14;
// Below it fourth powers of distances lose digits to underflow; a power of two puts that right.
constexpr double smallestExtent = 1e-60;
constexpr int largestEnlargement = 1000;  // of the exponent: 2^1023 is the last finite one
// Less growth than that is rounding.
constexpr double growth = 1 + 1e-15;
// 1e5 points in a cube, on a sphere, a circle or a helix took 1 to 8 exchanges.
constexpr int mostExchanges = 500;

using Points = std::span<const Vec3>;

double squaredDistance(const Vec3& a, const Vec3& b) noexcept {
    const Vec3 between = a - b;
    return glm::dot(between, between);
}

struct Farthest {
    std::size_t index = 0;
    double distance = 0;
};

Farthest farthestFrom(const Vec3& center, Points points) noexcept {
    std::size_t index = 0;
    double largest = -1;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double square = squaredDistance(points[i], center);
        if (square > largest) {
            largest = square;
            index = i;
        }
    }
    return {index, std::sqrt(largest)};
}

// ---- The smallest sphere -----------------------------------------------------------------------

/// x of A x = b by elimination with pivots; nothing where A is singular.
std::optional<Vec3> solved(std::array<Vec3, 3> a, Vec3 b) noexcept {
    for (int i = 0; i < 3; ++i) {
        const double size = glm::length(a[static_cast<std::size_t>(i)]);
        if (!(size > 0)) return std::nullopt;
        a[static_cast<std::size_t>(i)] /= size;
        b[i] /= size;
    }
    for (int column = 0; column < 3; ++column) {
        int pivot = column;
        for (int i = column + 1; i < 3; ++i) {
            if (std::abs(a[static_cast<std::size_t>(i)][column]) >
                std::abs(a[static_cast<std::size_t>(pivot)][column])) {
                pivot = i;
            }
        }
        std::swap(a[static_cast<std::size_t>(column)], a[static_cast<std::size_t>(pivot)]);
        std::swap(b[column], b[pivot]);
        const Vec3& row = a[static_cast<std::size_t>(column)];
        if (!(std::abs(row[column]) > smallestPivot)) return std::nullopt;
        for (int i = column + 1; i < 3; ++i) {
            const double factor = a[static_cast<std::size_t>(i)][column] / row[column];
            a[static_cast<std::size_t>(i)] -= factor * row;
            b[i] -= factor * b[column];
        }
    }
    Vec3 x;
    for (int i = 2; i >= 0; --i) {
        const Vec3& row = a[static_cast<std::size_t>(i)];
        double rest = b[i];
        for (int j = i + 1; j < 3; ++j) rest -= row[j] * x[j];
        x[i] = rest / row[i];
    }
    return x;
}

/// Up to five of the points: those that hold the sphere, and one more.
struct Support {
    std::array<Vec3, 5> points{};
    std::size_t size = 0;

    void add(const Vec3& point) noexcept { points[size++] = point; }
    [[nodiscard]] Points all() const noexcept { return {points.data(), size}; }
};

/// The centre of the smallest sphere through one to four points: (p_i - p_0) · c = |p_i - p_0|² / 2
/// for the c in the space that they span, seen from p_0. Nothing where they do not span enough.
std::optional<Vec3> centerThrough(Points p) noexcept {
    if (p.size() == 1) return p[0];
    const Vec3 a = p[1] - p[0];
    if (p.size() == 2) return p[0] + a / 2.0;
    const Vec3 b = p[2] - p[0];
    const Vec3 c = p.size() == 4 ? p[3] - p[0] : glm::cross(a, b);
    const double third = p.size() == 4 ? glm::dot(c, c) / 2 : 0;
    const auto found = solved({a, b, c}, {glm::dot(a, a) / 2, glm::dot(b, b) / 2, third});
    if (!found) return std::nullopt;
    return p[0] + *found;
}

/// Those whose bits are set.
Support chosen(const Support& from, unsigned members) noexcept {
    Support subset;
    for (std::size_t i = 0; i < from.size; ++i) {
        if ((members >> i & 1U) != 0) subset.add(from.points[i]);
    }
    return subset;
}

struct Held {
    Sphere sphere;
    Support support;
};

/// The smallest sphere around up to five points. Each subset of at most four offers the centre of
/// its sphere; the smallest sphere around all of them is that of the best centre.
Held smallestAround(const Support& given) noexcept {
    Held best{{Vec3(0), -1}, {}};
    for (int size = 1; size <= 4; ++size) {
        for (unsigned members = 1; members < 1U << given.size; ++members) {
            if (std::popcount(members) != size) continue;
            const Support subset = chosen(given, members);
            const auto center = centerThrough(subset.all());
            if (!center || !isFinite(*center)) continue;
            const double radius = farthestFrom(*center, given.all()).distance;
            if (best.sphere.radius < 0 || radius < best.sphere.radius) {
                best = {{*center, radius}, subset};
            }
        }
    }
    return best;
}

Sphere minimalSphere(Points points) noexcept {
    Held held;
    held.support.add(points[farthestFrom(points[0], points).index]);
    held.sphere = {held.support.points[0], 0};
    Farthest outside = farthestFrom(held.sphere.center, points);
    for (int i = 0; i < mostExchanges && outside.distance > held.sphere.radius * growth; ++i) {
        Support five = held.support;
        five.add(points[outside.index]);
        const Held next = smallestAround(five);
        // What does not grow any more goes round in circles.
        if (!(next.sphere.radius > held.sphere.radius * growth)) break;
        held = next;
        outside = farthestFrom(held.sphere.center, points);
    }
    return {held.sphere.center, std::max(held.sphere.radius, outside.distance)};
}

// ---- Spheres that grow -------------------------------------------------------------------------

/// The smallest sphere around a sphere and a point outside of it.
Sphere grown(const Sphere& sphere, const Vec3& point, double distance) noexcept {
    const double radius = (sphere.radius + distance) / 2;
    const double step = (distance - sphere.radius) / (2 * distance);
    return {sphere.center + step * (point - sphere.center), radius};
}

Sphere grownOver(Sphere sphere, Points points) noexcept {
    for (const Vec3& point : points) {
        const double square = squaredDistance(point, sphere.center);
        if (square <= sphere.radius * sphere.radius) continue;
        const double distance = std::sqrt(square);
        if (distance > sphere.radius) sphere = grown(sphere, point, distance);
    }
    // Rounding in later steps can leave an early point outside.
    sphere.radius = std::max(sphere.radius, farthestFrom(sphere.center, points).distance);
    return sphere;
}

Sphere ritterSphere(Points points) noexcept {
    const Vec3& one = points[farthestFrom(points[0], points).index];
    const Farthest other = farthestFrom(one, points);
    return grownOver({(one + points[other.index]) / 2.0, other.distance / 2}, points);
}

// ---- Points of any size ------------------------------------------------------------------------

std::optional<Error> checkPoints(Points points) {
    if (points.empty()) {
        return refuse(Code::wrongLength, "points",
                      "there are no points to enclose; give at least 1");
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 size = glm::abs(points[i]);
        const bool inside = size.x <= largestCoordinate && size.y <= largestCoordinate &&
                            size.z <= largestCoordinate;
        if (inside) continue;
        return refuse(isFinite(points[i]) ? Code::outOfRange : Code::notFinite,
                      indexed("points", i), "coordinates are numbers in ±1e12; this one is not");
    }
    return std::nullopt;
}

Sphere sphereAround(Points points, SphereMethod method) noexcept {
    switch (method) {
        case SphereMethod::minimal: return minimalSphere(points);
        case SphereMethod::ritter: return ritterSphere(points);
        case SphereMethod::incremental: return grownOver({points[0], 0}, points);
    }
    return {};  // not reached: there are no other methods
}

}  // namespace

Result<Sphere> enclosingSphere(std::span<const Vec3> points, SphereMethod method) {
    if (auto error = checkPoints(points)) return *error;
    double extent = 0;
    for (const Vec3& point : points) {
        const Vec3 away = glm::abs(point - points[0]);
        extent = std::max({extent, away.x, away.y, away.z});
    }
    if (extent == 0) return Sphere{points[0], 0};
    if (extent > smallestExtent) return sphereAround(points, method);
    const double enlargement =
        std::ldexp(1, std::min(-std::ilogb(extent), largestEnlargement));
    std::vector<Vec3> enlarged;
    for (const Vec3& point : points) enlarged.push_back(enlargement * (point - points[0]));
    const Sphere sphere = sphereAround(enlarged, method);
    return Sphere{points[0] + sphere.center / enlargement, sphere.radius / enlargement};
}

Sphere sphereUnion(const Sphere& a, const Sphere& b) noexcept {
    const Vec3 between = b.center - a.center;
    const double distance = glm::length(between);
    if (distance <= std::abs(a.radius - b.radius)) return a.radius >= b.radius ? a : b;
    const double radius = (distance + a.radius + b.radius) / 2;
    return {a.center + (radius - a.radius) / distance * between, radius};
}

}  // namespace knotwork
