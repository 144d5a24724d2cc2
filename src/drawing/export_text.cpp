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

/// The rows of some of the part's points.
void appendCsv(std::string& text, const ExportPart& part, const CsvColumns& columns,
               std::size_t first, std::size_t last) {
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
    rows.reserve((own + 3) * (last - first));
    for (std::size_t i = first; i < last; ++i) {
        const auto parameter = part.parameters.begin() + static_cast<std::ptrdiff_t>(own * i);
        rows.insert(rows.end(), parameter, parameter + static_cast<std::ptrdiff_t>(own));
        rows.insert(rows.end(), {part.xyz[3 * i], part.xyz[3 * i + 1], part.xyz[3 * i + 2]});
    }
    scene::appendRows(text, rows, before);
}

void writeCsv(ExportRun& run) {
    const CsvColumns columns{std::any_of(run.parts.begin(), run.parts.end(), isCurve),
                             std::any_of(run.parts.begin(), run.parts.end(), isSurface)};
    run.text += columns.header();
    for (const ExportPart& part : run.parts) {
        const auto numbers = static_cast<double>(part.xyz.size() + part.parameters.size());
        run.work.loop(part.count(), numbers,
                      [&run, &part, columns](std::size_t first, std::size_t last) {
                          appendCsv(run.text, part, columns, first, last);
                      });
    }
    run.work.step(0, [&run] { run.text += '\n'; });
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

/// A number of a vertex, which has no decimals to look for.
constexpr double indexWeight = 0.3;

std::size_t facesOf(const ExportPart& part) noexcept {
    return part.starts.empty() ? part.corners.size() / 3 : part.starts.size() - 1;
}

void appendFace(std::string& text, const ExportPart& part, std::size_t f, std::size_t firstVertex) {
    const std::size_t from = part.starts.empty() ? 3 * f : part.starts[f];
    const std::size_t to = part.starts.empty() ? from + 3 : part.starts[f + 1];
    text += "\nf";
    for (std::size_t i = from; i < to; ++i) {
        text += ' ' + std::to_string(firstVertex + part.corners[i]);
    }
}

void writeObjPart(ExportRun& run, const ExportPart& part, std::size_t firstVertex) {
    const auto points = static_cast<double>(part.count());
    run.work.loop(part.count(), 3 * points, [&run, &part](std::size_t first, std::size_t last) {
        constexpr std::array<std::string_view, 3> vertex{"\nv ", " ", " "};
        scene::appendRows(run.text, std::span(part.xyz).subspan(3 * first, 3 * (last - first)),
                          vertex);
    });
    if (part.kind == ExportPart::Kind::faces) {
        run.work.loop(facesOf(part), indexWeight * static_cast<double>(part.corners.size()),
                      [&run, &part, firstVertex](std::size_t first, std::size_t last) {
                          for (std::size_t f = first; f < last; ++f) {
                              appendFace(run.text, part, f, firstVertex);
                          }
                      });
        return;
    }
    run.work.loop(part.count(), indexWeight * points,
                  [&run, &part, firstVertex](std::size_t first, std::size_t last) {
                      if (first == 0) run.text += part.kind == ExportPart::Kind::line ? "\nl" : "\np";
                      for (std::size_t i = first; i < last; ++i) {
                          run.text += ' ' + std::to_string(firstVertex + i);
                      }
                  });
}

void writeObj(ExportRun& run) {
    run.text += "# Knotwork";
    const std::string* named = nullptr;
    std::size_t firstVertex = 1;
    for (const ExportPart& part : run.parts) {
        if (named == nullptr || *named != part.name) {
            run.work.step(0, [&run, &part] { run.text += "\no " + objName(part.name); });
        }
        named = &part.name;
        writeObjPart(run, part, firstVertex);
        firstVertex += part.count();
    }
    run.work.step(0, [&run] { run.text += '\n'; });
}

// ---- The document ------------------------------------------------------------------------------

std::string jsonText(const scene::State& state) {
    return scene::readableText(scene::writeDocument(state), scene::Notation::json) + '\n';
}

std::string javaScriptText(const scene::State& state) {
    std::string text = "import { load } from 'knotwork';\n\nconst kw = await load();\n";
    std::vector<std::string> names;
    for (const auto& object : state.objects) {
        names.push_back(freshName(variableName(object->id, names.size() + 1), names));
        text += "\nconst " + names.back() + " = " + callFor(*object) + ";\n";
    }
    return text;
}

}  // namespace

void planText(ExportRun& run, ExportFormat format) {
    switch (format) {
        case ExportFormat::json:
            return run.work.step(1, [&run] { run.text = jsonText(run.state); });
        case ExportFormat::js:
            return run.work.step(1, [&run] { run.text = javaScriptText(run.state); });
        case ExportFormat::csv: return planParts(run, {}, [&run] { writeCsv(run); });
        default: return planParts(run, {.corners = true}, [&run] { writeObj(run); });
    }
}

}  // namespace knotwork::drawing
