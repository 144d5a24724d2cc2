#include "bindings/marshal.hpp"

#include <cstring>

namespace knotwork::bindings {

using scene::Json;

namespace {

// First bytes of items: a major type with a small length in it, or one of these.
constexpr std::uint8_t majorMask = 0xe0;
constexpr std::uint8_t lengthMask = 0x1f;
constexpr std::uint8_t bytesMajor = 0x40;
constexpr std::uint8_t textMajor = 0x60;
constexpr std::uint8_t listMajor = 0x80;
constexpr std::uint8_t lengthFollows = 26;  // in four bytes
constexpr std::uint8_t openMap = 0xbf;
constexpr std::uint8_t falseItem = 0xf4;
constexpr std::uint8_t trueItem = 0xf5;
constexpr std::uint8_t nullItem = 0xf6;
constexpr std::uint8_t doubleItem = 0xfb;
constexpr std::uint8_t closeMap = 0xff;

class Reader {
public:
    explicit Reader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

    /// One item into `out`; false where the bytes are not what they should be.
    bool item(Json& out, int depth) {
        if (rest_.empty() || depth > scene::maximumDepth) return false;
        const std::uint8_t first = rest_[0];
        rest_ = rest_.subspan(1);
        switch (first) {
            case doubleItem: return number(out);
            case falseItem: out = false; return true;
            case trueItem: out = true; return true;
            case nullItem: out = nullptr; return true;
            case openMap: return map(out, depth);
            default: return counted(first, out, depth);
        }
    }

    [[nodiscard]] bool finished() const noexcept { return rest_.empty(); }

private:
    bool number(Json& out) {
        if (rest_.size() < sizeof(std::uint64_t)) return false;
        out = take<double, true>();
        return true;
    }

    bool counted(std::uint8_t first, Json& out, int depth) {
        std::size_t length = first & lengthMask;
        if (length == lengthFollows) {
            if (rest_.size() < sizeof(std::uint32_t)) return false;
            length = take<std::uint32_t, true>();
        } else if (length > lengthFollows) {
            return false;
        }
        if (length > rest_.size()) return false;  // every item takes at least a byte
        switch (first & majorMask) {
            case bytesMajor: return numbers(length, out);
            case textMajor: out = text(length); return true;
            case listMajor: return list(length, out, depth);
            default: return false;
        }
    }

    bool list(std::size_t length, Json& out, int depth) {
        Json::array_t items(length);
        for (Json& one : items) {
            if (!item(one, depth + 1)) return false;
        }
        out = std::move(items);
        return true;
    }

    bool numbers(std::size_t length, Json& out) {
        if (length % sizeof(double) != 0) return false;
        Json::array_t items(length / sizeof(double));
        for (Json& one : items) one = take<double, false>();
        out = std::move(items);
        return true;
    }

    bool map(Json& out, int depth) {
        Json::object_t fields;
        while (!rest_.empty() && rest_[0] != closeMap) {
            Json key;
            Json value;
            if (!item(key, depth + 1) || !key.is_string() || !item(value, depth + 1)) return false;
            fields.emplace(std::move(key.get_ref<std::string&>()), std::move(value));
        }
        if (rest_.empty()) return false;
        rest_ = rest_.subspan(1);
        out = std::move(fields);
        return true;
    }

    std::string text(std::size_t length) {
        std::string copy(reinterpret_cast<const char*>(rest_.data()), length);
        rest_ = rest_.subspan(length);
        return copy;
    }

    /// CBOR's own numbers begin with their highest byte; memory, here and in wasm, with the lowest.
    template <class T, bool highestFirst>
    T take() {
        std::uint8_t bytes[sizeof(T)];
        for (std::size_t i = 0; i < sizeof(T); ++i) {
            bytes[i] = rest_[highestFirst ? sizeof(T) - 1 - i : i];
        }
        rest_ = rest_.subspan(sizeof(T));
        T value;
        std::memcpy(&value, bytes, sizeof(T));
        return value;
    }

    std::span<const std::uint8_t> rest_;
};

}  // namespace

Result<Json> readCbor(std::span<const std::uint8_t> bytes) {
    Reader reader(bytes);
    Json value;
    if (reader.item(value, 0) && reader.finished()) return value;
    return refuse(Code::syntax, "", "The input did not cross whole; this is a fault of the facade.");
}

}  // namespace knotwork::bindings
