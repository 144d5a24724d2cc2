// Traces, whose arguments depend on the algorithm: the scene checks them.
#include "bindings/queries.hpp"
#include "scene/trace.hpp"

#include <array>

namespace knotwork::bindings {

namespace {

Result<Answer> trace(const scene::Json& arguments) {
    const auto made = scene::makeTrace(arguments);
    if (!made) return made.error();
    return Answer{.json = scene::traceJson(*made)};
}

constexpr std::array queries{FreeQuery{"trace", {}, false, trace}};

}  // namespace

std::span<const FreeQuery> traceQueries() noexcept { return queries; }

}  // namespace knotwork::bindings
