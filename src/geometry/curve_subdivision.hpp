// Subdivision of polygons: Lane–Riesenfeld of any degree, Chaikin, four-point.
//
// One level of degree d doubles the polygon (its vertices and their midpoints) and then replaces it
// d − 1 times by the midpoints of its legs. As one step: with the mask m_k = C(d+1, k) / 2^d,
//     Q_j = Σ_i m_{j+d−2i} P_i,   j = 0, 1, …,
// indices modulo n where the polygon is closed (2n points), and as far as all the P_i exist where it
// is open (2n − d points). With these indices, without any shift, Q are the control points of the
// same uniform B-spline on knots of half the distance: the closed one on 0, 1, …, n whose span j
// uses P_j … P_{j+d}, the open one on 0, 1, …, n+d. Chaikin's scheme is that of degree 2.
// (J. Lane, R. Riesenfeld, A theoretical development for the computer generation and display of
// piecewise polynomial surfaces, 1980; G. Chaikin, An algorithm for high speed curve generation,
// 1974.)
//
// The four-point scheme of tension w keeps the vertices and puts one on every leg:
//     Q_{2i} = P_i,   Q_{2i+1} = (1/2 + w)(P_i + P_{i+1}) − w (P_{i−1} + P_{i+2}).
// At an open end P_{−1} = 2P_0 − P_1 (2n − 1 points). w = 1/16 keeps cubics, w = 0 the polygon.
// (N. Dyn, D. Levin, J. Gregory, A 4-point interpolatory subdivision scheme for curve design, 1987.)
#pragma once

#include "geometry/result.hpp"
#include "geometry/vec.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace knotwork {

enum class CurveScheme { laneRiesenfeld, chaikin, fourPoint };

inline constexpr int maxSubdivisionLevels = 22;
/// How many points a final polygon may have.
inline constexpr std::size_t maxSubdividedPoints = std::size_t{1} << 22;

/// A polygon and how it is to be subdivided.
struct CurveSubdivision {
    CurveScheme scheme = CurveScheme::laneRiesenfeld;
    std::vector<Vec3> points;
    bool closed = false;
    int levels = 4;
    int degree = 3;            ///< of Lane–Riesenfeld
    double tension = 1.0 / 16; ///< of the four-point scheme
};

/// The degree of the B-spline that is the limit; 0 for the four-point scheme, which has none.
[[nodiscard]] int splineDegree(const CurveSubdivision& subdivision) noexcept;

/// How many points the final polygon has: closed 2^levels · n, open by the rules above.
[[nodiscard]] std::uint64_t subdividedCount(const CurveSubdivision& subdivision) noexcept;

/// Refusals: WRONG_LENGTH `points` (closed 3, open d + 1 and at least 2) or TOO_LARGE (100 000);
/// NOT_FINITE and OUT_OF_RANGE `points[i]` (|coordinate| ≤ 1e12); OUT_OF_RANGE or TOO_LARGE
/// `degree` (1 … 25); NOT_FINITE and OUT_OF_RANGE `tension` (−1 … 1); OUT_OF_RANGE `levels` and
/// TOO_LARGE (22, and a final polygon of more than `most` points). Nothing is computed.
[[nodiscard]] Result<Done> checkSubdivision(const CurveSubdivision& subdivision, std::size_t most);

/// The i-th vertex for any i: an open polygon is continued past its ends by point reflection about
/// them, which every level keeps, and a closed one round.
[[nodiscard]] Vec3 continuedVertex(const CurveSubdivision& subdivision, std::ptrdiff_t i) noexcept;

/// One level: Q_{2q} = Σ_s even_s P_{q+s−lead}, Q_{2q+1} = Σ_s odd_s P_{q+s−lead}, of 2n − lost points.
struct SubdivisionMask {
    std::array<double, 14> even{};
    std::array<double, 14> odd{};
    std::size_t taps = 1;
    std::size_t lead = 0;
    std::size_t lost = 0;
};

[[nodiscard]] SubdivisionMask subdivisionMask(const CurveSubdivision& subdivision) noexcept;

/// A final polygon that is never stored: all but the last levels are made at once, those are made
/// where points are asked for, block by block, in the processor's first cache.
class FinalPolygon {
public:
    /// Of a checked subdivision. O(n · 2^(levels − 6)) and as much memory.
    explicit FinalPolygon(const CurveSubdivision& subdivision);

    [[nodiscard]] std::size_t size() const noexcept { return size_; }

    /// Points first, first + 1, … as x, y, z triples, as many as fit; `first` is even.
    /// O(taps) each. Error of a level: half an ulp for each of its weights.
    void points(std::size_t first, std::span<double> xyz) const noexcept;

private:
    /// The coordinates of all vertices, each with as many before and after as masks reach.
    using Rows = std::array<std::vector<double>, 3>;

    void pad(Rows& rows, std::size_t count) const noexcept;
    [[nodiscard]] Rows refined(const Rows& coarse, std::size_t count) const;
    void block(std::size_t first, std::size_t points, double* xyz) const noexcept;

    CurveScheme scheme_;
    int degree_;
    bool closed_;
    SubdivisionMask mask_;
    int localLevels_;
    std::size_t size_ = 0;
    Rows base_;
};

}  // namespace knotwork
