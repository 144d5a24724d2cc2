// A scene: a document that has been checked, its history, and the commands that change it.
//
// A state is immutable and shares its objects with its neighbours in the history, so undo is a
// step back and costs nothing. Every front end changes a scene by the same commands.
#pragma once

#include "geometry/line_crossings.hpp"
#include "scene/body.hpp"
#include "scene/colour.hpp"
#include "scene/json.hpp"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace knotwork::scene {

struct Trace;

/// What of an object is drawn.
struct Show {
    bool curve = true;
    bool surface = true;
    bool isolines = true;
    bool wireframe = false;
    bool polygon = true;
    bool points = true;
    bool knots = true;
    bool locals = false;
    bool handles = true;
    bool basis = true;
    bool bFunction = true;
    bool comb = false;
    bool hodograph = false;
    bool curvature = false;
    bool osculating = false;
    bool hull = false;
    bool frames = false;
    bool sphere = false;
    bool crossings = false;
    bool residuals = true;
    bool labels = false;
};

/// By what a surface is coloured.
enum class Colouring { colour, gaussian, mean };

struct Style {
    Colour colour;       ///< with the opacity
    double width = 2.5;  ///< of the curve, in CSS pixels
    Colouring colouring = Colouring::colour;
    bool dashed = false;  ///< the curve, and what stands for it in plots
};

/// One object of a scene, immutable once made.
struct Object {
    Json spec;  ///< canonical
    std::string id;
    Style style;
    Show show;
    Body body;
    /// Where the frame, the osculating circle … are taken, in the domain.
    double parameter = 0;
    std::shared_ptr<const Trace> trace = {};  ///< null: none is shown
    std::size_t traceFrame = 0;               ///< which of its frames is
    std::size_t bytes = 0;                    ///< about as much memory as it takes
    std::optional<PlaneLine> line = {};       ///< whose crossings are counted
};

enum class EffectKind { translate, rotate, scale, simulate, morph, colour };

struct Effect {
    Json spec;
    EffectKind kind = EffectKind::translate;
    std::string target;
    double period = 10;
    BFunction easing;
    /// Of the one local curve or patch (row by row) that moves; none: the whole object.
    std::optional<std::size_t> local;
    Vec3 translate{0.0};
    Vec3 axis{0.0, 0.0, 1.0};
    double angle = 0;
    Vec3 factor{1.0};
    Vec3 center{0.0};  ///< of the turn or scaling of the whole object
    double seed = 0;
    std::optional<Curve> curve;  ///< of a morph
    Colour to;
};

struct State {
    std::shared_ptr<const Json> header;  ///< knotwork, title, description, view
    std::vector<std::shared_ptr<const Object>> objects;
    std::vector<std::shared_ptr<const Effect>> effects;

    [[nodiscard]] const Object* find(std::string_view id) const noexcept;
};

/// What a command changed, for listeners.
struct Change {
    std::string command;  ///< `set`, `move`, `insert`, `remove`, `add`, `pose`, `insertKnot`, `all`
    /// The place. Of a knot that was pulled off equal ones, the one that moved; of several places,
    /// what their paths have in common.
    std::string path;
};

/// What is selected: paths into the document.
using Selection = std::vector<std::string>;

constexpr std::size_t maximumSelection = 10'000;

class Scene {
public:
    /// Checks the whole document; the error names the place. VERSION for a document of a future
    /// version.
    static Result<Scene> open(const Json& document);

    /// The canonical document.
    [[nodiscard]] Json document() const;
    [[nodiscard]] const State& state() const noexcept { return history_[present_].state; }

    /// A command as executeCommand() (commands.hpp) knows it, with an optional `gesture`: commands of
    /// one gesture become one step of history; and an optional `selection`: what is selected from
    /// then on. A refused command leaves everything as it was.
    Result<Change> execute(const Json& command);
    /// Takes back all that the running gesture did, as Escape does during a drag.
    bool cancelGesture(std::string_view gesture);
    bool undo();
    bool redo();
    [[nodiscard]] bool canUndo() const noexcept { return present_ > 0; }
    [[nodiscard]] bool canRedo() const noexcept { return present_ + 1 < history_.size(); }

    /// What is selected. Undo brings back what was selected before the step, redo what was selected
    /// after it. Paths that lead nowhere any more are left out.
    [[nodiscard]] Selection selection() const;
    /// Selects without a step of history. WRONG_TYPE, TOO_LARGE or SYNTAX at `selection[i]`.
    Result<Done> select(const Json& paths);

    /// Grows by one with every visible change, undo and redo included.
    [[nodiscard]] std::uint64_t revision() const noexcept { return revision_; }

    /// [{ object, type, label, fields: panelFieldsJson(object) }].
    [[nodiscard]] Json schema() const;

private:
    struct Step {
        State state;
        std::string gesture;
        Selection before{};  ///< what was selected when the step began
        Selection after{};
    };
    explicit Scene(State first);
    void commit(Step next);
    void forgetAfter(std::size_t last);
    void keepWithinLimits();

    std::vector<Step> history_;
    std::size_t present_ = 0;
    std::size_t bytes_ = 0;  ///< of all objects of the history, each counted once
    Selection selection_;
    std::uint64_t revision_ = 0;
};

}  // namespace knotwork::scene
