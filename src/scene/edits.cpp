#include "scene/edits.hpp"

#include "scene/adaptation.hpp"
#include "scene/json_values.hpp"
#include "scene/validation.hpp"

#include <algorithm>
#include <utility>

namespace knotwork::scene {

namespace {

Error missingIn(std::span<const PathStep> rest) {
    const std::string path = formatPath(Path(rest.begin(), rest.end()));
    return refuse(Code::unknownField, path, "There is no " + path + " here.");
}

/// Whether `rest` names a point of a net, and with it its column.
bool namesColumn(const Json& part, std::span<const PathStep> rest) {
    return rest.size() == 3 && rest[0].key == "points" && rest[1].isIndex() && rest[2].isIndex() &&
           stringOr(part, "type", "") == "bspline-surface";
}

Result<Json> insertColumn(Json part, std::span<const PathStep> rest, const Json& column) {
    Json& rows = *find(part, rest.first(1));
    const std::size_t at = rest[2].index;
    if (rest[1].index >= rows.size() || at > rows[rest[1].index].size()) return missingIn(rest);
    if (!column.is_array() || column.size() != rows.size()) {
        return refuse(Code::wrongLength, "value",
                      "A column of this net is a list of " + std::to_string(rows.size()) +
                          " points, one for each row.");
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].insert(rows[i].begin() + static_cast<std::ptrdiff_t>(at), column[i]);
    }
    return part;
}

Json removeColumn(Json part, std::span<const PathStep> rest) {
    for (Json& row : *find(part, rest.first(1))) row.erase(rest[2].index);
    return part;
}

}  // namespace

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

Result<Json> setIn(Json part, std::span<const PathStep> rest, const Json& value) {
    Json* parent = find(part, rest.first(rest.size() - 1));
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
    return part;
}

Result<Json> insertIn(Json part, std::span<const PathStep> rest, const Json& value) {
    if (namesColumn(part, rest)) return insertColumn(std::move(part), rest, value);
    Json* list = find(part, rest.first(rest.size() - 1));
    const PathStep& last = rest.back();
    if (list == nullptr || !list->is_array() || !last.isIndex() || last.index > list->size()) {
        return missingIn(rest);
    }
    list->insert(list->begin() + static_cast<std::ptrdiff_t>(last.index), value);
    return part;
}

Result<Json> removeIn(Json part, std::span<const PathStep> rest) {
    Json* parent = find(part, rest.first(rest.size() - 1));
    const PathStep& last = rest.back();
    if (parent == nullptr || find(part, rest) == nullptr) return missingIn(rest);
    if (namesColumn(part, rest)) return removeColumn(std::move(part), rest);
    if (last.isIndex()) {
        parent->erase(last.index);
    } else {
        parent->erase(last.key);
    }
    return part;
}

}  // namespace knotwork::scene
