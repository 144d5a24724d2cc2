// Scenes at a moment in the formats that other programs read.
//
//   svg   the picture (svg.hpp)
//   json  the document itself, to be read by people
//   js    the calls that make its objects in Node
//   csv   a row for every point: object, t (of curves), u and v (of surfaces), x, y, z
//   obj   Wavefront: an object each, curves as lines, surfaces and meshes as faces, clouds as points
//   stl   triangles for printing, binary
//   gltf  glTF 2.0 as one text, its numbers in it as base64; glb the same as one binary file
//
// Curves become polylines and surfaces triangles that are nowhere farther away than a tolerance.
#pragma once

#include "drawing/svg.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace knotwork::drawing {

enum class ExportFormat { svg, json, js, csv, obj, stl, gltf, glb };

/// Their public names, in the order of ExportFormat.
inline constexpr std::array<std::string_view, 8> exportFormatNames{"svg", "json", "js",   "csv",
                                                                   "obj", "stl",  "gltf", "glb"};

[[nodiscard]] constexpr bool isBinary(ExportFormat format) noexcept {
    return format == ExportFormat::stl || format == ExportFormat::glb;
}

struct ExportOptions {
    scene::Moment moment{};
    /// World units; by default 1e-4 of the scene's size for curves and 1e-3 for surfaces.
    std::optional<double> tolerance{};
};

/// NOT_SUPPORTED at `format` for STL of a scene without faces, TOO_LARGE at `tolerance` where that
/// would take too many points.
[[nodiscard]] Result<std::string> exportScene(const scene::State& state, ExportFormat format,
                                              const ExportOptions& options);

// One each; what they are made of is in export_parts.hpp.
[[nodiscard]] std::string exportJson(const scene::State& state);
[[nodiscard]] std::string exportJavaScript(const scene::State& state);
[[nodiscard]] Result<std::string> exportCsv(const scene::State& state, const ExportOptions& options);
[[nodiscard]] Result<std::string> exportObj(const scene::State& state, const ExportOptions& options);
[[nodiscard]] Result<std::string> exportStl(const scene::State& state, const ExportOptions& options);
[[nodiscard]] Result<std::string> exportGltf(const scene::State& state, const ExportOptions& options);
[[nodiscard]] Result<std::string> exportGlb(const scene::State& state, const ExportOptions& options);

}  // namespace knotwork::drawing
