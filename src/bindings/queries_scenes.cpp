// Questions about documents that are no scene.
#include "bindings/marshal.hpp"
#include "bindings/queries.hpp"
#include "scene/problems.hpp"

#include <array>

namespace knotwork::bindings {

namespace {

/// { problems: [{ code, path, message }] }; the arguments are the document.
Result<Answer> validate(const scene::Json& document) {
    // How many bytes it came in is not known here; the answer is asked for seldom.
    const auto size = checkSize(document, scene::maximumCborBytes);
    const auto found = size ? scene::findProblems(document) : std::vector<Error>{size.error()};
    scene::Json problems = scene::Json::array();
    for (const Error& problem : found) {
        problems.push_back({{"code", codeName(problem.code)},
                            {"path", problem.path},
                            {"message", problem.message}});
    }
    return Answer{.json = {{"problems", std::move(problems)}}};
}

constexpr std::array queries{FreeQuery{"validate", {}, false, validate}};

}  // namespace

std::span<const FreeQuery> sceneQueries() noexcept { return queries; }

}  // namespace knotwork::bindings
