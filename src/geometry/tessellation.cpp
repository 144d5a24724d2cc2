#include "geometry/tessellation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace knotwork {

namespace {

constexpr std::size_t maximumPoints = std::size_t{1} << 17;
/// Every smooth piece begins as this many chords, so that a whole turn is not taken for a point
/// and an inflexion in the middle of a chord not for a straight line.
constexpr int firstChords = 4;
/// A model given by a formula has no knots: it is cut into this many pieces first.
constexpr int formulaPieces = 32;
/// Chords are not halved more often than this: 2⁻²⁴ of a piece is below any picture's resolution.
constexpr int maximumDepth = 24;
/// The error is looked at in three points of a chord only, hence this share of the tolerance.
constexpr double share = 0.9;

/// Where the curve is cut before anything is looked at, the ends of the part included.
std::vector<double> cuts(const Curve& curve, const Interval& part) {
    std::vector<double> breaks = breakParameters(curve, part);
    if (breaks.empty()) {
        for (int i = 1; i < formulaPieces; ++i) {
            breaks.push_back(part.start + part.length() * i / formulaPieces);
        }
    }
    breaks.insert(breaks.begin(), part.start);
    breaks.push_back(part.end);
    return breaks;
}

double distanceToChord(const Vec3& p, const Vec3& a, const Vec3& b) noexcept {
    const Vec3 chord = b - a;
    const double squared = glm::dot(chord, chord);
    if (squared == 0) return glm::length(p - a);
    const double along = std::clamp(glm::dot(p - a, chord) / squared, 0.0, 1.0);
    return glm::length(p - a - along * chord);
}

struct Sample {
    double t;
    Vec3 point;
};

/// A chord with the three points at which its error is looked at.
struct Chord {
    std::array<Sample, 5> at;
    int depth;

    [[nodiscard]] bool within(double tolerance) const noexcept {
        for (std::size_t i = 1; i < 4; ++i) {
            if (!(distanceToChord(at[i].point, at[0].point, at[4].point) <= tolerance)) return false;
        }
        return true;
    }
};

class Refiner {
public:
    Refiner(const Curve& curve, double tolerance) : curve_(curve), tolerance_(share * tolerance) {}

    void piece(double start, double end) {
        for (int i = 0; i < firstChords; ++i) {
            const double a = start + (end - start) * i / firstChords;
            const double b = i + 1 == firstChords ? end
                                                  : start + (end - start) * (i + 1) / firstChords;
            refine(sample(a, Side::right), sample(b, Side::left));
        }
    }

    [[nodiscard]] Polyline take() { return std::move(line_); }

private:
    [[nodiscard]] Sample sample(double t, Side side) const noexcept {
        Sample made{t, {}};
        evaluate(curve_, t, side, {&made.point, 1});
        return made;
    }

    /// The chord from one sample to another, its inner ones half way between those known.
    [[nodiscard]] Chord chord(const Sample& a, const Sample& middle, const Sample& b,
                              int depth) const noexcept {
        return {{a, sample((a.t + middle.t) / 2, Side::right), middle,
                 sample((middle.t + b.t) / 2, Side::right), b},
                depth};
    }

    void refine(const Sample& a, const Sample& b) {
        append(a);
        open_.push_back(chord(a, sample((a.t + b.t) / 2, Side::right), b, 0));
        while (!open_.empty()) {
            const Chord top = open_.back();
            open_.pop_back();
            const bool full = line_.parameters.size() + open_.size() >= maximumPoints;
            if (full || top.depth >= maximumDepth || top.within(tolerance_)) {
                append(top.at[4]);
                continue;
            }
            open_.push_back(chord(top.at[2], top.at[3], top.at[4], top.depth + 1));
            open_.push_back(chord(top.at[0], top.at[1], top.at[2], top.depth + 1));
        }
    }

    /// Where the curve does not jump, the end of one chord is the beginning of the next.
    void append(const Sample& s) {
        if (!line_.parameters.empty() && line_.parameters.back() == s.t) {
            const double* last = line_.xyz.data() + line_.xyz.size() - 3;
            if (glm::length(Vec3(last[0], last[1], last[2]) - s.point) <= tolerance_) return;
        }
        line_.parameters.push_back(s.t);
        line_.xyz.insert(line_.xyz.end(), {s.point.x, s.point.y, s.point.z});
    }

    const Curve& curve_;
    double tolerance_;
    Polyline line_;
    std::vector<Chord> open_;
};

/// A polyline is its own: its ends and its corners, whatever the tolerance.
Polyline corners(const Curve& curve, const Interval& part) {
    Polyline line;
    line.parameters = breakParameters(curve, part);
    line.parameters.insert(line.parameters.begin(), part.start);
    line.parameters.push_back(part.end);
    line.xyz.reserve(3 * line.parameters.size());
    for (const double t : line.parameters) {
        Vec3 point;
        evaluate(curve, t, Side::left, {&point, 1});
        line.xyz.insert(line.xyz.end(), {point.x, point.y, point.z});
    }
    return line;
}

}  // namespace

Polyline polyline(const Curve& curve, double tolerance) {
    return polyline(curve, domain(curve), tolerance);
}

Polyline polyline(const Curve& curve, const Interval& part, double tolerance) {
    if (curve.as<SubdivisionCurve>() != nullptr) return corners(curve, part);
    Refiner refiner(curve, tolerance);
    const std::vector<double> breaks = cuts(curve, part);
    for (std::size_t i = 1; i < breaks.size(); ++i) refiner.piece(breaks[i - 1], breaks[i]);
    return refiner.take();
}

}  // namespace knotwork
