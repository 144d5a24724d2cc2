// The fast way to many points of a B-spline curve.
//
// One polynomial per span, made once and centred at mid-span: C(t) = Σ c_k u^k with u in [-1, 1],
// by Horner's rule over runs of parameters that fall into one span. Above degree 7 the power form
// loses digits and the pieces are in Bernstein form; so are those of rational curves. Positions
// agree with BsplineCurve within 4e-14 up to degree 3 (5e-15 on most curves), 1e-13 beyond, for
// coordinates up to 20.
#pragma once

#include "geometry/bspline_curve.hpp"
#include "geometry/interval.hpp"
#include "geometry/vec.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace knotwork {

class BsplineSampler {
public:
    /// O(n d²); (d+1) · 2 to 4 numbers per span are kept.
    explicit BsplineSampler(const BsplineCurve& curve);

    [[nodiscard]] Interval domain() const noexcept { return domain_; }

    /// Points first … first+count-1 of `total` that are spread uniformly over the domain, both
    /// ends included, as x, y, z triples: `xyz` holds 3·count numbers. Parameters as
    /// uniformParameter() gives them.
    void uniform(std::size_t first, std::size_t count, std::size_t total,
                 std::span<double> xyz) const noexcept;

    /// At each of ts, in any order (fast when sorted): all positions, then all first derivatives,
    /// and so on, so that `xyz` holds 3·(derivatives+1)·ts.size() numbers. Taken from the right
    /// at knots; outside the domain continued as BsplineCurve does.
    void at(std::span<const double> ts, int derivatives, std::span<double> xyz) const noexcept;

private:
    // Answers for start ≤ t < end; the outermost pieces of a curve that is not closed reach to
    // infinity. u = (t - origin) · scale is in [-1, 1] for the power form, [0, 1] for Bernstein's.
    struct Piece {
        double start;
        double end;
        double origin;
        double scale;
    };
    struct Terms;

    void addPiece(const BsplineCurve& curve, std::size_t span);
    [[nodiscard]] std::size_t pieceAt(double t) const noexcept;
    [[nodiscard]] Terms termsOf(std::size_t piece) const noexcept;
    void evaluate(const Terms& terms, const double* us, std::size_t count,
                  double* xyz) const noexcept;
    void uniformRun(std::size_t piece, std::size_t first, std::size_t count, std::size_t total,
                    double* xyz) const noexcept;
    std::size_t run(std::span<const double> ts, std::size_t first, int derivatives,
                    std::span<double> xyz) const noexcept;
    void rows(std::size_t piece, const double* us, std::size_t count, int derivatives,
              std::size_t stride, double* xyz) const noexcept;
    void rationalRows(std::size_t piece, const double* us, std::size_t count, int derivatives,
                      std::size_t stride, double* xyz) const noexcept;
    void fixEnd(double t, double* xyz) const noexcept;

    std::vector<Piece> pieces_;         // one per span that is not empty, ascending
    std::vector<double> coefficients_;  // one piece's Coefficients after the other
    Interval domain_;
    Vec3 startPoint_;
    Vec3 endPoint_;
    std::size_t degree_;
    std::size_t components_;  // 2: z is zero; 3; or 4: homogeneous
    bool bernstein_;
    bool closed_;
};

}  // namespace knotwork
