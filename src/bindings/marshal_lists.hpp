// What is shared by those who read lists straight from their bytes, without a tree of JSON in
// between. What is in any way unusual is answered by false and left to the scene's validation,
// which says what is wrong with it.
#pragma once

#include "bindings/marshal_cbor.hpp"
#include "geometry/vec.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace knotwork::bindings {

/// At most `most` numbers, NaN and infinities included.
[[nodiscard]] bool readNumbers(const CborItem& item, std::size_t most,
                               std::vector<double>& numbers);

/// A list that is read where it crossed, or from a copy where it cannot be. To be moved, not copied.
template <class T>
struct LongList {
    std::vector<T> copy;
    std::span<const T> all;
};

template <class T>
[[nodiscard]] LongList<T> copied(std::vector<T> list) {
    const std::span<const T> all(list);  // which stays there when the list is moved
    return {std::move(list), all};
}

/// readNumbers() and readPoints() that copy only what does not stand as such in the bytes; those must
/// stay as they are.
[[nodiscard]] std::optional<LongList<double>> findNumbers(const CborItem& item, std::size_t most);
[[nodiscard]] std::optional<LongList<Vec3>> findPoints(const CborItem& item, std::size_t most);

}  // namespace knotwork::bindings
