// Any text as a document, and what follows it as commands, one a line after a line that begins with
// `>`: refused with a code, or a scene whose canonical document opens again as itself.
#include "fuzz/input.hpp"

#include "drawing/drawing.hpp"
#include "scene/scene.hpp"

#include <string_view>

using namespace knotwork;

namespace {

void checkCanonical(const scene::Scene& scene) {
    const scene::Json document = scene.document();
    const std::string text = scene::dumpJson(document);
    const auto parsed = scene::parseJson(text);
    fuzz::check(parsed.ok(), "a canonical document is JSON");
    const auto again = scene::Scene::open(*parsed);
    fuzz::check(again.ok(), "a canonical document opens");
    fuzz::check(scene::dumpJson(again->document()) == text, "a canonical document is its own");
}

void execute(scene::Scene& scene, std::string_view line) {
    if (line == "undo") {
        scene.undo();
    } else if (line == "redo") {
        scene.redo();
    } else if (const auto command = scene::parseJson(line)) {
        const auto before = scene.revision();
        const auto done = scene.execute(*command);
        fuzz::check(done.ok() == (scene.revision() != before), "a refused command changes nothing");
    }
}

/// The text up to the next `\n>`, which is taken away with it.
std::string_view take(std::string_view& text) {
    const std::size_t end = text.find("\n>");
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 2);
    return part;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto parsed = scene::parseJson(take(text));
    if (!parsed) return 0;
    auto scene = scene::Scene::open(*parsed);
    if (!scene) {
        fuzz::check(scene.error().message.size() > 10, "a refusal says why");
        return 0;
    }
    for (int i = 0; i < 8 && !text.empty(); ++i) execute(*scene, take(text));
    checkCanonical(*scene);
    drawing::Options options;
    options.moment.phase = 0.3;
    options.tolerance = 0.1;
    (void)drawing::draw(scene->state(), options);
    return 0;
}
