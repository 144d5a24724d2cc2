#include "scene/path.hpp"

namespace knotwork::scene {

namespace {

constexpr std::size_t maximumSteps = 64;
constexpr std::size_t maximumIndexDigits = 9;

bool isKeyCharacter(char c) noexcept {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
}

class PathReader {
public:
    explicit PathReader(std::string_view text) : text_(text) {}

    Result<Path> read() {
        Path path;
        while (at_ < text_.size() || path.empty()) {
            const bool first = path.empty();
            const bool read = peek() == '[' && !first ? readIndex(path) : readKey(path, first);
            if (!read || path.size() > maximumSteps) return fail();
        }
        return path;
    }

private:
    [[nodiscard]] char peek() const noexcept { return at_ < text_.size() ? text_[at_] : '\0'; }

    bool readKey(Path& path, bool first) {
        if (!first) {
            if (peek() != '.') return false;
            ++at_;
        }
        const std::size_t start = at_;
        while (isKeyCharacter(peek())) ++at_;
        if (at_ == start) return false;
        path.push_back({std::string(text_.substr(start, at_ - start)), 0});
        return true;
    }

    bool readIndex(Path& path) {
        const std::size_t start = ++at_;
        std::size_t index = 0;
        while (peek() >= '0' && peek() <= '9') {
            index = 10 * index + static_cast<std::size_t>(peek() - '0');
            ++at_;
        }
        if (at_ == start || at_ - start > maximumIndexDigits || peek() != ']') return false;
        ++at_;
        path.push_back({"", index});
        return true;
    }

    [[nodiscard]] Error fail() const {
        return refuse(Code::syntax, "",
                      "\"" + std::string(text_.substr(0, 100)) + "\" is no path (at character " +
                          std::to_string(at_) + "); write for example objects[0].points[2].");
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace

Result<Path> parsePath(std::string_view text) { return PathReader(text).read(); }

std::string formatPath(const Path& path) {
    std::string text;
    for (const PathStep& step : path) {
        text = joinPath(text, step.isIndex() ? "[" + std::to_string(step.index) + "]" : step.key);
    }
    return text;
}

const Json* find(const Json& root, std::span<const PathStep> path) noexcept {
    const Json* at = &root;
    for (const PathStep& step : path) {
        if (step.isIndex()) {
            at = at->is_array() && step.index < at->size() ? &(*at)[step.index] : nullptr;
        } else {
            at = member(*at, step.key);
        }
        if (at == nullptr) return nullptr;
    }
    return at;
}

Json* find(Json& root, std::span<const PathStep> path) noexcept {
    return const_cast<Json*>(find(std::as_const(root), path));
}

}  // namespace knotwork::scene
