// Questions about blending surfaces: their knots and their local patches.
#include "bindings/queries.hpp"
#include "geometry/patch_surface.hpp"
#include "scene/json_values.hpp"

#include <array>

namespace knotwork::bindings {

using scene::Field;
using scene::FieldKind;
using scene::Json;

namespace {

constexpr std::array patchFields{
    Field{.name = "i", .label = "Along u", .kind = FieldKind::integer, .min = 0, .max = 9999,
          .required = true},
    Field{.name = "j", .label = "Along v", .kind = FieldKind::integer, .min = 0, .max = 9999,
          .required = true}};

/// Only the facade of blending surfaces asks.
const BlendingSurface& blendOf(const Surface& surface) { return *surface.as<BlendingSurface>(); }

Result<std::size_t> indexOf(const Json& arguments, const char* name, std::size_t count) {
    const double index = arguments[name].get<double>();
    if (index < static_cast<double>(count)) return static_cast<std::size_t>(index);
    return refuse(Code::outOfRange, name,
                  "There is no local patch " + formatNumber(index) +
                      " in this direction; they are 0 to " + std::to_string(count - 1) + ".");
}

Result<Answer> knots(const Surface& surface, const Json&) {
    const BlendingSurface& blend = blendOf(surface);
    Answer answer;
    answer.json["knots"] = Json::array(
        {scene::listOf(blend.alongU().knots), scene::listOf(blend.alongV().knots)});
    return answer;
}

/// Where the own points of all patches stand, posed, row by row.
Result<Answer> origins(const Surface& surface, const Json&) {
    const BlendingSurface& blend = blendOf(surface);
    Answer answer;
    answer.numbers.reserve(3 * blend.alongU().count * blend.alongV().count);
    for (std::size_t i = 0; i < blend.alongU().count; ++i) {
        for (std::size_t j = 0; j < blend.alongV().count; ++j) {
            const PatchPlace& place = blend.place(i, j);
            const Vec3 origin = place.placement().point(place.origin());
            answer.numbers.insert(answer.numbers.end(), {origin.x, origin.y, origin.z});
        }
    }
    return answer;
}

Result<Answer> local(const Surface& surface, const Json& arguments) {
    const BlendingSurface& blend = blendOf(surface);
    const auto i = indexOf(arguments, "i", blend.alongU().count);
    if (!i) return i.error();
    const auto j = indexOf(arguments, "j", blend.alongV().count);
    if (!j) return j.error();
    auto patch = patchSurface(blend, *i, *j);
    if (!patch) return patch.error();
    Answer answer;
    answer.surfaces.push_back(std::move(*patch));
    return answer;
}

std::span<const Field> none() noexcept { return {}; }

const std::array queries{SurfaceQuery{"knots", none(), knots},
                         SurfaceQuery{"origins", none(), origins},
                         SurfaceQuery{"local", patchFields, local}};

}  // namespace

std::span<const SurfaceQuery> blendingSurfaceQueries() noexcept { return queries; }

}  // namespace knotwork::bindings
