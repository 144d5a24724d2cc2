#include "geometry/convex_hull.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <utility>

namespace knotwork {

namespace {

__extension__ using Exact = __int128;

/// Differences take 39 bits, and the sum of six products of three of them 120.
constexpr int latticeBits = 38;
/// Of the extent: what is closer to a plane lies in it.
constexpr double flat = 1e-9;

struct Site {
    std::array<std::int64_t, 3> at{};
    friend bool operator==(const Site&, const Site&) = default;
    friend bool operator<(const Site& a, const Site& b) noexcept { return a.at < b.at; }
};

Exact difference(const Site& a, const Site& b, std::size_t c) noexcept { return a.at[c] - b.at[c]; }

double extentOf(std::span<const Vec3> points) noexcept {
    Vec3 low = points.front();
    Vec3 high = low;
    for (const Vec3& p : points) {
        for (int c = 0; c < 3; ++c) {
            low[c] = std::min(low[c], p[c]);
            high[c] = std::max(high[c], p[c]);
        }
    }
    const Vec3 size = high - low;
    return std::max({size.x, size.y, size.z});
}

std::vector<Site> sitesOf(std::span<const Vec3> points) {
    const double extent = extentOf(points);
    const double scale = extent > 0 ? std::ldexp(1.0, latticeBits) / extent : 0;
    std::vector<Site> sites;
    sites.reserve(points.size());
    for (const Vec3& p : points) {
        const Vec3 from = (p - points.front()) * scale;
        sites.push_back({{std::llround(from.x), std::llround(from.y), std::llround(from.z)}});
    }
    return sites;
}

/// The points in order of their sites, of equal ones the first.
std::vector<std::uint32_t> distinct(const std::vector<Site>& sites) {
    std::vector<std::uint32_t> order(sites.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return sites[a] < sites[b];
    });
    order.erase(std::unique(order.begin(), order.end(),
                            [&](std::uint32_t a, std::uint32_t b) { return sites[a] == sites[b]; }),
                order.end());
    return order;
}

// --- in a plane ---------------------------------------------------------------------------------

/// Twice the area of a triangle in the first two coordinates, positive counter-clockwise.
Exact turn(const Site& a, const Site& b, const Site& c) noexcept {
    return difference(b, a, 0) * difference(c, a, 1) - difference(b, a, 1) * difference(c, a, 0);
}

/// Appends a half of the hull of sorted points: the part that turns left only.
template <class Iterator>
void appendChain(const std::vector<Site>& sites, Iterator first, Iterator last,
                 std::vector<std::uint32_t>& hull) {
    const std::size_t base = hull.size();
    for (Iterator i = first; i != last; ++i) {
        while (hull.size() >= base + 2 &&
               turn(sites[hull[hull.size() - 2]], sites[hull.back()], sites[*i]) <= 0) {
            hull.pop_back();
        }
        hull.push_back(*i);
    }
    hull.pop_back();  // the other half begins with it
}

std::vector<std::uint32_t> polygonOf(const std::vector<Site>& sites) {
    const std::vector<std::uint32_t> order = distinct(sites);
    if (order.size() < 2) return order;
    std::vector<std::uint32_t> hull;
    appendChain(sites, order.begin(), order.end(), hull);
    appendChain(sites, order.rbegin(), order.rend(), hull);
    return hull;
}

// --- in space -----------------------------------------------------------------------------------

/// Six times the volume of a tetrahedron, positive where d is on the side from which a, b, c go
/// counter-clockwise.
Exact volume(const Site& a, const Site& b, const Site& c, const Site& d) noexcept {
    const auto minor = [&](std::size_t x, std::size_t y) {
        return difference(b, a, x) * difference(c, a, y) - difference(b, a, y) * difference(c, a, x);
    };
    return difference(d, a, 0) * minor(1, 2) + difference(d, a, 1) * minor(2, 0) +
           difference(d, a, 2) * minor(0, 1);
}

struct Face {
    std::array<std::uint32_t, 3> corners{};
    std::vector<std::uint32_t> outside{};  ///< points beyond it that no other face has
    bool alive = true;
};

class Quickhull {
public:
    explicit Quickhull(const std::vector<Site>& sites) : sites_(sites) {}

    void run(const std::array<std::uint32_t, 4>& simplex, std::span<const std::uint32_t> points) {
        auto [a, b, c, d] = simplex;
        if (volume(sites_[a], sites_[b], sites_[c], sites_[d]) > 0) std::swap(b, c);
        std::vector<std::size_t> faces{add({a, b, c}), add({a, c, d}), add({c, b, d}),
                                       add({b, a, d})};
        std::vector<std::uint32_t> rest(points.begin(), points.end());
        distribute(rest, faces);
        for (std::size_t f = 0; f < faces_.size(); ++f) {
            while (faces_[f].alive && !faces_[f].outside.empty()) expand(f);
        }
    }

    [[nodiscard]] const std::vector<Face>& faces() const noexcept { return faces_; }
    /// The face on the other side of the edge from a to b.
    [[nodiscard]] std::size_t beyond(std::uint32_t a, std::uint32_t b) const {
        return edges_.at(key(b, a));
    }

private:
    static std::uint64_t key(std::uint32_t a, std::uint32_t b) noexcept {
        return std::uint64_t{a} << 32U | b;
    }
    [[nodiscard]] Exact above(std::size_t face, std::uint32_t point) const noexcept {
        const auto& [a, b, c] = faces_[face].corners;
        return volume(sites_[a], sites_[b], sites_[c], sites_[point]);
    }

    std::size_t add(const std::array<std::uint32_t, 3>& corners) {
        faces_.push_back({corners});
        for (std::size_t k = 0; k < 3; ++k) {
            edges_[key(corners[k], corners[(k + 1) % 3])] = faces_.size() - 1;
        }
        return faces_.size() - 1;
    }

    void distribute(std::span<const std::uint32_t> points, std::span<const std::size_t> faces) {
        for (const std::uint32_t p : points) {
            for (const std::size_t f : faces) {
                if (!(above(f, p) > 0)) continue;
                faces_[f].outside.push_back(p);
                break;
            }
        }
    }

    [[nodiscard]] std::uint32_t farthest(std::size_t face) const {
        const auto& outside = faces_[face].outside;
        return *std::max_element(outside.begin(), outside.end(),
                                 [&](std::uint32_t a, std::uint32_t b) {
                                     return above(face, a) < above(face, b);
                                 });
    }

    /// Replaces the faces that the farthest point sees by those that join it to their border.
    void expand(std::size_t first) {
        const std::uint32_t top = farthest(first);
        std::vector<std::size_t> seen{first};
        std::vector<std::array<std::uint32_t, 2>> border;
        std::vector<std::uint32_t> loose;
        faces_[first].alive = false;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const std::array<std::uint32_t, 3> corners = faces_[seen[i]].corners;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t next = beyond(corners[k], corners[(k + 1) % 3]);
                if (!faces_[next].alive) continue;
                if (above(next, top) > 0) {
                    faces_[next].alive = false;
                    seen.push_back(next);
                }
            }
        }
        for (const std::size_t f : seen) {
            const std::array<std::uint32_t, 3> corners = faces_[f].corners;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t a = corners[k];
                const std::uint32_t b = corners[(k + 1) % 3];
                if (faces_[beyond(a, b)].alive) border.push_back({a, b});
            }
            loose.insert(loose.end(), faces_[f].outside.begin(), faces_[f].outside.end());
            faces_[f].outside = {};
        }
        std::vector<std::size_t> made;
        for (const auto& [a, b] : border) made.push_back(add({a, b, top}));
        distribute(loose, made);
    }

    const std::vector<Site>& sites_;
    std::vector<Face> faces_;
    std::unordered_map<std::uint64_t, std::size_t> edges_;
};

Vec3 normalOf(std::span<const Vec3> points, const std::array<std::uint32_t, 3>& corners) noexcept {
    const Vec3& a = points[corners[0]];
    const Vec3 across = glm::cross(points[corners[1]] - a, points[corners[2]] - a);
    const double length = glm::length(across);
    return length > 0 ? across / length : Vec3(0);
}

/// The point for which a measure is largest.
template <class Measure>
std::uint32_t largest(std::span<const std::uint32_t> order, Measure measure) {
    return *std::max_element(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return measure(a) < measure(b);
    });
}

using Edges = std::vector<std::array<std::uint32_t, 2>>;

/// The polygon of points in a plane, seen along the axis that is closest to its normal.
Edges planeEdges(std::vector<Site> sites, const Vec3& normal) {
    const Vec3 size(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z));
    const std::size_t dropped = size.x > std::max(size.y, size.z) ? 0 : size.y > size.z ? 1 : 2;
    for (Site& site : sites) {
        std::swap(site.at[dropped], site.at[2]);
        site.at[2] = 0;
    }
    const std::vector<std::uint32_t> corners = polygonOf(sites);
    Edges edges;
    if (corners.size() == 2) return {{corners[0], corners[1]}};
    for (std::size_t i = 0; corners.size() > 2 && i < corners.size(); ++i) {
        edges.push_back({corners[i], corners[(i + 1) % corners.size()]});
    }
    return edges;
}

/// The edges between faces that do not lie in one plane.
Edges sharpEdges(const Quickhull& hull, std::span<const Vec3> points, double extent) {
    Edges edges;
    for (const Face& face : hull.faces()) {
        if (!face.alive) continue;
        const Vec3 normal = normalOf(points, face.corners);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = face.corners[k];
            const std::uint32_t b = face.corners[(k + 1) % 3];
            if (a > b) continue;
            double away = 0;
            for (const std::uint32_t c : hull.faces()[hull.beyond(a, b)].corners) {
                away = std::max(away, std::abs(glm::dot(normal, points[c] - points[a])));
            }
            if (away > flat * extent) edges.push_back({a, b});
        }
    }
    return edges;
}

}  // namespace

std::vector<std::uint32_t> planeHull(std::span<const Vec3> points) {
    if (points.empty()) return {};
    std::vector<Vec3> plane(points.begin(), points.end());
    for (Vec3& p : plane) p.z = 0;
    return polygonOf(sitesOf(plane));
}

Edges hullEdges(std::span<const Vec3> points) {
    if (points.empty()) return {};
    const std::vector<Site> sites = sitesOf(points);
    const std::vector<std::uint32_t> order = distinct(sites);
    if (order.size() < 2) return {};
    const double extent = extentOf(points);
    const Vec3 from = points[order.front()];
    const std::uint32_t second =
        largest(order, [&](std::uint32_t i) { return glm::length(points[i] - from); });
    const Vec3 along = points[second] - from;
    const auto across = [&](std::uint32_t i) { return glm::cross(along, points[i] - from); };
    const std::uint32_t third =
        largest(order, [&](std::uint32_t i) { return glm::length(across(i)); });
    const double away = glm::length(across(third)) / glm::length(along);
    if (!(away > flat * extent)) {
        return {{order.front(), second}};
    }
    const Vec3 normal = normalOf(points, {order.front(), second, third});
    const auto height = [&](std::uint32_t i) { return std::abs(glm::dot(normal, points[i] - from)); };
    const std::uint32_t fourth = largest(order, height);
    const Exact content =
        volume(sites[order.front()], sites[second], sites[third], sites[fourth]);
    if (!(height(fourth) > flat * extent) || content == 0) return planeEdges(sites, normal);
    Quickhull hull(sites);
    hull.run({order.front(), second, third, fourth}, order);
    return sharpEdges(hull, points, extent);
}

}  // namespace knotwork
