#include "scene/scene.hpp"

#include "scene/commands.hpp"
#include "scene/document.hpp"
#include "scene/fields.hpp"
#include "scene/object_builders.hpp"
#include "scene/validation.hpp"

#include <algorithm>

namespace knotwork::scene {

namespace {

/// Steps share their objects, so a step costs little more than what it changed.
constexpr std::size_t maximumHistory = 500;

Result<std::string> gestureOf(const Json& command) {
    const Json* gesture = member(command, "gesture");
    if (gesture == nullptr) return std::string();
    if (!gesture->is_string()) {
        return refuse(Code::wrongType, "gesture",
                      "A gesture is named by a text, got " + describeValue(*gesture) + ".");
    }
    return gesture->get<std::string>();
}

}  // namespace

const Object* State::find(std::string_view id) const noexcept {
    for (const auto& object : objects) {
        if (object->id == id) return object.get();
    }
    return nullptr;
}

Scene::Scene(State first) { history_.push_back({std::move(first), ""}); }

Result<Scene> Scene::open(const Json& document) {
    auto state = readDocument(document);
    if (!state) return state.error();
    return Scene(std::move(*state));
}

Json Scene::document() const { return writeDocument(state()); }

Result<Change> Scene::execute(const Json& command) {
    auto executed = executeCommand(state(), command);
    if (!executed) return executed.error();
    auto gesture = gestureOf(command);
    if (!gesture) return gesture.error();
    commit(std::move(executed->state), std::move(*gesture));
    return std::move(executed->change);
}

void Scene::commit(State next, std::string gesture) {
    ++revision_;
    history_.erase(history_.begin() + static_cast<std::ptrdiff_t>(present_ + 1), history_.end());
    const bool continues = !gesture.empty() && history_.back().gesture == gesture;
    if (continues) {
        history_.back().state = std::move(next);
        return;
    }
    history_.push_back({std::move(next), std::move(gesture)});
    if (history_.size() > maximumHistory) history_.erase(history_.begin());
    present_ = history_.size() - 1;
}

bool Scene::cancelGesture(std::string_view gesture) {
    if (gesture.empty() || present_ == 0 || history_[present_].gesture != gesture) return false;
    history_.erase(history_.begin() + static_cast<std::ptrdiff_t>(present_), history_.end());
    --present_;
    ++revision_;
    return true;
}

bool Scene::undo() {
    if (!canUndo()) return false;
    --present_;
    ++revision_;
    // A gesture that was undone is over: what comes next under its name is a step of its own.
    history_[present_].gesture.clear();
    return true;
}

bool Scene::redo() {
    if (!canRedo()) return false;
    ++present_;
    ++revision_;
    history_[present_].gesture.clear();
    return true;
}

Json Scene::schema() const {
    Json list = Json::array();
    for (const auto& object : state().objects) {
        const std::string type = stringOr(object->spec, "type", "");
        list.push_back({{"object", object->id},
                        {"type", type},
                        {"label", objectTypeLabel(object->spec)},
                        {"fields", panelFieldsJson(object->spec)}});
    }
    return list;
}

}  // namespace knotwork::scene
