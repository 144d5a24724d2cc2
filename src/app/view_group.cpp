// A view's group: several points, or several local curves or patches, that are selected together.
#include "app/hit.hpp"
#include "app/view.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace knotwork::app {

namespace {

/// Knots have neighbours to mind, and stand in no plane with others.
bool joinsGroups(TargetKind kind) noexcept {
    return kind == TargetKind::point || kind == TargetKind::pose;
}

Box boxBetween(const Pixel& a, const Pixel& b) noexcept {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::abs(a.x - b.x), std::abs(a.y - b.y)};
}

/// All that a drawing offers in the pane of curves, of this kind and, unless that is -1, object.
std::vector<Target> offered(const drawing::Drawing& drawing, TargetKind kind, int object) {
    std::vector<Target> found;
    for (const Shape& shape : drawing.shapes) {
        if (!offers(shape) || kindOfList(shape.path) != kind || shape.pane != Pane::curve) continue;
        if (object >= 0 && shape.object != object) continue;
        for (std::size_t k = 0; k < shape.positions.size() / 3; ++k) {
            found.push_back({shape.object, shape.pane, kind, shape.path, k, positionOf(shape, k)});
        }
    }
    return found;
}

/// The first object that has something of the kind, or -1.
int firstWith(const drawing::Drawing& drawing, TargetKind kind) {
    const std::vector<Target> all = offered(drawing, kind, -1);
    return all.empty() ? -1 : all.front().object;
}

}  // namespace

std::vector<Target> View::chosen() const {
    std::vector<Target> all;
    if (!emphasis_.selected) return all;
    all.push_back(*emphasis_.selected);
    all.insert(all.end(), emphasis_.others.begin(), emphasis_.others.end());
    return all;
}

bool View::isChosen(const Target& target) const noexcept {
    return (emphasis_.selected && emphasis_.selected->same(target)) || emphasis_.groups(target);
}

void View::choose(std::vector<Target> targets) {
    emphasis_.selected.reset();
    if (!targets.empty()) {
        emphasis_.selected = std::move(targets.front());
        targets.erase(targets.begin());
    }
    emphasis_.others = std::move(targets);
}

/// A click: alone, or with what is selected already, or no longer with it.
void View::take(const Target& target, bool joins) {
    touch();
    std::vector<Target> all = chosen();
    const bool fits = !all.empty() && joinsGroups(target.kind) && all.front().kind == target.kind;
    if (!joins || !fits) return choose({target});
    const auto there = std::find_if(all.begin(), all.end(),
                                    [&](const Target& one) { return one.same(target); });
    if (there != all.end()) {
        all.erase(there);
    } else {
        all.push_back(target);
    }
    choose(std::move(all));
}

bool View::selectAll() {
    if (scene() == nullptr || hold_ != Hold::nothing || figure() == nullptr) return false;
    const auto& selected = emphasis_.selected;
    const int object = selected ? selected->object : -1;
    const bool poses = selected && selected->kind == TargetKind::pose;
    std::vector<TargetKind> kinds{TargetKind::point, TargetKind::pose};
    if (poses) std::swap(kinds[0], kinds[1]);
    for (const TargetKind kind : kinds) {
        const int of = object >= 0 ? object : firstWith(drawing(), kind);
        std::vector<Target> all = of >= 0 ? offered(drawing(), kind, of) : std::vector<Target>{};
        if (all.empty()) continue;
        choose(std::move(all));
        touch();
        return true;
    }
    return false;
}

Group View::group(double pixel) const {
    std::vector<Member> members;
    std::optional<int> object;
    Frame frame;
    for (const Target& target : chosen()) {
        if (object != target.object) frame = Frame(placementOf(target.object));
        object = target.object;
        members.push_back({target, frame});
    }
    return Group::of(scene()->state(), members, pixel);
}

std::optional<Gizmo> View::groupGizmo() const {
    if (readOnly_) return std::nullopt;
    const double pixel = sightOf(camera_.aim(), {}).unitsPerPixel();
    const Affine placement = placementOf(emphasis_.selected->object);
    Gizmo gizmo{centreOf(chosen(), pixel), {}, {}, !spatial_, layout_.curve.value_or(box())};
    for (glm::length_t k = 0; k < 3; ++k) {
        gizmo.axes[static_cast<std::size_t>(k)] = glm::normalize(placement.linear[k]);
    }
    gizmo.own = gizmo.axes;
    return gizmo;
}

bool View::beginGroupDrag(const PaneFigure& pane) {
    groupDrag_.emplace(group(pane.sight.unitsPerPixel()), pressedAt_);
    if (const auto tool = gizmo(); heldPart_ && tool) {
        groupDrag_->hold(*tool, *heldPart_, pane.sight);
    }
    return true;
}

void View::beginBand() {
    hold_ = Hold::banding;
    chosenBefore_ = chosen();
    drawBand();
}

std::optional<Box> View::band() const noexcept {
    if (hold_ != Hold::banding) return std::nullopt;
    return boxBetween(pressedAt_, lastAt_);
}

/// What lies in the band is selected, with what was before under Ctrl or while gathering. Points go
/// before handles unless handles are what is selected.
void View::drawBand() {
    const Figure* now = figure();
    const PaneFigure* pane = now != nullptr ? now->find(Pane::curve) : nullptr;
    if (pane == nullptr) return;
    const Box within = *band();
    const bool adds = gathering_ || (pressedWith_ & commandKey) != 0;
    std::vector<Target> all = adds ? chosenBefore_ : std::vector<Target>{};
    for (const TargetKind kind : {TargetKind::point, TargetKind::pose}) {
        if (!all.empty() && all.front().kind != kind) continue;
        for (Target& target : offered(drawing(), kind, -1)) {
            const bool there = std::any_of(all.begin(), all.end(), [&](const Target& one) {
                return one.same(target);
            });
            if (within.contains(pane->sight.toPixels(target.at)) && !there) {
                all.push_back(std::move(target));
            }
        }
    }
    choose(std::move(all));
    touch();
}

/// One more of the same list, next to what was selected last.
bool View::extend(int step) {
    if (!emphasis_.selected || figure() == nullptr) return false;
    if (!joinsGroups(emphasis_.selected->kind)) return selectNeighbour(step);
    const std::vector<std::string> all = siblings(*emphasis_.selected);
    const std::string last = chosen().back().path();
    const auto found = std::find(all.begin(), all.end(), last);
    if (found == all.end()) return false;
    const std::size_t place = static_cast<std::size_t>(found - all.begin()) + all.size();
    for (std::size_t k = 1; k < all.size(); ++k) {
        const std::size_t next = step > 0 ? place + k : place - k;
        const auto target = find(all[next % all.size()]);
        if (!target || isChosen(*target)) continue;
        std::vector<Target> more = chosen();
        more.push_back(*target);
        choose(std::move(more));
        touch();
        return true;
    }
    return true;
}

}  // namespace knotwork::app
