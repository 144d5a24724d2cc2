// The drag of a handle that stands for one value: a parameter of a B-function or a number or vector
// of an effect. Its command sets the value, as a field does.
#pragma once

#include "app/effect_handles.hpp"
#include "app/function_handles.hpp"
#include "app/target.hpp"

#include <optional>
#include <string>
#include <variant>

namespace knotwork::app {

/// All handles of this kind that a scene has.
struct ValueHandles {
    std::vector<FunctionHandle> functions;
    std::vector<EffectHandle> effects;

    /// Those that the target's siblings stand at, in the order of keys.
    [[nodiscard]] std::vector<std::string> pathsLike(const Target& target) const;
    /// The target with this path, or nothing.
    [[nodiscard]] std::optional<Target> find(std::string_view path) const;
    [[nodiscard]] const FunctionHandle* function(std::string_view path) const noexcept;
    [[nodiscard]] const EffectHandle* effect(std::string_view path) const noexcept;
};

[[nodiscard]] Target targetOf(const FunctionHandle& handle);
[[nodiscard]] Target targetOf(const EffectHandle& handle);

class ValueDrag {
public:
    ValueDrag(const FunctionHandle& handle, const Pixel& pressed, const Sight& sight);
    ValueDrag(const EffectHandle& handle, const Pixel& pressed, const Sight& sight);

    /// Brings the handle under the pointer. A vector moves across the screen (Shift: along the axis
    /// that is seen nearest; Ctrl: on the grid), an angle follows the pointer round its centre, also
    /// more than once (Ctrl: by 15 degrees), a factor follows it outwards (Ctrl: by tenths).
    [[nodiscard]] scene::Json command(const scene::State& state, const Pixel& pointer,
                                      const Sight& sight, int modifiers);

private:
    [[nodiscard]] scene::Json effectValue(const EffectHandle& handle, const Pixel& held,
                                          const Sight& sight, int modifiers);
    [[nodiscard]] double angleAt(const EffectHandle& handle, const Pixel& held,
                                 const Sight& sight) const noexcept;

    std::variant<FunctionHandle, EffectHandle> handle_;
    Pixel grabbed_;          ///< from the handle to the pointer when it was pressed
    double lastAngle_ = 0;
    double turned_ = 0;      ///< since then
};

}  // namespace knotwork::app
