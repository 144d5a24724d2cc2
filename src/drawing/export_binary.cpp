// STL and glTF 2.0 (Khronos, glTF 2.0 Specification, 2021).
#include "drawing/export_parts.hpp"

#include "scene/readable.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <map>
#include <memory>
#include <utility>

namespace knotwork::drawing {

namespace {

using scene::Json;

// ---- Bytes, the least first --------------------------------------------------------------------

void appendInteger(std::string& bytes, std::uint32_t value) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
        bytes += static_cast<char>(static_cast<unsigned char>(value >> shift & 0xffU));
    }
}

void appendFloat(std::string& bytes, double value) {
    const auto single = static_cast<float>(value);
    std::uint32_t bits = 0;
    std::memcpy(&bits, &single, sizeof bits);
    appendInteger(bytes, bits);
}

/// Bytes as base64, of which what is no multiple of three waits for the next ones.
class Base64 {
public:
    void append(std::string& text, std::string_view bytes) {
        waiting_ += bytes;
        const std::size_t whole = waiting_.size() / 3 * 3;
        for (std::size_t i = 0; i < whole; i += 3) {
            letters(text, byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2), 4);
        }
        waiting_.erase(0, whole);
    }
    void end(std::string& text) {
        if (waiting_.empty()) return;
        const std::uint32_t rest = byte(0) << 16U | (waiting_.size() > 1 ? byte(1) << 8U : 0U);
        letters(text, rest, waiting_.size() + 1);
        text.append(3 - waiting_.size(), '=');
        waiting_.clear();
    }

private:
    [[nodiscard]] std::uint32_t byte(std::size_t i) const noexcept {
        return static_cast<unsigned char>(waiting_[i]);
    }
    static void letters(std::string& text, std::uint32_t three, std::size_t count) {
        constexpr std::string_view digits =
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        for (std::size_t k = 0; k < count; ++k) text += digits[three >> (18U - 6U * k) & 63U];
    }

    std::string waiting_;
};

// ---- STL ---------------------------------------------------------------------------------------

Vec3 pointOf(const ExportPart& part, std::uint32_t i) noexcept {
    const double* p = part.xyz.data() + 3 * std::size_t{i};
    return {p[0], p[1], p[2]};
}

void appendFacet(std::string& bytes, const ExportPart& part, std::size_t first) {
    const std::array corners{pointOf(part, part.triangles[first]),
                             pointOf(part, part.triangles[first + 1]),
                             pointOf(part, part.triangles[first + 2])};
    const Vec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double area = glm::length(across);
    const Vec3 normal = area > 0 ? across / area : Vec3(0.0);
    for (const Vec3& v : {normal, corners[0], corners[1], corners[2]}) {
        appendFloat(bytes, v.x);
        appendFloat(bytes, v.y);
        appendFloat(bytes, v.z);
    }
    bytes.append(2, '\0');
}

// ---- glTF --------------------------------------------------------------------------------------

// Names of the specification for what it writes as numbers.
constexpr int unsignedInteger = 5125;
constexpr int floatingPoint = 5126;
constexpr int vertexBuffer = 34962;
constexpr int indexBuffer = 34963;
constexpr int modePoints = 0;
constexpr int modeLineStrip = 3;
constexpr int modeTriangles = 4;

/// The box that the points of a part lie in.
struct Box {
    std::array<double, 3> least{};
    std::array<double, 3> most{};

    void add(const ExportPart& part, std::size_t first, std::size_t last) noexcept {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (first == 0) least[axis] = most[axis] = part.xyz[axis];
            for (std::size_t i = 3 * first + axis; i < 3 * last; i += 3) {
                least[axis] = std::min(least[axis], part.xyz[i]);
                most[axis] = std::max(most[axis], part.xyz[i]);
            }
        }
    }
};

/// What the file says about its numbers, which come in the order in which they are described: of each
/// part that is written its points and, of faces, its normals and its triangles.
struct Gltf {
    Json json = Json::object();
    std::size_t bytes = 0;
};

bool isWritten(const ExportPart& part) noexcept {
    return part.kind != ExportPart::Kind::line || part.count() >= 2;
}

class GltfMaker {
public:
    Gltf make(const std::vector<ExportPart>& parts, const std::vector<Box>& boxes,
              const std::string& title) {
        json_["asset"] = {{"version", "2.0"}, {"generator", "Knotwork"}};
        Json scene = Json::object();
        if (!title.empty()) scene["name"] = title;
        for (std::size_t k = 0; k < parts.size(); ++k) {
            if (!isWritten(parts[k])) continue;
            add(parts[k], boxes[k]);
            scene["nodes"].push_back(json_["nodes"].size() - 1);
        }
        json_["scene"] = 0;
        json_["scenes"] = Json::array({std::move(scene)});
        if (bytes_ > 0) json_["buffers"] = Json::array({Json{{"byteLength", bytes_}}});
        return {std::move(json_), bytes_};
    }

private:
    void add(const ExportPart& part, const Box& box) {
        Json primitive{{"attributes", {{"POSITION", positions(part, box)}}}};
        if (part.kind == ExportPart::Kind::faces) {
            primitive["attributes"]["NORMAL"] = vectors(part.normals.size());
            primitive["indices"] = indices(part.triangles.size());
        }
        primitive["material"] = material(part);
        primitive["mode"] = part.kind == ExportPart::Kind::faces  ? modeTriangles
                            : part.kind == ExportPart::Kind::line ? modeLineStrip
                                                                  : modePoints;
        json_["nodes"].push_back({{"name", part.name}, {"mesh", json_["meshes"].size()}});
        json_["meshes"].push_back(
            {{"name", part.name}, {"primitives", Json::array({std::move(primitive)})}});
    }

    /// Of so many numbers of four bytes.
    std::size_t view(std::size_t numbers, int target) {
        json_["bufferViews"].push_back({{"buffer", 0},
                                        {"byteOffset", bytes_},
                                        {"byteLength", 4 * numbers},
                                        {"target", target}});
        bytes_ += 4 * numbers;
        return json_["bufferViews"].size() - 1;
    }

    std::size_t accessor(Json accessor) {
        json_["accessors"].push_back(std::move(accessor));
        return json_["accessors"].size() - 1;
    }

    std::size_t vectors(std::size_t numbers) {
        return accessor({{"bufferView", view(numbers, vertexBuffer)},
                         {"componentType", floatingPoint},
                         {"count", numbers / 3},
                         {"type", "VEC3"}});
    }

    /// With their box, of the numbers as they stand in the buffer.
    std::size_t positions(const ExportPart& part, const Box& box) {
        const std::size_t made = vectors(part.xyz.size());
        Json least = Json::array();
        Json most = Json::array();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            least.push_back(static_cast<double>(static_cast<float>(box.least[axis])));
            most.push_back(static_cast<double>(static_cast<float>(box.most[axis])));
        }
        json_["accessors"][made]["min"] = std::move(least);
        json_["accessors"][made]["max"] = std::move(most);
        return made;
    }

    std::size_t indices(std::size_t count) {
        return accessor({{"bufferView", view(count, indexBuffer)},
                         {"componentType", unsignedInteger},
                         {"count", count},
                         {"type", "SCALAR"}});
    }

    /// One for each colour; both sides of a surface are seen.
    std::size_t material(const ExportPart& part) {
        const std::string name = scene::formatColour(part.colour);
        const auto [found, isNew] = materials_.try_emplace(name, materials_.size());
        if (isNew) {
            const Colour& c = part.colour;
            const Json colour{scene::linearLight(c.red), scene::linearLight(c.green),
                              scene::linearLight(c.blue), 1.0};
            const Json shine{{"baseColorFactor", colour},
                             {"metallicFactor", 0.0},
                             {"roughnessFactor", 0.6}};
            json_["materials"].push_back(
                {{"name", name}, {"pbrMetallicRoughness", shine}, {"doubleSided", true}});
        }
        return found->second;
    }

    Json json_ = Json::object();
    std::size_t bytes_ = 0;
    std::map<std::string, std::size_t> materials_;
};

/// A number in four bytes or six letters, beside one that is written as text.
constexpr double binaryWeight = 0.1;

/// Takes the bytes of some numbers.
using Sink = std::function<void(std::string_view)>;

/// The numbers in the order of their description.
void writeNumbers(ExportRun& run, const Sink& sink) {
    const auto list = [&](const auto& numbers, auto append) {
        run.work.loop(numbers.size(), binaryWeight * static_cast<double>(numbers.size()),
                      [&numbers, append, sink](std::size_t first, std::size_t last) {
                          std::string bytes;
                          bytes.reserve(4 * (last - first));
                          for (std::size_t i = first; i < last; ++i) append(bytes, numbers[i]);
                          sink(bytes);
                      });
    };
    for (const ExportPart& part : run.parts) {
        if (!isWritten(part)) continue;
        list(part.xyz, appendFloat);
        if (part.kind != ExportPart::Kind::faces) continue;
        list(part.normals, appendFloat);
        list(part.triangles, appendInteger);
    }
}

/// What a text file says in place of the numbers, and their letters.
void writeText(ExportRun& run, Gltf made) {
    constexpr std::string_view uri = "\"uri\": \"data:application/octet-stream;base64,";
    if (made.bytes > 0) {
        made.json["buffers"][0]["uri"] = "data:application/octet-stream;base64,";
    }
    const std::string text = scene::readableText(made.json, scene::Notation::json) + '\n';
    // No string of the file has this in it: its quotes would stand after backslashes.
    const std::size_t at = made.bytes > 0 ? text.find(uri) + uri.size() : text.size();
    run.text = text.substr(0, at);
    const auto letters = std::make_shared<Base64>();
    writeNumbers(run, [&run, letters](std::string_view bytes) { letters->append(run.text, bytes); });
    run.work.step(0, [&run, letters, rest = text.substr(at)] {
        letters->end(run.text);
        run.text += rest;
    });
}

/// A chunk of a binary glTF file begins with the number of its bytes, which are whole words.
void beginChunk(std::string& file, std::string_view type, std::size_t bytes) {
    appendInteger(file, static_cast<std::uint32_t>(bytes));
    file += type;
}

void writeBinary(ExportRun& run, const Gltf& made) {
    std::string json = scene::dumpJson(made.json);
    json.resize((json.size() + 3) / 4 * 4, ' ');
    constexpr std::size_t heads = 8;
    const std::size_t numbers = made.bytes > 0 ? heads + made.bytes : 0;
    run.text = "glTF";
    appendInteger(run.text, 2);
    appendInteger(run.text, static_cast<std::uint32_t>(12 + heads + json.size() + numbers));
    beginChunk(run.text, "JSON", json.size());
    run.text += json;
    if (made.bytes > 0) beginChunk(run.text, std::string_view("BIN\0", 4), made.bytes);
    writeNumbers(run, [&run](std::string_view bytes) { run.text += bytes; });
}

void writeGltf(ExportRun& run, bool binary) {
    const auto boxes = std::make_shared<std::vector<Box>>(run.parts.size());
    for (std::size_t k = 0; k < run.parts.size(); ++k) {
        const ExportPart& part = run.parts[k];
        run.work.loop(part.count(), binaryWeight * static_cast<double>(part.count()),
                      [boxes, &part, k](std::size_t first, std::size_t last) {
                          (*boxes)[k].add(part, first, last);
                      });
    }
    double weight = 0;
    for (const ExportPart& part : run.parts) {
        weight += static_cast<double>(2 * part.xyz.size() + part.triangles.size());
    }
    run.work.step(binaryWeight * weight, [&run, boxes, binary] {
        Gltf made =
            GltfMaker().make(run.parts, *boxes, scene::stringOr(*run.state.header, "title", ""));
        if (binary) writeBinary(run, made);
        else writeText(run, std::move(made));
    });
}

void writeStl(ExportRun& run) {
    std::size_t count = 0;
    for (const ExportPart& part : run.parts) count += part.triangles.size() / 3;
    if (count == 0) {
        return run.refuse(
            refuse(Code::notSupported, "format",
                   "STL holds triangles, and this scene has no surface; curves go into obj, gltf "
                   "or csv."));
    }
    run.text = "Knotwork";  // must not begin with "solid", as the texts do
    run.text.resize(80, ' ');
    appendInteger(run.text, static_cast<std::uint32_t>(count));
    for (const ExportPart& part : run.parts) {
        const std::size_t triangles = part.triangles.size() / 3;
        run.work.loop(triangles, 12 * binaryWeight * static_cast<double>(triangles),
                      [&run, &part](std::size_t first, std::size_t last) {
                          for (std::size_t i = first; i < last; ++i) {
                              appendFacet(run.text, part, 3 * i);
                          }
                      });
    }
}

}  // namespace

void planBinary(ExportRun& run, ExportFormat format) {
    if (format == ExportFormat::stl) {
        return planParts(run, {.triangles = true}, [&run] { writeStl(run); });
    }
    const bool binary = format == ExportFormat::glb;
    planParts(run, {.triangles = true, .normals = true}, [&run, binary] { writeGltf(run, binary); });
}

}  // namespace knotwork::drawing
