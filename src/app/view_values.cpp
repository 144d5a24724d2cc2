// A view's handles of values: parameters of B-functions, and how far effects go.
#include "app/view.hpp"
#include "ui/theme.hpp"

#include <algorithm>
#include <cmath>

namespace knotwork::app {

namespace {

using scene::Json;

constexpr float handleWidth = 10;  // CSS pixels
constexpr double guideStrength = 0.75;

Shape dotOf(const Target& target, const scene::Colour& colour) {
    Shape dot;
    dot.object = target.object;
    dot.role = drawing::Role::handle;
    dot.kind = drawing::Kind::points;
    dot.pane = target.pane;
    dot.positions = {target.at.x, target.at.y, target.at.z};
    dot.colour = colour;
    dot.width = handleWidth;
    dot.path = target.list;
    return dot;
}

/// The first of each kind that an object offers, in the order of keys.
std::vector<std::string> firstOfKinds(const drawing::Drawing& drawing, const ValueHandles& values,
                                      int object) {
    std::vector<std::string> paths;
    for (const TargetKind kind : {TargetKind::point, TargetKind::pose, TargetKind::knot}) {
        for (const Shape& shape : drawing.shapes) {
            const bool fits = shape.object == object && offers(shape) &&
                              kindOfList(shape.path) == kind && !shape.positions.empty();
            if (!fits) continue;
            paths.push_back(indexed(shape.path, 0));
            break;
        }
    }
    for (const TargetKind kind : {TargetKind::parameter, TargetKind::effect}) {
        Target any;
        any.object = object;
        any.kind = kind;
        const std::vector<std::string> all = values.pathsLike(any);
        if (!all.empty()) paths.push_back(all.front());
    }
    return paths;
}

}  // namespace

void View::followValues() {
    const auto& selected = emphasis_.selected;
    NearLocal near = valuesNear_;
    if (selected && selected->kind == TargetKind::pose) near = {selected->object, selected->index};
    if (valuesOf_ == revision_ + 1 && near.object == valuesNear_.object &&
        near.index == valuesNear_.index) {
        return;
    }
    const scene::State& state = scene()->state();
    if (valuesOf_ != revision_ + 1) values_.functions = functionHandles(state);
    values_.effects = effectHandles(state, spatial_, near);
    valuesOf_ = revision_ + 1;
    valuesNear_ = near;
}

/// Those of B-functions always, those of an effect while something of its object is selected and
/// nothing moves.
void View::drawValues() {
    valueShapes_.clear();
    if (readOnly_) return;
    const scene::Colour colour = ui::theme(theme_).accent;
    for (const FunctionHandle& handle : values_.functions) {
        valueShapes_.push_back(dotOf(targetOf(handle), colour));
    }
    const auto& selected = emphasis_.selected;
    const bool still = !clock_.running() || (selected && selected->kind == TargetKind::effect);
    if (!selected || !still) return;
    scene::Colour faint = colour;
    faint.alpha *= guideStrength;
    for (const EffectHandle& handle : values_.effects) {
        if (handle.object != selected->object) continue;
        for (Shape& guide : guidesOf(handle, spatial_, faint)) {
            valueShapes_.push_back(std::move(guide));
        }
    }
    for (const EffectHandle& handle : values_.effects) {
        if (handle.object != selected->object) continue;
        valueShapes_.push_back(dotOf(targetOf(handle), colour));
    }
}

std::optional<Target> View::find(std::string_view path) {
    if (auto element = findTarget(drawing(), path)) return element;
    return values_.find(path);
}

std::vector<std::string> View::siblings(const Target& target) {
    return isValue(target.kind) ? values_.pathsLike(target) : siblingsOf(drawing(), target);
}

bool View::beginValueDrag(const PaneFigure& pane) {
    if (const FunctionHandle* handle = values_.function(held_->path())) {
        valueDrag_.emplace(*handle, pressedAt_, pane.sight);
    } else if (const EffectHandle* effect = values_.effect(held_->path())) {
        valueDrag_.emplace(*effect, pressedAt_, pane.sight);
    }
    return valueDrag_.has_value();
}

/// A number by the first coordinate, as decimal as that is.
void View::setBy(const Target& target, const Vec3& by) {
    const Json* was = valueAt(scene()->state(), target.path());
    if (was == nullptr) return;
    const auto more = [](double number, double step) {
        return step == 0 ? number : roundedTo(number + step, std::abs(step) / 1e6);
    };
    Json to = *was;
    if (to.is_number()) {
        to = more(was->get<double>(), by.x);
    } else {
        for (std::size_t k = 0; k < std::min<std::size_t>(to.size(), 3); ++k) {
            to[k] = more((*was)[k].get<double>(), by[static_cast<glm::length_t>(k)]);
        }
    }
    editor_.run(setCommand(target.path(), std::move(to)), "key");
}

/// From points to handles, knots, parameters of B-functions, effects, and round again.
bool View::selectNextKind() {
    if (hold_ != Hold::nothing || figure() == nullptr) return false;
    const auto& selected = emphasis_.selected;
    const std::size_t count = scene()->state().objects.size();
    const std::size_t first = selected ? static_cast<std::size_t>(selected->object) : 0;
    for (std::size_t k = 0; k < (selected ? 1 : count); ++k) {
        const auto paths = firstOfKinds(drawing(), values_, static_cast<int>(first + k));
        if (paths.empty()) continue;
        const auto here = std::find_if(paths.begin(), paths.end(), [&](const std::string& path) {
            const auto target = find(path);
            return selected && target && target->kind == selected->kind;
        });
        const bool next = here != paths.end() && here + 1 != paths.end();
        select(next ? *(here + 1) : paths.front());
        return true;
    }
    return false;
}

}  // namespace knotwork::app
