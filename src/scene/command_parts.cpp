#include "scene/command_parts.hpp"

#include "scene/adaptation.hpp"
#include "scene/document.hpp"
#include "scene/followed_locals.hpp"
#include "scene/mesh_specs.hpp"
#include "scene/validation.hpp"

#include <algorithm>

namespace knotwork::scene {

namespace {

using MadeObject = Result<std::shared_ptr<const Object>>;

Result<Done> checkFreeId(const State& state, std::size_t i, std::string_view id) {
    for (std::size_t other = 0; other < state.objects.size(); ++other) {
        if (other != i && state.objects[other]->id == id) {
            return refuse(Code::outOfRange, indexed("objects", i) + ".id",
                          "There is an object \"" + std::string(id) + "\" already.");
        }
    }
    return Done{};
}

Result<State> withMade(const State& state, std::size_t i, MadeObject object) {
    if (!object) return object.error().under(indexed("objects", i));
    const auto free = checkFreeId(state, i, (*object)->id);
    if (!free) return free.error();
    State next = state;
    const Object& former = *state.objects[i];
    next.objects[i] = std::move(*object);
    next.effects.clear();
    for (std::size_t k = 0; k < state.effects.size(); ++k) {
        if (state.effects[k]->target != former.id) {
            next.effects.push_back(state.effects[k]);
            continue;
        }
        auto effect = followedEffect(former.spec, next.objects[i]->spec, state.effects[k]->spec);
        if (!effect) continue;
        (*effect)["target"] = next.objects[i]->id;
        auto read = readEffect(*effect, next.objects);
        if (!read) return read.error().under(indexed("effects", k));
        next.effects.push_back(std::move(*read));
    }
    return next;
}

/// How many steps from an object to one of its points: `points[i]`, or `points[i][j]` of a net.
std::size_t stepsToPoint(const Json& spec) {
    const ObjectType* type = findObjectType(stringOr(spec, "type", ""));
    if (type == nullptr) return 0;
    const auto field = std::find_if(type->fields.begin(), type->fields.end(),
                                    [](const Field& f) { return f.name == "points"; });
    if (field == type->fields.end()) return 0;
    return field->kind == FieldKind::points ? 2 : 3;
}

}  // namespace

std::string Part::path() const {
    if (of == Of::header) return {};
    return indexed(of == Of::object ? "objects" : "effects", index);
}

Result<Part> partAt(const State& state, const Path& path) {
    const std::span<const PathStep> all(path);
    if (startsWith(path, "objects") && path.size() > 2 && path[1].index < state.objects.size()) {
        const std::size_t i = path[1].index;
        return Part{Part::Of::object, i, &state.objects[i]->spec, all.subspan(2)};
    }
    if (startsWith(path, "effects") && path.size() > 2 && path[1].index < state.effects.size()) {
        const std::size_t i = path[1].index;
        return Part{Part::Of::effect, i, &state.effects[i]->spec, all.subspan(2)};
    }
    if (path[0].key == "objects" || path[0].key == "effects") return missing(path);
    return Part{Part::Of::header, 0, state.header.get(), all};
}

Json editable(const State& state, const Part& part) {
    Json spec = *part.spec;
    if (part.of != Part::Of::object) return spec;
    const bool elements = part.rest.size() > 1 && part.rest[0].key == "mesh" &&
                          (part.rest[1].key == "vertices" || part.rest[1].key == "faces");
    const SubdivisionSurface* surface = state.objects[part.index]->body.subdivision();
    if (elements && surface != nullptr && member(spec["mesh"], "solid") != nullptr) {
        spec["mesh"] = specOf(surface->control);
    }
    return spec;
}

Result<State> withPart(const State& state, const Part& part, Json changed) {
    switch (part.of) {
        case Part::Of::object:
            return withObject(state, part.index, adaptObject(*part.spec, std::move(changed)));
        case Part::Of::effect: return withEffect(state, part.index, changed);
        case Part::Of::header: break;
    }
    return withHeader(state, changed);
}

bool changesOnlyPoint(const Json& changed, std::span<const PathStep> rest) {
    if (rest.empty() || rest[0].key != "points") return false;
    const std::size_t steps = stepsToPoint(changed);
    if (steps == 0 || rest.size() < steps || rest.size() > steps + 1) return false;
    const Json* point = find(changed, rest.first(steps));
    return point != nullptr && readPoint(*point).ok();
}

Error missing(const Path& path) {
    return refuse(Code::unknownField, formatPath(path),
                  "There is nothing at " + formatPath(path) + " in this scene.");
}

bool startsWith(const Path& path, std::string_view list) {
    return path.size() >= 2 && path[0].key == list && path[1].isIndex();
}

Result<std::size_t> objectNamed(const State& state, const Json& arguments, std::string_view verb) {
    const std::string path = std::string(verb) + ".object";
    const Json* id = member(arguments, "object");
    if (id == nullptr || !id->is_string()) {
        return refuse(Code::wrongType, path, "Give the id of an object, a text.");
    }
    for (std::size_t i = 0; i < state.objects.size(); ++i) {
        if (state.objects[i]->id == id->get_ref<const std::string&>()) return i;
    }
    return refuse(Code::unknownName, path, "There is no object " + describeValue(*id) + ".");
}

Result<State> withObject(const State& state, std::size_t i, const Json& spec) {
    return withMade(state, i, readObject(spec));
}

Result<State> withPointsOf(const State& state, std::size_t i, Json spec) {
    return withMade(state, i, remakeObject(*state.objects[i], std::move(spec)));
}

Result<State> withEffect(const State& state, std::size_t i, const Json& spec) {
    auto effect = readEffect(spec, state.objects);
    if (!effect) return effect.error().under(indexed("effects", i));
    State next = state;
    next.effects[i] = std::move(*effect);
    return next;
}

Result<State> withHeader(const State& state, const Json& header) {
    auto read = readHeader(header);
    if (!read) return read.error();
    State next = state;
    next.header = std::move(*read);
    return next;
}

Json dressed(Json spec, const Object& object) {
    if (!spec.is_object()) return spec;  // validation will say so
    Json full{{"id", object.id}};
    full.update(spec);
    for (const char* key : {"style", "show"}) {
        const Json* value = member(object.spec, key);
        if (value != nullptr && member(full, key) == nullptr) full[key] = *value;
    }
    return full;
}

}  // namespace knotwork::scene
