#include "scene/obj.hpp"

#include "scene/json.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

namespace knotwork::scene {

namespace {

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

/// Digits with a point somewhere, and perhaps an exponent: the C library also takes `inf`, `nan` and
/// hexadecimal numbers, which are none here.
bool isDecimal(std::string_view word) noexcept {
    const std::size_t first = pastSign(word, 0);
    const std::size_t point = pastDigits(word, first);
    const bool pointed = point < word.size() && word[point] == '.';
    const std::size_t fraction = pointed ? point + 1 : point;
    const std::size_t end = pastDigits(word, fraction);
    if (point == first && end == fraction) return false;
    if (end == word.size()) return true;
    if (word[end] != 'e' && word[end] != 'E') return false;
    const std::size_t exponent = pastSign(word, end + 1);
    return exponent < word.size() && pastDigits(word, exponent) == word.size();
}

std::optional<double> numberOf(std::string_view word) {
    if (!isDecimal(word)) return std::nullopt;
    return std::strtod(std::string(word).c_str(), nullptr);
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
