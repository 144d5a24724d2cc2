// Traces and checklists, whose arguments are checked by the scene.
#include "bindings/queries.hpp"
#include "scene/axioms.hpp"
#include "scene/trace.hpp"

#include <array>

namespace knotwork::bindings {

namespace {

Result<Answer> trace(const scene::Json& arguments) {
    const auto made = scene::makeTrace(arguments);
    if (!made) return made.error();
    return Answer{.json = scene::traceJson(*made)};
}

Result<Answer> axioms(const scene::Json& arguments) {
    const auto candidate = scene::makeCandidate(arguments);
    if (!candidate) return candidate.error();
    return Answer{.json = {{"axioms", scene::describeAxioms(candidate->value)}}};
}

constexpr std::array queries{FreeQuery{"trace", {}, false, trace},
                             FreeQuery{"axioms", {}, false, axioms}};

}  // namespace

std::span<const FreeQuery> traceQueries() noexcept { return queries; }

}  // namespace knotwork::bindings
