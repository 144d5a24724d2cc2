#include "scene/obj.hpp"

#include "scene/json.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

namespace knotwork::scene {

namespace {

__extension__ using Wide = unsigned __int128;

constexpr std::size_t longestQuote = 40;

/// The words of the format that say nothing about vertices and faces.
constexpr std::array passedOver{
    "vt", "vn", "vp", "g", "o", "s", "mg", "usemtl", "mtllib", "usemap", "maplib", "l", "p",
    "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv", "sp",
    "end", "con", "bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj", "ctech",
    "stech", "call", "csh", "bsp", "bzp", "cdc", "cdp", "res"};

bool isDigit(char c) noexcept { return '0' <= c && c <= '9'; }
bool isBlank(char c) noexcept { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool isEnd(char c) noexcept { return c == '\n' || c == '\r'; }
bool endsWord(char c) noexcept { return isBlank(c) || isEnd(c) || c == '#'; }

// ---- Words -------------------------------------------------------------------------------------

/// Goes through a text word by word and line by line.
class Words {
public:
    explicit Words(std::string_view text) : text_(text) {
        constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
        if (text_.starts_with(byteOrderMark)) at_ = byteOrderMark.size();
    }

    [[nodiscard]] bool finished() const noexcept { return at_ >= text_.size(); }
    [[nodiscard]] std::size_t line() const noexcept { return line_; }

    /// The next word of this line; empty at its end and at a comment.
    std::string_view next() noexcept {
        skipBlanks();
        const std::size_t from = at_;
        while (!finished() && !endsWord(text_[at_]) && continuation() == 0) ++at_;
        return text_.substr(from, at_ - from);
    }

    /// To where the next line begins, past words that nobody reads. A comment is of one line.
    void nextLine() noexcept {
        bool comment = false;
        while (!finished() && !isEnd(text_[at_])) {
            comment = comment || text_[at_] == '#';
            const std::size_t length = comment ? 0 : continuation();
            at_ += std::max<std::size_t>(length, 1);
            if (length > 0) ++line_;
        }
        if (finished()) return;
        at_ += endLength(at_);
        ++line_;
    }

private:
    /// Of the end of line at a place: 2 for \r\n.
    [[nodiscard]] std::size_t endLength(std::size_t at) const noexcept {
        return text_.substr(at, 2) == "\r\n" ? 2 : 1;
    }

    /// How long the \ and the end of line are that make the next line part of this one; 0 for none.
    [[nodiscard]] std::size_t continuation() const noexcept {
        if (text_[at_] != '\\' || at_ + 1 >= text_.size() || !isEnd(text_[at_ + 1])) return 0;
        return 1 + endLength(at_ + 1);
    }

    void skipBlanks() noexcept {
        while (!finished()) {
            const std::size_t length = continuation();
            if (length == 0 && !isBlank(text_[at_])) return;
            at_ += std::max<std::size_t>(length, 1);
            if (length > 0) ++line_;
        }
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
};

// ---- Numbers -----------------------------------------------------------------------------------

std::size_t pastDigits(std::string_view word, std::size_t at) noexcept {
    while (at < word.size() && isDigit(word[at])) ++at;
    return at;
}

std::size_t pastSign(std::string_view word, std::size_t at) noexcept {
    return at < word.size() && (word[at] == '+' || word[at] == '-') ? at + 1 : at;
}

/// Digits with a point somewhere, and perhaps an exponent, by its parts.
struct Decimal {
    std::uint64_t digits = 0;
    int count = 0;     ///< of digits without leading zeros
    int exponent = 0;  ///< of ten, after the point has been moved behind the digits
    bool negative = false;
};

std::optional<Decimal> decimalOf(std::string_view word) noexcept {
    Decimal decimal;
    std::size_t at = pastSign(word, 0);
    decimal.negative = at > 0 && word[0] == '-';
    bool any = false;
    bool point = false;
    for (; at < word.size() && (isDigit(word[at]) || (word[at] == '.' && !point)); ++at) {
        if (word[at] == '.') {
            point = true;
            continue;
        }
        any = true;
        if (point) --decimal.exponent;
        if (decimal.count == 0 && word[at] == '0') continue;
        decimal.digits = 10 * decimal.digits + static_cast<std::uint64_t>(word[at] - '0');
        ++decimal.count;
    }
    if (!any) return std::nullopt;
    if (at == word.size()) return decimal;
    if (word[at] != 'e' && word[at] != 'E') return std::nullopt;
    const std::size_t sign = at + 1;
    const std::size_t digits = pastSign(word, sign);
    const std::size_t end = pastDigits(word, digits);
    if (end == digits || end != word.size()) return std::nullopt;
    constexpr int beyondAll = 9999;
    int exponent = 0;
    for (at = digits; at < end; ++at) {
        exponent = std::min(beyondAll, 10 * exponent + (word[at] - '0'));
    }
    decimal.exponent += word[sign] == '-' ? -exponent : exponent;
    return decimal;
}

/// digits / 10^power, correctly rounded, for powers up to 19 and digits that are not 0: an integer
/// division of 128 bits by 64, whose remainder says to which side what lies on the middle goes.
double quotient(std::uint64_t digits, std::size_t power) noexcept {
    std::uint64_t divisor = 1;
    for (std::size_t i = 0; i < power; ++i) divisor *= 10;
    int shift = 0;  // that gives digits and divisor 64 bits each, and the quotient 63 or 64
    for (; (digits >> 63U) == 0; ++shift) digits <<= 1U;
    for (; (divisor >> 63U) == 0; --shift) divisor <<= 1U;
    const Wide above = Wide{digits} << 63U;
    auto bits = static_cast<std::uint64_t>(above / divisor);
    const bool rest = bits * Wide{divisor} != above;
    for (; (bits >> 63U) == 0; ++shift) bits <<= 1U;
    constexpr std::uint64_t below = 0x7ff;  // what a double has no room for
    constexpr std::uint64_t half = 0x400;
    const std::uint64_t low = bits & below;
    const bool odd = (bits & (below + 1)) != 0;
    const bool up = low > half || (low == half && (rest || odd));
    const double kept = static_cast<double>((bits >> 11U) + (up ? 1U : 0U));
    return std::ldexp(kept, 11 - 63 - shift);
}

/// Correctly rounded. Up to 15 digits and powers of ten up to 22 are exact, so that one operation
/// rounds once (W. Clinger, How to read floating point numbers accurately, 1990).
std::optional<double> numberOf(std::string_view word) {
    const auto decimal = decimalOf(word);
    if (!decimal) return std::nullopt;
    constexpr int exactDigits = 15;
    constexpr int wholeDigits = 19;  // of 64 bits
    static constexpr std::array exactPowers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                            1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                            1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    const auto power = static_cast<std::size_t>(std::abs(decimal->exponent));
    double size = 0;
    if (decimal->count <= exactDigits && power < exactPowers.size()) {
        const auto digits = static_cast<double>(decimal->digits);
        size = decimal->exponent < 0 ? digits / exactPowers[power] : digits * exactPowers[power];
    } else if (decimal->count <= wholeDigits && decimal->exponent <= 0 && power <= wholeDigits) {
        size = quotient(decimal->digits, power);
    } else {
        return std::strtod(std::string(word).c_str(), nullptr);
    }
    return decimal->negative ? -size : size;
}

/// Past the whole number at a place; the place itself where there is none.
std::size_t pastInteger(std::string_view word, std::size_t at) noexcept {
    const std::size_t digits = pastSign(word, at);
    const std::size_t end = pastDigits(word, digits);
    return end == digits ? at : end;
}

/// The vertex of `7`, `7/2`, `7//3` or `7/2/3`; nothing for anything else.
std::optional<std::int64_t> referenceOf(std::string_view word) noexcept {
    const std::size_t end = pastInteger(word, 0);
    if (end == 0) return std::nullopt;
    std::size_t at = end;
    for (int part = 0; part < 2 && at < word.size() && word[at] == '/'; ++part) {
        at = pastInteger(word, at + 1);
    }
    if (at != word.size() || word.back() == '/') return std::nullopt;
    constexpr std::int64_t beyondAll = std::int64_t{1} << 40;
    std::int64_t index = 0;
    for (std::size_t i = pastSign(word, 0); i < end; ++i) {
        index = std::min(beyondAll, 10 * index + (word[i] - '0'));
    }
    return word[0] == '-' ? -index : index;
}

// ---- Reading -----------------------------------------------------------------------------------

class ObjReader {
public:
    explicit ObjReader(std::string_view text) : words_(text) {}

    Result<Mesh> read() {
        for (; !words_.finished(); words_.nextLine()) {
            const std::string_view word = words_.next();
            if (word.empty()) continue;
            if (word == "v") readVertex();
            else if (word == "f") readFace();
            else if (std::find(passedOver.begin(), passedOver.end(), word) == passedOver.end()) {
                refuseWord(word, "is no word of OBJ; vertices begin with v and faces with f");
            }
            if (error_) return std::move(*error_);
        }
        if (highest_ > static_cast<std::int64_t>(points_.size())) {
            noSuchVertex(highest_, lineOfHighest_);
            return std::move(*error_);
        }
        return Mesh::make(std::move(points_), std::move(corners_), std::move(starts_));
    }

private:
    void stop(Code code, std::string path, std::size_t line, const std::string& message) {
        error_ = refuse(code, std::move(path), "Line " + std::to_string(line) + ": " + message);
    }

    void refuseWord(std::string_view word, const std::string& what) {
        std::string quoted(word.substr(0, longestQuote));
        if (word.size() > longestQuote) quoted += "…";
        stop(Code::syntax, "obj", words_.line(), "\"" + quoted + "\" " + what + ".");
    }

    void noSuchVertex(std::int64_t index, std::size_t line) {
        stop(Code::outOfRange, "obj", line,
             "there is no vertex " + std::to_string(index) + "; there are " +
                 std::to_string(points_.size()) + ", counted from 1.");
    }

    void readVertex() {
        Vec3 point{0};
        for (int axis = 0; axis < 3; ++axis) {
            const std::string_view word = words_.next();
            if (word.empty()) {
                return stop(Code::syntax, "obj", words_.line(),
                            "the vertex has " + std::to_string(axis) + " coordinates and needs 3.");
            }
            const auto number = numberOf(word);
            if (!number) return refuseWord(word, "is no number");
            point[axis] = *number;
        }
        if (points_.size() == maxMeshVertices) {
            return stop(Code::tooLarge, "obj", words_.line(),
                        "a mesh has at most " + std::to_string(maxMeshVertices) + " vertices.");
        }
        points_.push_back(point);
    }

    void readFace() {
        const std::size_t line = words_.line();
        for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
            const auto reference = referenceOf(word);
            if (!reference) return refuseWord(word, "names no vertex; write 7, 7/2, 7//3 or 7/2/3");
            addCorner(*reference);
            if (error_) return;
        }
        const std::size_t size = corners_.size() - starts_.back();
        if (size < 3) {
            return stop(Code::wrongLength, indexed("faces", starts_.size() - 1), line,
                        "the face has " + std::to_string(size) + " vertices and needs 3.");
        }
        starts_.push_back(static_cast<std::uint32_t>(corners_.size()));
    }

    /// A vertex that comes later in the file may be named; whether it does is known at the end.
    void addCorner(std::int64_t reference) {
        const auto count = static_cast<std::int64_t>(points_.size());
        const std::int64_t index = reference < 0 ? count + 1 + reference : reference;
        constexpr auto most = static_cast<std::int64_t>(maxMeshVertices);
        if (index < 1 || index > most) return noSuchVertex(reference, words_.line());
        if (index > highest_) {
            highest_ = index;
            lineOfHighest_ = words_.line();
        }
        if (corners_.size() == maxMeshCorners) {
            return stop(Code::tooLarge, "obj", words_.line(), "the faces have too many corners.");
        }
        corners_.push_back(static_cast<std::uint32_t>(index - 1));
    }

    Words words_;
    std::vector<Vec3> points_;
    std::vector<std::uint32_t> corners_;
    std::vector<std::uint32_t> starts_{0};
    std::int64_t highest_ = 0;
    std::size_t lineOfHighest_ = 0;
    std::optional<Error> error_;
};

// ---- Writing -----------------------------------------------------------------------------------

/// The JSON library writes the fewest digits that read back: of many numbers at once, [a,b,c,d,…].
void addVertices(std::string& text, std::span<const Vec3> points) {
    Json::array_t numbers;
    numbers.reserve(3 * points.size());
    for (const Vec3& p : points) numbers.insert(numbers.end(), {p.x, p.y, p.z});
    const std::string list = dumpJson(Json(std::move(numbers)));
    int axis = 0;
    text += "v ";
    for (const char c : std::string_view(list).substr(1, list.size() - 2)) {
        if (c != ',') {
            text += c;
            continue;
        }
        axis = (axis + 1) % 3;
        text += axis == 0 ? "\nv " : " ";
    }
    text += '\n';
}

}  // namespace

Result<Mesh> readObj(std::string_view text) { return ObjReader(text).read(); }

std::string writeObj(const Mesh& mesh) {
    std::string text;
    constexpr std::size_t atOnce = 1024;
    const auto points = mesh.points();
    for (std::size_t first = 0; first < points.size(); first += atOnce) {
        addVertices(text, points.subspan(first, std::min(atOnce, points.size() - first)));
    }
    const FaceRows faces = mesh.faces();
    for (std::size_t f = 0; f < faces.count(); ++f) {
        text += 'f';
        for (const std::uint32_t vertex : faces[f]) {
            text += ' ';
            text += std::to_string(vertex + 1);
        }
        text += '\n';
    }
    return text;
}

}  // namespace knotwork::scene
