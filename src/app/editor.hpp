// Commands on the scene of a view, gathered into gestures, and the report of them for the page.
#pragma once

#include "scene/scene.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace knotwork::app {

class Editor {
public:
    void attach(std::shared_ptr<scene::Scene> scene);
    [[nodiscard]] scene::Scene* scene() const noexcept { return scene_.get(); }

    /// Names the gesture that the following commands belong to, one step of history together;
    /// `prefix` keeps apart the gestures of different views of one scene.
    void beginGesture(std::string_view prefix);
    [[nodiscard]] bool inGesture() const noexcept { return !gesture_.empty(); }
    /// Reports the last command of the gesture as the change; none if there was none.
    void endGesture(std::string_view source);
    /// Puts back what the gesture did, and reports that.
    void cancelGesture(std::string_view source);

    /// Executes; refused commands change nothing and are not reported. Within a gesture they are
    /// reported as `input`, alone as `change`.
    bool run(scene::Json command, std::string_view source);
    /// The same in the place of all that the gesture has done so far: for commands that say what
    /// happens since it began. A refused one leaves what the one before it did.
    bool runAnew(scene::Json command, std::string_view source);
    bool undo(std::string_view source);
    bool redo(std::string_view source);
    /// Reports what someone else (the panel) did.
    void report(bool final, std::string_view source, std::string path, scene::Json command);

    /// The report since the last call, as JSON: [{ type, source, path, command }].
    [[nodiscard]] std::string takeEvents();

private:
    std::shared_ptr<scene::Scene> scene_;
    std::string gesture_;
    unsigned gestures_ = 0;
    scene::Json lastCommand_;
    std::string lastPath_;
    scene::Json events_ = scene::Json::array();
};

}  // namespace knotwork::app
