// Random surfaces of every kind and form, and where they are looked at.
#pragma once

#include "geometry/blending_surface.hpp"
#include "geometry/bspline_surface.hpp"
#include "geometry/surface.hpp"
#include "properties/generators.hpp"

#include <array>
#include <iosfwd>
#include <string>
#include <vector>

namespace knotwork::test {

struct SurfaceCase {
    KnotsCase u;
    KnotsCase v;
    std::vector<Vec3> points;  ///< row by row
    std::vector<double> weights;

    [[nodiscard]] BsplineSurface surface() const;
    /// The same with the directions exchanged.
    [[nodiscard]] SurfaceCase transposed() const;
};
void showValue(const SurfaceCase& surface, std::ostream& out);

struct SurfaceOptions {
    int maxDegree = 5;
    int maxSpans = 5;
    bool rational = true;
    bool nearlyEqualKnots = true;
};
/// Points in [-1, 1]³, weights from 0.25 to 3.
rc::Gen<SurfaceCase> anySurface(const SurfaceOptions& options = {});

/// A model with parameters of its own.
struct ModelCase {
    std::string name;
    std::vector<NamedValue> parameters;

    [[nodiscard]] ParametricSurface surface() const;
};
void showValue(const ModelCase& model, std::ostream& out);
rc::Gen<ModelCase> anyModelSurface();

struct BlendDirectionCase {
    std::size_t count = 2;
    BlendForm form = BlendForm::open;
    BFunctionCase blend;
    std::vector<double> knots;

    [[nodiscard]] BlendDirection direction() const { return {count, form, blend.function, knots}; }
};
void showValue(const BlendDirectionCase& along, std::ostream& out);
/// 2 to 4 patches over the domain.
rc::Gen<BlendDirectionCase> anyBlendDirection(const Interval& domain);

struct BlendingSurfaceCase {
    ModelCase model;
    BlendDirectionCase u;
    BlendDirectionCase v;
    PatchCut cut;
    std::vector<Pose> poses;

    [[nodiscard]] BlendingSurface surface() const;
};
void showValue(const BlendingSurfaceCase& blending, std::ostream& out);
rc::Gen<BlendingSurfaceCase> anyBlendingSurface();

/// From both sides of both parameters: every pair of knots and ends, and every knot, its
/// floating-point neighbours and others with a few places of the other direction.
[[nodiscard]] std::vector<SurfacePlace> placesOf(const Rectangle& domain,
                                                 std::span<const double> knotsU,
                                                 std::span<const double> knotsV);
[[nodiscard]] inline std::vector<SurfacePlace> placesOf(const Surface& surface) {
    return placesOf(domain(surface), breaksU(surface), breaksV(surface));
}

}  // namespace knotwork::test
