// The part of the session that writes scenes for other programs.
#include "bindings/session.hpp"
#include "scene/validation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace knotwork::bindings {

namespace {

using drawing::ExportFormat;
using drawing::SceneExport;
using scene::Choice;
using scene::Field;
using scene::FieldKind;
using scene::Json;

constexpr std::array themes{Choice{"light", "Light"}, Choice{"dark", "Dark"},
                            Choice{"contrast", "High contrast"}};
/// Of a picture, in pixels: more than any screen or sheet of paper shows.
constexpr double largestSide = 32768;

constexpr Field phaseField{.name = "phase", .label = "Phase", .kind = FieldKind::number,
                           .help = "Of all effects.", .min = 0, .max = 1};
constexpr Field timeField{.name = "time", .label = "Time", .kind = FieldKind::number,
                          .help = "In seconds, each effect then at its own phase."};

constexpr std::array pictureFields{
    phaseField, timeField,
    Field{.name = "width", .label = "Width", .kind = FieldKind::number, .help = "In pixels.",
          .min = 1, .max = largestSide, .maxIsSize = true, .defaultJson = "800"},
    Field{.name = "height", .label = "Height", .kind = FieldKind::number, .help = "In pixels.",
          .min = 1, .max = largestSide, .maxIsSize = true, .defaultJson = "600"},
    Field{.name = "theme", .label = "Theme", .kind = FieldKind::choice, .help = "Its colours.",
          .defaultJson = "\"light\"", .choices = themes},
    Field{.name = "title", .label = "Title", .kind = FieldKind::text,
          .help = "In place of the document's."},
    Field{.name = "description", .label = "Description", .kind = FieldKind::text,
          .help = "In place of the document's."},
    Field{.name = "background", .label = "Background", .kind = FieldKind::text,
          .help = "theme, none or #rrggbb.", .defaultJson = "\"theme\""},
    Field{.name = "panes", .label = "Panes", .kind = FieldKind::panes,
          .help = "Which of the linked views are in it.", .defaultJson = "[\"curve\"]"},
};

constexpr std::array geometryFields{
    phaseField, timeField,
    Field{.name = "tolerance", .label = "Tolerance", .kind = FieldKind::number,
          .help = "Largest distance from what is exported, in units of the scene.", .min = 0,
          .minOpen = true},
};

std::optional<double> numberOf(const Json& fields, std::string_view name) {
    const Json* given = scene::member(fields, name);
    return given != nullptr ? std::optional(scene::numberOr(fields, name, 0)) : std::nullopt;
}

std::optional<std::string> textOf(const Json& fields, std::string_view name) {
    const Json* given = scene::member(fields, name);
    return given != nullptr ? std::optional(scene::stringOr(fields, name, "")) : std::nullopt;
}

Result<scene::Moment> momentOf(const Json& fields) {
    const scene::Moment moment{numberOf(fields, "phase"), numberOf(fields, "time")};
    if (!moment.phase || !moment.time) return moment;
    return refuse(Code::unknownField, "time", "Give a phase or a time, not both.");
}

Result<Done> checkBackground(const std::string& background) {
    if (background == "theme" || background == "none" || scene::parseColour(background)) return Done{};
    return refuse(Code::syntax, "background",
                  "background is \"" + background + "\"; it can be theme, none or #rrggbb.");
}

drawing::SvgTheme themeOf(const Json& fields) {
    const std::string name = scene::stringOr(fields, "theme", "");
    const auto found = std::find_if(themes.begin(), themes.end(),
                                    [&](const Choice& theme) { return theme.value == name; });
    return static_cast<drawing::SvgTheme>(found - themes.begin());
}

std::vector<drawing::Pane> panesOf(const Json& fields) {
    std::vector<drawing::Pane> panes;
    for (const drawing::Pane pane : drawing::allPanes) {
        const Json* list = scene::member(fields, "panes");
        const Json name(drawing::paneName(pane));
        if (std::find(list->begin(), list->end(), name) != list->end()) panes.push_back(pane);
    }
    return panes;
}

Result<SceneExport> picture(const scene::State& state, const Json& fields) {
    auto moment = momentOf(fields);
    if (!moment) return moment.error();
    drawing::SvgOptions options;
    options.moment = *moment;
    options.width = scene::numberOr(fields, "width", options.width);
    options.height = scene::numberOr(fields, "height", options.height);
    options.theme = themeOf(fields);
    options.title = textOf(fields, "title");
    options.description = textOf(fields, "description");
    options.panes = panesOf(fields);
    options.background = scene::stringOr(fields, "background", "theme");
    if (auto colour = checkBackground(options.background); !colour) return colour.error();
    return SceneExport(state, options);
}

Result<SceneExport> geometry(const scene::State& state, ExportFormat format, const Json& fields) {
    auto moment = momentOf(fields);
    if (!moment) return moment.error();
    return SceneExport(state, format, {*moment, numberOf(fields, "tolerance")});
}

Result<SceneExport> begun(const scene::State& state, ExportFormat format, const Json& given) {
    const bool isPicture = format == ExportFormat::svg;
    const auto fields = scene::readGroup(given, isPicture ? std::span<const Field>(pictureFields)
                                                          : std::span<const Field>(geometryFields));
    if (!fields) return fields.error();
    return isPicture ? picture(state, *fields) : geometry(state, format, *fields);
}

}  // namespace

bool Session::sceneExport(int handle, int format, unsigned bytes) {
    const auto* held = find<scene::Scene>(handle);
    if (!held) return false;
    const auto given = input(bytes);
    auto work = given ? begun(held->state(), static_cast<ExportFormat>(format), *given)
                      : Result<SceneExport>(given.error());
    auto text = work ? work->finish() : Result<std::string>(work.error());
    if (!text) return refuse(text.error()) != 0;
    leaveText(*std::move(text), 0);
    return true;
}

void Session::leaveText(std::string text, std::size_t at) {
    text_ = std::move(text);
    block_[at] = static_cast<double>(reinterpret_cast<Address>(text_.data()));
    block_[at + 1] = static_cast<double>(text_.size());
}

void Session::dropExport() { text_ = std::string(); }

int Session::sceneExporting(int handle, int format, unsigned bytes) {
    const auto* held = find<scene::Scene>(handle);
    if (!held) return 0;
    const auto given = input(bytes);
    if (!given) return refuse(given.error());
    auto work = begun(held->state(), static_cast<ExportFormat>(format), *given);
    if (!work) return refuse(work.error());
    return hold(std::make_unique<SceneExport>(*std::move(work)));
}

bool Session::exportAdvance(int handle, double numbers) {
    auto* work = find<SceneExport>(handle);
    if (!work) return false;
    const auto more = work->advance(numbers);
    if (!more) return refuse(more.error()) != 0;
    block_[0] = *more ? 1 : 0;
    block_[1] = work->fraction();
    leaveText(work->take(), 2);
    return true;
}

}  // namespace knotwork::bindings
