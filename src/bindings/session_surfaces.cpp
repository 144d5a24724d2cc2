// The part of the session that holds and evaluates surfaces.
#include "bindings/marshal.hpp"
#include "bindings/session.hpp"
#include "geometry/surface_differential.hpp"
#include "geometry/surface_tessellation.hpp"
#include "geometry/triples.hpp"
#include "scene/json_values.hpp"
#include "scene/surface_specs.hpp"
#include "scene/validation.hpp"

namespace knotwork::bindings {

int Session::holdSurface(SurfaceValue value) {
    const Surface& surface = value.surface;
    const Rectangle whole = domain(surface);
    const ClosedDirections closed = closedDirections(surface);
    block_[0] = whole.u.start;
    block_[1] = whole.u.end;
    block_[2] = whole.v.start;
    block_[3] = whole.v.end;
    block_[4] = closed.u ? 1 : 0;
    block_[5] = closed.v ? 1 : 0;
    block_[6] = static_cast<double>(surface.kind().index());
    return hold(std::make_unique<SurfaceValue>(std::move(value)));
}

int Session::surface(unsigned bytes) {
    const std::span<const std::uint8_t> given = inputBytes(bytes);
    if (auto usual = readUsualSurface(given)) {
        return holdSurface({std::move(*usual), std::nullopt, {}, {given.begin(), given.end()}});
    }
    const auto spec = readCbor(given);
    if (!spec) return refuse(spec.error());
    auto made = scene::makeSurface(*spec);
    if (!made) return refuse(made.error());
    return holdSurface({std::move(made->value), std::move(made->spec)});
}

/// Bytes are kept of B-spline surfaces only; a surface that was computed has none.
const scene::Json& Session::specOf(SurfaceValue& held) {
    if (!held.spec) {
        const auto given = readCbor(held.source);
        auto made = given ? scene::makeSurface(*given)
                          : Result<scene::Made<Surface>>(given.error());
        held.spec = made ? std::move(made->spec) : scene::specOf(held.surface);
        held.source = {};
    }
    return *held.spec;
}

std::string Session::surfaceSpec(int handle) {
    auto* held = find<SurfaceValue>(handle);
    return held ? scene::dumpJson(specOf(*held)) : std::string();
}

bool Session::surfacePoint(int handle, double u, double v) {
    const auto* held = find<SurfaceValue>(handle);
    if (!held) return false;
    const auto place = placeInDomain(held->surface, u, v);
    if (!place) return refuse(place.error());
    write(pointAt(held->surface, *place), block_.data());
    return true;
}

bool Session::surfaceDerivatives(int handle, double u, double v) {
    const auto* held = find<SurfaceValue>(handle);
    if (!held) return false;
    const auto place = placeInDomain(held->surface, u, v);
    if (!place) return refuse(place.error());
    constexpr SurfaceOrders orders{2, 2};
    std::array<Vec3, orders.size()> rows{};
    derivativesWithin(held->surface, *place, 2, rows);
    constexpr std::array<std::array<std::size_t, 2>, 6> answered{
        {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};
    for (std::size_t k = 0; k < answered.size(); ++k) {
        write(rows[orders.at(answered[k][0], answered[k][1])], block_.data() + 3 * k);
    }
    return true;
}

bool Session::surfaceNormal(int handle, double u, double v) {
    const auto* held = find<SurfaceValue>(handle);
    if (!held) return false;
    const auto place = placeInDomain(held->surface, u, v);
    if (!place) return refuse(place.error());
    write(unitNormal(held->surface, *place), block_.data());
    return true;
}

bool Session::surfaceCurvatures(int handle, double u, double v) {
    const auto* held = find<SurfaceValue>(handle);
    if (!held) return false;
    const auto place = placeInDomain(held->surface, u, v);
    if (!place) return refuse(place.error());
    const auto found = curvatures(held->surface, *place);
    if (!found) return refuse(found.error());
    block_[0] = found->gaussian;
    block_[1] = found->mean;
    block_[2] = found->k1;
    block_[3] = found->k2;
    return true;
}

bool Session::surfaceGrid(int handle, unsigned nu, unsigned nv, unsigned first, unsigned count) {
    auto* held = find<SurfaceValue>(handle);
    if (!held) return false;
    std::optional<SurfaceGrid>& grid = held->grid;
    if (!grid || grid->rowCount() != nu || grid->columnCount() != nv) {
        grid.emplace(held->surface, nu, nv);
    }
    const std::size_t points = std::min<std::size_t>(count, blockPoints);
    grid->points(first, points, {block_.data(), 3 * points}, {normals_.data(), 3 * points});
    return true;
}

// A handle that is dragged asks for this at the rate of a picture.
int Session::surfaceWithPose(int handle, int i, int j, unsigned bytes) {
    const auto* held = find<SurfaceValue>(handle);
    if (!held) return 0;
    const BlendingSurface& blend = *held->surface.as<BlendingSurface>();  // nothing else asks
    const std::array counts{blend.alongU().count, blend.alongV().count};
    for (std::size_t direction = 0; direction < 2; ++direction) {
        const int index = direction == 0 ? i : j;
        if (index >= 0 && static_cast<std::size_t>(index) < counts[direction]) continue;
        return refuse({Code::outOfRange, indexed("local", direction),
                       "There is no local patch " + std::to_string(index) +
                           " in this direction; they are 0 to " +
                           std::to_string(counts[direction] - 1) + "."});
    }
    const auto given = input(bytes);
    if (!given) return refuse(given.error());
    // The first field says which patch, as the arguments have already.
    const auto read = scene::readGroup(*given, scene::patchPoseFields().subspan(1));
    if (!read) return refuse(read.error());
    const Pose pose = scene::poseOf(*read);
    if (const auto checked = checkPose(pose); !checked) return refuse(checked.error());
    return holdSurface({blend.withPose(static_cast<std::size_t>(i), static_cast<std::size_t>(j), pose),
                        std::nullopt});
}

std::string Session::surfaceTriangles(int handle, double tolerance) {
    const auto* held = find<SurfaceValue>(handle);
    if (!held) return {};
    if (auto distance = checkTolerance(tolerance); !distance) {
        refuse(distance.error());
        return {};
    }
    auto mesh = trianglesWithin(held->surface, tolerance);
    if (!mesh) {
        refuse(mesh.error());
        return {};
    }
    const std::size_t vertices = mesh->parameters.size() / 2;
    std::vector<double> all = std::move(mesh->positions);
    all.insert(all.end(), mesh->normals.begin(), mesh->normals.end());
    all.insert(all.end(), mesh->parameters.begin(), mesh->parameters.end());
    leave(std::move(all), vertices);
    bulkIndices_ = std::move(mesh->triangles);
    return scene::dumpJson(
        scene::Json{{"vertices", vertices}, {"indices", bulkIndices_.size()}});
}

int Session::surfaceIsoline(int handle, bool alongU, double at, unsigned count, double tolerance) {
    const auto* held = find<SurfaceValue>(handle);
    if (!held) return -1;
    const Rectangle whole = domain(held->surface);
    const auto place = placeInDomain(held->surface, alongU ? whole.u.start : at,
                                     alongU ? at : whole.v.start);
    if (!place) {
        Error error = place.error();
        error.path = "at";
        refuse(std::move(error));
        return -1;
    }
    const Isoline line{alongU, alongU ? place->v : place->u};
    if (count > 0) return leave(isolinePoints(held->surface, line, count), count);
    auto distance = checkTolerance(tolerance);
    auto points = distance ? isolineWithin(held->surface, line, tolerance)
                           : Result<std::vector<double>>(distance.error());
    if (!points) {
        refuse(points.error());
        return -1;
    }
    const std::size_t found = points->size() / 3;
    return leave(std::move(*points), found);
}

std::string Session::parametricSurfaces() const {
    return scene::dumpJson(scene::describeParametricSurfaces());
}

}  // namespace knotwork::bindings
