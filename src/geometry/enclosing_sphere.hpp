// Spheres around points: the smallest one, and two that are found in fewer steps.
#pragma once

#include "geometry/result.hpp"
#include "geometry/vec.hpp"

#include <span>

namespace knotwork {

struct Sphere {
    Vec3 center{0};
    double radius = 0;

    friend bool operator==(const Sphere&, const Sphere&) = default;
};

enum class SphereMethod {
    minimal,      ///< the smallest
    ritter,       ///< two farthest points, then grown: at most 3/2 of the smallest, often 1.05
    incremental,  ///< grown from the first point: at most 3/2 as well
};

/// A sphere with every point in it: |p - center| ≤ radius (1 + 1e-14), as computed. Points in the
/// plane z = 0 have a circle's centre in it. The same points in the same order give the same
/// sphere. Refusals: WRONG_LENGTH `points` for none; NOT_FINITE and OUT_OF_RANGE `points[i]`
/// (|coordinate| ≤ 1e12).
///
/// minimal: move-to-front with the farthest point as pivot (E. Welzl, Smallest enclosing disks,
/// 1991; B. Gärtner, Fast and robust smallest enclosing balls, 1999). The sphere is held by at most
/// four points; the farthest point outside joins them, and of the subsets of these five the one
/// whose sphere encloses all five best takes over, which needs no tolerance for duplicates and for
/// points on a line, a plane or a sphere. The radius is within 1e-12 of the smallest. O(n) for
/// each exchange, of which 10⁵ points in a cube, on a sphere or a helix take 1 to 8; no recursion.
/// ritter: J. Ritter, An efficient bounding sphere, 1990. O(n).
/// incremental: each point outside enlarges the sphere as little as possible (H. Zarrabi-Zadeh and
/// T. Chan, A simple streaming algorithm for minimum enclosing balls, 2006). O(n).
[[nodiscard]] Result<Sphere> enclosingSphere(std::span<const Vec3> points,
                                             SphereMethod method = SphereMethod::minimal);

/// The smallest sphere around two spheres: the larger where it holds the other.
[[nodiscard]] Sphere sphereUnion(const Sphere& a, const Sphere& b) noexcept;

}  // namespace knotwork
