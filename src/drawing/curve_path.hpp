// Curves as paths of lines and cubic Bézier curves, the vocabulary of SVG and of PDF.
//
// On [a, b], h = b − a, the cubic with the points
//     C(a),  C(a) + h/3 C′(a),  C(b) − h/3 C′(b),  C(b)
// has the ends and the derivatives there of C. Where C is a polynomial of degree 3 or less it is C
// itself; elsewhere it is within h⁴/384 max|C⁗| at equal parameters, and [a, b] is halved until that
// is small. An affine map of the points is the map of the curve.
#pragma once

#include "drawing/drawing.hpp"

#include <vector>

namespace knotwork::drawing {

/// A step of a path from where the one before it ended.
struct PathStep {
    enum class Kind { move, line, cubic };
    Kind kind = Kind::move;
    Vec3 first{0.0};   ///< the inner control points of a cubic
    Vec3 second{0.0};
    Vec3 end{0.0};
};

/// The degree of all pieces of a curve that is made of polynomials; 4 stands for more, and for what
/// is no polynomial.
[[nodiscard]] int polynomialDegree(const Curve& curve) noexcept;

/// The part of the curve, placed: exact up to degree 3, otherwise at most `tolerance` (> 0) away in
/// x and y. It begins with a move and has another one where the curve jumps; what is not finite is
/// left out. Not more than 2^15 steps are made of a curve that is no polynomial, whatever the
/// tolerance.
[[nodiscard]] std::vector<PathStep> curvePath(const CurvePart& part, double tolerance);

}  // namespace knotwork::drawing
