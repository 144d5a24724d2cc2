#include "app/function_handles.hpp"

#include "app/target.hpp"
#include "scene/specs.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace knotwork::app {

using scene::Json;

namespace {

using Way = FunctionHandle::Way;

constexpr std::size_t mostValues = 25;  // of a table; more handles could not be told apart
constexpr int mostMade = 16;            // B-functions to find a parameter
constexpr double nearEnough = 1e-4;     // of B: far less than a pixel
constexpr double significant = 1e-2;    // digits of a parameter that a hand sets
constexpr double gridOfCentre = 0.05;
constexpr double innermost = 0.01;      // a centre keeps away from the ends
constexpr double leastParameter = 1e-3; // where 0 itself is not allowed

/// Which parameter stands for a handle, and where.
struct Rule {
    std::string_view parameter;
    Way way;
    double place;  ///< the t or the value that stays
};

std::vector<Rule> rulesOf(const BFunction& blend) {
    const auto parameters = blend.parameters();
    switch (blend.family()) {
        case BFamily::trigonometric: return {{"order", Way::upAndDown, 0.25}};
        case BFamily::polynomial:
            return {{"p", Way::upAndDown, 0.25}, {"q", Way::upAndDown, 0.75}};
        case BFamily::rational:
            return {{"c", Way::toAndFro, 0.5}, {"m", Way::upAndDown, 0.75}};
        case BFamily::expoRational:
            return {{"lambda", Way::along, 0},
                    {"beta", Way::upAndDown, (1 + parameters[3]) / 2}};
        case BFamily::logistic: return {{"c", Way::upAndDown, 0.75}};
        case BFamily::mixed: return {{"weight", Way::upAndDown, 0}};
        default: return {};
    }
}

/// Where two functions are farthest apart, among sixteenths.
double farthestApart(const BFunction& a, const BFunction& b) noexcept {
    double best = 0.5;
    double most = -1;
    for (int k = 1; k < 16; ++k) {
        const double t = k / 16.0;
        const double apart = std::abs(a.value(t) - b.value(t));
        if (apart <= most) continue;
        most = apart;
        best = t;
    }
    return best;
}

/// The t at which B takes a value; B is monotone.
double parameterOf(const BFunction& blend, double value) noexcept {
    double low = 0;
    double high = 1;
    for (int k = 0; k < 40; ++k) {
        const double middle = (low + high) / 2;
        (blend.value(middle) < value ? low : high) = middle;
    }
    return (low + high) / 2;
}

Vec3 placeOn(const BFunction& blend, const Rule& rule, double value) noexcept {
    if (rule.way == Way::toAndFro) return {parameterOf(blend, rule.place), rule.place, 0};
    double t = rule.way == Way::along ? value : rule.place;
    if (blend.family() == BFamily::mixed) {
        const auto operands = blend.operands();
        t = farthestApart(operands[0], operands[1]);
    }
    return {t, blend.value(t), 0};
}

/// What a family calls the parameter of this name, and where that stands in its list.
struct Parameter {
    const ParameterDescription* description = nullptr;
    std::size_t index = 0;
};

Parameter parameterNamed(const BFunction& blend, std::string_view name) noexcept {
    const auto all = blend.description().parameters;
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (all[k].name == name) return {&all[k], k};
    }
    return {};
}

/// The letter that a label begins with: "β" of "β, steepness"; the last word of "order m".
std::string letterOf(std::string_view label) {
    if (const std::size_t comma = label.find(','); comma != std::string_view::npos) {
        return std::string(label.substr(0, comma));
    }
    const std::size_t space = label.rfind(' ');
    const bool letter = space != std::string_view::npos && label.size() - space == 2;
    return std::string(letter ? label.substr(space + 1) : label);
}

/// What is plotted of one object: its function, and where.
struct Graph {
    BFunction blend;
    drawing::Pane pane = drawing::Pane::bFunction;
    Vec3 origin{0.0};
    double unit = 1;
};

std::optional<Graph> graphOf(const scene::Object& object) {
    if (const auto* curve = object.body.as<BlendingCurve>()) {
        if (!object.show.bFunction) return std::nullopt;
        return Graph{curve->blend()};
    }
    const scene::FunctionGraph* graph = object.body.graph();
    const Json* spec = scene::member(object.spec, "bFunction");
    if (graph == nullptr || spec == nullptr || !object.show.curve) return std::nullopt;
    const auto blend = scene::makeBFunction(*spec);  // a proposal need not be one
    if (!blend) return std::nullopt;
    return Graph{blend->value, drawing::Pane::curve, graph->at, graph->size};
}

FunctionHandle handleOf(const Graph& graph, int object, std::string path, std::string label,
                        Way way, const Vec3& place, double value) {
    FunctionHandle handle;
    handle.path = std::move(path);
    handle.label = std::move(label);
    handle.object = object;
    handle.pane = graph.pane;
    handle.way = way;
    handle.at = graph.origin + graph.unit * place;
    handle.origin = graph.origin;
    handle.unit = graph.unit;
    handle.value = value;
    return handle;
}

void addParameters(std::vector<FunctionHandle>& handles, const Graph& graph, int object,
                   const std::string& path) {
    for (const Rule& rule : rulesOf(graph.blend)) {
        const Parameter parameter = parameterNamed(graph.blend, rule.parameter);
        const double value = graph.blend.parameters()[parameter.index];
        handles.push_back(handleOf(graph, object, path + "." + std::string(rule.parameter),
                                   letterOf(parameter.description->label), rule.way,
                                   placeOn(graph.blend, rule, value), value));
        handles.back().integer = parameter.description->integer;
    }
}

void addValues(std::vector<FunctionHandle>& handles, const Graph& graph, int object,
               const std::string& path) {
    const auto values = graph.blend.values();
    if (values.size() > mostValues) return;
    for (std::size_t k = 1; k + 1 < values.size(); ++k) {
        const double t = static_cast<double>(k) / static_cast<double>(values.size() - 1);
        handles.push_back(handleOf(graph, object, indexed(path + ".values", k), "B",
                                   Way::upAndDown, {t, values[k], 0}, values[k]));
    }
}

/// The function with another value of one of its parameters.
Result<BFunction> with(const BFunction& blend, std::size_t index, double value) {
    if (blend.family() == BFamily::mixed) {
        const auto operands = blend.operands();
        return BFunction::makeMixed(operands[0], operands[1], value);
    }
    std::vector<NamedValue> named;
    const auto descriptions = blend.description().parameters;
    for (std::size_t k = 0; k < descriptions.size(); ++k) {
        named.push_back({std::string(descriptions[k].name), k == index ? value : blend.parameters()[k]});
    }
    return BFunction::make(blend.description().name, named);
}

/// Where a monotone function of a parameter in [low, high] vanishes, or the end that comes nearest
/// (the Illinois method: Dowell and Jarratt, 1971).
double rootOf(const std::function<double(double)>& off, double low, double high) {
    double former = low;
    double now = high;
    double atFormer = off(low);
    double atNow = off(high);
    if (atFormer * atNow > 0) return std::abs(atFormer) < std::abs(atNow) ? low : high;
    for (int made = 2; made < mostMade && std::abs(atNow) > nearEnough; ++made) {
        const double next = now - atNow * (now - former) / (atNow - atFormer);
        const double atNext = off(next);
        if (atNext * atNow < 0) {
            former = now;
            atFormer = atNow;
        } else {
            atFormer /= 2;
        }
        now = next;
        atNow = atNext;
    }
    return now;
}

double nearestInteger(const BFunction& blend, std::size_t index, double t, double value) {
    const ParameterDescription& range = blend.description().parameters[index];
    double best = blend.parameters()[index];
    double least = 2;
    for (double k = range.min; k <= range.max; ++k) {
        const auto other = with(blend, index, k);
        const double off = other ? std::abs(other->value(t) - value) : 2;
        if (off >= least) continue;
        least = off;
        best = k;
    }
    return best;
}

/// The parameter with which the graph passes through (t, value); on a scale of its logarithm where
/// it may be any size.
double passingThrough(const BFunction& blend, std::size_t index, double t, double value) {
    const ParameterDescription& range = blend.description().parameters[index];
    if (range.integer) return nearestInteger(blend, index, t, value);
    const bool large = range.max > 1;
    const double low = large ? std::log(std::max(range.min, leastParameter)) : range.min;
    const double high = large ? std::log(range.max) : range.max;
    const auto parameter = [&](double x) { return large ? std::exp(x) : x; };
    const double x = rootOf(
        [&](double at) {
            const auto other = with(blend, index, std::clamp(parameter(at), range.min, range.max));
            return other ? other->value(t) - value : 0;
        },
        low, high);
    return std::clamp(roundedTo(parameter(x), std::max(parameter(x), 0.01) * significant),
                      range.min, range.max);
}

/// Between its neighbours in the table.
double valueInTable(const BFunction& blend, const std::string& path, double value) {
    const std::size_t open = path.rfind('[');
    const auto k = static_cast<std::size_t>(std::stoul(path.substr(open + 1)));
    return std::clamp(roundedTo(value, significant), blend.values()[k - 1], blend.values()[k + 1]);
}

}  // namespace

std::vector<FunctionHandle> functionHandles(const scene::State& state) {
    std::vector<FunctionHandle> handles;
    for (std::size_t i = 0; i < state.objects.size(); ++i) {
        const auto graph = graphOf(*state.objects[i]);
        const std::string path = indexed("objects", i) + ".bFunction";
        const int object = static_cast<int>(i);
        if (!graph || valueAt(state, path) == nullptr) continue;
        addParameters(handles, *graph, object, path);
        if (graph->blend.family() == BFamily::tabulated) addValues(handles, *graph, object, path);
    }
    return handles;
}

double parameterFor(const scene::State& state, const FunctionHandle& handle, const Vec3& to,
                    bool onGrid) {
    const auto graph = graphOf(*state.objects[static_cast<std::size_t>(handle.object)]);
    if (!graph) return handle.value;
    const Vec3 place = (to - handle.origin) / handle.unit;
    if (handle.way == Way::along) {
        const double t = onGrid ? multipleOf(gridOfCentre, place.x) : roundedTo(place.x, significant);
        return std::clamp(t, onGrid ? gridOfCentre : innermost,
                          1 - (onGrid ? gridOfCentre : innermost));
    }
    const Vec3 fixed = (handle.at - handle.origin) / handle.unit;
    const bool upright = handle.way == Way::upAndDown;
    const double t = upright ? fixed.x : std::clamp(place.x, innermost, 1 - innermost);
    const double value = upright ? place.y : fixed.y;
    if (graph->blend.family() == BFamily::tabulated) {
        return valueInTable(graph->blend, handle.path, value);
    }
    const std::string name = handle.path.substr(handle.path.rfind('.') + 1);
    return passingThrough(graph->blend, parameterNamed(graph->blend, name).index, t, value);
}

Json setCommand(const std::string& path, Json value) {
    Json command = Json::object();
    command["set"] = path;
    command["value"] = std::move(value);
    return command;
}

}  // namespace knotwork::app
