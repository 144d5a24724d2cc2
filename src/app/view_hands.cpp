// What is selected, told and moved without holding it: for fields over the picture, and for clicks
// in place of drags.
#include "app/view.hpp"

#include <algorithm>


namespace knotwork::app {

namespace {

using scene::Json;

Json listOf(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

Json poseJson(const PosedLocal& local) {
    Json json = Json::object();
    json["translate"] = listOf(local.pose.translate);
    json["angle"] = local.pose.angle;
    json["scale"] = listOf(local.pose.scale);
    return json;
}

struct Place {
    std::size_t number = 0;  ///< counted from one
    std::size_t count = 0;
};

/// Among all that can be taken hold of and are of its kind and object.
Place placeAmongSiblings(const drawing::Drawing& drawing, const Target& target) {
    Place place;
    for (const Shape& shape : drawing.shapes) {
        if (!siblings(shape, target)) continue;
        if (shape.path == target.list) place.number = place.count + target.index + 1;
        place.count += shape.positions.size() / 3;
    }
    return place;
}

Place placeAmong(const std::vector<std::string>& paths, const std::string& path) {
    const auto found = std::find(paths.begin(), paths.end(), path);
    return {static_cast<std::size_t>(found - paths.begin()) + 1, paths.size()};
}

}  // namespace

std::string View::held() {
    const Figure* now = figure();
    const auto& target = emphasis_.selected;
    const PaneFigure* pane = now != nullptr && target ? now->find(target->pane) : nullptr;
    if (pane == nullptr) return "null";
    if (grouped()) return heldGroup(*pane);
    const Place place = isValue(target->kind) ? placeAmong(siblings(*target), target->path())
                                              : placeAmongSiblings(drawing(), *target);
    const Pixel at = pane->sight.toPixels(target->at);
    Json json = Json::object();
    json["path"] = target->path();
    json["kind"] = kindName(target->kind);
    json["number"] = place.number;
    json["count"] = place.count;
    json["pixel"] = Json::array({at.x, at.y});
    json["step"] = stepIn(*pane);
    if (const FunctionHandle* handle = values_.function(target->path())) {
        json["name"] = handle->label;
    }
    const scene::Object& object =
        *scene()->state().objects[static_cast<std::size_t>(target->object)];
    json["spatial"] = spatial_;
    if (target->kind == TargetKind::pose) {
        const auto local = posedLocal(object.body, target->index);
        if (!local) return "null";
        json["local"] = local->name;
        json["value"] = poseJson(*local);
    } else if (const Json* value = valueAt(scene()->state(), target->path())) {
        json["value"] = *value;
    }
    return scene::dumpJson(json);
}

/// All that is selected as one thing, at its centre.
std::string View::heldGroup(const PaneFigure& pane) const {
    const Target& first = *emphasis_.selected;
    const Vec3 centre = centreOf(chosen(), pane.sight.unitsPerPixel());
    const Pixel at = pane.sight.toPixels(centre);
    Json json = Json::object();
    json["path"] = first.path();
    json["kind"] = "group";
    const scene::Object& object =
        *scene()->state().objects[static_cast<std::size_t>(first.object)];
    const auto local = posedLocal(object.body, first.index);
    const bool pose = first.kind == TargetKind::pose && local;
    json["of"] = !pose ? kindName(first.kind) : local->name.is_array() ? "patch" : "local";
    json["count"] = emphasis_.others.size() + 1;
    json["pixel"] = Json::array({at.x, at.y});
    json["step"] = stepIn(pane);
    json["value"] = listOf(centre);
    json["spatial"] = spatial_;
    return scene::dumpJson(json);
}

/// Where a drag of this kind takes hold of what is selected; notes the part of the tool it is.
std::optional<Pixel> View::grip(std::string_view how, const PaneFigure& pane) {
    const Target& target = *emphasis_.selected;
    const auto tool = gizmo();
    if (how == "move") return pane.sight.toPixels(grouped() && tool ? tool->at : target.at);
    if (!tool) return std::nullopt;
    if (how == "turn") {
        const int axis = facingAxis(*tool, pane.sight);
        heldPart_ = GizmoPart{GizmoKind::turn, axis};
        const Vec3& own = tool->own[static_cast<std::size_t>((axis + 1) % 3)];
        return pane.sight.toPixels(tool->at + own);
    }
    for (int axis = 0; how == "scale" && axis < 3; ++axis) {
        const auto box = boxPlace(*tool, pane.sight, axis);
        if (!box) continue;
        heldPart_ = GizmoPart{GizmoKind::scale, axis};
        return box;
    }
    return std::nullopt;
}

bool View::place(const Pixel& at, std::string_view how) {
    const Figure* now = figure();
    letGo();
    if (now == nullptr || readOnly_ || !emphasis_.selected) return false;
    const PaneFigure* pane = now->find(emphasis_.selected->pane);
    const auto from = pane != nullptr ? grip(how, *pane) : std::nullopt;
    const PaneFigure* under = now->paneAt(at);
    if (!from || (under != nullptr && under != pane)) {
        heldPart_.reset();
        return false;
    }
    held_ = emphasis_.selected;
    pressedAt_ = *from;
    const bool began = beginDrag();
    if (began) {
        // Boxes scale along all axes: one click cannot say more.
        dragTo({"move", at, 1, how == "scale" ? int{shiftKey} : 0, "mouse", 0});
        editor_.endGesture("pointer");
    }
    hold_ = Hold::nothing;
    letGo();
    touch();
    return began;
}

}  // namespace knotwork::app
