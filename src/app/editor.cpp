#include "app/editor.hpp"

namespace knotwork::app {

using scene::Json;

void Editor::attach(std::shared_ptr<scene::Scene> scene) {
    scene_ = std::move(scene);
    gesture_.clear();
    lastCommand_ = nullptr;
}

void Editor::beginGesture(std::string_view prefix) {
    gesture_ = std::string(prefix) + "-" + std::to_string(++gestures_);
    lastCommand_ = nullptr;
    lastPath_.clear();
}

void Editor::endGesture(std::string_view source) {
    if (!lastCommand_.is_null()) report(true, source, lastPath_, lastCommand_);
    gesture_.clear();
    lastCommand_ = nullptr;
}

void Editor::cancelGesture(std::string_view source) {
    if (scene_ && scene_->cancelGesture(gesture_)) report(true, source, lastPath_, nullptr);
    gesture_.clear();
    lastCommand_ = nullptr;
}

bool Editor::run(Json command, std::string_view source) {
    if (!scene_) return false;
    if (inGesture()) command["gesture"] = gesture_;
    const auto change = scene_->execute(command);
    if (!change) return false;
    lastPath_ = change->path;
    lastCommand_ = std::move(command);
    report(!inGesture(), source, lastPath_, lastCommand_);
    return true;
}

bool Editor::runAnew(Json command, std::string_view source) {
    if (!scene_) return false;
    const bool further = inGesture() && !lastCommand_.is_null();
    // Someone else has changed the scene meanwhile: what began before that is over.
    if (further && !scene_->cancelGesture(gesture_)) return false;
    if (run(std::move(command), source)) return true;
    if (further) static_cast<void>(scene_->execute(lastCommand_));
    return false;
}

bool Editor::undo(std::string_view source) {
    if (!scene_ || !scene_->undo()) return false;
    report(true, source, "", Json{{"undo", true}});
    return true;
}

bool Editor::redo(std::string_view source) {
    if (!scene_ || !scene_->redo()) return false;
    report(true, source, "", Json{{"redo", true}});
    return true;
}

void Editor::report(bool final, std::string_view source, std::string path, Json command) {
    Json event = Json::object();
    event["type"] = final ? "change" : "input";
    event["source"] = source;
    event["path"] = std::move(path);
    event["command"] = std::move(command);
    events_.push_back(std::move(event));
}

std::string Editor::takeEvents() {
    std::string text = scene::dumpJson(events_);
    events_ = Json::array();
    return text;
}

}  // namespace knotwork::app
