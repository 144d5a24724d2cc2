#include "bindings/queries.hpp"

#include "geometry/named.hpp"

#include <array>

namespace knotwork::bindings {

namespace {

std::array<std::span<const CurveQuery>, 3> curveTopics() noexcept {
    return {bsplineQueries(), subdivisionQueries(), crossingQueries()};
}
std::array<std::span<const SurfaceQuery>, 3> surfaceTopics() noexcept {
    return {bsplineSurfaceQueries(), blendingSurfaceQueries(), blendingTriangleQueries()};
}
std::array<std::span<const FreeQuery>, 2> freeTopics() noexcept {
    return {traceQueries(), sceneQueries()};
}

template <class Query, std::size_t N>
const Query* findIn(const std::array<std::span<const Query>, N>& topics,
                    std::string_view name) noexcept {
    for (const std::span<const Query> topic : topics) {
        if (const Query* found = findNamed(topic, &Query::name, name)) return found;
    }
    return nullptr;
}

}  // namespace

const CurveQuery* findCurveQuery(std::string_view name) noexcept {
    return findIn(curveTopics(), name);
}

const SurfaceQuery* findSurfaceQuery(std::string_view name) noexcept {
    return findIn(surfaceTopics(), name);
}

const FreeQuery* findFreeQuery(std::string_view name) noexcept {
    return findIn(freeTopics(), name);
}

}  // namespace knotwork::bindings
