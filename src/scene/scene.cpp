#include "scene/scene.hpp"

#include "scene/commands.hpp"
#include "scene/document.hpp"
#include "scene/fields.hpp"
#include "scene/object_builders.hpp"
#include "scene/path.hpp"
#include "scene/validation.hpp"

#include <algorithm>

namespace knotwork::scene {

namespace {

/// Steps share their objects, so a step costs little more than what it changed.
constexpr std::size_t maximumHistory = 500;
/// Of the objects of all steps, where each of them is large.
constexpr std::size_t maximumHistoryBytes = std::size_t{128} << 20U;

Result<std::string> gestureOf(const Json& command) {
    const Json* gesture = member(command, "gesture");
    if (gesture == nullptr) return std::string();
    if (!gesture->is_string()) {
        return refuse(Code::wrongType, "gesture",
                      "A gesture is named by a text, got " + describeValue(*gesture) + ".");
    }
    return gesture->get<std::string>();
}

Result<Selection> readSelection(const Json& given) {
    if (!given.is_array()) {
        return refuse(Code::wrongType, "selection",
                      "A selection is a list of paths, got " + describeValue(given) + ".");
    }
    if (given.size() > maximumSelection) {
        return refuse(Code::tooLarge, "selection",
                      std::to_string(given.size()) + " paths; at most " +
                          std::to_string(maximumSelection) + " can be selected.");
    }
    Selection selection;
    for (std::size_t i = 0; i < given.size(); ++i) {
        if (!given[i].is_string()) {
            return refuse(Code::wrongType, indexed("selection", i),
                          "Expected a path such as \"objects[0].points[2]\", got " +
                              describeValue(given[i]) + ".");
        }
        const auto path = parsePath(given[i].get_ref<const std::string&>());
        if (!path) return path.error().under(indexed("selection", i));
        selection.push_back(formatPath(*path));
    }
    return selection;
}

/// Whether there is something at the path.
bool leadsSomewhere(const State& state, const Path& path) {
    const std::span<const PathStep> all(path);
    const bool entry = path.size() >= 2 && path[1].isIndex();
    if (entry && path[0].key == "objects") {
        const std::size_t i = path[1].index;
        return i < state.objects.size() && find(state.objects[i]->spec, all.subspan(2)) != nullptr;
    }
    if (entry && path[0].key == "effects") {
        const std::size_t i = path[1].index;
        return i < state.effects.size() && find(state.effects[i]->spec, all.subspan(2)) != nullptr;
    }
    return find(*state.header, all) != nullptr;
}

/// Of those objects of `state` that `without` does not share. Only neighbours in the history have
/// objects in common.
std::size_t ownBytes(const State& state, const State* without) {
    std::size_t bytes = 0;
    for (std::size_t i = 0; i < state.objects.size(); ++i) {
        const auto& object = state.objects[i];
        const auto shares = [&](const auto& other) { return other == object; };
        const bool shared =
            without != nullptr &&
            ((i < without->objects.size() && shares(without->objects[i])) ||
             std::any_of(without->objects.begin(), without->objects.end(), shares));
        if (!shared) bytes += object->bytes;
    }
    return bytes;
}

}  // namespace

const Object* State::find(std::string_view id) const noexcept {
    for (const auto& object : objects) {
        if (object->id == id) return object.get();
    }
    return nullptr;
}

Scene::Scene(State first) {
    bytes_ = ownBytes(first, nullptr);
    history_.push_back({.state = std::move(first), .gesture = ""});
}

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
    Step next{.state = std::move(executed->state),
              .gesture = std::move(*gesture),
              .before = selection_,
              .after = selection_};
    if (const Json* given = member(command, "selection")) {
        auto selected = readSelection(*given);
        if (!selected) return selected.error();
        next.after = std::move(*selected);
    }
    commit(std::move(next));
    return std::move(executed->change);
}

void Scene::forgetAfter(std::size_t last) {
    while (history_.size() > last + 1) {
        bytes_ -= ownBytes(history_.back().state, &history_[history_.size() - 2].state);
        history_.pop_back();
    }
}

void Scene::keepWithinLimits() {
    while (history_.size() > 2 &&
           (history_.size() > maximumHistory || bytes_ > maximumHistoryBytes)) {
        bytes_ -= ownBytes(history_[0].state, &history_[1].state);
        history_.erase(history_.begin());
        --present_;
    }
}

void Scene::commit(Step next) {
    ++revision_;
    selection_ = next.after;
    forgetAfter(present_);
    Step& last = history_[present_];
    if (!next.gesture.empty() && last.gesture == next.gesture) {
        next.before = std::move(last.before);
        forgetAfter(--present_);  // never the first one: no gesture made that
    }
    bytes_ += ownBytes(next.state, &history_[present_].state);
    history_.push_back(std::move(next));
    ++present_;
    keepWithinLimits();
}

bool Scene::cancelGesture(std::string_view gesture) {
    if (gesture.empty() || present_ == 0 || history_[present_].gesture != gesture) return false;
    selection_ = history_[present_].before;
    forgetAfter(--present_);
    ++revision_;
    return true;
}

bool Scene::undo() {
    if (!canUndo()) return false;
    selection_ = history_[present_].before;
    --present_;
    ++revision_;
    // A gesture that was undone is over: what comes next under its name is a step of its own.
    history_[present_].gesture.clear();
    return true;
}

bool Scene::redo() {
    if (!canRedo()) return false;
    ++present_;
    selection_ = history_[present_].after;
    ++revision_;
    history_[present_].gesture.clear();
    return true;
}

Selection Scene::selection() const {
    Selection alive;
    for (const std::string& text : selection_) {
        const auto path = parsePath(text);
        if (path && leadsSomewhere(state(), *path)) alive.push_back(text);
    }
    return alive;
}

Result<Done> Scene::select(const Json& paths) {
    auto selected = readSelection(paths);
    if (!selected) return selected.error();
    selection_ = std::move(*selected);
    return Done{};
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
