#include "app/view.hpp"

#include "app/hit.hpp"
#include "drawing/palette.hpp"

#include <algorithm>

namespace knotwork::app {

using scene::Json;

namespace {

bool sameBox(const std::optional<Box>& a, const std::optional<Box>& b) noexcept { return a == b; }

std::vector<double> periodsOf(const scene::State& state) {
    std::vector<double> periods;
    for (const auto& effect : state.effects) periods.push_back(effect->period);
    return periods;
}

/// Width over height, within what a layout can follow.
double aspectOf(const drawing::Bounds& bounds) noexcept {
    const Vec3 size = bounds.max - bounds.min;
    if (bounds.empty || !(size.x > 0) || !(size.y > 0)) return 1;
    return std::clamp(size.x / size.y, 0.2, 5.0);
}

std::string_view alignName(ui::Align align) noexcept {
    return align == ui::Align::left ? "left" : align == ui::Align::right ? "right" : "center";
}

std::string_view baselineName(ui::Baseline baseline) noexcept {
    return baseline == ui::Baseline::top      ? "top"
           : baseline == ui::Baseline::bottom ? "bottom"
                                              : "middle";
}

/// Where a comma stands in numbers, another sign has to stand between them.
std::string withPoint(const std::string& text, const std::string& point) {
    std::string written;
    for (const char letter : text) {
        if (letter == '.') {
            written += point;
        } else {
            written += letter == ',' && point == "," ? ';' : letter;
        }
    }
    return written;
}

Json labelJson(const ui::Label& label, const Words& words, const ui::Theme& theme) {
    Json json = Json::object();
    json["text"] = label.number ? withPoint(label.text, words.decimalPoint) : label.text;
    json["x"] = label.at.x;
    json["y"] = label.at.y;
    json["align"] = alignName(label.align);
    json["baseline"] = baselineName(label.baseline);
    json["size"] = label.size;
    json["weight"] = label.strong ? 600 : 400;
    const bool clearer = ui::hasContrast(theme.name);
    json["colour"] = scene::formatColour(
        clearer ? drawing::withContrast(label.colour, theme.background, drawing::clearContrast) : label.colour);
    if (label.halo) json["halo"] = scene::formatColour(theme.background);
    return json;
}

}  // namespace

void View::attach(std::shared_ptr<scene::Scene> scene) {
    letGo();
    editor_.attach(std::move(scene));
    emphasis_ = {};
    figure_ = {};
    picture_.forget();
    valuesOf_ = 0;
    cameraPlaced_ = false;
    atHome_ = true;
    clock_.setPhase(0);
    if (editor_.scene() != nullptr) {
        revision_ = editor_.scene()->revision();
        clock_.setPeriod(loopPeriod(periodsOf(editor_.scene()->state())));
        measure();
    }
    touch();
}

void View::resize(double width, double height, double pixelRatio) {
    if (width == width_ && height == height_ && pixelRatio == pixelRatio_) return;
    width_ = std::max(0.0, width);
    height_ = std::max(0.0, height);
    pixelRatio_ = pixelRatio > 0 ? pixelRatio : 1;
    touch();
}

void View::setTheme(ui::ThemeName theme) {
    if (theme == theme_) return;
    theme_ = theme;
    touch();
}

void View::setReadOnly(bool readOnly) {
    if (readOnly) letGo();
    readOnly_ = readOnly;
}

void View::setWords(Words words) {
    words_ = std::move(words);
    touch();
}

void View::setInset(double inset) {
    if (inset == inset_) return;
    inset_ = inset;
    touch();
}

drawing::Outlook View::outlook() const {
    drawing::Outlook outlook = drawing::outlookOf(scene()->state(), {});
    outlook.spatial = spatial_;
    return outlook;
}

/// What there is to be seen, and whether it is a plane.
void View::measure() {
    const scene::State& state = scene()->state();
    bounds_ = loopBounds(state);
    const drawing::Outlook look = drawing::outlookOf(state, bounds_);
    spatial_ = look.spatial;
    depthChecked_ = true;
    if (spatial_) bounds_ = loopBounds(state, orientationOf({look.azimuth, look.elevation}));
}

void View::fit() {
    if (scene() == nullptr) return;
    measure();
    atHome_ = true;
    if (layout_.curve && cameraPlaced_ && !reducedMotion_) {
        camera_.glide(homeAim(*layout_.curve));
    } else {
        cameraPlaced_ = false;
    }
    touch();
}

bool View::lookFrom(const Viewpoint& from) {
    if (scene() == nullptr || !spatial_ || !layout_.curve) return false;
    const drawing::Bounds seen = loopBounds(scene()->state(), orientationOf(from));
    const Aim aim = fitAim(seen, *layout_.curve, from);
    if (reducedMotion_) {
        camera_.jump(aim);
    } else {
        camera_.glide(aim);
    }
    atHome_ = false;
    touch();
    return true;
}

bool View::pinch(const Pixel& between, const Pixel& by, double factor) {
    const Figure* now = figure();
    const PaneFigure* pane = now != nullptr ? now->paneAt(between) : nullptr;
    if (pane == nullptr || pane->plot.pane != Pane::curve) return false;
    camera_.pan(by);
    camera_.zoom(pane->plot.box, between, factor, false);
    atHome_ = false;
    touch();
    return true;
}

void View::tick(double seconds) {
    const double elapsed = lastTick_ < 0 ? 0 : std::clamp(seconds - lastTick_, 0.0, 0.1);
    lastTick_ = seconds;
    const double before = clock_.phase();
    clock_.advance(seconds);
    if (clock_.phase() != before) {
        stale_ = true;
        // Things move away from a resting pointer.
        if (pointedAt_ && hold_ == Hold::nothing) hover({"move", lastAt_, 0, 0, "mouse", 0});
    }
    if (camera_.gliding()) {
        camera_.advance(elapsed);
        touch();
    }
}

bool View::needsFrame() const noexcept {
    const bool changed = scene() != nullptr && scene()->revision() != revision_;
    return touched_ || changed || clock_.running() || camera_.gliding();
}

void View::painted() noexcept { touched_ = false; }

Box View::box() const noexcept {
    return ui::inside({0, 0, width_, height_}, {inset_, 0, 0, 0});
}

scene::Moment View::moment() const noexcept {
    const auto& effects = scene()->state().effects;
    const double period = clock_.period();
    const bool together = std::all_of(effects.begin(), effects.end(),
                                      [=](const auto& e) { return e->period == period; });
    if (together) return {clock_.phase(), std::nullopt};
    return {std::nullopt, clock_.phase() * period};
}

const drawing::Drawing& View::drawing() {
    const double tolerance = toleranceAt(camera_.aim().scale * pixelRatio_);
    const Picture::Key key{scene()->revision(),
                           scene()->state().effects.empty() ? 0 : clock_.phase(),
                           tolerance,
                           ui::isDark(theme_),
                           panesAsked(scene()->state()),
                           pixelAt(tolerance) * pixelRatio_};
    return picture_.get(scene()->state(), key, moment());
}

FigureRequest View::request(const drawing::Drawing& drawing) const {
    FigureRequest request;
    request.drawing = &drawing;
    request.state = &scene()->state();
    request.moment = moment();
    request.box = box();
    request.object = emphasis_.selected ? emphasis_.selected->object : -1;
    request.curveAspect = aspectOf(bounds_);
    request.spatial = spatial_;
    request.theme = theme_;
    request.orderWords = words_.order;
    request.emphasis = emphasis_;
    request.emphasis.quiet = clock_.running() && !pointedAt_ && !emphasis_.selected;
    request.frozenRange = frozenRange_;
    request.gizmo = gizmo();
    request.reading = reading();
    request.ghost = &ghost_;
    request.shares = shares_;
    request.values = &valueShapes_;
    request.band = band();
    if (heldPart_) request.emphasis.part = heldPart_;
    return request;
}

Aim View::homeAim(const Box& pane) const {
    const drawing::Outlook look = outlook();
    const Viewpoint from = look.spatial ? Viewpoint{look.azimuth, look.elevation} : fromAbove;
    Aim aim = fitAim(bounds_, pane, from);
    if (look.height > 0) aim = heightAim(aim.centre, look.height, pane, from);
    if (look.centre) aim.centre = *look.centre;
    return aim;
}

void View::followScene() {
    if (scene()->revision() == revision_) return;
    revision_ = scene()->revision();
    clock_.setPeriod(loopPeriod(periodsOf(scene()->state())));
    depthChecked_ = false;
    touch();
}

/// A plane scene that is given depth is seen in space from then on, and the other way round.
void View::followDepth() {
    if (depthChecked_ || hold_ != Hold::nothing || editor_.inGesture()) return;
    depthChecked_ = true;
    const scene::State& state = scene()->state();
    drawing::Bounds bounds = drawing().bounds;
    if (!state.effects.empty()) bounds.add(loopBounds(state));
    if (drawing::outlookOf(state, bounds).spatial != spatial_) fit();
}

void View::placeCamera(bool layoutMoved) {
    if (!layout_.curve || (cameraPlaced_ && !(atHome_ && layoutMoved))) return;
    camera_.jump(homeAim(*layout_.curve));
    cameraPlaced_ = true;
}

void View::followSelection() {
    for (auto* target : {&emphasis_.selected, &emphasis_.hovered}) {
        if (*target) *target = find((*target)->path());
    }
    if (!grouped()) return;
    std::vector<Target> found;
    for (const Target& target : chosen()) {
        if (const auto now = find(target.path())) found.push_back(*now);
    }
    choose(std::move(found));
}

Affine View::placementOf(int object) const {
    const scene::State& state = scene()->state();
    for (const scene::Placed& placed : scene::place(state, moment())) {
        if (placed.object == state.objects[static_cast<std::size_t>(object)].get()) {
            return placed.placement;
        }
    }
    return {};
}

const Figure* View::figure() {
    if (scene() == nullptr || width_ < 1 || height_ < 1) return nullptr;
    followScene();
    if (!stale_) return &figure_;
    // The first drawing needs some camera; that of the whole view is near enough to the one that
    // the layout of this very drawing will give.
    if (!cameraPlaced_) camera_.jump(homeAim(box()));
    followDepth();
    // While something is dragged the panes stay, whatever the drag makes of the piles of knots.
    if (hold_ != Hold::dragging) {
        const ui::FigureLayout layout = layoutOf(request(drawing()));
        const bool moved = !sameBox(layout.curve, layout_.curve);
        layout_ = layout;
        placeCamera(moved);
    }
    const drawing::Drawing& now = drawing();
    followValues();
    followSelection();
    drawValues();
    figure_ = composeFigure(request(now), layout_, camera_);
    stale_ = false;
    return &figure_;
}

std::optional<Gizmo> View::gizmo() const {
    const auto& target = emphasis_.selected;
    if (grouped()) return groupGizmo();
    if (readOnly_ || !target || target->kind != TargetKind::pose) return std::nullopt;
    return gizmoOf(scene()->state(), *target, placementOf(target->object), !spatial_,
                   layout_.curve.value_or(box()));
}

void View::select(std::string_view path) {
    if (scene() == nullptr) return;
    choose({});
    if (figure() != nullptr && !path.empty()) emphasis_.selected = find(path);
    touch();
}

std::string View::selection() const {
    if (!emphasis_.selected || scene() == nullptr) return "null";
    const Target& target = *emphasis_.selected;
    const auto& objects = scene()->state().objects;
    Json json = Json::object();
    json["object"] = target.object;
    json["id"] = static_cast<std::size_t>(target.object) < objects.size()
                     ? objects[static_cast<std::size_t>(target.object)]->id
                     : std::string();
    json["path"] = target.path();
    json["kind"] = kindName(target.kind);
    json["index"] = target.index;
    json["position"] = Json::array({target.at.x, target.at.y, target.at.z});
    for (const Target& one : chosen()) json["paths"].push_back(one.path());
    return scene::dumpJson(json);
}

std::string View::labels(const std::function<bool(const ui::Box&)>& covered) const {
    Json list = Json::array();
    for (const PaneFigure& pane : figure_.panes) {
        for (const ui::Label& label : pane.plot.labels) {
            if (covered(ui::boxOf(label))) continue;
            list.push_back(labelJson(label, words_, ui::theme(theme_)));
        }
    }
    return scene::dumpJson(list);
}

}  // namespace knotwork::app
