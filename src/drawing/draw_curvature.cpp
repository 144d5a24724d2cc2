// The curvature over the parameter. It may be without bounds (at cusps), so the graph ends at a
// height that most of it stays below, with a mark and the greatest value where it goes beyond.
#include "drawing/measures.hpp"
#include "drawing/ticks.hpp"
#include "geometry/smooth_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace knotwork::drawing {

namespace {

constexpr std::size_t wantedSamples = 512;
constexpr std::size_t leastOfPiece = 8;
constexpr std::size_t mostOfPiece = 48;
constexpr std::size_t mostPieces = 4096;  // of a spline whose graph one can still read
constexpr std::size_t mostRuns = 400;   // then jumps are drawn, as verticals
constexpr int depth = 7;                // of halvings between two samples
constexpr double chordShare = 2e-3;     // of the height of the graph
constexpr double jumpShare = 1e-3;      // of the same: less is no jump
constexpr double quantile = 0.9;        // of the samples …
constexpr double quantileShare = 4;     // … that are to stay this far below the height
constexpr double flatShare = 4;         // the least height, in radians along the curve's size
constexpr double inset = 1e-6;          // of a piece, from a place where the curve stands still
constexpr double stillness = 1e-9;      // of the largest speed of a piece
constexpr double straightness = 1e-12;  // a turn that rounding makes
constexpr double pole = 1e5;            // of the height: what is greater has no bound
constexpr int searches = 90;            // golden sections, to the last digits of a parameter

struct Sample {
    double t = 0;
    double value = 0;
    std::size_t piece = 0;
};

/// κ over one smooth piece.
class Curvature {
public:
    Curvature(const Curve& curve, const Interval& piece) noexcept
        : curve_(curve), piece_(piece), plane_(dimension(curve) == 2) {
        for (std::size_t i = 0; i < leastOfPiece; ++i) {
            const double t = uniformParameter(piece, i, leastOfPiece);
            fastest_ = std::max(fastest_, glm::length(rowsAt(t)[1]));
        }
    }

    [[nodiscard]] double at(double t) const noexcept {
        const auto rows = rowsAt(t);
        if (glm::length(rows[1]) > stillness * fastest_) return of(rows);
        // Where the curve stands still, the limit as near as rounding lets one come.
        const double aside = inset * piece_.length();
        return of(rowsAt(t + aside < piece_.end ? t + aside : t - aside));
    }

private:
    using Rows = std::array<Vec3, 3>;

    [[nodiscard]] Rows rowsAt(double t) const noexcept {
        Rows rows{};
        evaluate(curve_, t, t < piece_.end ? Side::right : Side::left, rows);
        return rows;
    }
    [[nodiscard]] double of(const Rows& rows) const noexcept {
        const double speed = glm::length(rows[1]);
        const Vec3 turn = glm::cross(rows[1], rows[2]);
        const double turning = glm::length(turn);
        if (!(turning > straightness * speed * glm::length(rows[2]))) return 0;
        const double value = (plane_ ? turn.z : turning) / speed / speed / speed;
        return std::isnan(value) ? 0 : value;
    }

    const Curve& curve_;
    Interval piece_;
    bool plane_;
    double fastest_ = 0;
};

/// How high a graph may be, so that a cusp does not press all else against the axis, and how high
/// it is by its samples.
struct Height {
    double most = 1;
    double scale = 1;
};

Height heightOf(std::vector<double> sizes, double size) {
    std::erase_if(sizes, [](double value) { return !std::isfinite(value); });
    if (sizes.empty()) return {};
    const auto last = static_cast<double>(sizes.size() - 1);
    const auto place = static_cast<std::ptrdiff_t>(quantile * last);
    std::nth_element(sizes.begin(), sizes.begin() + place, sizes.end());
    const double flat = size > 0 ? flatShare / size : 1;
    const double most = std::max(quantileShare * sizes[static_cast<std::size_t>(place)], flat);
    const double largest = *std::max_element(sizes.begin(), sizes.end());
    return {most, largest > 0 ? std::min(largest, most) : most};
}

/// Samples close enough together for a polyline that is cut at the height.
class Refinement {
public:
    Refinement(const std::vector<Curvature>& pieces, const Height& height)
        : pieces_(pieces), height_(height) {}

    void add(const std::vector<Sample>& coarse) {
        samples_.push_back(coarse.front());
        for (std::size_t i = 0; i + 1 < coarse.size(); ++i) extend(coarse[i], coarse[i + 1], depth);
    }
    [[nodiscard]] std::vector<Sample> take() { return std::move(samples_); }

private:
    [[nodiscard]] double clipped(const Sample& sample) const noexcept {
        return std::clamp(sample.value, -1.05 * height_.most, 1.05 * height_.most);
    }

    void extend(const Sample& from, const Sample& to, int left) {
        const double t = (from.t + to.t) / 2;
        const Sample middle{t, pieces_[from.piece].at(t), from.piece};
        const double off = std::abs(clipped(middle) - (clipped(from) + clipped(to)) / 2);
        if (left == 0 || !(off > chordShare * height_.scale)) {
            samples_.insert(samples_.end(), {middle, to});
            return;
        }
        extend(from, middle, left - 1);
        extend(middle, to, left - 1);
    }

    const std::vector<Curvature>& pieces_;
    Height height_;
    std::vector<Sample> samples_;
};

/// The graph below its height as runs without jumps, and where it is beyond.
class Graph {
public:
    Graph(const std::vector<Curvature>& pieces, const Height& height)
        : pieces_(pieces), height_(height.most), jump_(jumpShare * height.scale) {}

    void trace(const std::vector<Sample>& all) {
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Sample* former = i > 0 ? &all[i - 1] : nullptr;
            const bool apart = former != nullptr && former->t < all[i].t;
            if (isBeyond(all[i])) {
                if (apart && !isBeyond(*former)) place(cut(*former, all[i]));
                inRun_ = false;
                leave(all, i);
                continue;
            }
            endExcursion(all);
            if (apart && isBeyond(*former)) place(cut(all[i], *former));
            const bool jumps = former != nullptr && !apart &&
                               std::abs(all[i].value - former->value) > jump_;
            if (jumps && runs_.size() < mostRuns) inRun_ = false;
            place(all[i]);
        }
        endExcursion(all);
    }

    void draw(Sketch& sketch) const {
        for (const std::vector<Vec3>& run : runs_) {
            append(sketch.add(Role::comb, Kind::polyline, 2, Pane::curvature), run);
        }
        if (peaks_.empty()) return;
        Shape& marks = sketch.add(Role::comb, Kind::points, 6, Pane::curvature);
        marks.index = 2;
        for (const Sample& peak : peaks_) append(marks, markOf(peak));
        for (const Sample& peak : peaks_) {
            Shape& label = sketch.add(Role::comb, Kind::label, 11, Pane::curvature);
            label.text = textOf(peak.value);
            append(label, markOf(peak));
        }
    }

private:
    /// Samples beyond the height on one side, from the first to the last.
    struct Excursion {
        std::size_t first = 0;
        std::size_t last = 0;
    };

    [[nodiscard]] bool isBeyond(const Sample& sample) const noexcept {
        return std::abs(sample.value) > height_ * (1 + 1e-9);
    }
    [[nodiscard]] Vec3 markOf(const Sample& peak) const noexcept {
        return {peak.t, std::copysign(height_, peak.value), 0};
    }

    /// Between a sample below the height and one beyond it.
    [[nodiscard]] Sample cut(const Sample& below, const Sample& beyond) const noexcept {
        const double edge = std::copysign(height_, beyond.value);
        const double whole = std::clamp(beyond.value, -2 * height_, 2 * height_) - below.value;
        const double part = std::clamp((edge - below.value) / whole, 0.0, 1.0);
        return {below.t + part * (beyond.t - below.t), edge, below.piece};
    }

    void place(const Sample& sample) {
        if (!inRun_) runs_.emplace_back();
        inRun_ = true;
        runs_.back().emplace_back(sample.t, sample.value, 0);
    }

    void leave(const std::vector<Sample>& all, std::size_t i) {
        const auto below = [&](std::size_t k) { return std::signbit(all[k].value); };
        if (excursion_ && below(excursion_->first) != below(i)) endExcursion(all);
        if (!excursion_) excursion_ = Excursion{i, i};
        excursion_->last = i;
    }

    void endExcursion(const std::vector<Sample>& all) {
        if (!excursion_) return;
        std::size_t top = excursion_->first;
        for (std::size_t k = top; k <= excursion_->last; ++k) {
            if (std::abs(all[k].value) > std::abs(all[top].value)) top = k;
        }
        const auto in = [&](std::size_t k) {
            return k < all.size() && all[k].piece == all[top].piece;
        };
        const double from = top > 0 && in(top - 1) ? all[top - 1].t : all[top].t;
        const double to = in(top + 1) ? all[top + 1].t : all[top].t;
        peaks_.push_back(highest(all[top], from, to));
        excursion_.reset();
    }

    /// Golden section about the greatest sample (J. Kiefer, 1953).
    [[nodiscard]] Sample highest(Sample best, double a, double b) const noexcept {
        constexpr double ratio = 0.6180339887498949;
        const Curvature& curvature = pieces_[best.piece];
        for (int k = 0; k < searches && a < b && std::abs(best.value) < pole * height_; ++k) {
            const Sample low{b - ratio * (b - a), curvature.at(b - ratio * (b - a)), best.piece};
            const Sample high{a + ratio * (b - a), curvature.at(a + ratio * (b - a)), best.piece};
            for (const Sample& one : {low, high}) {
                const bool sameSide = std::signbit(one.value) == std::signbit(best.value);
                if (sameSide && std::abs(one.value) > std::abs(best.value)) best = one;
            }
            if (std::abs(low.value) > std::abs(high.value)) b = high.t;
            else a = low.t;
        }
        return best;
    }

    [[nodiscard]] std::string textOf(double value) const {
        if (!(std::abs(value) < pole * height_)) return value < 0 ? "\u2212\u221e" : "\u221e";
        const double digits = 2 - std::floor(std::log10(std::abs(value)));
        return numberText(value, static_cast<int>(std::clamp(digits, 0.0, 12.0)));
    }

    const std::vector<Curvature>& pieces_;
    double height_;
    double jump_;
    std::vector<std::vector<Vec3>> runs_;
    std::optional<Excursion> excursion_;
    std::vector<Sample> peaks_;
    bool inRun_ = false;
};

std::vector<Sample> samplesOf(const Curvature& curvature, const Interval& interval,
                              std::size_t piece, std::size_t count) {
    std::vector<Sample> samples;
    for (std::size_t i = 0; i <= count; ++i) {
        const double t = uniformParameter(interval, i, count + 1);
        samples.push_back({t, curvature.at(t), piece});
    }
    return samples;
}

/// Points of the graph: role knots at the ends of the spans, index 1 at the object's parameter.
class Points {
public:
    Points(Sketch& sketch, double height) noexcept : sketch_(sketch), height_(height) {}

    void knot(const Curvature& curvature, double t) { add(curvature, t, Role::knots, 6); }
    void parameter(const Curvature& curvature, double t) {
        if (add(curvature, t, Role::comb, 9)) made_->index = 1;
    }

private:
    bool add(const Curvature& curvature, double t, Role role, float width) {
        const double value = curvature.at(t);
        if (std::abs(value) > height_ * (1 + 1e-9)) return false;
        made_ = &sketch_.add(role, Kind::points, width, Pane::curvature);
        append(*made_, Vec3(t, value, 0));
        return true;
    }

    Sketch& sketch_;
    double height_;
    Shape* made_ = nullptr;
};

void drawPoints(Sketch& sketch, const Curve& curve, const std::vector<Interval>& pieces,
                const std::vector<Curvature>& curvatures, double height) {
    Points points(sketch, height);
    const bool knots = curve.as<BsplineCurve>() != nullptr || curve.as<BlendingCurve>() != nullptr;
    const std::vector<double> breaks = breakParameters(curve, domain(curve));
    const auto isKnot = [&](double at) {
        return std::binary_search(breaks.begin(), breaks.end(), at);
    };
    const double t = sketch.parameterOn(curve);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const bool last = i + 1 == pieces.size();
        const Interval& piece = pieces[i];
        if (knots && (i == 0 || isKnot(piece.start))) points.knot(curvatures[i], piece.start);
        if (knots && (last || isKnot(piece.end))) points.knot(curvatures[i], piece.end);
        const bool holds = piece.contains(t) && (t < piece.end || last);
        if (holds) points.parameter(curvatures[i], t);
    }
}

}  // namespace

void drawCurvature(Sketch& sketch, const Curve& curve) {
    const std::vector<Interval> pieces = smoothPieces(curve);
    if (pieces.size() > mostPieces) return;
    const std::size_t each = std::clamp(wantedSamples / pieces.size(), leastOfPiece, mostOfPiece);
    std::vector<Curvature> curvatures;
    std::vector<std::vector<Sample>> coarse;
    std::vector<double> sizes;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        curvatures.emplace_back(curve, pieces[i]);
        coarse.push_back(samplesOf(curvatures.back(), pieces[i], i, each));
        for (const Sample& sample : coarse.back()) sizes.push_back(std::abs(sample.value));
    }
    const Height height = heightOf(std::move(sizes), sizeOf(curve));
    Refinement refinement(curvatures, height);
    for (const std::vector<Sample>& samples : coarse) refinement.add(samples);
    Graph graph(curvatures, height);
    graph.trace(refinement.take());
    graph.draw(sketch);
    drawPoints(sketch, curve, pieces, curvatures, height.most);
}

}  // namespace knotwork::drawing
