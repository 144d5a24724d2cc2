// A view of a scene: camera, clock, what is pointed at and held, and the figure that results.
//
// No GL here: what a view shows is asked for with figure() and painted by someone else, so that
// every click, drag and key can be tested without a browser.
#pragma once

#include "app/clock.hpp"
#include "app/drag.hpp"
#include "app/editor.hpp"
#include "app/figure.hpp"
#include "app/group_drag.hpp"
#include "app/picture.hpp"
#include "app/value_drag.hpp"
#include "drawing/outlook.hpp"

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace knotwork::app {

/// Pixels and kind as PointerEvent has them; time in seconds of any clock, for double clicks.
struct PointerInput {
    std::string_view kind;  ///< down, move, up, cancel, leave
    Pixel at;
    int buttons = 0;
    int modifiers = 0;
    std::string_view pointerType = "mouse";
    double time = 0;
};

class View {
public:
    explicit View(int id) : id_(id) {}

    void attach(std::shared_ptr<scene::Scene> scene);
    void resize(double width, double height, double pixelRatio);
    void setTheme(ui::ThemeName theme);
    void setReadOnly(bool readOnly);
    void setReducedMotion(bool reduced) noexcept { reducedMotion_ = reduced; }
    void setWords(Words words);
    /// Width at the left that is covered by a panel and left free by the figure.
    void setInset(double inset);
    void fit();
    /// Looks from there at all there is, in a scene in space.
    bool lookFrom(const Viewpoint& from);
    /// Whether what is seen can be turned.
    [[nodiscard]] bool spatial() const noexcept { return spatial_; }
    /// Two fingers: moves the picture along with them and scales it about the place between them.
    bool pinch(const Pixel& between, const Pixel& by, double factor);

    [[nodiscard]] Clock& clock() noexcept { return clock_; }
    [[nodiscard]] const Clock& clock() const noexcept { return clock_; }
    [[nodiscard]] Editor& editor() noexcept { return editor_; }
    void tick(double seconds);

    [[nodiscard]] bool needsFrame() const noexcept;
    void touch() noexcept { touched_ = stale_ = true; }
    /// The figure of this moment, made anew when something changed; null without scene or size.
    const Figure* figure();
    /// The last figure was painted: no frame is due until something else changes.
    void painted() noexcept;

    bool pointer(const PointerInput& input);
    bool wheel(const Pixel& at, double dy, int modifiers);
    bool key(std::string_view name, bool down, int modifiers);
    [[nodiscard]] bool hits(const Pixel& at, std::string_view pointerType);
    [[nodiscard]] std::string cursor() const;
    /// Whether the pointer holds something of the view, or its picture.
    [[nodiscard]] bool holding() const noexcept { return hold_ != Hold::nothing; }
    /// Lets go of everything without trace, as when the window loses the focus during a drag.
    void blur();

    [[nodiscard]] const std::optional<Target>& selected() const noexcept {
        return emphasis_.selected;
    }
    void select(std::string_view path);
    /// All points or handles of the object that something is selected of, or of the first that has
    /// some.
    bool selectAll();
    /// While gathering a click adds to what is selected or takes it out, and a drag of a hand or
    /// finger over the background draws a band round what it selects; Ctrl or Shift do the same.
    void setGathering(bool gathering) noexcept { gathering_ = gathering; }
    [[nodiscard]] std::string selection() const;

    /// What is selected, for hands that cannot hold it: App::held.
    [[nodiscard]] std::string held();
    /// How far an arrow key moves, in units; 0 lets the zoom decide.
    void setStep(double step) noexcept { step_ = step; }
    /// Moves what is selected by so many units along its object's axes, as the arrow keys do.
    bool shift(const Vec3& by);
    /// A click in place of a drag of what is selected: App::place.
    bool place(const Pixel& at, std::string_view how);

    /// Which panes there are and the seams between them: App::panes.
    [[nodiscard]] std::string panes();
    /// Puts a seam where so large a share of what it parts is to its left or above it; without a
    /// share where it stands by itself. That is kept from scene to scene.
    bool moveSeam(std::string_view name, std::optional<double> share);

    /// `covered` tells whether something lies over a box of the view, so that no label is wanted.
    [[nodiscard]] std::string labels(const std::function<bool(const ui::Box&)>& covered) const;
    [[nodiscard]] std::string labels() const {
        return labels([](const ui::Box&) { return false; });
    }

    [[nodiscard]] double width() const noexcept { return width_; }
    [[nodiscard]] double height() const noexcept { return height_; }
    [[nodiscard]] double pixelRatio() const noexcept { return pixelRatio_; }
    [[nodiscard]] ui::ThemeName theme() const noexcept { return theme_; }
    [[nodiscard]] const Camera& camera() const noexcept { return camera_; }
    [[nodiscard]] std::uint64_t drawingsMade() const noexcept { return picture_.made(); }

private:
    enum class Hold { nothing, pressedTarget, dragging, pressedEmpty, panning, orbiting, banding };

    [[nodiscard]] const scene::Scene* scene() const noexcept { return editor_.scene(); }
    [[nodiscard]] Box box() const noexcept;
    [[nodiscard]] scene::Moment moment() const noexcept;
    [[nodiscard]] const drawing::Drawing& drawing();
    [[nodiscard]] FigureRequest request(const drawing::Drawing& drawing) const;
    [[nodiscard]] Aim homeAim(const Box& pane) const;
    [[nodiscard]] drawing::Outlook outlook() const;
    void measure();
    void followScene();
    void followDepth();
    void placeCamera(bool layoutMoved);
    void followSelection();
    [[nodiscard]] Affine placementOf(int object) const;
    [[nodiscard]] std::string gesturePrefix() const { return "view" + std::to_string(id_); }

    // view_pointer.cpp
    void noteWhereabouts(const PointerInput& input);
    bool press(const PointerInput& input);
    bool follow(const PointerInput& input);
    bool release(const PointerInput& input);
    void dragTo(const PointerInput& input);
    /// Whether a click adds to what is selected.
    [[nodiscard]] bool joins() const noexcept {
        return gathering_ || (pressedWith_ & (shiftKey | commandKey)) != 0;
    }
    bool beginDrag();
    bool beginSingleDrag(const PaneFigure& pane);
    [[nodiscard]] std::optional<Gizmo> gizmo() const;
    [[nodiscard]] std::optional<Reading> reading() const;
    [[nodiscard]] std::optional<Reading> groupReading() const;
    [[nodiscard]] std::optional<Reading> valueReading() const;
    void rememberShape();
    [[nodiscard]] std::optional<GizmoPart> partUnder(const Pixel& at, double radius,
                                                     const std::optional<Target>& target) const;
    void wander(const PointerInput& input);
    void letGo();
    void hover(const PointerInput& input);
    void point(const Emphasis& at);
    void noteClick(const PointerInput& input);

    // view_group.cpp
    [[nodiscard]] bool grouped() const noexcept { return !emphasis_.others.empty(); }
    [[nodiscard]] std::vector<Target> chosen() const;
    [[nodiscard]] bool isChosen(const Target& target) const noexcept;
    void choose(std::vector<Target> targets);
    void take(const Target& target, bool joins);
    [[nodiscard]] Group group(double pixel) const;
    [[nodiscard]] std::optional<Gizmo> groupGizmo() const;
    bool beginGroupDrag(const PaneFigure& pane);
    void beginBand();
    void drawBand();
    [[nodiscard]] std::optional<Box> band() const noexcept;
    bool extend(int step);

    // view_values.cpp
    void followValues();
    void drawValues();
    [[nodiscard]] std::optional<Target> find(std::string_view path);
    [[nodiscard]] std::vector<std::string> siblings(const Target& target);
    bool beginValueDrag(const PaneFigure& pane);
    void setBy(const Target& target, const Vec3& by);
    bool selectNextKind();

    // view_editing.cpp
    bool doubleClick(const PointerInput& input, const std::optional<Target>& target);
    bool insertKnotAt(const PaneFigure& pane, const Pixel& at, const std::optional<Target>& target);
    bool addPointAt(const Pixel& at);

    // view_keys.cpp
    bool escape();
    bool removeSelected();
    bool nudge(const Vec3& direction, int modifiers);
    void moveBy(const Target& target, const Vec3& by);
    [[nodiscard]] double stepIn(const PaneFigure& pane) const noexcept;
    bool turn(const Vec3& direction);
    bool selectNeighbour(int step);
    bool zoomKey(double factor);
    bool turnSelected(double angle);
    bool scaleSelected(double factor);
    [[nodiscard]] std::optional<PosedLocal> selectedLocal() const;
    void poseSelected(const scene::Json& local, const Pose& pose);
    void runGroup(GizmoKind kind, const Vec3& by, double angle, double factor);

    // view_hands.cpp
    [[nodiscard]] std::string heldGroup(const PaneFigure& pane) const;
    [[nodiscard]] std::optional<Pixel> grip(std::string_view how, const PaneFigure& pane);

    int id_;
    double width_ = 0;
    double height_ = 0;
    double pixelRatio_ = 1;
    double inset_ = 0;
    ui::ThemeName theme_ = ui::ThemeName::light;
    bool readOnly_ = false;
    bool reducedMotion_ = false;
    double step_ = 0;  ///< of the arrow keys, 0 by the zoom
    Words words_;

    Editor editor_;
    Clock clock_;
    Camera camera_;
    Picture picture_;
    Figure figure_;
    Emphasis emphasis_;

    drawing::Bounds bounds_;         ///< that fit() shows, as seen from home
    bool spatial_ = false;
    bool depthChecked_ = true;       ///< spatial_ is that of the present revision
    ui::FigureLayout layout_;
    ui::Shares shares_;
    bool touched_ = true;            ///< a frame is due
    bool stale_ = true;              ///< figure_ is not that of the present state
    bool atHome_ = true;             ///< the camera shows what fit() would, also in another size
    bool cameraPlaced_ = false;
    std::uint64_t revision_ = 0;     ///< of the scene when it was last followed
    double lastTick_ = -1;

    bool pointedAt_ = false;  ///< the pointer is over the view
    Hold hold_ = Hold::nothing;
    std::optional<Target> held_;
    std::optional<GizmoPart> heldPart_;  ///< of the tool at what is held
    std::optional<Drag> drag_;
    std::optional<GroupDrag> groupDrag_;
    std::optional<ValueDrag> valueDrag_;
    ValueHandles values_;
    std::uint64_t valuesOf_ = 0;         ///< the revision they were made for, 0 for none
    NearLocal valuesNear_;
    std::vector<Shape> valueShapes_;     ///< of those that are shown
    std::vector<Shape> ghost_;  ///< of what is dragged, as it was before
    std::optional<Interval> frozenRange_;
    Pixel pressedAt_;
    int pressedWith_ = 0;     ///< modifiers
    bool gathering_ = false;
    std::vector<Target> chosenBefore_;  ///< the band
    /// Presses of keys on a group, one after the other.
    struct Run {
        Group group;
        GizmoKind kind = GizmoKind::move;
        Vec3 by{0.0};
        double angle = 0;
        double factor = 1;
    };
    std::optional<Run> run_;
    Pixel lastAt_;
    double lastClickTime_ = -1;
    Pixel lastClickAt_;
};

}  // namespace knotwork::app
