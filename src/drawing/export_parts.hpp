// The objects of a scene as points, lines and faces: what every exchange format is written from.
#pragma once

#include "drawing/exports.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace knotwork::drawing {

struct ExportPart {
    enum class Kind { points, line, faces };

    std::string name;  ///< the object's id
    Kind kind = Kind::line;
    Colour colour;
    std::vector<double> xyz;         ///< triples, all finite
    /// One for each point of a curve, u and v for each of a surface, otherwise none.
    std::vector<double> parameters;
    std::vector<double> normals;     ///< of a surface: unit triples
    std::vector<std::uint32_t> corners;  ///< of the faces
    std::vector<std::uint32_t> starts;   ///< where each begins, one more than faces; none: triangles
    std::vector<std::uint32_t> triangles;  ///< the faces in triangles

    [[nodiscard]] std::size_t count() const noexcept { return xyz.size() / 3; }
};

/// In the order of the objects; a cloud with a fit is two, and a curve that is not finite somewhere
/// falls into what is left of it. Nothing has no points.
[[nodiscard]] Result<std::vector<ExportPart>> exportParts(const scene::State& state,
                                                          const ExportOptions& options);

}  // namespace knotwork::drawing
