#include "scene/trace_formula.hpp"

#include <algorithm>
#include <cstdlib>

namespace knotwork::scene {

namespace {

constexpr std::size_t longestTable = 12;

bool isDigit(char c) noexcept { return ('0' <= c && c <= '9') || c == '.'; }
bool isLetter(char c) noexcept { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z'); }

std::string element(std::string_view name, std::string_view content) {
    std::string text = "<";
    text += name;
    text += '>';
    text += content;
    text += "</";
    text += name;
    return text += '>';
}

std::string escaped(std::string_view symbol) {
    if (symbol == "<") return "&lt;";
    if (symbol == ">") return "&gt;";
    if (symbol == "&") return "&amp;";
    if (symbol == "-") return "\u2212";
    return std::string(symbol);
}

std::string operation(std::string_view symbol) { return element("mo", escaped(symbol)); }

/// Reads the notation from left to right; what is not closed ends with the text.
class NotationReader {
public:
    explicit NotationReader(std::string_view notation) : rest_(notation) {}

    std::string terms() {
        std::string content;
        for (skipSpaces(); !atEnd(); skipSpaces()) content += scripted();
        return content;
    }

    /// Whatever ends a group outside every group.
    bool skipStray() {
        if (rest_.empty()) return false;
        rest_.remove_prefix(1);
        return true;
    }

private:
    void skipSpaces() {
        while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
    }

    bool take(std::string_view expected) {
        if (!rest_.starts_with(expected)) return false;
        rest_.remove_prefix(expected.size());
        return true;
    }

    bool atEnd() const {
        return rest_.empty() || rest_.front() == '}' || rest_.front() == '&' ||
               rest_.starts_with("\\\\");
    }

    std::string scripted() {
        const std::string base = atom();
        const std::string below = take("_") ? atom() : "";
        const std::string above = take("^") ? atom() : "";
        if (below.empty() && above.empty()) return base;
        if (above.empty()) return element("msub", base + below);
        if (below.empty()) return element("msup", base + above);
        return element("msubsup", base + below + above);
    }

    template <class Belongs>
    std::string_view takeWhile(Belongs belongs) {
        const auto end = std::find_if_not(rest_.begin(), rest_.end(), belongs);
        const std::string_view taken =
            rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
        rest_.remove_prefix(taken.size());
        return taken;
    }

    std::string atom() {
        if (atEnd()) return element("mrow", "");
        if (take("{")) return group();
        if (take("\\")) return command(takeWhile(isLetter));
        if (isDigit(rest_.front())) return element("mn", takeWhile(isDigit));
        if (isLetter(rest_.front())) return element("mi", takeOne());
        return operation(takeOne());
    }

    std::string group() {
        const std::string content = element("mrow", terms());
        take("}");
        return content;
    }

    std::string_view takeOne() {
        const std::string_view one = rest_.substr(0, 1);
        rest_.remove_prefix(1);
        return one;
    }

    std::string command(std::string_view name) {
        if (name == "frac") {
            const std::string above = atom();
            return element("mfrac", above + atom());
        }
        if (name == "table") return table();
        if (name == "matrix") {
            return element("mrow", operation("(") + table() + operation(")"));
        }
        if (name == "alpha") return element("mi", "\u03b1");
        if (name == "sum") return operation("\u2211");
        if (name == "cdot") return operation("\u22c5");
        if (name == "le") return operation("\u2264");
        if (name == "cdots") return operation("\u22ef");
        return operation("\u22ee");
    }

    std::string table() {
        take("{");
        std::string rows;
        do {
            std::string cells;
            do cells += element("mtd", terms());
            while (take("&"));
            rows += element("mtr", cells);
        } while (take("\\\\"));
        take("}");
        return element("mtable", rows);
    }

    std::string_view rest_;
};

}  // namespace

std::string mathml(std::string_view notation) {
    NotationReader reader(notation);
    std::string content = reader.terms();
    while (reader.skipStray()) content += reader.terms();
    return "<math xmlns=\"http://www.w3.org/1998/Math/MathML\" display=\"block\">" +
           element("mrow", content) + "</math>";
}

std::string noted(double value, const Reading& reading) {
    const std::string text = readable(value, reading);
    const std::size_t at = text.find('e');
    if (at == std::string::npos) return text;
    return text.substr(0, at) + "\\cdot 10^{" + std::to_string(std::atoi(text.c_str() + at + 1)) +
           '}';
}

std::string notedDifference(double a, double b, const Reading& reading) {
    const std::string second = noted(b, reading);
    return noted(a, reading) + '-' + (second.front() == '-' ? '(' + second + ')' : second);
}

std::string noted(const Vec3& point, int dimension, const Reading& reading) {
    std::string text = '(' + noted(point.x, reading) + ',' + noted(point.y, reading);
    if (dimension == 3) text += ',' + noted(point.z, reading);
    return text + ')';
}

std::string indexedTerm(std::string_view letter, std::size_t index) {
    return std::string(letter) + "_{" + std::to_string(index) + '}';
}

std::string indexedTerm(std::string_view letter, std::size_t first, std::size_t second) {
    return std::string(letter) + "_{" + std::to_string(first) + ',' + std::to_string(second) + '}';
}

std::string levelTerm(std::string_view letter, std::size_t index, std::size_t level) {
    return indexedTerm(letter, index) + "^{(" + std::to_string(level) + ")}";
}

std::string fraction(std::string_view above, std::string_view below) {
    return "\\frac{" + std::string(above) + "}{" + std::string(below) + '}';
}

std::string notedMatrix(std::span<const std::vector<double>> rows) {
    std::string text = "\\matrix{";
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i > 0) text += "\\\\";
        for (std::size_t j = 0; j < rows[i].size(); ++j) {
            if (j > 0) text += '&';
            text += noted(rows[i][j]);
        }
    }
    return text + '}';
}

std::string NotedRows::table() const {
    const bool whole = rows_.size() <= longestTable;
    std::string text = "\\table{";
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const bool hidden = !whole && i + 3 >= longestTable && i + 2 < rows_.size();
        if (hidden && i + 3 > longestTable) continue;
        if (i > 0) text += "\\\\";
        text += hidden ? "\\vdots" : rows_[i];
    }
    return text + '}';
}

}  // namespace knotwork::scene
