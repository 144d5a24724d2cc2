#include "scene/readable.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace knotwork::scene {

namespace {

constexpr std::size_t pageWidth = 100;
constexpr std::size_t indentWidth = 4;
/// What is longer than this in a list stands on a line of its own.
constexpr std::size_t longestFilled = 40;

bool isLetter(char c) noexcept {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_' || c == '$';
}

class ReadableText {
public:
    explicit ReadableText(Notation notation) : notation_(notation) {}

    /// `used`: what stands on the line before the value; `depth`: how far the line is indented.
    void write(const Json& value, std::size_t depth, std::size_t used) {
        std::string line;
        if (fits(line, value, pageWidth - std::min(used, pageWidth))) {
            text_ += line;
        } else if (value.is_object()) {
            object(value, depth);
        } else if (value.is_array()) {
            list(value, depth);
        } else {
            text_ += line;
        }
    }

    [[nodiscard]] std::string take() { return std::move(text_); }

private:
    /// Appends the value to the line; false as soon as that is longer than `room`. A number or a
    /// string is written whatever its length.
    bool fits(std::string& line, const Json& value, std::size_t room) const {
        if (value.is_object()) {
            line += value.empty() ? "{" : "{ ";
            for (auto item = value.begin(); item != value.end(); ++item) {
                if (item != value.begin()) line += ", ";
                line += key(item.key()) + ": ";
                if (!fits(line, item.value(), room)) return false;
            }
            line += value.empty() ? "}" : " }";
        } else if (value.is_array()) {
            line += '[';
            for (std::size_t i = 0; i < value.size(); ++i) {
                if (i > 0) line += ", ";
                if (!fits(line, value[i], room)) return false;
            }
            line += ']';
        } else {
            line += scalar(value);
        }
        return line.size() <= room;
    }

    void object(const Json& value, std::size_t depth) {
        text_ += '{';
        for (auto item = value.begin(); item != value.end(); ++item) {
            newLine(depth + 1);
            const std::string name = key(item.key()) + ": ";
            text_ += name;
            write(item.value(), depth + 1, (depth + 1) * indentWidth + name.size() + 1);
            const bool last = std::next(item) == value.end();
            if (!last || notation_ == Notation::javaScript) text_ += ',';
        }
        newLine(depth);
        text_ += '}';
    }

    void list(const Json& value, std::size_t depth) {
        text_ += '[';
        const std::size_t indent = (depth + 1) * indentWidth;
        std::size_t used = pageWidth;  // the first begins a line
        for (std::size_t i = 0; i < value.size(); ++i) {
            std::string item;
            const bool fills = fits(item, value[i], longestFilled);
            if (fills && used + item.size() + 2 <= pageWidth) {
                text_ += ' ' + item;
                used += item.size() + 2;
            } else {
                newLine(depth + 1);
                if (fills) text_ += item;
                else write(value[i], depth + 1, indent + 1);
                used = fills ? indent + item.size() + 1 : pageWidth;
            }
            const bool last = i + 1 == value.size();
            if (!last || notation_ == Notation::javaScript) text_ += ',';
        }
        newLine(depth);
        text_ += ']';
    }

    void newLine(std::size_t depth) {
        text_ += '\n';
        text_.append(depth * indentWidth, ' ');
    }

    [[nodiscard]] std::string key(const std::string& name) const {
        if (notation_ == Notation::json) return dumpJson(Json(name));
        return isBareWord(name) ? name : javaScriptString(name);
    }

    [[nodiscard]] std::string scalar(const Json& value) const {
        if (value.is_string() && notation_ == Notation::javaScript) {
            return javaScriptString(*value.get_ptr<const std::string*>());
        }
        std::string text = dumpJson(value);
        if (value.is_number_float() && text.ends_with(".0")) text.resize(text.size() - 2);
        return text;
    }

    Notation notation_;
    std::string text_;
};

}  // namespace

std::string readableText(const Json& value, Notation notation) {
    ReadableText text(notation);
    text.write(value, 0, 0);
    return text.take();
}

std::string javaScriptString(std::string_view text) {
    std::string quoted = dumpJson(Json(std::string(text)));
    const bool plain = quoted.find_first_of("\\'") == std::string::npos;
    if (plain) quoted.front() = quoted.back() = '\'';
    return quoted;
}

bool isBareWord(std::string_view text) noexcept {
    const auto allowed = [](char c) { return isLetter(c) || ('0' <= c && c <= '9'); };
    return !text.empty() && isLetter(text[0]) && std::all_of(text.begin(), text.end(), allowed);
}

void appendRows(std::string& text, std::span<const double> numbers,
                std::span<const std::string_view> before) {
    // The JSON library writes the fewest digits that read back: of many numbers at once.
    constexpr std::size_t atOnce = 3072;
    std::size_t column = 0;
    for (std::size_t first = 0; first < numbers.size(); first += atOnce) {
        const auto some = numbers.subspan(first, std::min(atOnce, numbers.size() - first));
        const std::string list = dumpJson(Json(Json::array_t(some.begin(), some.end())));
        for (std::size_t at = 1; at < list.size();) {
            const std::size_t end = list.find_first_of(",]", at);
            std::string_view number = std::string_view(list).substr(at, end - at);
            if (number.ends_with(".0")) number.remove_suffix(2);
            text += before[column];
            text += number;
            column = (column + 1) % before.size();
            at = end + 1;
        }
    }
}

}  // namespace knotwork::scene
