#include "bindings/marshal_cbor.hpp"

#include "bindings/marshal.hpp"

#include <algorithm>
#include <array>

namespace knotwork::bindings {

using scene::Json;
using Kind = CborItem::Kind;

namespace {

// First bytes of items: a major type with a small length in it, or one of these.
constexpr std::uint8_t majorMask = 0xe0;
constexpr std::uint8_t lengthMask = 0x1f;
constexpr std::uint8_t bytesMajor = 0x40;
constexpr std::uint8_t textMajor = 0x60;
constexpr std::uint8_t listMajor = 0x80;
constexpr std::size_t lengthFollows = 26;  // in four bytes
constexpr std::uint8_t openMap = 0xbf;
constexpr std::uint8_t falseItem = 0xf4;
constexpr std::uint8_t trueItem = 0xf5;
constexpr std::uint8_t nullItem = 0xf6;
constexpr std::uint8_t doubleItem = 0xfb;
constexpr std::uint8_t closeMap = 0xff;
constexpr std::uint8_t tag = 0xd8;
constexpr std::uint8_t pointsTag = 40;  // then the dimension and the numbers
constexpr std::array<std::uint8_t, 3> emptyTag{0xd9, 0xd9, 0xf7};

bool startsWith(std::span<const std::uint8_t> bytes,
                std::span<const std::uint8_t> start) noexcept {
    return bytes.size() >= start.size() && std::equal(start.begin(), start.end(), bytes.begin());
}

/// A number that begins with its highest byte, as CBOR's do.
template <class Bits>
Bits bigEndian(std::span<const std::uint8_t> bytes) noexcept {
    Bits bits = 0;
    for (std::size_t i = 0; i < sizeof(Bits); ++i) bits = bits << 8U | bytes[i];
    return bits;
}

}  // namespace

CborItem CborCursor::next() noexcept {
    while (startsWith(rest_, emptyTag)) rest_ = rest_.subspan(emptyTag.size());
    if (rest_.empty()) return {};
    const std::uint8_t first = rest_[0];
    rest_ = rest_.subspan(1);
    switch (first) {
        case doubleItem: {
            if (rest_.size() < sizeof(std::uint64_t)) return {};
            const auto bits = bigEndian<std::uint64_t>(rest_);
            rest_ = rest_.subspan(sizeof bits);
            CborItem item{.kind = Kind::number};
            std::memcpy(&item.number, &bits, sizeof bits);
            return item;
        }
        case falseItem: return {.kind = Kind::flag, .number = 0};
        case trueItem: return {.kind = Kind::flag, .number = 1};
        case nullItem: return {.kind = Kind::null};
        case openMap: return {.kind = Kind::map};
        case closeMap: return {.kind = Kind::close};
        case tag: return points();
        default: return counted(first);
    }
}

CborItem CborCursor::points() noexcept {
    if (rest_.size() < 3 || rest_[0] != pointsTag) return {};
    const std::size_t width = rest_[1];
    const std::uint8_t first = rest_[2];
    rest_ = rest_.subspan(3);
    CborItem item = counted(first);
    if (item.kind != Kind::numbers || width < 2 || width > 3 || item.length % width != 0) return {};
    item.kind = Kind::points;
    item.width = width;
    return item;
}

CborItem CborCursor::counted(std::uint8_t first) noexcept {
    std::size_t length = first & lengthMask;
    if (length == lengthFollows) {
        if (rest_.size() < sizeof(std::uint32_t)) return {};
        length = bigEndian<std::uint32_t>(rest_);
        rest_ = rest_.subspan(sizeof(std::uint32_t));
    }
    if (length > rest_.size()) return {};  // every item takes at least a byte
    const std::uint8_t major = first & majorMask;
    if (major == listMajor) return {.kind = Kind::list, .length = length};
    if (major != bytesMajor && major != textMajor) return {};
    CborItem item{.kind = major == textMajor ? Kind::text : Kind::numbers,
                  .length = length / sizeof(double),
                  .bytes = rest_.first(length)};
    if (item.kind == Kind::numbers && length % sizeof(double) != 0) return {};
    rest_ = rest_.subspan(length);
    return item;
}

namespace {

bool readItem(CborCursor& cursor, const CborItem& item, Json& out, int depth);

Json numbersFrom(const CborItem& item, std::size_t first, std::size_t count) {
    Json::array_t numbers(count);
    for (std::size_t i = 0; i < count; ++i) numbers[i] = item.numberAt(first + i);
    return numbers;
}

bool readList(CborCursor& cursor, std::size_t length, Json& out, int depth) {
    Json::array_t items(length);
    for (Json& one : items) {
        if (!readItem(cursor, cursor.next(), one, depth + 1)) return false;
    }
    out = std::move(items);
    return true;
}

bool readMap(CborCursor& cursor, Json& out, int depth) {
    Json::object_t fields;
    for (;;) {
        const CborItem key = cursor.next();
        if (key.kind == Kind::close) break;
        Json value;
        if (key.kind != Kind::text) return false;
        if (!readItem(cursor, cursor.next(), value, depth + 1)) return false;
        fields.emplace(std::string(key.text()), std::move(value));
    }
    out = std::move(fields);
    return true;
}

bool readItem(CborCursor& cursor, const CborItem& item, Json& out, int depth) {
    if (depth > scene::maximumDepth) return false;
    switch (item.kind) {
        case Kind::number: out = item.number; return true;
        case Kind::text: out = std::string(item.text()); return true;
        case Kind::flag: out = item.number != 0; return true;
        case Kind::null: out = nullptr; return true;
        case Kind::list: return readList(cursor, item.length, out, depth);
        case Kind::map: return readMap(cursor, out, depth);
        case Kind::numbers: out = numbersFrom(item, 0, item.length); return true;
        case Kind::points: {
            Json::array_t points(item.length / item.width);
            for (std::size_t i = 0; i < points.size(); ++i) {
                points[i] = numbersFrom(item, i * item.width, item.width);
            }
            out = std::move(points);
            return true;
        }
        case Kind::close:
        case Kind::bad: return false;
    }
    return false;
}

}  // namespace

bool readValue(CborCursor& cursor, const CborItem& item, Json& value) {
    return readItem(cursor, item, value, 1);
}

Result<Json> readCbor(std::span<const std::uint8_t> bytes) {
    CborCursor cursor(bytes);
    Json value;
    if (readItem(cursor, cursor.next(), value, 0) && cursor.finished()) return value;
    return refuse(Code::syntax, "", "The input did not cross whole; this is a fault of the facade.");
}

bool readPoints(const CborItem& item, std::size_t most, std::vector<Vec3>& points) {
    const std::size_t width = item.kind == Kind::points ? item.width : 3;
    if (item.kind != Kind::points && item.kind != Kind::numbers) return false;
    if (item.length % width != 0 || item.length / width > most) return false;
    points.resize(item.length / width);
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    if (width == 3 && !points.empty()) {
        std::memcpy(&points[0].x, item.bytes.data(), item.bytes.size());
        return true;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i] = {item.numberAt(2 * i), item.numberAt(2 * i + 1), 0};
    }
    return true;
}

}  // namespace knotwork::bindings
