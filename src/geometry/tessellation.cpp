#include "geometry/tessellation.hpp"

#include "geometry/smooth_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

namespace knotwork {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
/// What chords may use up of the tolerance; the rest is for points that are taken for one.
constexpr double share = 0.98;
/// Points closer than this share of the tolerance are taken for one.
constexpr double sameShare = 0.01;
/// A stretch is divided evenly when its bound asks for at most this times as many chords as its
/// curvature does (and one more).
constexpr double tight = 1.25;

/// Where a stretch is looked at once more before it is accepted: a flat end of a B-function says
/// nothing about the steep part beside it.
constexpr double secondLooks[] = {1.0 / 16, 15.0 / 16};

/// Derivatives up to the fifth at one parameter.
struct Probe {
    double t;
    std::array<Vec3, 6> rows;
};

Probe probe(const Curve& curve, double t, Side side) noexcept {
    Probe made{t, {}};
    evaluate(curve, t, side, made.rows);
    return made;
}

/// Σ terms[k] r^k/k!, the last once more for what comes after it.
double majorant(const std::array<double, 4>& terms, double r) noexcept {
    const double last = terms[3] * r * r * r / 6;
    return terms[0] + r * (terms[1] + r / 2 * terms[2]) + 2 * last;
}

/// Bounds on the curve within `r` of a probe: of |C″|, of |C′ × C″| and of |C″(t) × C‴(u)|, and
/// the least |C′|.
struct Bounds {
    double bend = 0;
    double turn = 0;
    double twist = 0;
    double speed = std::numeric_limits<double>::infinity();

    void add(const Probe& at, double r) noexcept {
        const auto& c = at.rows;
        const auto size = [](const Vec3& v) { return glm::length(v); };
        const auto area = [](const Vec3& a, const Vec3& b) { return glm::length(glm::cross(a, b)); };
        const double bends = majorant({size(c[2]), size(c[3]), size(c[4]), size(c[5])}, r);
        bend = larger(bend, bends);
        turn = larger(turn, majorant({area(c[1], c[2]), area(c[1], c[3]),
                                      area(c[2], c[3]) + area(c[1], c[4]),
                                      2 * area(c[2], c[4]) + area(c[1], c[5])}, r));
        twist = larger(twist, majorant({area(c[2], c[3]), 5 * area(c[2], c[4]),
                                        area(c[3], c[4]) + area(c[2], c[5]), area(c[3], c[5])}, r));
        speed = std::min(speed, size(c[1]) - r * bends);
    }
    /// Where C″ differs between two probes by more than their C‴ allows, there is a place near them
    /// at which the curve is less smooth than its pieces promise, and C″ may be larger by that much.
    void distrust(const Probe& a, const Probe& b, double r) noexcept {
        double allowed = 0;
        double allowedSlope = 0;
        for (const Probe* at : {&a, &b}) {
            const auto& c = at->rows;
            const std::array<double, 4> bends{glm::length(c[2]), glm::length(c[3]),
                                              glm::length(c[4]), glm::length(c[5])};
            allowed += r * majorant({bends[1], bends[2], bends[3], 0}, r);
            allowedSlope += r * majorant(bends, r);
        }
        if (hasCorner(a, b, r, allowedSlope)) bend = std::numeric_limits<double>::infinity();
        const double excess = 2 * (glm::length(b.rows[2] - a.rows[2]) - allowed);
        if (!(excess > 0)) return;
        bend += excess;
        turn += excess * std::max(glm::length(a.rows[1]), glm::length(b.rows[1]));
    }
    /// Whether the curve has another direction, or another place, at the second probe than C″ can
    /// lead it to: a corner between them, which nothing bounds.
    static bool hasCorner(const Probe& a, const Probe& b, double r, double allowed) noexcept {
        const Vec3 slopes = a.rows[1] + b.rows[1];
        const double rounding = 1e-12 * glm::length(slopes) +
                                8 * epsilon * (glm::length(a.rows[0]) + glm::length(b.rows[0])) / r;
        if (glm::length(b.rows[1] - a.rows[1]) > allowed + rounding) return true;
        return glm::length(b.rows[0] - a.rows[0] - r * slopes) > r * (allowed + rounding);
    }
    /// Not finite as soon as one of them is not.
    static double larger(double a, double b) noexcept {
        return std::isfinite(b) ? std::max(a, b) : std::numeric_limits<double>::infinity();
    }
};

/// A part of a smooth piece with probes at its ends and its middle.
struct Stretch {
    Probe start;
    Probe middle;
    Probe end;

    [[nodiscard]] double length() const noexcept { return end.t - start.t; }
    [[nodiscard]] bool divisible() const noexcept {
        return length() > 8 * epsilon * std::max(std::abs(start.t), std::abs(end.t)) &&
               length() > 1e-300;
    }
};

/// The bound on the deviation of chords over parameters of length h; see the header. The direction
/// of the chord is within the turn θ of every tangent, hence the cosine, and C′ at one place of the
/// chord differs from that at another across C″ by at most h² |C″ × C‴|.
double deviation(const Bounds& on, double h) noexcept {
    const double anyway = on.bend * h * h / 8;
    if (!(on.speed > 0)) return anyway;
    const double theta = h * on.turn / (on.speed * on.speed);
    if (!(theta < 1)) return anyway;
    return std::min(anyway, h * h / 8 * (on.turn + h * h * on.twist) / (on.speed * std::cos(theta)));
}

/// How many chords the curvature asks for: H √(κ|C′|²/8ε), by Simpson's rule.
double wanted(const Stretch& on, double tolerance) noexcept {
    const auto density = [&](const Probe& at) {
        const double speed = glm::length(at.rows[1]);
        const double turn = glm::length(glm::cross(at.rows[1], at.rows[2]));
        return speed > 0 ? std::sqrt(turn / speed / (8 * tolerance)) : 0;
    };
    return on.length() * (density(on.start) + 4 * density(on.middle) + density(on.end)) / 6;
}

Bounds boundsOf(const Stretch& on) noexcept {
    Bounds bounds;
    const double r = on.length() / 4;
    for (const Probe* at : {&on.start, &on.middle, &on.end}) bounds.add(*at, r);
    bounds.distrust(on.start, on.middle, r);
    bounds.distrust(on.middle, on.end, r);
    return bounds;
}

/// The least number of equal chords that the bounds allow; infinite where there are none.
double needed(const Stretch& on, const Bounds& bounds, double tolerance) noexcept {
    constexpr double none = std::numeric_limits<double>::infinity();
    if (!std::isfinite(bounds.bend)) return none;
    double most = std::ceil(on.length() * std::sqrt(bounds.bend / (8 * tolerance)));
    if (!(most > 1)) return 1;
    if (!(bounds.speed > 0)) return most;
    double count = std::ceil(on.length() * std::sqrt(bounds.turn / bounds.speed / (8 * tolerance)));
    count = std::max(count, 1.0);
    while (count < most && !(deviation(bounds, on.length() / count) <= tolerance)) {
        count = std::max(count + 1, std::floor(count * 1.02));
    }
    return std::min(count, most);
}

/// Where nothing bounds the curve (a derivative is infinite), its points must be all but one, or
/// none at all.
bool isPoint(const Stretch& on, double tolerance) noexcept {
    if (!isFinite(on.middle.rows[0])) return true;
    return glm::length(on.middle.rows[0] - on.start.rows[0]) <= tolerance / 4 &&
           glm::length(on.end.rows[0] - on.middle.rows[0]) <= tolerance / 4;
}

/// An interval that is divided into so many chords of equal parameters.
struct Chords {
    double start;
    double end;
    std::size_t count;
    bool beginsPiece;
    bool endsPiece;
};

class Planner {
public:
    Planner(const Curve& curve, double tolerance, std::size_t most)
        : curve_(curve), tolerance_(share * tolerance), most_(most),
          looksTwice_(!isPiecewiseRational(curve)) {}

    /// False when it takes too many points.
    bool piece(const Interval& over) {
        open_.clear();
        open_.push_back(between(probe(curve_, over.start, Side::right),
                                probe(curve_, over.end, Side::left)));
        bool begins = true;
        while (!open_.empty()) {
            const Stretch top = open_.back();
            open_.pop_back();
            const double count = chordsOf(top);
            if (count > static_cast<double>(most_ - total_)) return false;
            if (count == 0) {
                open_.push_back(between(top.middle, top.end));
                open_.push_back(between(top.start, top.middle));
                continue;
            }
            plan_.push_back({top.start.t, top.end.t, static_cast<std::size_t>(count), begins,
                             open_.empty()});
            total_ += static_cast<std::size_t>(count);
            begins = false;
        }
        return true;
    }

    [[nodiscard]] const std::vector<Chords>& plan() const noexcept { return plan_; }
    [[nodiscard]] std::size_t total() const noexcept { return total_; }

private:
    [[nodiscard]] Stretch between(const Probe& a, const Probe& b) const noexcept {
        return {a, probe(curve_, a.t + (b.t - a.t) / 2, Side::right), b};
    }

    /// How many chords, or 0 for a stretch that is to be halved.
    [[nodiscard]] double chordsOf(const Stretch& on) const noexcept {
        if (!on.divisible()) return 1;
        const Bounds bounds = boundsOf(on);
        const double count = needed(on, bounds, tolerance_);
        if (!std::isfinite(count)) return isPoint(on, tolerance_) ? 1 : 0;
        if (count > 1 && count > tight * wanted(on, tolerance_) + 1) return 0;
        return looksTwice_ && !holds(bounds, on, count) ? 0 : count;
    }

    /// Whether the bounds hold, as far as they matter, also in other places than the three.
    [[nodiscard]] bool holds(const Bounds& bounds, const Stretch& on, double count) const noexcept {
        const double h = on.length() / count;
        for (const double place : secondLooks) {
            std::array<Vec3, 3> rows;
            evaluate(curve_, on.start.t + place * on.length(), Side::right, rows);
            const double bend = glm::length(rows[2]);
            if (bend * h * h / 8 <= tolerance_) continue;
            const double turn = glm::length(glm::cross(rows[1], rows[2]));
            if (!(bend <= bounds.bend && turn <= bounds.turn)) return false;
        }
        return true;
    }

    const Curve& curve_;
    double tolerance_;
    std::size_t most_;
    bool looksTwice_;
    std::size_t total_ = 0;
    std::vector<Chords> plan_;
    std::vector<Stretch> open_;
};

/// Makes the points of a plan.
class Writer {
public:
    Writer(const Curve& curve, double tolerance, std::size_t points)
        : curve_(curve), sampler_(curve), tolerance_(tolerance) {
        line_.parameters.reserve(points);
        line_.xyz.reserve(3 * points);
    }

    void chords(const Chords& on) {
        if (on.beginsPiece) end(on.start, Side::right);
        std::array<double, blockSize> ts{};
        const Interval over{on.start, on.end};
        const std::size_t inner = on.endsPiece ? on.count - 1 : on.count;
        for (std::size_t done = 0; done < inner; done += blockSize) {
            const std::size_t part = std::min(blockSize, inner - done);
            for (std::size_t i = 0; i < part; ++i) {
                ts[i] = uniformParameter(over, done + i + 1, on.count + 1);
            }
            inside({ts.data(), part});
        }
        if (on.endsPiece) end(on.end, Side::left);
    }

    [[nodiscard]] Polyline take() { return std::move(line_); }

private:
    static constexpr std::size_t blockSize = 256;

    void inside(std::span<const double> ts) {
        const std::size_t before = line_.xyz.size();
        line_.parameters.insert(line_.parameters.end(), ts.begin(), ts.end());
        line_.xyz.resize(before + 3 * ts.size());
        sampler_.at(ts, 0, std::span(line_.xyz).subspan(before));
    }

    /// The end of a piece. Where the curve does not jump, it is also the beginning of the next one.
    void end(double t, Side side) {
        Vec3 point;
        evaluate(curve_, t, side, {&point, 1});
        if (!line_.parameters.empty() && line_.parameters.back() == t) {
            const double* last = line_.xyz.data() + line_.xyz.size() - 3;
            const double rounding = 8 * epsilon * glm::length(point);
            const double jump = glm::length(Vec3(last[0], last[1], last[2]) - point);
            if (jump <= std::max(sameShare * tolerance_, rounding)) return;
        }
        line_.parameters.push_back(t);
        line_.xyz.insert(line_.xyz.end(), {point.x, point.y, point.z});
    }

    const Curve& curve_;
    CurveSampler sampler_;
    double tolerance_;
    Polyline line_;
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

// What things weigh, in tenths of a microsecond.
constexpr double pieceWeight = 100;  // its bounds
constexpr double chordWeight = 5;

Error tooManyPoints(double tolerance) {
    return refuse(Code::tooLarge, "tolerance",
                  "A tolerance of " + formatNumber(tolerance) + " takes more than " +
                      std::to_string(mostPolylinePoints) +
                      " points on this curve; give a larger one.");
}

/// A polyline on its way. The loops keep it.
class Maker {
public:
    Maker(SlicedWork& work, const Curve& curve, double tolerance,
          std::function<void(Result<Polyline>)> done)
        : work_(work), curve_(curve), tolerance_(tolerance), done_(std::move(done)),
          pieces_(smoothPieces(curve_, domain(curve_))),
          planner_(curve_, tolerance, std::max(mostPolylinePoints, 2 * pieces_.size())) {}

    static void plan(const std::shared_ptr<Maker>& self) {
        const std::size_t count = self->pieces_.size();
        self->work_.loop(count, pieceWeight * static_cast<double>(count),
                         [self](std::size_t first, std::size_t last) {
                             for (std::size_t i = first; i < last && !self->tooMany_; ++i) {
                                 self->tooMany_ = !self->planner_.piece(self->pieces_[i]);
                             }
                         });
        self->work_.step(pieceWeight * static_cast<double>(count), [self] { self->write(self); });
    }

private:
    void write(const std::shared_ptr<Maker>& self) {
        if (tooMany_) return done_(tooManyPoints(tolerance_));
        writer_.emplace(curve_, tolerance_, planner_.total() + pieces_.size() + 1);
        const auto& chords = planner_.plan();
        work_.loop(chords.size(), chordWeight * static_cast<double>(planner_.total()),
                   [self, &chords](std::size_t first, std::size_t last) {
                       for (std::size_t i = first; i < last; ++i) self->writer_->chords(chords[i]);
                   });
        work_.step(0, [self] { self->done_(self->writer_->take()); });
    }

    SlicedWork& work_;
    Curve curve_;
    double tolerance_;
    std::function<void(Result<Polyline>)> done_;
    std::vector<Interval> pieces_;
    Planner planner_;
    bool tooMany_ = false;
    std::optional<Writer> writer_;
};

/// The same at once, for pictures that are made many times a second.
std::optional<Polyline> withAtMost(const Curve& curve, const Interval& part, double tolerance,
                                   std::size_t most) {
    if (curve.as<SubdivisionCurve>() != nullptr) return corners(curve, part);
    const std::vector<Interval> pieces = smoothPieces(curve, part);
    Planner planner(curve, tolerance, std::max(most, 2 * pieces.size()));
    for (const Interval& piece : pieces) {
        if (!planner.piece(piece)) return std::nullopt;
    }
    Writer writer(curve, tolerance, planner.total() + pieces.size() + 1);
    for (const Chords& chords : planner.plan()) writer.chords(chords);
    return writer.take();
}

}  // namespace

Result<Polyline> polylineWithin(const Curve& curve, double tolerance) {
    auto line = withAtMost(curve, domain(curve), tolerance, mostPolylinePoints);
    if (line) return *std::move(line);
    return tooManyPoints(tolerance);
}

void planPolyline(SlicedWork& work, const Curve& curve, double tolerance,
                  std::function<void(Result<Polyline>)> done) {
    if (curve.as<SubdivisionCurve>() != nullptr) return done(corners(curve, domain(curve)));
    Maker::plan(std::make_shared<Maker>(work, curve, tolerance, std::move(done)));
}

Polyline polyline(const Curve& curve, double tolerance) {
    return polyline(curve, domain(curve), tolerance);
}

Polyline polyline(const Curve& curve, const Interval& part, double tolerance) {
    for (;; tolerance *= 4) {  // half as many points
        if (auto line = withAtMost(curve, part, tolerance, mostDrawnPoints)) {
            return *std::move(line);
        }
    }
}

}  // namespace knotwork
