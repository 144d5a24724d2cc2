// What the traces of all algorithms share: sentences, numbers for reading, pictures and limits.
#pragma once

#include "scene/trace.hpp"

#include <limits>
#include <span>

namespace knotwork::scene {

/// A sentence of a trace, with `{names}` in place of numbers. Every algorithm has its own in one
/// table, so that another language needs no more than tables with the same keys.
struct Sentence {
    std::string_view key;
    std::string_view title;
    std::string_view text;
};

using SentenceValues = std::vector<std::pair<std::string_view, std::string>>;

/// A frame that says this, and shows nothing yet.
[[nodiscard]] TraceFrame tell(const Sentence& sentence, SentenceValues values);

/// How closely to read numbers of one sort: what is small beside `size` is rounding, and numbers
/// that differ by `gap` must look different.
struct Reading {
    double size = 1;
    double gap = std::numeric_limits<double>::infinity();
};

/// Four significant digits, or more where whole numbers and the reading need them; never "-0".
[[nodiscard]] std::string readable(double value, const Reading& reading = {});
[[nodiscard]] std::string readable(std::size_t value);

/// The size of the largest coordinate.
[[nodiscard]] Reading readingOf(std::span<const Vec3> points) noexcept;

/// `(1, 2)`, or `(1, 2, 3)` in three dimensions.
[[nodiscard]] std::string readable(const Vec3& point, int dimension, const Reading& reading);

/// `a, b and c`; of a long list the first ones and how many more.
[[nodiscard]] std::string spoken(const std::vector<std::string>& items);
[[nodiscard]] std::string spoken(std::span<const double> values);
[[nodiscard]] std::string spoken(std::span<const Vec3> points, int dimension,
                                 const Reading& reading);

/// Adds a polygon to the picture; answers the index of its first point.
std::size_t addPolygon(TraceFrame& frame, std::span<const Vec3> points, bool closed = false);
/// Adds a polygon whose points this step has made, or is about.
std::size_t addMarked(TraceFrame& frame, std::span<const Vec3> points, bool closed = false);

/// How many points all frames of a trace have at most.
inline constexpr std::size_t mostTracedPoints = 20'000;

/// Collects frames up to the limits of makeTrace(), and drops what is beyond them.
class TraceWriter {
public:
    explicit TraceWriter(std::string_view algorithm) { trace_.algorithm = algorithm; }

    void add(TraceFrame frame);
    [[nodiscard]] bool full() const noexcept { return full_; }
    /// The trace, or TOO_LARGE at this path.
    [[nodiscard]] Result<Trace> finish(std::string_view path) &&;

private:
    Trace trace_;
    std::size_t points_ = 0;
    std::size_t numbers_ = 0;
    bool full_ = false;
};

}  // namespace knotwork::scene
