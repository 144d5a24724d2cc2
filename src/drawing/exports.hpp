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
// Curves become polylines and surfaces triangles that are nowhere farther away than a tolerance. A
// large scene takes seconds, so that exports are made in slices (sliced_work.hpp); written at once
// they are the same to the byte.
#pragma once

#include "drawing/svg.hpp"

#include <array>
#include <memory>
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

struct ExportRun;

/// An export that is made in slices, of the scene as it was when it began. Whoever drops it before its
/// end leaves nothing behind.
class SceneExport {
public:
    SceneExport(scene::State state, const SvgOptions& picture);
    SceneExport(scene::State state, ExportFormat format, const ExportOptions& options);
    SceneExport(SceneExport&&) noexcept;
    SceneExport& operator=(SceneExport&&) noexcept;
    ~SceneExport();

    /// Goes on by about so many numbers that are written as text. Whether anything is left to do.
    /// A refusal is NOT_SUPPORTED at `format` for STL of a scene without faces, TOO_LARGE at
    /// `tolerance` where that would take too many points.
    Result<bool> advance(double numbers);
    [[nodiscard]] double fraction() const noexcept;
    /// What has been written since the last call.
    [[nodiscard]] std::string take();
    /// The rest of it at once.
    [[nodiscard]] Result<std::string> finish();

private:
    std::unique_ptr<ExportRun> run_;
};

/// All of it at once.
[[nodiscard]] Result<std::string> exportScene(const scene::State& state, ExportFormat format,
                                              const ExportOptions& options);

}  // namespace knotwork::drawing
