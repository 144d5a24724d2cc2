// Any text as a document, and what follows it as commands, one a line after a line that begins with
// `>`: refused with a code, and then first of all its problems; or a scene whose canonical document
// opens again as itself, and whose steps lead back to the first document and forth to the last.
#include "fuzz/input.hpp"

#include "drawing/drawing.hpp"
#include "scene/problems.hpp"
#include "scene/scene.hpp"
#include "scene/validation.hpp"

#include <string>
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
        const auto revision = scene.revision();
        const std::string before = scene::dumpJson(scene.document());
        const auto done = scene.execute(*command);
        fuzz::check(done.ok() == (scene.revision() != revision), "a refused command is no step");
        if (done) return checkCanonical(scene);
        fuzz::check(scene::dumpJson(scene.document()) == before, "a refused command changes nothing");
    }
}

/// To the last step and back to the first one, and once more.
void checkHistory(scene::Scene& scene, const std::string& first) {
    while (scene.redo()) {}
    const std::string last = scene::dumpJson(scene.document());
    while (scene.undo()) (void)scene.selection();
    fuzz::check(scene::dumpJson(scene.document()) == first, "undone is as it was");
    while (scene.redo()) (void)scene.selection();
    fuzz::check(scene::dumpJson(scene.document()) == last, "redone is as it came to be");
}

void checkProblems(const scene::Json& document, const Error& refusal) {
    const auto problems = scene::findProblems(document);
    fuzz::check(!problems.empty() && problems.front() == refusal, "the refusal is the first problem");
    fuzz::check(problems.size() <= scene::maximumProblems, "there are not too many problems");
    for (const Error& problem : problems) {
        fuzz::check(problem.message.size() > 10, "a refusal says why");
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
        checkProblems(*parsed, scene.error());
        return 0;
    }
    fuzz::check(scene::findProblems(*parsed).empty(), "a document that opens has no problems");
    checkCanonical(*scene);
    const std::string first = scene::dumpJson(scene->document());
    for (int i = 0; i < 12 && !text.empty(); ++i) execute(*scene, take(text));
    checkHistory(*scene, first);
    drawing::Options options;
    options.moment.phase = 0.3;
    options.tolerance = 0.1;
    (void)drawing::draw(scene->state(), options);
    return 0;
}
