// The document tree: nlohmann's, with keys in the order in which they were written. Text and bytes
// are read by one function that bounds depth and size while it reads; nothing throws.
#pragma once

#include "geometry/result.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace knotwork::scene {

using Json = nlohmann::ordered_json;

constexpr std::size_t maximumDocumentBytes = 1024 * 1024;
/// Of one value that crosses from JavaScript: 100 000 rational points with room to spare.
constexpr std::size_t maximumCborBytes = 16 * 1024 * 1024;
constexpr int maximumDepth = 32;

/// Reads JSON text. SYNTAX with the byte position for malformed text, TOO_LARGE beyond 1 MiB or
/// depth 32.
[[nodiscard]] Result<Json> parseJson(std::string_view text);

/// Reads CBOR, the form in which plain JavaScript objects cross the border: exact doubles (NaN and
/// infinities included, so that validation can name them), and a Float64Array of numbers as a byte
/// string of little-endian doubles, which is read as a flat list of numbers. TOO_LARGE beyond
/// maximumCborBytes or depth 32.
[[nodiscard]] Result<Json> parseCbor(std::span<const std::uint8_t> bytes);

/// Compact text; numbers in their shortest exact form.
[[nodiscard]] std::string dumpJson(const Json& value);

// Careful access: without exceptions nlohmann's own throwing accessors abort.
/// The member, or null where `object` is no object or has no such key.
[[nodiscard]] const Json* member(const Json& object, std::string_view key) noexcept;
[[nodiscard]] Json* member(Json& object, std::string_view key) noexcept;
/// The member's number, or `otherwise`.
[[nodiscard]] double numberOr(const Json& object, std::string_view key, double otherwise) noexcept;
[[nodiscard]] std::string stringOr(const Json& object, std::string_view key,
                                   std::string_view otherwise);
[[nodiscard]] bool flagOr(const Json& object, std::string_view key, bool otherwise) noexcept;

}  // namespace knotwork::scene
