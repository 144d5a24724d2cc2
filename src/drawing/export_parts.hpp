// The objects of a scene as points, lines and faces: what every exchange format is written from.
#pragma once

#include "drawing/exports.hpp"
#include "geometry/sliced_work.hpp"

#include <cstdint>
#include <functional>
#include <optional>
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

/// Which of the lists of faces a format is written from; the others stay empty.
struct ExportNeeds {
    bool corners = false;  ///< with their starts
    bool triangles = false;
    bool normals = false;
};

/// An export on its way: what its loops have in common. It stays where it is as long as they are run.
struct ExportRun {
    scene::State state;
    ExportOptions options;
    SlicedWork work = {};  ///< weighed in numbers that are written as text
    std::string text;
    std::function<void()> flush = {};  ///< brings what was written elsewhere into the text
    std::optional<Error> refusal = {};
    std::vector<ExportPart> parts = {};

    void refuse(Error error) {
        refusal = std::move(error);
        work.stop();
    }
};

/// Has the parts made, and then `write` called, which queues what comes next. In the order of the
/// objects; a cloud with a fit is two, and a curve that is not finite somewhere falls into what is
/// left of it. Nothing has no points.
void planParts(ExportRun& run, ExportNeeds needs, std::function<void()> write);

// One each: they queue all that is to be done.
void planText(ExportRun& run, ExportFormat format);
void planBinary(ExportRun& run, ExportFormat format);
void planPicture(ExportRun& run, const SvgOptions& picture);

}  // namespace knotwork::drawing
