// CBOR (RFC 8949) as the facade writes it, item by item and without copies: maps of open length,
// lists, texts, true, false, null, every number a double, and a Float64Array as a byte string of
// little-endian doubles. Before a long one stands the tag that says nothing (55799) as often as it
// takes for its numbers to lie where numbers in memory do.
#pragma once

#include "geometry/vec.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <vector>

namespace knotwork::bindings {

struct CborItem {
    enum class Kind { number, text, numbers, points, list, map, close, flag, null, bad };

    Kind kind = Kind::bad;
    double number = 0;       ///< of a number; 1 for true
    std::size_t length = 0;  ///< how many items of a list follow, or numbers a byte string holds
    std::size_t width = 1;   ///< of points: how many of the numbers make one
    std::span<const std::uint8_t> bytes{};  ///< of a text, of numbers or of points

    [[nodiscard]] std::string_view text() const noexcept {
        return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    }
    [[nodiscard]] double numberAt(std::size_t i) const noexcept {
        double value = 0;
        std::memcpy(&value, bytes.data() + i * sizeof(double), sizeof(double));
        return value;
    }
};

class CborCursor {
public:
    explicit CborCursor(std::span<const std::uint8_t> bytes) noexcept : rest_(bytes) {}

    /// The next item; `bad` where the bytes end or are not what the facade writes.
    CborItem next() noexcept;
    [[nodiscard]] bool finished() const noexcept { return rest_.empty(); }

private:
    CborItem counted(std::uint8_t first) noexcept;
    CborItem points() noexcept;

    std::span<const std::uint8_t> rest_;
};

/// Whether a map comes next whose fields are all taken: `take` is given the name of each and reads
/// its value.
template <class Take>
[[nodiscard]] bool takeFields(CborCursor& cursor, Take take) {
    if (cursor.next().kind != CborItem::Kind::map) return false;
    for (;;) {
        const CborItem key = cursor.next();
        if (key.kind == CborItem::Kind::close) return true;
        if (key.kind != CborItem::Kind::text || !take(key.text())) return false;
    }
}

/// Flat triples, or points of one dimension; false for any other list, and for more than `most`.
[[nodiscard]] bool readPoints(const CborItem& item, std::size_t most, std::vector<Vec3>& points);

}  // namespace knotwork::bindings
