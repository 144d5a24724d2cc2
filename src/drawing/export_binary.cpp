// STL and glTF 2.0 (Khronos, glTF 2.0 Specification, 2021).
#include "drawing/export_parts.hpp"

#include "scene/readable.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
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

std::string base64(const std::string& bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t k) -> std::uint32_t {
            return k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0U;
        };
        const std::uint32_t three = byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2);
        text += digits[three >> 18U & 63U];
        text += digits[three >> 12U & 63U];
        text += i + 1 < bytes.size() ? digits[three >> 6U & 63U] : '=';
        text += i + 2 < bytes.size() ? digits[three & 63U] : '=';
    }
    return text;
}

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

struct Gltf {
    Json json = Json::object();
    std::string buffer;
};

class GltfMaker {
public:
    Gltf make(const std::vector<ExportPart>& parts, const std::string& title) {
        json_["asset"] = {{"version", "2.0"}, {"generator", "Knotwork"}};
        Json scene = Json::object();
        if (!title.empty()) scene["name"] = title;
        for (const ExportPart& part : parts) {
            if (part.kind == ExportPart::Kind::line && part.count() < 2) continue;
            add(part);
            scene["nodes"].push_back(json_["nodes"].size() - 1);
        }
        json_["scene"] = 0;
        json_["scenes"] = Json::array({std::move(scene)});
        if (!buffer_.empty()) {
            json_["buffers"] = Json::array({Json{{"byteLength", buffer_.size()}}});
        }
        return {std::move(json_), std::move(buffer_)};
    }

private:
    void add(const ExportPart& part) {
        Json primitive{{"attributes", {{"POSITION", positions(part)}}}};
        if (part.kind == ExportPart::Kind::faces) {
            primitive["attributes"]["NORMAL"] = vectors(part.normals);
            primitive["indices"] = indices(part.triangles);
        }
        primitive["material"] = material(part);
        primitive["mode"] = part.kind == ExportPart::Kind::faces  ? modeTriangles
                            : part.kind == ExportPart::Kind::line ? modeLineStrip
                                                                  : modePoints;
        json_["nodes"].push_back({{"name", part.name}, {"mesh", json_["meshes"].size()}});
        json_["meshes"].push_back(
            {{"name", part.name}, {"primitives", Json::array({std::move(primitive)})}});
    }

    std::size_t view(std::size_t from, int target) {
        json_["bufferViews"].push_back({{"buffer", 0},
                                        {"byteOffset", from},
                                        {"byteLength", buffer_.size() - from},
                                        {"target", target}});
        return json_["bufferViews"].size() - 1;
    }

    std::size_t accessor(Json accessor) {
        json_["accessors"].push_back(std::move(accessor));
        return json_["accessors"].size() - 1;
    }

    std::size_t vectors(const std::vector<double>& xyz) {
        const std::size_t from = buffer_.size();
        for (const double number : xyz) appendFloat(buffer_, number);
        return accessor({{"bufferView", view(from, vertexBuffer)},
                         {"componentType", floatingPoint},
                         {"count", xyz.size() / 3},
                         {"type", "VEC3"}});
    }

    /// With the box that they lie in, of the numbers as they stand in the buffer.
    std::size_t positions(const ExportPart& part) {
        const std::size_t made = vectors(part.xyz);
        Json least = Json::array();
        Json most = Json::array();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            double low = part.xyz[axis];
            double high = low;
            for (std::size_t i = axis; i < part.xyz.size(); i += 3) {
                low = std::min(low, part.xyz[i]);
                high = std::max(high, part.xyz[i]);
            }
            least.push_back(static_cast<double>(static_cast<float>(low)));
            most.push_back(static_cast<double>(static_cast<float>(high)));
        }
        json_["accessors"][made]["min"] = std::move(least);
        json_["accessors"][made]["max"] = std::move(most);
        return made;
    }

    std::size_t indices(const std::vector<std::uint32_t>& list) {
        const std::size_t from = buffer_.size();
        for (const std::uint32_t index : list) appendInteger(buffer_, index);
        return accessor({{"bufferView", view(from, indexBuffer)},
                         {"componentType", unsignedInteger},
                         {"count", list.size()},
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
    std::string buffer_;
    std::map<std::string, std::size_t> materials_;
};

Result<Gltf> gltfOf(const scene::State& state, const ExportOptions& options) {
    const auto parts = exportParts(state, options);
    if (!parts) return parts.error();
    return GltfMaker().make(*parts, scene::stringOr(*state.header, "title", ""));
}

/// A chunk of a binary glTF file, filled up to whole words.
void appendChunk(std::string& file, std::string_view type, std::string content, char filler) {
    content.resize((content.size() + 3) / 4 * 4, filler);
    appendInteger(file, static_cast<std::uint32_t>(content.size()));
    file += type;
    file += content;
}

}  // namespace

Result<std::string> exportStl(const scene::State& state, const ExportOptions& options) {
    const auto parts = exportParts(state, options);
    if (!parts) return parts.error();
    std::size_t count = 0;
    for (const ExportPart& part : *parts) count += part.triangles.size() / 3;
    if (count == 0) {
        return refuse(Code::notSupported, "format",
                      "STL holds triangles, and this scene has no surface; curves go into obj, gltf "
                      "or csv.");
    }
    std::string bytes = "Knotwork";  // must not begin with "solid", as the texts do
    bytes.resize(80, ' ');
    appendInteger(bytes, static_cast<std::uint32_t>(count));
    bytes.reserve(bytes.size() + 50 * count);
    for (const ExportPart& part : *parts) {
        for (std::size_t i = 0; i < part.triangles.size(); i += 3) appendFacet(bytes, part, i);
    }
    return bytes;
}

Result<std::string> exportGltf(const scene::State& state, const ExportOptions& options) {
    auto made = gltfOf(state, options);
    if (!made) return made.error();
    if (!made->buffer.empty()) {
        made->json["buffers"][0]["uri"] =
            "data:application/octet-stream;base64," + base64(made->buffer);
    }
    return scene::readableText(made->json, scene::Notation::json) + '\n';
}

Result<std::string> exportGlb(const scene::State& state, const ExportOptions& options) {
    const auto made = gltfOf(state, options);
    if (!made) return made.error();
    std::string chunks;
    appendChunk(chunks, "JSON", scene::dumpJson(made->json), ' ');
    if (!made->buffer.empty()) {
        appendChunk(chunks, std::string_view("BIN\0", 4), made->buffer, '\0');
    }
    std::string file = "glTF";
    appendInteger(file, 2);
    appendInteger(file, static_cast<std::uint32_t>(12 + chunks.size()));
    return file + chunks;
}

}  // namespace knotwork::drawing
