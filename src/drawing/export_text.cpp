// JSON, JavaScript, CSV and OBJ.
#include "drawing/export_parts.hpp"

#include "scene/document.hpp"
#include "scene/readable.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace knotwork::drawing {

namespace {

using scene::Json;

// ---- JavaScript --------------------------------------------------------------------------------

/// What cannot name a variable, or already names one of ours.
constexpr std::string_view reserved =
    " arguments await break case catch class const continue debugger default delete do else enum"
    " eval export extends false finally for function if implements import in instanceof interface"
    " kw let load new null package private protected public return static super switch this throw"
    " true try typeof var void while with yield ";

/// A name for a variable: the id where it can be one, else `object` and a number.
std::string variableName(const std::string& id, std::size_t number) {
    const bool free = reserved.find(' ' + id + ' ') == std::string_view::npos;
    if (scene::isBareWord(id) && free) return id;
    return "object" + std::to_string(number);
}

/// Unlike the names before it.
std::string freshName(std::string name, const std::vector<std::string>& taken) {
    while (std::find(taken.begin(), taken.end(), name) != taken.end()) name += '_';
    return name;
}

/// The specification without what only a scene has.
Json specWithout(const Json& spec, std::initializer_list<std::string_view> left) {
    Json kept = Json::object();
    for (auto item = spec.begin(); item != spec.end(); ++item) {
        if (std::find(left.begin(), left.end(), item.key()) == left.end()) {
            kept[item.key()] = item.value();
        }
    }
    return kept;
}

std::string inJavaScript(const Json& value) {
    return scene::readableText(value, scene::Notation::javaScript);
}

/// `kw.curve({ … })`, or whatever makes this object.
std::string callFor(const scene::Object& object) {
    const Json spec = specWithout(object.spec, {"id", "style", "show"});
    if (object.body.curve() != nullptr) return "kw.curve(" + inJavaScript(spec) + ")";
    if (object.body.surface() != nullptr) return "kw.surface(" + inJavaScript(spec) + ")";
    const Json* mesh = scene::member(spec, "mesh");
    if (mesh != nullptr) {
        const std::string scheme = scene::stringOr(spec, "scheme", "");
        const auto levels = static_cast<int>(scene::numberOr(spec, "levels", 0));
        return "kw.mesh(" + inJavaScript(*mesh) + ").subdivide(" +
               scene::javaScriptString(scheme) + ", " + std::to_string(levels) + ")";
    }
    const Json* points = scene::member(spec, "points");
    const Json* fit = scene::member(spec, "fit");
    if (fit == nullptr || !fit->is_object()) {
        return points != nullptr ? inJavaScript(*points) : inJavaScript(spec);
    }
    Json request{{"points", points != nullptr ? *points : Json::array()}};
    request.update(*fit);
    return "kw.fit(" + inJavaScript(request) + ").curve";
}

// ---- CSV ---------------------------------------------------------------------------------------

/// In quotes where a comma, a quote or the end of a line in it asks for that (RFC 4180).
std::string csvField(const std::string& text) {
    if (text.find_first_of(",\"\r\n;\t") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

bool isSurface(const ExportPart& part) noexcept {
    return part.parameters.size() == 2 * part.count() && part.count() > 0;
}
bool isCurve(const ExportPart& part) noexcept {
    return part.parameters.size() == part.count() && part.count() > 0;
}

/// Which columns of parameters there are; those that a part has no numbers for stay empty.
struct CsvColumns {
    bool t = false;
    bool uv = false;

    [[nodiscard]] std::string header() const {
        return std::string("object") + (t ? ",t" : "") + (uv ? ",u,v" : "") + ",x,y,z";
    }
};

void appendCsv(std::string& text, const ExportPart& part, const CsvColumns& columns) {
    const std::size_t own = isSurface(part) ? 2 : isCurve(part) ? 1 : 0;
    const std::string empty(columns.t && own != 1 ? 1 : 0, ',');
    const std::string emptyPair(columns.uv && own != 2 ? 2 : 0, ',');
    // What stands before the first number and, where that is a curve's parameter, before the second.
    const std::string name = "\n" + csvField(part.name) + "," + (own == 1 ? "" : empty) +
                             (own == 0 ? emptyPair : "");
    const std::string afterOne = "," + emptyPair;
    std::vector<std::string_view> before(own + 3, ",");
    before[0] = name;
    if (own == 1) before[1] = afterOne;
    std::vector<double> rows;
    rows.reserve(part.xyz.size() + part.parameters.size());
    for (std::size_t i = 0; i < part.count(); ++i) {
        const auto parameter = part.parameters.begin() + static_cast<std::ptrdiff_t>(own * i);
        rows.insert(rows.end(), parameter, parameter + static_cast<std::ptrdiff_t>(own));
        rows.insert(rows.end(), {part.xyz[3 * i], part.xyz[3 * i + 1], part.xyz[3 * i + 2]});
    }
    scene::appendRows(text, rows, before);
}

// ---- OBJ ---------------------------------------------------------------------------------------

/// Names end with the line and are better without blanks.
std::string objName(const std::string& name) {
    std::string kept = name;
    for (char& c : kept) {
        if (static_cast<unsigned char>(c) <= ' ' || c == '#' || c == '\\') c = '_';
    }
    return kept;
}

void appendFaces(std::string& text, const ExportPart& part, std::size_t first) {
    const std::size_t faces = part.starts.empty() ? part.corners.size() / 3 : part.starts.size() - 1;
    for (std::size_t f = 0; f < faces; ++f) {
        const std::size_t from = part.starts.empty() ? 3 * f : part.starts[f];
        const std::size_t to = part.starts.empty() ? from + 3 : part.starts[f + 1];
        text += "\nf";
        for (std::size_t i = from; i < to; ++i) {
            text += ' ' + std::to_string(first + part.corners[i]);
        }
    }
}

void appendObj(std::string& text, const ExportPart& part, std::size_t first) {
    constexpr std::array<std::string_view, 3> vertex{"\nv ", " ", " "};
    scene::appendRows(text, part.xyz, vertex);
    if (part.kind == ExportPart::Kind::faces) return appendFaces(text, part, first);
    text += part.kind == ExportPart::Kind::line ? "\nl" : "\np";
    for (std::size_t i = 0; i < part.count(); ++i) text += ' ' + std::to_string(first + i);
}

}  // namespace

std::string exportJson(const scene::State& state) {
    return scene::readableText(scene::writeDocument(state), scene::Notation::json) + '\n';
}

std::string exportJavaScript(const scene::State& state) {
    std::string text = "import { load } from 'knotwork';\n\nconst kw = await load();\n";
    std::vector<std::string> names;
    for (const auto& object : state.objects) {
        names.push_back(freshName(variableName(object->id, names.size() + 1), names));
        text += "\nconst " + names.back() + " = " + callFor(*object) + ";\n";
    }
    return text;
}

Result<std::string> exportCsv(const scene::State& state, const ExportOptions& options) {
    const auto parts = exportParts(state, options);
    if (!parts) return parts.error();
    const CsvColumns columns{std::any_of(parts->begin(), parts->end(), isCurve),
                             std::any_of(parts->begin(), parts->end(), isSurface)};
    std::string text = columns.header();
    for (const ExportPart& part : *parts) appendCsv(text, part, columns);
    return text + '\n';
}

Result<std::string> exportObj(const scene::State& state, const ExportOptions& options) {
    const auto parts = exportParts(state, options);
    if (!parts) return parts.error();
    std::string text = "# Knotwork";
    const std::string* named = nullptr;
    std::size_t first = 1;
    for (const ExportPart& part : *parts) {
        if (named == nullptr || *named != part.name) text += "\no " + objName(part.name);
        named = &part.name;
        appendObj(text, part, first);
        first += part.count();
    }
    return text + '\n';
}

}  // namespace knotwork::drawing
