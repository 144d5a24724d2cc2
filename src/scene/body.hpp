// What an object of a scene is: a curve, a surface, a subdivision surface, a cloud of points, or a
// proposed B-function.
#pragma once

#include "geometry/curve.hpp"
#include "geometry/fitting.hpp"
#include "geometry/mesh_subdivision.hpp"
#include "geometry/surface.hpp"
#include "scene/axioms.hpp"

#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace knotwork::scene {

/// A control mesh and what `levels` levels of the scheme make of it.
struct SubdivisionSurface {
    MeshScheme scheme = MeshScheme::catmullClark;
    int levels = 0;
    Mesh control;
    Mesh refined;
};

/// Points, and the curve that was fitted to them where one is asked for.
struct PointCloud {
    std::vector<Vec3> points;
    std::optional<Fit> fit;
};

/// The graph of a proposed B-function over the square with this lower left corner and this side.
struct FunctionGraph {
    Candidate candidate;
    Vec3 at{0.0};
    double size = 1;
};

/// Cheap to copy: what it holds is immutable and shared.
class Body {
public:
    Body(Curve curve) : kind_(std::move(curve)) {}
    Body(Surface surface) : kind_(std::move(surface)) {}
    Body(SubdivisionSurface surface) : kind_(share(std::move(surface))) {}
    Body(PointCloud cloud) : kind_(share(std::move(cloud))) {}
    Body(FunctionGraph graph) : kind_(share(std::move(graph))) {}

    // Each is null where the body is of another kind.
    [[nodiscard]] const Curve* curve() const noexcept { return std::get_if<Curve>(&kind_); }
    [[nodiscard]] const Surface* surface() const noexcept { return std::get_if<Surface>(&kind_); }
    [[nodiscard]] const SubdivisionSurface* subdivision() const noexcept {
        return held<SubdivisionSurface>();
    }
    [[nodiscard]] const PointCloud* cloud() const noexcept { return held<PointCloud>(); }
    [[nodiscard]] const FunctionGraph* graph() const noexcept { return held<FunctionGraph>(); }

    /// The curve or surface where it is of the kind T, else null.
    template <class T>
    [[nodiscard]] const T* as() const noexcept {
        if constexpr (std::is_constructible_v<Curve::Kind, const T&>) {
            return curve() != nullptr ? curve()->as<T>() : nullptr;
        } else {
            return surface() != nullptr ? surface()->as<T>() : nullptr;
        }
    }

private:
    template <class T>
    static std::shared_ptr<const T> share(T value) {
        return std::make_shared<const T>(std::move(value));
    }
    template <class T>
    [[nodiscard]] const T* held() const noexcept {
        const auto* shared = std::get_if<std::shared_ptr<const T>>(&kind_);
        return shared != nullptr ? shared->get() : nullptr;
    }

    std::variant<Curve, Surface, std::shared_ptr<const SubdivisionSurface>,
                 std::shared_ptr<const PointCloud>, std::shared_ptr<const FunctionGraph>>
        kind_;
};

}  // namespace knotwork::scene
