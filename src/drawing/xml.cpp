#include "drawing/xml.hpp"

#include <algorithm>
#include <cmath>

namespace knotwork::drawing {

namespace {

constexpr double farthest = 1e9;  // with nine decimals still exact as a whole number of them
constexpr std::string_view replacement = "\xEF\xBF\xBD";

/// The escape of a character that has a meaning in XML; empty for the others.
std::string_view escapeOf(char c) noexcept {
    switch (c) {
        case '&': return "&amp;";
        case '<': return "&lt;";
        case '>': return "&gt;";
        case '"': return "&quot;";
        case '\'': return "&#39;";
        case '\t': return "&#9;";
        case '\n': return "&#10;";
        case '\r': return "&#13;";
        default: return static_cast<unsigned char>(c) < 0x20 ? replacement : std::string_view();
    }
}

/// U+FFFE and U+FFFF are no characters of XML.
bool isNoCharacter(std::string_view three) noexcept {
    return three.starts_with("\xEF\xBF") && three.size() == 3 &&
           (three[2] == '\xBE' || three[2] == '\xBF');
}

}  // namespace

void appendNumber(std::string& text, double value, int decimals) {
    const double held = std::isnan(value) ? 0 : std::clamp(value, -farthest, farthest);
    const long long unit = std::llround(std::pow(10.0, decimals));
    const long long rounded = std::llround(held * static_cast<double>(unit));
    if (rounded < 0) text += '-';
    const long long size = std::llabs(rounded);
    text += std::to_string(size / unit);
    if (size % unit == 0) return;
    std::string fraction = std::to_string(unit + size % unit);
    fraction[0] = '.';
    fraction.erase(fraction.find_last_not_of('0') + 1);
    text += fraction;
}

void appendEscaped(std::string& xml, std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::string_view escape = escapeOf(text[i]);
        if (!escape.empty()) {
            xml += escape;
        } else if (isNoCharacter(text.substr(i, 3))) {
            xml += replacement;
            i += 2;
        } else {
            xml += text[i];
        }
    }
}

XmlWriter& XmlWriter::begin(std::string_view tag) {
    if (fresh_) text_ += ">\n";
    text_.append(2 * open_.size(), ' ');
    text_ += '<';
    text_ += tag;
    open_.emplace_back(tag);
    fresh_ = true;
    return *this;
}

XmlWriter& XmlWriter::attribute(std::string_view name, std::string_view value) {
    text_ += ' ';
    text_ += name;
    text_ += "=\"";
    appendEscaped(text_, value);
    text_ += '"';
    return *this;
}

XmlWriter& XmlWriter::number(std::string_view name, double value) {
    std::string digits;
    appendNumber(digits, value, decimals_);
    return attribute(name, digits);
}

void XmlWriter::end() {
    const std::string tag = std::move(open_.back());
    open_.pop_back();
    if (fresh_) {
        text_ += "/>\n";
    } else {
        text_.append(2 * open_.size(), ' ');
        text_ += "</" + tag + ">\n";
    }
    fresh_ = false;
}

void XmlWriter::text(std::string_view content) {
    text_ += '>';
    appendEscaped(text_, content);
    text_ += "</" + open_.back() + ">\n";
    open_.pop_back();
    fresh_ = false;
}

}  // namespace knotwork::drawing
