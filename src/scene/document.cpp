#include "scene/document.hpp"

#include "scene/counted_line.hpp"
#include "scene/memory.hpp"
#include "scene/migrations.hpp"
#include "scene/object_builders.hpp"
#include "scene/object_trace.hpp"
#include "scene/validation.hpp"

#include <algorithm>

namespace knotwork::scene {

namespace {

using Objects = std::vector<std::shared_ptr<const Object>>;

Style styleOf(const Json& spec) {
    const Json& style = *member(spec, "style");
    const std::string by = stringOr(style, "colourBy", "colour");
    Style made{*parseColour(stringOr(style, "colour", "#000000")), numberOr(style, "width", 2.5),
               by == "gaussian" ? Colouring::gaussian
               : by == "mean"   ? Colouring::mean
                                : Colouring::colour};
    made.colour.alpha = numberOr(style, "opacity", 1);
    made.dashed = flagOr(style, "dashed", false);
    return made;
}

Show showOf(const Json& spec) {
    const Json& show = *member(spec, "show");
    const auto shown = [&](std::string_view name) { return flagOr(show, name, false); };
    return {.curve = shown("curve"),
            .surface = shown("surface"),
            .isolines = shown("isolines"),
            .wireframe = shown("wireframe"),
            .polygon = shown("polygon"),
            .points = shown("points"),
            .knots = shown("knots"),
            .locals = shown("locals"),
            .handles = shown("handles"),
            .basis = shown("basis"),
            .bFunction = shown("bFunction"),
            .comb = shown("comb"),
            .hodograph = shown("hodograph"),
            .curvature = shown("curvature"),
            .osculating = shown("osculating"),
            .hull = shown("hull"),
            .frames = shown("frames"),
            .sphere = shown("sphere"),
            .crossings = shown("crossings"),
            .residuals = shown("residuals"),
            .labels = shown("labels")};
}

Result<Objects> readObjects(const Json* list) {
    Objects objects;
    for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
        Json spec = (*list)[i];
        if (spec.is_object() && member(spec, "id") == nullptr) spec["id"] = freshId(objects);
        auto object = readObject(spec);
        if (!object) return object.error().under(indexed("objects", i));
        const auto free = checkNewId(objects, (*object)->id);
        if (!free) return free.error().under(indexed("objects", i));
        objects.push_back(std::move(*object));
    }
    return objects;
}

Result<Done> checkVersion(const Json& document) {
    const Json* version = member(document, "knotwork");
    if (version == nullptr) {
        return refuse(Code::wrongType, "knotwork",
                      "A document begins with its version: \"knotwork\": 1.");
    }
    if (version->is_number() && version->get<double>() > documentVersion) {
        return refuse(Code::version, "knotwork",
                      "The document has version " + formatNumber(version->get<double>()) +
                          "; this program reads up to " + std::to_string(documentVersion) +
                          ". Open it with a newer Knotwork.");
    }
    return Done{};
}

/// What has been made, with where it is measured and the trace that it shows.
Result<std::shared_ptr<const Object>> objectOf(Made<Body> made, std::string id,
                                               std::size_t bytes) {
    const auto parameter = parameterOf(made.spec, made.value);
    if (!parameter) return parameter.error();
    auto trace = traceOf(made.spec, made.value, *parameter);
    if (!trace) return trace.error();
    const Style style = styleOf(made.spec);
    const Show show = showOf(made.spec);
    const auto line = lineOf(made.spec);
    if (!line) return line.error();
    return std::make_shared<const Object>(Object{std::move(made.spec), std::move(id), style, show,
                                                 std::move(made.value), *parameter,
                                                 std::move(trace->trace), trace->frame, bytes,
                                                 *line});
}

/// n of an id `c<n>` as freshId() makes them, up to `most`; 0 for any other.
std::size_t numberOfId(std::string_view id, std::size_t most) noexcept {
    if (id.size() < 2 || id.size() > 8 || id[0] != 'c' || id[1] == '0') return 0;
    std::size_t number = 0;
    for (const char digit : id.substr(1)) {
        if (digit < '0' || digit > '9') return 0;
        number = 10 * number + static_cast<std::size_t>(digit - '0');
    }
    return number <= most ? number : 0;
}

}  // namespace

std::string freshId(std::span<const std::shared_ptr<const Object>> objects) {
    // So many objects cannot take all of these.
    std::vector<bool> taken(objects.size() + 2, false);
    for (const auto& object : objects) taken[numberOfId(object->id, objects.size() + 1)] = true;
    std::size_t n = 1;
    while (taken[n]) ++n;
    return "c" + std::to_string(n);
}

Result<Done> checkNewId(std::span<const std::shared_ptr<const Object>> objects,
                        std::string_view id) {
    const bool taken = std::any_of(objects.begin(), objects.end(),
                                   [&](const auto& object) { return object->id == id; });
    if (!taken) return Done{};
    return refuse(Code::outOfRange, "id",
                  "There is an object \"" + std::string(id) +
                      "\" already; every id stands once.");
}

Json headerOf(const Json& document) {
    Json header = Json::object();
    for (const auto& item : document.items()) {
        if (item.key() != "objects" && item.key() != "effects") header[item.key()] = item.value();
    }
    return header;
}

Result<const Json*> listUnder(const Json& document, std::string_view key, std::size_t most) {
    const Json* list = member(document, key);
    if (list == nullptr) return list;
    if (!list->is_array()) {
        return refuse(Code::wrongType, std::string(key),
                      "Expected a list, got " + describeValue(*list) + ".");
    }
    if (list->size() > most) {
        return refuse(Code::tooLarge, std::string(key),
                      std::to_string(list->size()) + " entries; there may be " +
                          std::to_string(most) + ".");
    }
    return list;
}

Result<Json> currentVersion(const Json& document) {
    if (!document.is_object()) {
        return refuse(Code::wrongType, "",
                      "Expected a document such as { \"knotwork\": 1, \"objects\": […] }, got " +
                          describeValue(document) + ".");
    }
    if (const auto version = checkVersion(document); !version) return version.error();
    return isOutdated(document, migrations()) ? migrated(document, migrations()) : document;
}

Result<std::shared_ptr<const Json>> readHeader(const Json& header) {
    if (const auto version = checkVersion(header); !version) return version.error();
    auto canonical = readGroup(header, headerFields());
    if (!canonical) return canonical.error();
    return std::make_shared<const Json>(std::move(*canonical));
}

Result<std::shared_ptr<const Object>> readObject(const Json& spec) {
    auto made = makeObject(spec);
    if (!made) return made.error();
    std::string id = stringOr(made->spec, "id", "");
    if (id.empty()) {
        return refuse(Code::outOfRange, "id", "An id is a text of at least one character.");
    }
    const std::size_t bytes = bytesOf(made->spec) + bytesOf(made->value);
    return objectOf(std::move(*made), std::move(id), bytes);
}

Result<std::shared_ptr<const Object>> remakeObject(const Object& object, Json spec) {
    auto made = remakeObject(std::move(spec));
    if (!made) return made.error();
    return objectOf(std::move(*made), object.id, object.bytes);
}

Result<State> readDocument(const Json& given) {
    const auto document = currentVersion(given);
    if (!document) return document.error();
    State state;
    auto read = readHeader(headerOf(*document));
    if (!read) return read.error();
    state.header = std::move(*read);
    const auto objectList = listUnder(*document, "objects", maximumObjects);
    if (!objectList) return objectList.error();
    auto objects = readObjects(*objectList);
    if (!objects) return objects.error();
    state.objects = std::move(*objects);
    const auto effectList = listUnder(*document, "effects", maximumEffects);
    if (!effectList) return effectList.error();
    for (std::size_t i = 0; *effectList != nullptr && i < (*effectList)->size(); ++i) {
        auto effect = readEffect((**effectList)[i], state.objects);
        if (!effect) return effect.error().under(indexed("effects", i));
        state.effects.push_back(std::move(*effect));
    }
    return state;
}

Json writeDocument(const State& state) {
    Json document = *state.header;
    Json objects = Json::array();
    for (const auto& object : state.objects) objects.push_back(object->spec);
    Json effects = Json::array();
    for (const auto& effect : state.effects) effects.push_back(effect->spec);
    document["objects"] = std::move(objects);
    document["effects"] = std::move(effects);
    return document;
}

}  // namespace knotwork::scene
