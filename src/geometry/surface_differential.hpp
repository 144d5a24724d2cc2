// Normals and curvatures of surfaces.
//
// N = Su × Sv, e = Suu·n, f = Suv·n, g = Svv·n with n = N/|N|, and E, F, G of the first derivatives:
//     K = (eg − f²) / (EG − F²),  H = (eG − 2fF + gE) / (2 (EG − F²)),  k = H ± √(H² − K).
// A sphere whose n points outwards has H = −1/r. (M. do Carmo, Differential Geometry of Curves and
// Surfaces, 1976, 3.3.)
//
// Where N vanishes (at a pole), N, K and H are taken as limits along the diagonal that leads from
// the place into the sides from which it is approached: S is expanded along it, and what vanishes
// cancels between the power series.
#pragma once

#include "geometry/result.hpp"
#include "geometry/surface.hpp"
#include "geometry/vec.hpp"

namespace knotwork {

struct SurfaceCurvatures {
    double gaussian = 0;
    double mean = 0;
    double k1 = 0;  ///< k1 ≥ k2
    double k2 = 0;
};

/// The unit normal, that of Su × Sv. At a pole its limit; (0, 0, 0) where there is none, that is
/// where the surface is a curve or a point along the whole diagonal, to order 5.
[[nodiscard]] Vec3 unitNormal(const Surface& surface, const SurfacePlace& at) noexcept;

/// At a pole their limits; NOT_SUPPORTED where they grow beyond bounds (the tip of a cone) or where
/// there is no normal.
[[nodiscard]] Result<SurfaceCurvatures> curvatures(const Surface& surface, const SurfacePlace& at);

/// The normal of these first derivatives if they span a plane well enough for it to be theirs, over
/// a domain of these lengths; otherwise (0, 0, 0), and unitNormal() has to look closer.
[[nodiscard]] Vec3 plainNormal(const Vec3& su, const Vec3& sv, double lengthU,
                               double lengthV) noexcept;

}  // namespace knotwork
