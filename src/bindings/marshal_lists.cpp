#include "bindings/marshal_lists.hpp"

namespace knotwork::bindings {

using Kind = CborItem::Kind;

bool readNumbers(const CborItem& item, std::size_t most, std::vector<double>& numbers) {
    if (item.kind != Kind::numbers || item.length > most) return false;
    numbers.resize(item.length);
    if (!numbers.empty()) std::memcpy(numbers.data(), item.bytes.data(), item.bytes.size());
    return true;
}

}  // namespace knotwork::bindings
