// The tables of effects.
#include "geometry/named.hpp"
#include "scene/fields.hpp"
#include "scene/rotation_fields.hpp"

#include <array>

namespace knotwork::scene {

namespace {

constexpr Field targetField{.name = "target", .label = "Object", .kind = FieldKind::text,
                            .help = "The id of the object that moves.", .required = true};
constexpr Field localField{.name = "local", .label = "Local", .kind = FieldKind::local,
                           .help = "The one local curve or patch that moves; left out: the whole "
                                   "object."};
constexpr Field centerField{.name = "center", .label = "Centre", .kind = FieldKind::point,
                            .help = "The point of the whole object that stays; a local curve or "
                                    "patch has its own.",
                            .defaultJson = "[0,0,0]"};
constexpr Field periodField{.name = "period", .label = "Period", .kind = FieldKind::number,
                            .help = "Seconds until everything stands where it began.", .min = 0,
                            .max = 86'400, .minOpen = true, .defaultJson = "10"};
constexpr Field easingField{.name = "easing", .label = "Easing", .kind = FieldKind::bFunction,
                            .help = "The B-function by which it goes there and comes back.",
                            .defaultJson = "{\"family\":\"trigonometric\"}"};

constexpr std::array translateFields{
    targetField, localField,
    Field{.name = "by", .label = "By", .kind = FieldKind::point, .help = "How far it moves.",
          .defaultJson = "[1,0,0]"},
    periodField, easingField};
constexpr std::array turnFields{
    targetField, localField,
    Field{.name = "axis", .label = "Axis", .kind = FieldKind::point, .help = "Axis of rotation.",
          .defaultJson = "[0,0,1]"},
    Field{.name = "angle", .label = "Angle", .kind = FieldKind::number, .help = "Radians.",
          .min = -1000, .max = 1000, .defaultJson = "1"},
    centerField, periodField, easingField};
constexpr std::array scaleFields{
    targetField, localField,
    Field{.name = "factor", .label = "Factor", .kind = FieldKind::scale,
          .help = "How much larger it gets, along each axis or along all.",
          .defaultJson = "1.5"},
    centerField, periodField, easingField};
constexpr std::array simulateFields{
    targetField,
    Field{.name = "translate", .label = "Move", .kind = FieldKind::point,
          .help = "How far a local curve or patch moves at most along each axis.",
          .defaultJson = "[0.5,0.5,0]"},
    Field{.name = "rotate", .label = "Turn", .kind = FieldKind::group,
          .help = "How far a local curve or patch turns at most.", .defaultJson = "{}",
          .fields = rotateFields},
    Field{.name = "seed", .label = "Seed", .kind = FieldKind::integer,
          .help = "Another number, another dance.", .min = 0, .max = 4294967295.0,
          .defaultJson = "1"},
    periodField, easingField};
constexpr std::array morphFields{
    targetField,
    Field{.name = "to", .label = "To", .kind = FieldKind::curve,
          .help = "The curve that it becomes, its domain mapped onto that of the object.",
          .defaultJson = "{\"type\":\"parametric-curve\",\"name\":\"circle\"}"},
    periodField, easingField};
constexpr std::array colourFields{
    targetField,
    Field{.name = "to", .label = "To", .kind = FieldKind::colour, .help = "The other colour.",
          .defaultJson = "\"#d69e2e\""},
    periodField, easingField};

constexpr std::array effects{
    EffectType{"translate", "Move", translateFields},
    EffectType{"rotate", "Turn", turnFields},
    EffectType{"scale", "Scale", scaleFields},
    EffectType{"simulate", "Simulate", simulateFields},
    EffectType{"morph", "Morph", morphFields},
    EffectType{"colour", "Colour", colourFields},
};

}  // namespace

std::span<const EffectType> effectTypes() noexcept { return effects; }

const EffectType* findEffectType(std::string_view kind) noexcept {
    return findNamed(effects, &EffectType::kind, kind);
}

}  // namespace knotwork::scene
