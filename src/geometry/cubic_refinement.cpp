#include "geometry/cubic_refinement.hpp"

#include "geometry/simd.hpp"

#include <array>
#include <cstddef>

namespace knotwork {

namespace {

using simd::Double2;

constexpr std::size_t degree = 3;

/// C_0 + C_1 e_1 + C_2 e_2 + C_3 e_3 in the elementary symmetric functions of u - origin, ….
struct Blossom {
    double origin;
    std::array<Vec3, degree + 1> terms;
};

/// A cubic with what its spans share: reciprocals of differences of knots, and with them the
/// divided differences
///     first_i = (c_i - c_{i-1}) / (t_{i+3} - t_i), second_i = (first_i - first_{i-1}) / (t_{i+2} - t_i).
/// Those over equal knots are never used.
class Cubic {
public:
    Cubic(std::span<const double> knots, std::span<const Vec3> points)
        : knots_(knots), points_(points), nodes_(points.size()) {
        for (std::size_t i = 1; i < nodes_.size(); ++i) {
            Node& node = nodes_[i];
            for (std::size_t k = 1; k <= degree; ++k) {
                node.growth[k - 1] = 1 / (knots[i + k] - knots[i]);
            }
            node.first = node.growth[2] * (points[i] - points[i - 1]);
            node.second = node.growth[1] * (node.first - nodes_[i - 1].first);
        }
    }

    /// That of a span that is not empty. Each difference is multiplied by a span that it contains,
    /// so that nothing exceeds a few times the largest point.
    [[nodiscard]] Blossom blossom(std::size_t span) const noexcept {
        const double origin = 0.5 * (knots_[span] + knots_[span + 1]);
        // As numbers the two ends may lie less than symmetrically to it.
        const double start = knots_[span] - origin;
        const double end = knots_[span + 1] - origin;
        const Vec3 third =
            nodes_[span].growth[0] * (nodes_[span].second - nodes_[span - 1].second);
        const Vec3 second = nodes_[span - 1].second - start * third;
        const Vec3& slope = nodes_[span - 1].first;
        const Vec3 first = slope - (start + end) * second - start * end * third;
        const Vec3 value = points_[span - 2] - (knots_[span - 1] - origin) * slope -
                           (start + end) * first - start * end * second;
        return {origin, {value, first, second, third}};
    }

    /// Points begin … end-1 over `refined` as rows of Oslo 1 (oslo.hpp); the first one lies in
    /// `span` or in a later one.
    void rows(std::span<const double> refined, std::size_t span, std::size_t begin,
              std::size_t end, std::span<Vec3> out) const noexcept {
        for (std::size_t j = begin; j < end; ++j) {
            while (knots_[span + 1] <= refined[j]) ++span;
            out[j] = row(span, refined.subspan(j + 1).first<degree>());
        }
    }

private:
    struct Node {
        Vec3 first{0};
        Vec3 second{0};
        std::array<double, degree> growth{};
    };

    [[nodiscard]] Vec3 row(std::size_t span,
                           std::span<const double, degree> arguments) const noexcept {
        std::array<double, degree + 1> weights{1};
        for (std::size_t k = 1; k <= degree; ++k) {
            const double t = arguments[k - 1];
            double carried = 0;
            for (std::size_t j = 0; j < k; ++j) {
                const std::size_t i = span + 1 - k + j;
                const double w =
                    t >= knots_[i + k] ? 1 : (t - knots_[i]) * nodes_[i].growth[k - 1];
                const double lower = weights[j];
                weights[j] = carried + (1 - w) * lower;
                carried = w * lower;
            }
            weights[k] = carried;
        }
        const Vec3* active = &points_[span - degree];
        return weights[0] * active[0] + weights[1] * active[1] + weights[2] * active[2] +
               weights[3] * active[3];
    }

    std::span<const double> knots_;
    std::span<const Vec3> points_;
    std::vector<Node> nodes_;
};

simd::Points2 splat(const Vec3& point) noexcept {
    return {simd::splat(point.x), simd::splat(point.y), simd::splat(point.z)};
}

/// The blossom at knots i, i+1 and i+2 for each i < count. Two at a time: where `count` is odd, one
/// more is written, which waits for its turn.
void values(const Blossom& blossom, const double* knots, std::size_t count, Vec3* out) noexcept {
    const Double2 origin = simd::splat(blossom.origin);
    const simd::Points2 c0 = splat(blossom.terms[0]);
    const simd::Points2 c1 = splat(blossom.terms[1]);
    const simd::Points2 c2 = splat(blossom.terms[2]);
    const simd::Points2 c3 = splat(blossom.terms[3]);
    for (std::size_t i = 0; i < count; i += 2) {
        const Double2 u = simd::load(knots + i) - origin;
        const Double2 v = simd::load(knots + i + 1) - origin;
        const Double2 w = simd::load(knots + i + 2) - origin;
        const Double2 vPlusW = v + w;
        const Double2 vw = v * w;
        const Double2 e1 = u + vPlusW;
        const Double2 e2 = u * vPlusW + vw;
        const Double2 e3 = u * vw;
        simd::storeInterleaved(&out[i].x, (c0.x + e1 * c1.x) + (e2 * c2.x + e3 * c3.x),
                               (c0.y + e1 * c1.y) + (e2 * c2.y + e3 * c3.y),
                               (c0.z + e1 * c1.z) + (e2 * c2.z + e3 * c3.z));
    }
}

}  // namespace

std::optional<std::vector<Vec3>> refinedCubic(const KnotVector& knots,
                                              std::span<const Vec3> points,
                                              const KnotVector& refined) {
    const std::span<const double> tau = knots.extended();
    const std::span<const double> t = refined.extended();
    if (t.front() != tau.front() || t.back() != tau.back()) return std::nullopt;
    const Cubic cubic(tau, points);
    std::vector<Vec3> out(static_cast<std::size_t>(refined.pointCount()));

    std::size_t done = 0;
    std::size_t reached = degree;  // the span of the last one done
    std::size_t at = degree;       // the last knot of `refined` that equals the start of the span
    for (std::size_t span = degree; span < points.size();) {
        const double knot = tau[span + 1];
        std::size_t end = at + 1;
        while (t[end] < knot) ++end;
        std::size_t next = span + 1;
        while (next < points.size() && tau[next + 1] == knot) ++next;
        if (t[end + (next - span) - 1] != knot) return std::nullopt;
        const std::size_t inside = end - at - 1;
        if (inside > 0) {
            cubic.rows(t, reached, done, at - 1, out);
            values(cubic.blossom(span), &t[at], inside, &out[at - 1]);
            done = at - 1 + inside;
            reached = span;
        }
        at = end + (next - span) - 1;
        while (next < points.size() && t[at + 1] == knot) ++at;
        span = next;
    }
    cubic.rows(t, reached, done, out.size(), out);
    return out;
}

}  // namespace knotwork
