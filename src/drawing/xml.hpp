// XML text, indented, one element a line.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace knotwork::drawing {

/// Appends a number with at most so many decimals (0 to 9) and none that are zero; what is beyond
/// ±1e9 or not finite is held there, which is far outside of any picture.
void appendNumber(std::string& text, double value, int decimals);

/// Appends a text as XML may hold it, in an attribute too: & < > " ' escaped; what XML has no place
/// for, as control characters, becomes U+FFFD.
void appendEscaped(std::string& xml, std::string_view text);

class XmlWriter {
public:
    /// Numbers are written with at most so many decimals.
    explicit XmlWriter(int decimals) : decimals_(decimals) {}

    /// An element; what follows until end() is in it.
    XmlWriter& begin(std::string_view tag);
    /// Of the element that has just begun.
    XmlWriter& attribute(std::string_view name, std::string_view value);
    XmlWriter& number(std::string_view name, double value);
    void end();
    /// Ends the element that has just begun with this in it.
    void text(std::string_view content);

    [[nodiscard]] int decimals() const noexcept { return decimals_; }
    [[nodiscard]] std::string take() { return std::exchange(text_, std::string()); }

private:
    int decimals_;
    bool fresh_ = false;  ///< the tag that began last has not been closed
    std::string text_;
    std::vector<std::string> open_;
};

}  // namespace knotwork::drawing
