// The application behind a page: many views of scenes, one renderer, one Dear ImGui host that
// follows the focus. Everything crosses this border as plain numbers and strings.
//
// Positions and sizes are CSS pixels with the origin at the top left of the view; times are
// absolute page time in seconds. An unknown view id is ignored (false, 0 or an empty string).
#pragma once

#include "scene/scene.hpp"

#include <memory>
#include <string>

namespace knotwork::app {

class App {
public:
    App();
    ~App();
    App(const App&) = delete;
    App& operator=(const App&) = delete;

    /// Prepares drawing in the WebGL 2 context that is current: '' or why it cannot be done.
    std::string start();
    /// The context and everything in it is gone; views and scenes are kept.
    void contextLost();
    std::string contextRestored();

    int addView();
    void removeView(int id);
    void resize(int id, double width, double height, double pixelRatio);
    /// Shows this scene; null detaches. The view shares the scene as long as it shows it.
    void attach(int id, std::shared_ptr<scene::Scene> scene);
    void setTheme(int id, const std::string& theme);
    void setPanel(int id, bool shown);
    /// { order, decimalPoint, undo, redo, add, remove, local }, each optional: the words that the
    /// picture and the panel have of their own; `order` has {0} and {1} for the orders at 0 and 1.
    void setWords(int id, const std::string& json);
    void setReadOnly(int id, bool readOnly);
    void setReducedMotion(int id, bool reduced);
    void focus(int id);
    void fit(int id);

    /// kind: down, move, up, cancel, leave. Returns whether the view takes the event for itself.
    bool pointer(int id, const std::string& kind, double x, double y, int buttons, int modifiers,
                 const std::string& pointerType);
    /// Two fingers have moved by dx, dy and `factor` times apart; x, y is the place between them.
    bool pinch(int id, double x, double y, double dx, double dy, double factor);
    bool wheel(int id, double x, double y, double dx, double dy, int modifiers);
    bool key(int id, const std::string& key, bool down, int modifiers);
    void text(int id, const std::string& utf8);
    /// Whether there is something to take hold of at this place (for the page's touch-action).
    bool hits(int id, double x, double y, const std::string& pointerType);
    std::string cursor(int id) const;
    /// Whether the view shows a world in space, which a hand turns.
    bool spatial(int id) const;

    void setPlaying(int id, bool playing);
    bool playing(int id) const;
    void setPhase(int id, double phase);
    double phase(int id) const;
    /// Seconds after which the whole animation is back at its start; 0 where nothing moves.
    double period(int id) const;
    void tick(int id, double seconds);

    /// Whether the picture would differ from the one rendered last.
    bool needsFrame(int id) const;
    /// Paints into the lower left width × height device pixels of the current framebuffer.
    void render(int id);

    /// [{ text, x, y, align, baseline, size, weight, colour }] of the picture rendered last.
    std::string labels(int id) const;
    /// What people did since the last call: [{ type, source, path, command }].
    std::string takeEvents(int id);
    /// { object, id, path, kind, index, position, paths } or null; of a group the former tell of
    /// one, and `paths` has all.
    std::string selection(int id) const;
    void select(int id, const std::string& path);
    /// All points, or all handles, of an object; see View.
    bool selectAll(int id);
    /// Whether clicks add to what is selected and drags beside it draw a band; see View.
    void setGathering(int id, bool gathering);
    /// What is selected, for fields over the picture: { path, kind, number, count, pixel, step,
    /// value } or null. `number` of `count` of its kind, `pixel` where it is seen, `step` of the
    /// arrow keys; of a local curve or patch also its name `local` and whether it is in space, and
    /// the value is { translate, angle, scale }. Of a group the kind is `group`, `of` says point,
    /// local or patch, `count` how many they are, and the value their centre.
    std::string held(int id);
    /// Of the arrow keys, in units; 0 lets the zoom decide.
    void setStep(int id, double step);
    /// Moves what is selected by so many units, as a press of an arrow key does.
    bool shift(int id, double dx, double dy, double dz);
    /// A click in place of a drag of what is selected. `how` is move: to x, y; turn: until its own
    /// axis points there; scale: until the box of its tool stands there.
    bool place(int id, double x, double y, const std::string& how);
    /// { shown: names of panes, seams: [{ name, upright, box: [x, y, width, height], share, least,
    /// most, length }] } or null. `share` of the `length` that a seam parts is to its left or above.
    std::string panes(int id);
    /// Moves a seam; NaN puts it where it stands by itself.
    bool moveSeam(int id, const std::string& name, double share);
    /// { views, glObjects, drawCalls, vertices, frames }.
    std::string stats() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace knotwork::app
