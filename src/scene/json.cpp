#include "scene/json.hpp"

#include <cstring>
#include <utility>
#include <vector>

namespace knotwork::scene {

namespace {

/// Builds the tree while nlohmann's parser reads, and stops it at too deep a nesting.
class TreeBuilder {
public:
    using Parser = nlohmann::detail::exception;

    bool null() { return add(nullptr); }
    bool boolean(bool value) { return add(value); }
    bool number_integer(std::int64_t value) { return add(static_cast<double>(value)); }
    bool number_unsigned(std::uint64_t value) { return add(static_cast<double>(value)); }
    bool number_float(double value, const std::string&) { return add(value); }
    bool string(std::string& value) { return add(std::move(value)); }

    bool binary(Json::binary_t& bytes) {
        if (bytes.size() % sizeof(double) != 0) {
            return stop(Code::wrongType, "A byte string holds doubles, so a multiple of 8 bytes.");
        }
        Json::array_t numbers;
        numbers.reserve(bytes.size() / sizeof(double));
        for (std::size_t at = 0; at < bytes.size(); at += sizeof(double)) {
            double number = 0;
            std::memcpy(&number, bytes.data() + at, sizeof(double));
            numbers.emplace_back(number);
        }
        return add(std::move(numbers));
    }

    bool start_object(std::size_t) { return open(Json::object()); }
    bool end_object() { return close(); }
    bool start_array(std::size_t) { return open(Json::array()); }
    bool end_array() { return close(); }
    bool key(std::string& name) {
        key_ = std::move(name);
        return true;
    }

    bool parse_error(std::size_t position, const std::string&, const Parser& why) {
        return stop(Code::syntax, "At byte " + std::to_string(position) + ": " + why.what() + '.');
    }

    [[nodiscard]] Result<Json> take(bool complete) {
        if (error_) return *error_;
        if (!complete) return refuse(Code::syntax, "", "This is not a complete value.");
        return std::move(root_);
    }

private:
    bool stop(Code code, std::string message) {
        if (!error_) error_ = refuse(code, "", std::move(message));
        return false;
    }

    Json* place(Json&& value) {
        if (open_.empty()) {
            root_ = std::move(value);
            return &root_;
        }
        Json& parent = *open_.back();
        if (parent.is_array()) {
            parent.push_back(std::move(value));
            return &parent.back();
        }
        Json& slot = parent[key_];
        slot = std::move(value);
        return &slot;
    }

    bool add(Json&& value) {
        place(std::move(value));
        return true;
    }

    bool open(Json&& container) {
        if (open_.size() >= static_cast<std::size_t>(maximumDepth)) {
            return stop(Code::tooLarge, "The document is nested more than " +
                                            std::to_string(maximumDepth) + " levels deep.");
        }
        // A child is finished before its parent grows again, so these pointers stay valid.
        open_.push_back(place(std::move(container)));
        return true;
    }

    bool close() {
        open_.pop_back();
        return true;
    }

    Json root_;
    std::vector<Json*> open_;
    std::string key_;
    std::optional<Error> error_;
};

template <class Bytes>
Result<Json> read(const Bytes& bytes, nlohmann::detail::input_format_t format,
                  std::size_t maximumBytes) {
    if (bytes.size() > maximumBytes) {
        return refuse(Code::tooLarge, "",
                      "The input has " + std::to_string(bytes.size()) + " bytes; at most " +
                          std::to_string(maximumBytes) + " are read.");
    }
    TreeBuilder builder;
    const bool complete = Json::sax_parse(bytes.begin(), bytes.end(), &builder, format);
    return builder.take(complete);
}

}  // namespace

Result<Json> parseJson(std::string_view text) {
    return read(text, nlohmann::detail::input_format_t::json, maximumDocumentBytes);
}

Result<Json> parseCbor(std::span<const std::uint8_t> bytes) {
    return read(bytes, nlohmann::detail::input_format_t::cbor, maximumCborBytes);
}

std::string dumpJson(const Json& value) {
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

const Json* member(const Json& object, std::string_view key) noexcept {
    if (!object.is_object()) return nullptr;
    for (const auto& item : object.get_ref<const Json::object_t&>()) {
        if (item.first == key) return &item.second;
    }
    return nullptr;
}

Json* member(Json& object, std::string_view key) noexcept {
    return const_cast<Json*>(member(std::as_const(object), key));
}

double numberOr(const Json& object, std::string_view key, double otherwise) noexcept {
    const Json* found = member(object, key);
    return found != nullptr && found->is_number() ? found->get<double>() : otherwise;
}

std::string stringOr(const Json& object, std::string_view key, std::string_view otherwise) {
    const Json* found = member(object, key);
    return found != nullptr && found->is_string() ? found->get<std::string>()
                                                  : std::string(otherwise);
}

bool flagOr(const Json& object, std::string_view key, bool otherwise) noexcept {
    const Json* found = member(object, key);
    return found != nullptr && found->is_boolean() ? found->get<bool>() : otherwise;
}

}  // namespace knotwork::scene
