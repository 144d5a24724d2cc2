// How many letters a text has, which is all that is known of its width where it is not measured.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace knotwork::drawing {

/// A letter a code point.
[[nodiscard]] inline std::size_t lettersIn(std::string_view text) noexcept {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U;
    }));
}

}  // namespace knotwork::drawing
