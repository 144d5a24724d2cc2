#include "bindings/marshal_lists.hpp"

#include <cstdint>
#include <utility>

namespace knotwork::bindings {

using Kind = CborItem::Kind;

namespace {

/// The bytes as what they are, where they stand as that in memory.
template <class T>
std::optional<std::span<const T>> inPlace(std::span<const std::uint8_t> bytes) {
    if (reinterpret_cast<std::uintptr_t>(bytes.data()) % alignof(T) != 0) return std::nullopt;
    return std::span<const T>(reinterpret_cast<const T*>(bytes.data()), bytes.size() / sizeof(T));
}

}  // namespace

bool readNumbers(const CborItem& item, std::size_t most, std::vector<double>& numbers) {
    if (item.kind != Kind::numbers || item.length > most) return false;
    numbers.resize(item.length);
    if (!numbers.empty()) std::memcpy(numbers.data(), item.bytes.data(), item.bytes.size());
    return true;
}

std::optional<LongList<double>> findNumbers(const CborItem& item, std::size_t most) {
    if (item.kind == Kind::numbers && item.length <= most) {
        if (const auto all = inPlace<double>(item.bytes)) return LongList<double>{{}, *all};
    }
    std::vector<double> numbers;
    if (!readNumbers(item, most, numbers)) return std::nullopt;
    return copied(std::move(numbers));
}

std::optional<LongList<Vec3>> findPoints(const CborItem& item, std::size_t most) {
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    const bool flat = item.kind == Kind::numbers && item.length % 3 == 0;
    if (flat && item.length / 3 <= most) {
        if (const auto all = inPlace<Vec3>(item.bytes)) return LongList<Vec3>{{}, *all};
    }
    std::vector<Vec3> points;
    if (!readPoints(item, most, points)) return std::nullopt;
    return copied(std::move(points));
}

}  // namespace knotwork::bindings
