#include "bindings/marshal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace knotwork::bindings {

using scene::Json;

Result<Done> checkSize(const Json& document, std::size_t bytes) {
    if (bytes <= scene::maximumDocumentBytes / 3) return Done{};
    if (scene::dumpJson(document).size() <= scene::maximumDocumentBytes) return Done{};
    return refuse(Code::tooLarge, "", "A document has at most 1 MiB as text.");
}

std::string errorJson(const Error& error) {
    return scene::dumpJson(
        Json{{"code", codeName(error.code)}, {"path", error.path}, {"message", error.message}});
}

std::string changeJson(const scene::Change& change) {
    return scene::dumpJson(Json{{"command", change.command}, {"path", change.path}});
}

namespace {

Json pointJson(const Vec3& p) { return Json::array({p.x, p.y, p.z}); }

Json shapeJson(const drawing::Shape& shape, const scene::State& state) {
    const auto index = static_cast<std::size_t>(shape.object);
    Json json{{"object", index < state.objects.size() ? state.objects[index]->id : ""},
              {"role", drawing::roleName(shape.role)},
              {"kind", drawing::kindName(shape.kind)},
              {"pane", drawing::paneName(shape.pane)},
              {"index", shape.index},
              {"colour", scene::formatColour(shape.colour)},
              {"opacity", shape.colour.alpha},
              {"width", static_cast<double>(shape.width)},
              {"dashed", shape.dashed},
              {"square", shape.square},
              {"path", shape.path},
              {"text", shape.text}};
    if (shape.kind == drawing::Kind::label) {
        json["offset"] = Json::array({shape.offset[0], shape.offset[1]});
    }
    json["at"] = reinterpret_cast<std::uintptr_t>(shape.positions.data());
    json["count"] = shape.positions.size();
    if (!shape.normals.empty()) {
        json["normalsAt"] = reinterpret_cast<std::uintptr_t>(shape.normals.data());
    }
    if (!shape.indices.empty()) {
        json["indicesAt"] = reinterpret_cast<std::uintptr_t>(shape.indices.data());
        json["indexCount"] = shape.indices.size();
    }
    return json;
}

}  // namespace

std::string drawingJson(const drawing::Drawing& drawing, const scene::State& state) {
    Json bounds;
    if (!drawing.bounds.empty) {
        bounds = Json{{"min", pointJson(drawing.bounds.min)}, {"max", pointJson(drawing.bounds.max)}};
    }
    Json shapes = Json::array();
    for (const drawing::Shape& shape : drawing.shapes) shapes.push_back(shapeJson(shape, state));
    return scene::dumpJson(Json{{"bounds", std::move(bounds)}, {"shapes", std::move(shapes)}});
}

Result<Done> checkDerivative(int n, std::string_view name) {
    if (n >= 0 && n <= maximumDerivative) return Done{};
    return refuse(Code::outOfRange, std::string(name),
                  "The order of derivative is " + std::to_string(n) + "; it can be 0 to " +
                      std::to_string(maximumDerivative) + ".");
}

Result<Done> checkUnit(double t) {
    if (t >= 0 && t <= 1) return Done{};
    return refuse(std::isfinite(t) ? Code::outOfRange : Code::notFinite, "t",
                  "The parameter of a B-function is " + formatNumber(t) +
                      "; it must lie in [0, 1].");
}

Result<Done> checkTolerance(double tolerance) {
    if (std::isfinite(tolerance) && tolerance > 0) return Done{};
    return refuse(std::isfinite(tolerance) ? Code::outOfRange : Code::notFinite, "tolerance",
                  "The tolerance is " + formatNumber(tolerance) +
                      "; it is a distance and must be larger than 0.");
}

Result<Json> specWithPose(Json spec, int local, Json pose) {
    if (!pose.is_object()) {
        return refuse(Code::wrongType, "",
                      "A pose is an object such as { translate: [1, 0, 0] }.");
    }
    if (pose.contains("local")) {
        return refuse(Code::unknownField, "local",
                      "The first argument says which local curve is posed; leave out `local`.");
    }
    Json placed{{"local", local}};
    for (auto& item : pose.items()) placed[item.key()] = std::move(item.value());

    Json poses = Json::array();
    if (const Json* former = scene::member(spec, "poses"); former && former->is_array()) {
        for (const Json& one : *former) {
            if (scene::numberOr(one, "local", -1) != local) poses.push_back(one);
        }
    }
    poses.push_back(std::move(placed));
    spec["poses"] = std::move(poses);
    return spec;
}

Error seenFromPose(Error error) {
    constexpr std::string_view list = "poses[";
    if (!error.path.starts_with(list)) return error;
    const std::size_t close = error.path.find(']');
    error.path.erase(0, std::min(close + 1, error.path.size()));
    if (error.path.starts_with('.')) error.path.erase(0, 1);
    return error;
}

}  // namespace knotwork::bindings
