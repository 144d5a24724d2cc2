// The panes of a view and the seams between them, which people move.
#include "app/view.hpp"

#include <algorithm>

namespace knotwork::app {

namespace {

using scene::Json;

std::optional<std::size_t> seamNamed(std::string_view name) noexcept {
    const auto found = std::find(ui::seamNames.begin(), ui::seamNames.end(), name);
    if (found == ui::seamNames.end()) return std::nullopt;
    return static_cast<std::size_t>(found - ui::seamNames.begin());
}

Json seamJson(std::string_view name, const ui::Seam& seam) {
    Json json = Json::object();
    json["name"] = name;
    json["upright"] = seam.upright;
    json["box"] = Json::array({seam.at.x, seam.at.y, seam.at.width, seam.at.height});
    json["share"] = seam.share;
    json["least"] = seam.least;
    json["most"] = seam.most;
    json["length"] = seam.length;
    return json;
}

Json shownPanes(const ui::FigureLayout& layout) {
    Json list = Json::array();
    const auto add = [&](Pane pane, bool shown) {
        if (shown) list.push_back(drawing::paneName(pane));
    };
    add(Pane::curve, layout.curve.has_value());
    add(Pane::basis, layout.basis.has_value());
    add(Pane::knots, layout.knots.has_value());
    add(Pane::bFunction, layout.bFunction.has_value());
    add(Pane::hodograph, layout.hodograph.has_value());
    add(Pane::curvature, layout.curvature.has_value());
    return list;
}

}  // namespace

std::string View::panes() {
    if (figure() == nullptr) return "null";
    Json seams = Json::array();
    for (std::size_t i = 0; i < ui::seamNames.size(); ++i) {
        if (layout_.seams[i]) seams.push_back(seamJson(ui::seamNames[i], *layout_.seams[i]));
    }
    Json json = Json::object();
    json["shown"] = shownPanes(layout_);
    json["seams"] = std::move(seams);
    return scene::dumpJson(json);
}

bool View::moveSeam(std::string_view name, std::optional<double> share) {
    const auto seam = seamNamed(name);
    if (!seam || hold_ == Hold::dragging) return false;
    const auto& now = layout_.seams[*seam];
    // What is out of reach is not remembered, or the seam would lag behind the next hand.
    if (share && now) share = std::clamp(*share, now->least, now->most);
    if (shares_[*seam] == share) return false;
    shares_[*seam] = share;
    touch();
    return true;
}

}  // namespace knotwork::app
