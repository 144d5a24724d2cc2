#include "geometry/surface_differential.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace knotwork {

namespace {

// Of the sine of the angle between Su and Sv, and of the ratio of their lengths over the domain.
constexpr double leastSine = 1e-6;
constexpr double leastRatio = 1e-8;
// What of a coefficient is more than rounding, relative to the products that it is a sum of.
constexpr double significant = 1e-9;
// Of the domain: pieces that are shorter have series of their own.
constexpr double farShorter = 1e-2;
// Rounding of derivatives times the lengths of their piece, relative to the coordinates.
constexpr double ofCoordinates = 1e-13;

constexpr int seriesOrder = 10;  // of S along the diagonal: poles up to order 2 of N
constexpr std::size_t terms = seriesOrder - 1;  // left of second derivatives

using Series = std::array<double, terms>;
using VectorSeries = std::array<Vec3, terms>;

Series dot(const VectorSeries& a, const VectorSeries& b) noexcept {
    Series product{};
    for (std::size_t n = 0; n < terms; ++n) {
        for (std::size_t k = 0; k <= n; ++k) product[n] += glm::dot(a[k], b[n - k]);
    }
    return product;
}

VectorSeries cross(const VectorSeries& a, const VectorSeries& b) noexcept {
    VectorSeries product;
    for (std::size_t n = 0; n < terms; ++n) {
        product[n] = Vec3(0);
        for (std::size_t k = 0; k <= n; ++k) product[n] += glm::cross(a[k], b[n - k]);
    }
    return product;
}

Series operator*(const Series& a, const Series& b) noexcept {
    Series product{};
    for (std::size_t n = 0; n < terms; ++n) {
        for (std::size_t k = 0; k <= n; ++k) product[n] += a[k] * b[n - k];
    }
    return product;
}

/// a + factor · b
Series sum(Series a, double factor, const Series& b) noexcept {
    for (std::size_t n = 0; n < terms; ++n) a[n] += factor * b[n];
    return a;
}

/// Of the piece between breaks that a place lies in.
double pieceLength(std::span<const double> breaks, const Interval& whole, double t,
                   Side side) noexcept {
    const auto next = side == Side::right ? std::upper_bound(breaks.begin(), breaks.end(), t)
                                          : std::lower_bound(breaks.begin(), breaks.end(), t);
    if (next == breaks.begin() || next == breaks.end()) return whole.length();
    return *next - *(next - 1);
}

/// How far a series may go from a place: over the domain, or over a piece that is far shorter.
struct Lengths {
    double u;
    double v;
    bool shortPiece = false;

    Lengths(const Surface& surface, const SurfacePlace& at) noexcept {
        const Rectangle whole = domain(surface);
        u = whole.u.length();
        v = whole.v.length();
        const double pieceU = pieceLength(breaksU(surface), whole.u, at.u, at.sideU);
        const double pieceV = pieceLength(breaksV(surface), whole.v, at.v, at.sideV);
        shortPiece = std::min(pieceU / u, pieceV / v) < farShorter;
        if (pieceU < farShorter * u) u = pieceU;
        if (pieceV < farShorter * v) v = pieceV;
    }
};

/// How large the coordinates of some points of the surface are.
double reachOf(const Surface& surface) noexcept {
    const auto [u, v] = domain(surface);
    double farthest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const SurfacePlace at{uniformParameter(u, i, 3), uniformParameter(v, j, 3)};
            farthest = std::max(farthest, glm::length(pointAt(surface, at)));
        }
    }
    return farthest;
}

/// The derivatives of S along (u ± s · length_u, v ± s · length_v) as series in s, each derivative
/// multiplied by the lengths, so that all have the size of the surface.
struct Diagonal {
    VectorSeries su, sv, suu, suv, svv;
    double size = 0;          ///< of the coefficients up to the third order
    double rounding = 0;      ///< what of a coefficient of Su × Sv may be nothing else
    double orientation = 1;   ///< −1 where Su × Sv of the scaled derivatives points to the other side

    Diagonal(const Surface& surface, const SurfacePlace& at) noexcept {
        constexpr SurfaceOrders orders{seriesOrder, seriesOrder};
        std::array<Vec3, orders.size()> rows;
        derivativesWithin(surface, at, seriesOrder, rows);
        const Lengths lengths(surface, at);
        const double stepU = at.sideU == Side::left ? -lengths.u : lengths.u;
        const double stepV = at.sideV == Side::left ? -lengths.v : lengths.v;
        orientation = stepU * stepV < 0 ? -1 : 1;
        for (VectorSeries* series : {&su, &sv, &suu, &suv, &svv}) series->fill(Vec3(0));
        double factorU = 1;  // step^a / a!
        for (std::size_t a = 0; a <= seriesOrder; ++a) {
            if (a > 0) factorU *= stepU / static_cast<double>(a);
            double factor = factorU;
            for (std::size_t b = 0; a + b <= seriesOrder; ++b) {
                if (b > 0) factor *= stepV / static_cast<double>(b);
                if (a + b > 0) add(factor * rows[orders.at(a, b)], a, b);
            }
        }
        rounding = lengths.shortPiece ? roundingWithin(surface) : significant * size * size;
    }

private:
    /// Along a short piece S may hardly change: coordinates are rounded by their own size.
    [[nodiscard]] double roundingWithin(const Surface& surface) const noexcept {
        const double along = std::max({glm::length(su[0]), glm::length(su[1]), glm::length(su[2])});
        const double across = std::max({glm::length(sv[0]), glm::length(sv[1]), glm::length(sv[2])});
        return std::max(significant * along * across,
                        ofCoordinates * reachOf(surface) * std::max(along, across));
    }
    void add(const Vec3& term, std::size_t a, std::size_t b) noexcept {
        const std::size_t n = a + b;
        const auto i = static_cast<double>(a);
        const auto j = static_cast<double>(b);
        if (n <= 3) size = std::max(size, glm::length(term));
        if (n - 1 < terms) {
            su[n - 1] += i * term;
            sv[n - 1] += j * term;
        }
        if (n < 2) return;
        suu[n - 2] += i * (i - 1) * term;
        suv[n - 2] += i * j * term;
        svv[n - 2] += j * (j - 1) * term;
    }
};

/// The first coefficient that is more than rounding.
std::optional<std::size_t> leading(const VectorSeries& series, double rounding) noexcept {
    for (std::size_t n = 0; n < terms; ++n) {
        if (glm::length(series[n]) > rounding) return n;
    }
    return {};
}

/// What a / b tends to, where b begins with s^order; nothing where it grows beyond bounds.
std::optional<double> limit(const Series& a, double size, std::size_t order,
                            double denominator) noexcept {
    for (std::size_t n = 0; n < order; ++n) {
        if (std::abs(a[n]) > significant * size) return {};
    }
    return a[order] / denominator;
}

Error noCurvatures(const SurfacePlace& at) {
    return refuse(Code::notSupported, "",
                  "The surface has no curvatures at u = " + formatNumber(at.u) + ", v = " +
                      formatNumber(at.v) +
                      ": it is not regular there and they have no limit; ask nearby.");
}

Result<SurfaceCurvatures> limits(const Diagonal& s, const VectorSeries& normal,
                                 std::size_t order, const SurfacePlace& at) {
    if (4 * order >= terms) return noCurvatures(at);
    const double length = glm::length(normal[order]);
    const Series e = dot(s.suu, normal);
    const Series f = dot(s.suv, normal);
    const Series g = dot(s.svv, normal);
    const Series gauss = sum(e * g, -1, f * f);
    const Series mean =
        sum(sum(e * dot(s.sv, s.sv), -2, f * dot(s.su, s.sv)), 1, g * dot(s.su, s.su));
    const auto k = limit(gauss, std::pow(s.size, 6), 4 * order, std::pow(length, 4));
    const auto h = limit(mean, std::pow(s.size, 5), 3 * order, 2 * std::pow(length, 3));
    if (!k || !h) return noCurvatures(at);
    SurfaceCurvatures found{*k, s.orientation * *h, 0, 0};
    // What remains of the difference of equal numbers is rounding: a root would magnify it.
    const double rest = found.mean * found.mean - *k;
    const double root = rest > significant * found.mean * found.mean ? std::sqrt(rest) : 0;
    found.k1 = found.mean + root;
    found.k2 = found.mean - root;
    return found;
}

constexpr SurfaceOrders first{1, 1};
constexpr SurfaceOrders second{2, 2};

/// From the derivatives up to the second and the unit normal. The second fundamental form in the
/// orthonormal basis that begins with Su: its eigenvalues come without the cancellation of H² − K.
SurfaceCurvatures regular(std::span<const Vec3> rows, const Vec3& n) noexcept {
    const Vec3& su = rows[second.at(1, 0)];
    const Vec3& sv = rows[second.at(0, 1)];
    const double E = glm::dot(su, su);
    const double shear = glm::dot(su, sv) / E;
    const double area = glm::length(glm::cross(su, sv));
    const double e = glm::dot(rows[second.at(2, 0)], n);
    const double f = glm::dot(rows[second.at(1, 1)], n);
    const double g = glm::dot(rows[second.at(0, 2)], n);
    const double a = e / E;
    const double b = (f - shear * e) / area;
    const double c = (g - shear * (2 * f - shear * e)) * E / (area * area);
    const double mean = (a + c) / 2;
    const double root = std::hypot((a - c) / 2, b);
    return {a * c - b * b, mean, mean + root, mean - root};
}

/// The normal of a surface that is far longer than wide, or nothing.
Vec3 thinNormal(const Vec3& su, const Vec3& sv) noexcept {
    const Vec3 normal = glm::cross(su, sv);
    const double length = glm::length(normal);
    const bool spans = length > leastSine * glm::length(su) * glm::length(sv);
    return spans ? normal / length : Vec3(0);
}

Vec3 plainNormal(const Surface& surface, const SurfacePlace& at, const Vec3& su,
                 const Vec3& sv) noexcept {
    const Lengths lengths(surface, at);
    return knotwork::plainNormal(su, sv, lengths.u, lengths.v);
}

}  // namespace

Vec3 plainNormal(const Vec3& su, const Vec3& sv, double lengthU, double lengthV) noexcept {
    const Vec3 normal = glm::cross(su, sv);
    const double along = glm::length(su);
    const double across = glm::length(sv);
    const double length = glm::length(normal);
    const double ratio = leastRatio * std::max(along * lengthU, across * lengthV);
    const bool plain = length > leastSine * along * across && along * lengthU > ratio &&
                       across * lengthV > ratio;
    return plain ? normal / length : Vec3(0);
}

Vec3 unitNormal(const Surface& surface, const SurfacePlace& at) noexcept {
    std::array<Vec3, first.size()> rows{};
    derivativesWithin(surface, at, 1, rows);
    const Vec3& su = rows[first.at(1, 0)];
    const Vec3& sv = rows[first.at(0, 1)];
    const Vec3 plain = plainNormal(surface, at, su, sv);
    if (plain != Vec3(0)) return plain;
    const Diagonal s(surface, at);
    const VectorSeries normal = cross(s.su, s.sv);
    const auto order = leading(normal, s.rounding);
    if (!order) return thinNormal(su, sv);
    return s.orientation * normal[*order] / glm::length(normal[*order]);
}

Result<SurfaceCurvatures> curvatures(const Surface& surface, const SurfacePlace& at) {
    std::array<Vec3, second.size()> rows{};
    derivativesWithin(surface, at, 2, rows);
    const Vec3& su = rows[second.at(1, 0)];
    const Vec3& sv = rows[second.at(0, 1)];
    const Vec3 plain = plainNormal(surface, at, su, sv);
    if (plain != Vec3(0)) return regular(rows, plain);
    const Diagonal s(surface, at);
    const VectorSeries normal = cross(s.su, s.sv);
    if (const auto order = leading(normal, s.rounding)) return limits(s, normal, *order, at);
    const Vec3 thin = thinNormal(su, sv);
    if (thin == Vec3(0)) return noCurvatures(at);
    return regular(rows, thin);
}

}  // namespace knotwork
