// What is shared by those who read lists straight from their bytes, without a tree of JSON in
// between. What is in any way unusual is answered by false and left to the scene's validation,
// which says what is wrong with it.
#pragma once

#include "bindings/marshal_cbor.hpp"

#include <vector>

namespace knotwork::bindings {

/// At most `most` numbers, NaN and infinities included.
[[nodiscard]] bool readNumbers(const CborItem& item, std::size_t most,
                               std::vector<double>& numbers);

}  // namespace knotwork::bindings
