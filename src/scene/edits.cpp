#include "scene/edits.hpp"

#include "scene/adaptation.hpp"
#include "scene/json_values.hpp"
#include "scene/validation.hpp"

#include <algorithm>

namespace knotwork::scene {

namespace {

Error missingIn(std::span<const PathStep> rest) {
    const std::string path = formatPath(Path(rest.begin(), rest.end()));
    return refuse(Code::unknownField, path, "There is no " + path + " here.");
}

/// The knots with one moved; equal ones at a clamped end move as one.
Json movedKnots(const Json& spec, const Json& before, std::size_t index, double to) {
    Json knots = before;
    const bool clamped = stringOr(spec, "type", "") == "bspline-curve" &&
                         stringOr(spec, "form", "") == "clamped";
    const auto degree = static_cast<std::size_t>(numberOr(spec, "degree", 0));
    const std::size_t last = knots.size() - 1;
    std::size_t first = index;
    std::size_t end = index;
    if (clamped && index <= degree) {
        first = 0;
        end = degree;
    } else if (clamped && index + degree >= last) {
        first = last - degree;
        end = last;
    }
    for (std::size_t k = first; k <= end; ++k) knots[k] = to;
    return knots;
}

Result<Json> movedValue(const Json& value, const Json& command) {
    const Json* to = member(command, "to");
    const Json* by = member(command, "by");
    if ((to == nullptr) == (by == nullptr)) {
        return refuse(Code::wrongType, "move", "A move goes either \"to\" a place or \"by\" an amount.");
    }
    if (to != nullptr) return *to;
    if (value.is_number() && by->is_number()) return Json(value.get<double>() + by->get<double>());
    const bool points = value.is_array() && by->is_array() && by->size() >= 2 && by->size() <= 3 &&
                        std::all_of(by->begin(), by->end(),
                                    [](const Json& x) { return x.is_number(); });
    if (!points || value.size() < 2 || !value[0].is_number()) {
        return refuse(Code::wrongType, "by",
                      "A point moves by [x, y] or [x, y, z], a number by a number; got " +
                          describeValue(*by) + ".");
    }
    const Vec3 sum = vec3Of(value) + vec3Of(*by);
    return pointJson(sum, sum.z == 0 && value.size() == 2 ? 2 : 3);
}

}  // namespace

Result<Json> setIn(const Json& part, std::span<const PathStep> rest, const Json& value) {
    Json changed = part;
    Json* parent = find(changed, rest.first(rest.size() - 1));
    const PathStep& last = rest.back();
    if (parent == nullptr) return missingIn(rest);
    if (last.isIndex()) {
        if (!parent->is_array() || last.index >= parent->size()) return missingIn(rest);
        (*parent)[last.index] = value;
    } else {
        if (!parent->is_object()) return missingIn(rest);
        if (last.key == "family" && value.is_string()) {
            *parent = adaptFamily(*parent, value.get<std::string>());
        } else {
            (*parent)[last.key] = value;  // a key that does not belong is validation's to refuse
        }
    }
    return changed;
}

Result<Json> moveIn(const Json& part, std::span<const PathStep> rest, const Json& command) {
    const Json* value = find(part, rest);
    if (value == nullptr) return missingIn(rest);
    const auto moved = movedValue(*value, command);
    if (!moved) return moved.error();
    const bool ownKnot = rest.size() == 2 && rest[0].key == "knots" && moved->is_number();
    if (!ownKnot) return setIn(part, rest, *moved);
    Json changed = part;
    changed["knots"] =
        movedKnots(part, *member(part, "knots"), rest[1].index, moved->get<double>());
    return changed;
}

Result<Json> insertIn(const Json& part, std::span<const PathStep> rest, const Json& value) {
    Json changed = part;
    Json* list = find(changed, rest.first(rest.size() - 1));
    const PathStep& last = rest.back();
    if (list == nullptr || !list->is_array() || !last.isIndex() || last.index > list->size()) {
        return missingIn(rest);
    }
    list->insert(list->begin() + static_cast<std::ptrdiff_t>(last.index), value);
    return changed;
}

Result<Json> removeIn(const Json& part, std::span<const PathStep> rest) {
    Json changed = part;
    Json* parent = find(changed, rest.first(rest.size() - 1));
    const PathStep& last = rest.back();
    if (parent == nullptr || find(part, rest) == nullptr) return missingIn(rest);
    if (last.isIndex()) {
        parent->erase(last.index);
    } else {
        parent->erase(last.key);
    }
    return changed;
}

}  // namespace knotwork::scene
