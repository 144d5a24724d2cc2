// The fast way to many points of a blending curve.
//
// Spans are looked up once for each run of parameters that fall into one, and B is sampled for the
// whole run. What is blended there is, in the order of its price: one curve that both local curves
// are; one model in two placements, so that a blend of two affine maps acts on one point of it; two
// polynomials about mid-span, P(u) + B·(Q − P)(u), with u in [−1, 1]; or any two curves, each with
// the sampler of its own kind. Agrees with BlendingCurve within 1e-13 for coordinates up to 20.
#pragma once

#include "geometry/blending_curve.hpp"
#include "geometry/curve.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace knotwork {

class BlendingSampler {
public:
    /// O(n): two polynomials a span, and a sampler for each source that is no polynomial.
    explicit BlendingSampler(const BlendingCurve& curve);

    /// The points at ts, in any order (fast when sorted), as x, y, z triples: xyz.size() is
    /// 3·ts.size(). Taken from the right at knots, at the end of the domain from the left; outside
    /// continued as BlendingCurve does. Nothing is allocated.
    void points(std::span<const double> ts, std::span<double> xyz) const noexcept;

    /// The highest order for which rows() is.
    static constexpr int mostDerivatives = 3;
    /// All positions, then all first derivatives, …, of orders up to `derivatives`: xyz.size() is
    /// 3·(derivatives+1)·ts.size().
    void rows(std::span<const double> ts, int derivatives, std::span<double> xyz) const noexcept;

private:
    enum class Method { one, placements, polynomials, any };

    // Answers for start ≤ t < end; the outermost of an open curve reach to infinity.
    struct Piece {
        double start;
        double end;
        BlendingCurve::Span span;
        Method method;
        std::size_t degree;   // of the polynomials
        std::size_t offset;   // of their coefficients
    };
    struct Run;
    struct Rows;

    void addPiece(const BlendingCurve::Span& span);
    void addPolynomials(const BlendingCurve::Span& span, Piece& piece);
    std::size_t samplerOf(std::size_t local);
    [[nodiscard]] const Piece& pieceAt(double t) const noexcept;
    [[nodiscard]] const Piece* begin(std::span<const double> ts, Run& run) const noexcept;
    void locate(const Piece& piece, Run& run) const noexcept;
    void blend(const Piece& piece, Run& run, double* xyz) const noexcept;
    void placements(const Piece& piece, Run& run, double* xyz) const noexcept;
    void any(const Piece& piece, Run& run, double* xyz) const noexcept;
    void local(std::size_t j, double shift, const Run& run, double* xyz) const noexcept;
    void blendRows(const Piece& piece, const Run& run, std::size_t orders, std::size_t stride,
                   double* xyz) const noexcept;
    void localRows(std::size_t j, double shift, const Run& run, std::size_t orders,
                   Rows& rows) const noexcept;
    void polynomialRows(const Piece& piece, const Run& run, std::size_t orders, Rows& first,
                        Rows& step) const noexcept;

    BlendingCurve curve_;
    std::vector<Piece> pieces_;          // one per span that is not empty, ascending
    std::vector<double> coefficients_;   // term after term: those of P, then those of Q − P
    std::vector<CurveSampler> samplers_;
    std::vector<std::size_t> samplerOf_;  // of each local curve
    std::size_t components_;              // 2: z is zero; or 3
};

}  // namespace knotwork
