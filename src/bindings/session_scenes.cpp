// The part of the session that holds scenes.
#include "bindings/marshal.hpp"
#include "bindings/session.hpp"
#include "scene/builtin.hpp"
#include "scene/schema.hpp"

#include <cmath>

namespace knotwork::bindings {

using scene::Scene;

namespace {

/// A bit a pane, in the order of the enumeration.
drawing::Panes panesOf(unsigned bits) {
    const auto has = [&](drawing::Pane pane) { return (bits >> static_cast<unsigned>(pane) & 1U) != 0; };
    return {has(drawing::Pane::curve), has(drawing::Pane::basis), has(drawing::Pane::knots),
            has(drawing::Pane::bFunction), has(drawing::Pane::hodograph),
            has(drawing::Pane::curvature)};
}

}  // namespace

int Session::openScene(unsigned bytes) {
    auto document = input(bytes);
    if (!document) return refuse(document.error());
    if (const auto size = checkSize(*document, bytes); !size) return refuse(size.error());
    auto opened = Scene::open(*document);
    if (!opened) return refuse(opened.error());
    return hold(std::make_shared<Scene>(std::move(*opened)));
}

std::shared_ptr<Scene> Session::scene(int handle) const {
    const Slot* found = slot(handle);
    const auto* held = found ? std::get_if<std::shared_ptr<Scene>>(&found->value) : nullptr;
    return held ? *held : nullptr;
}

std::string Session::sceneDocument(int handle) {
    const Scene* held = find<Scene>(handle);
    return held ? scene::dumpJson(held->document()) : std::string();
}

std::string Session::sceneSchema(int handle) {
    const Scene* held = find<Scene>(handle);
    return held ? scene::dumpJson(held->schema()) : std::string();
}

std::string Session::sceneExecute(int handle, unsigned bytes) {
    Scene* held = find<Scene>(handle);
    if (!held) return {};
    auto command = input(bytes);
    auto change = command ? held->execute(*command) : Result<scene::Change>(command.error());
    if (change) return changeJson(*change);
    refuse(change.error());
    return {};
}

int Session::sceneUndo(int handle) {
    Scene* held = find<Scene>(handle);
    return held ? int{held->undo()} : -1;
}

int Session::sceneRedo(int handle) {
    Scene* held = find<Scene>(handle);
    return held ? int{held->redo()} : -1;
}

bool Session::sceneCanUndo(int handle) {
    const Scene* held = find<Scene>(handle);
    return held && held->canUndo();
}

bool Session::sceneCanRedo(int handle) {
    const Scene* held = find<Scene>(handle);
    return held && held->canRedo();
}

double Session::sceneRevision(int handle) {
    const Scene* held = find<Scene>(handle);
    return held ? static_cast<double>(held->revision()) : -1;
}

std::string Session::sceneSelection(int handle) {
    const Scene* held = find<Scene>(handle);
    return held ? scene::dumpJson(scene::Json(held->selection())) : std::string();
}

bool Session::sceneSelect(int handle, unsigned bytes) {
    Scene* held = find<Scene>(handle);
    if (!held) return false;
    const auto paths = input(bytes);
    const auto selected = paths ? held->select(*paths) : Result<Done>(paths.error());
    if (!selected) refuse(selected.error());
    return selected.ok();
}

std::string Session::sceneDrawing(int handle, double phase, double time, double tolerance,
                                  unsigned panes) {
    const Scene* held = find<Scene>(handle);
    if (!held) return {};
    drawing::Options options;
    options.panes = panesOf(panes);
    if (!std::isnan(phase)) options.moment.phase = phase;
    if (!std::isnan(time)) options.moment.time = time;
    if (!std::isnan(tolerance)) {
        if (auto distance = checkTolerance(tolerance); !distance) {
            refuse(distance.error());
            return {};
        }
        options.tolerance = tolerance;
    }
    if (handle != drawn_) drawings_.forget();
    drawn_ = handle;
    return drawingJson(drawings_.draw(held->state(), options), held->state());
}

std::string Session::scenes() const { return scene::dumpJson(scene::describeScenes()); }

std::string Session::documentSchema() const { return scene::dumpJson(scene::documentSchema()); }

}  // namespace knotwork::bindings
