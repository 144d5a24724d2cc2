#include "scene/trace_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace knotwork::scene {

namespace {

constexpr std::size_t mostFrames = 2'000;
constexpr std::size_t mostNumbers = 500'000;

// A sum of numbers of size 1 that ought to be 0 comes out as some 1e-16.
constexpr double roundingNoise = 1e-13;
constexpr int usualDigits = 4;
constexpr int mostDigits = 15;

constexpr std::size_t longestList = 8;
constexpr std::size_t shortenedList = 6;

std::string filled(std::string_view sentence, const SentenceValues& values) {
    std::string text;
    while (!sentence.empty()) {
        const std::size_t open = sentence.find('{');
        text += sentence.substr(0, open);
        if (open == std::string_view::npos) break;
        const std::size_t close = sentence.find('}', open);
        const std::string_view name = sentence.substr(open + 1, close - open - 1);
        for (const auto& value : values) {
            if (value.first == name) text += value.second;
        }
        sentence.remove_prefix(close + 1);
    }
    return text;
}

int exponentOf(double value) noexcept {
    return static_cast<int>(std::floor(std::log10(std::abs(value))));
}

std::size_t numbersOf(const TraceFrame& frame) noexcept {
    std::size_t count = frame.weights.size();
    for (const auto& row : frame.matrix) count += row.size();
    return count;
}

}  // namespace

TraceFrame tell(const Sentence& sentence, SentenceValues values) {
    TraceFrame frame{.key = sentence.key};
    frame.title = filled(sentence.title, values);
    frame.text = filled(sentence.text, values);
    frame.values = std::move(values);
    return frame;
}

std::string readable(double value, const Reading& reading) {
    if (!(std::abs(value) > roundingNoise * reading.size)) return "0";
    const int exponent = exponentOf(value);
    int digits = std::max(usualDigits, exponent + 1);
    if (std::isfinite(reading.gap)) {
        digits = std::max(digits, exponent - exponentOf(reading.gap) + 2);
    }
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.*e", std::min(digits, mostDigits) - 1, value);
    return formatNumber(std::strtod(text.data(), nullptr));
}

std::string readable(std::size_t value) { return std::to_string(value); }

Reading readingOf(std::span<const Vec3> points) noexcept {
    double size = 0;
    for (const Vec3& point : points) {
        size = std::max({size, std::abs(point.x), std::abs(point.y), std::abs(point.z)});
    }
    return {.size = size};
}

std::string readable(const Vec3& point, int dimension, const Reading& reading) {
    std::string text = '(' + readable(point.x, reading) + ", " + readable(point.y, reading);
    if (dimension == 3) text += ", " + readable(point.z, reading);
    return text + ')';
}

std::string spoken(const std::vector<std::string>& items) {
    const bool whole = items.size() <= longestList;
    const std::size_t shown = whole ? items.size() : shortenedList;
    std::string text;
    for (std::size_t i = 0; i < shown; ++i) {
        if (i > 0) text += whole && i + 1 == shown ? " and " : ", ";
        text += items[i];
    }
    return whole ? text : text + " and " + std::to_string(items.size() - shown) + " more";
}

std::string spoken(std::span<const double> values) {
    std::vector<std::string> items;
    for (const double value : values) items.push_back(readable(value));
    return spoken(items);
}

std::string spoken(std::span<const Vec3> points, int dimension, const Reading& reading) {
    std::vector<std::string> items;
    for (const Vec3& point : points) items.push_back(readable(point, dimension, reading));
    return spoken(items);
}

std::size_t addPolygon(TraceFrame& frame, std::span<const Vec3> points, bool closed) {
    const std::size_t first = frame.points.size();
    frame.points.insert(frame.points.end(), points.begin(), points.end());
    for (std::size_t i = 1; i < points.size(); ++i) {
        frame.edges.push_back({first + i - 1, first + i});
    }
    if (closed && points.size() > 2) frame.edges.push_back({first + points.size() - 1, first});
    return first;
}

std::size_t addMarked(TraceFrame& frame, std::span<const Vec3> points, bool closed) {
    const std::size_t first = addPolygon(frame, points, closed);
    for (std::size_t i = 0; i < points.size(); ++i) frame.marked.push_back(first + i);
    return first;
}

void TraceWriter::add(TraceFrame frame) {
    points_ += frame.points.size();
    numbers_ += numbersOf(frame);
    full_ = full_ || points_ > mostTracedPoints || numbers_ > mostNumbers ||
            trace_.frames.size() == mostFrames;
    if (!full_) trace_.frames.push_back(std::move(frame));
}

Result<Trace> TraceWriter::finish(std::string_view path) && {
    if (!full_) return std::move(trace_);
    return refuse(Code::tooLarge, std::string(path),
                  "This makes more steps than anybody can look at: a trace has at most 2000 "
                  "frames, 20000 points and 500000 numbers in them. Trace something smaller.");
}

}  // namespace knotwork::scene
