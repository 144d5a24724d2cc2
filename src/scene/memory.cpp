#include "scene/memory.hpp"

namespace knotwork::scene {

std::size_t bytesOf(const Json& value) noexcept {
    std::size_t bytes = 2 * sizeof(Json);
    if (value.is_string()) return bytes + value.get_ref<const std::string&>().size();
    if (value.is_array()) {
        for (const Json& item : value.get_ref<const Json::array_t&>()) bytes += bytesOf(item);
    }
    if (value.is_object()) {
        for (const auto& item : value.get_ref<const Json::object_t&>()) {
            bytes += sizeof(std::string) + item.first.size() + bytesOf(item.second);
        }
    }
    return bytes;
}

std::size_t bytesOf(const Body& body) noexcept {
    const SubdivisionSurface* surface = body.subdivision();
    if (surface == nullptr) return 0;
    const Mesh& mesh = surface->refined;
    return mesh.points().size_bytes() + mesh.corners().size_bytes() +
           mesh.faceStarts().size_bytes();
}

}  // namespace knotwork::scene
