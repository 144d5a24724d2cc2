#include "geometry/line_crossings.hpp"

#include "geometry/bezier_piece.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <span>

namespace knotwork {

namespace {

constexpr int mostHalvings = 52;   // then the ends of a piece are neighbouring numbers
constexpr int bisections = 60;

/// Distances from the line, and which of them count.
class Ruler {
public:
    Ruler(const PlaneLine& line, std::span<const Vec3> points) noexcept : point_(line.point) {
        const double length = std::hypot(line.direction.x, line.direction.y);
        normal_ = Vec3(-line.direction.y, line.direction.x, 0) / length;
        double farthest = 0;
        for (const Vec3& p : points) {
            farthest = std::max(farthest, std::hypot(p.x - point_.x, p.y - point_.y));
        }
        tolerance_ = lineTolerance * farthest;
    }

    [[nodiscard]] double distance(const Vec3& p) const noexcept {
        return glm::dot(normal_, p - point_);
    }
    /// 1 to the left of the line, −1 to the right, 0 on it.
    [[nodiscard]] int side(const Vec3& p) const noexcept { return signOf(distance(p), 1); }
    /// The same of the distance h/w.
    [[nodiscard]] int signOf(double h, double w) const noexcept {
        return h > tolerance_ * w ? 1 : h < -tolerance_ * w ? -1 : 0;
    }

private:
    Vec3 point_;
    Vec3 normal_{0.0};
    double tolerance_ = 0;
};

// --- polygons ---------------------------------------------------------------------------------

struct Vertex {
    std::size_t index = 0;
    int side = 0;
};

std::vector<Vertex> verticesAside(std::span<const Vec3> points, const Ruler& ruler) {
    std::vector<Vertex> found;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const int side = ruler.side(points[i]);
        if (side != 0) found.push_back({i, side});
    }
    return found;
}

/// Where one leg of a polygon is crossed: the leg that begins at `from`, or what lies on the line
/// between two vertices that do not.
struct LegCrossing {
    std::size_t leg = 0;
    double part = 0;  ///< of the leg, from 0 to 1
};

/// Between two vertices on opposite sides, of which the second may be past the end of the list.
LegCrossing between(std::span<const Vec3> points, const Ruler& ruler, std::size_t first,
                    std::size_t last) noexcept {
    const std::size_t n = points.size();
    if (last - first > 1) return {(first + last) / 2 % n, (first + last) % 2 == 0 ? 0.0 : 0.5};
    const double a = ruler.distance(points[first % n]);
    const double b = ruler.distance(points[last % n]);
    return {first % n, a / (a - b)};
}

std::vector<LegCrossing> polygonCrossings(std::span<const Vec3> points, bool closed,
                                          const Ruler& ruler) {
    const std::vector<Vertex> aside = verticesAside(points, ruler);
    std::vector<LegCrossing> found;
    for (std::size_t k = 0; k + 1 < aside.size(); ++k) {
        if (aside[k].side == aside[k + 1].side) continue;
        found.push_back(between(points, ruler, aside[k].index, aside[k + 1].index));
    }
    if (closed && aside.size() > 1 && aside.front().side != aside.back().side) {
        found.push_back(between(points, ruler, aside.back().index,
                                aside.front().index + points.size()));
    }
    return found;
}

Vec3 pointOn(std::span<const Vec3> points, const LegCrossing& at) noexcept {
    const Vec3& from = points[at.leg];
    return from + at.part * (points[(at.leg + 1) % points.size()] - from);
}

std::vector<Vec3> pointsOn(std::span<const Vec3> points, const std::vector<LegCrossing>& all) {
    std::vector<Vec3> found;
    for (const LegCrossing& one : all) found.push_back(pointOn(points, one));
    return found;
}

// --- splines ----------------------------------------------------------------------------------

/// f = h/w over an interval by the coefficients of both.
struct Piece {
    Interval interval;
    std::vector<double> h;
    std::vector<double> w;
};

Piece pieceOf(const BezierPiece& bezier, const Ruler& ruler) {
    Piece piece{bezier.interval, {}, {}};
    for (const Homogeneous& point : bezier.points) {
        piece.h.push_back(point.w * ruler.distance(Vec3(point) / point.w));
        piece.w.push_back(point.w);
    }
    return piece;
}

/// The left half of de Casteljau's triangle in the middle; what is left in `c` is the right half.
std::vector<double> halve(std::vector<double>& c) {
    std::vector<double> left{c.front()};
    for (std::size_t last = c.size() - 1; last > 0; --last) {
        for (std::size_t j = 0; j < last; ++j) c[j] = (c[j] + c[j + 1]) / 2;
        left.push_back(c.front());
    }
    return left;
}

/// A parameter at which the curve is on one side of the line.
struct Sighting {
    double t = 0;
    int side = 0;
};

/// Sightings in ascending order, between any two of which the curve crosses the line at most once.
class Isolation {
public:
    explicit Isolation(const Ruler& ruler) noexcept : ruler_(ruler) {}

    void add(Piece piece, int halvings = mostHalvings) {
        const int first = ruler_.signOf(piece.h.front(), piece.w.front());
        const int last = ruler_.signOf(piece.h.back(), piece.w.back());
        if (isDecided(piece, first, last) || halvings == 0) {
            see(piece.interval.start, first);
            see(piece.interval.end, last);
            return;
        }
        const double middle = (piece.interval.start + piece.interval.end) / 2;
        Piece left{{piece.interval.start, middle}, halve(piece.h), halve(piece.w)};
        piece.interval.start = middle;
        add(std::move(left), halvings - 1);
        add(std::move(piece), halvings - 1);
    }

    [[nodiscard]] std::vector<Sighting> take() { return std::move(seen_); }

private:
    /// Whether the ends of a piece tell all about it.
    [[nodiscard]] bool isDecided(const Piece& piece, int first, int last) const noexcept {
        int changes = 0;
        int former = 0;
        for (std::size_t i = 0; i < piece.h.size(); ++i) {
            const int sign = ruler_.signOf(piece.h[i], piece.w[i]);
            if (sign == 0) continue;
            if (former != 0 && sign != former) ++changes;
            former = sign;
        }
        if (former == 0) return true;                                  // along the line
        if (changes == 0) return first != 0 || last != 0;              // on one side
        return changes == 1 && first != 0 && last != 0;                // across it once
    }

    void see(double t, int side) {
        if (side != 0) seen_.push_back({t, side});
    }

    const Ruler& ruler_;
    std::vector<Sighting> seen_;
};

/// Where f changes its sign between two sightings on opposite sides.
Crossing crossingBetween(const Curve& curve, const Ruler& ruler, const Sighting& from,
                         const Sighting& to) noexcept {
    double a = from.t;
    double b = to.t;
    for (int step = 0; step < bisections; ++step) {
        const double middle = (a + b) / 2;
        if (!(a < middle && middle < b)) break;
        const double distance = ruler.distance(pointAt(curve, middle));
        (distance * from.side > 0 ? a : b) = middle;
    }
    return {b, pointAt(curve, b)};
}

/// The crossings of one run of sightings without a gap.
void addCrossings(std::vector<Crossing>& all, const Curve& curve, const Ruler& ruler,
                  const std::vector<Sighting>& seen) {
    for (std::size_t k = 0; k + 1 < seen.size(); ++k) {
        if (seen[k].side == seen[k + 1].side) continue;
        all.push_back(crossingBetween(curve, ruler, seen[k], seen[k + 1]));
    }
}

struct Run {
    std::vector<Sighting> seen;
};

/// A closed curve goes on where it began: what is seen first is seen once more after the end.
void joinSeam(std::vector<Run>& runs, const Interval& domain) {
    if (runs.empty()) return;
    Run& last = runs.back();
    for (const Sighting& sighting : runs.front().seen) {
        last.seen.push_back({sighting.t + domain.length(), sighting.side});
        break;
    }
}

std::vector<Crossing> splineCrossings(const Curve& curve, const std::vector<BezierPiece>& pieces,
                                      const std::vector<bool>& gapBefore, bool seam,
                                      const Ruler& ruler) {
    std::vector<Run> runs;
    for (std::size_t i = 0; i < pieces.size();) {
        Isolation isolation(ruler);
        do {
            isolation.add(pieceOf(pieces[i], ruler));
            ++i;
        } while (i < pieces.size() && !gapBefore[i]);
        runs.push_back({isolation.take()});
    }
    if (seam) joinSeam(runs, domain(curve));
    std::vector<Crossing> all;
    for (const Run& run : runs) addCrossings(all, curve, ruler, run.seen);
    const Interval whole = domain(curve);
    for (Crossing& crossing : all) {
        if (crossing.t > whole.end) crossing.t -= whole.length();
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const Crossing& a, const Crossing& b) { return a.t < b.t; });
    return all;
}

LineCrossings ofSpline(const Curve& curve, const BsplineCurve& spline, const PlaneLine& line) {
    const Ruler ruler(line, spline.points());
    const std::vector<BezierPiece> pieces = bezierPieces(spline);
    const KnotVector& knots = spline.knotVector();
    std::vector<bool> gapBefore;
    for (const BezierPiece& piece : pieces) {
        gapBefore.push_back(knots.multiplicity(piece.interval.start) > knots.degree());
    }
    const bool seam = spline.closed() && !gapBefore.front();
    return {splineCrossings(curve, pieces, gapBefore, seam, ruler),
            pointsOn(spline.points(), polygonCrossings(spline.points(), spline.closed(), ruler))};
}

LineCrossings ofBezier(const Curve& curve, const BezierCurve& bezier, const PlaneLine& line) {
    const Ruler ruler(line, bezier.points());
    BezierPiece piece{bezier.domain(), {}};
    for (std::size_t i = 0; i < bezier.points().size(); ++i) {
        const double w = bezier.rational() ? bezier.weights()[i] : 1;
        piece.points.emplace_back(w * bezier.points()[i], w);
    }
    return {splineCrossings(curve, {piece}, {false}, false, ruler),
            pointsOn(bezier.points(), polygonCrossings(bezier.points(), false, ruler))};
}

/// The curve is a polyline itself, of which an open one shows only the part in its domain.
LineCrossings ofSubdivision(const SubdivisionCurve& curve, const PlaneLine& line) {
    const CurveSubdivision& made = curve.subdivision();
    const Ruler ruler(line, made.points);
    std::vector<double> parameters(curve.breaks().begin(), curve.breaks().end());
    const Interval domain = curve.domain();
    for (const double end : {domain.start, domain.end}) {
        if (std::find(parameters.begin(), parameters.end(), end) == parameters.end()) {
            parameters.push_back(end);
        }
    }
    std::sort(parameters.begin(), parameters.end());
    std::vector<Vec3> points(parameters.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Side side = parameters[i] == domain.end ? Side::left : Side::right;
        curve.evaluate(parameters[i], side, std::span(&points[i], 1));
    }
    // A closed one has come back to its first point, which is not to be counted twice.
    if (curve.closed()) points.pop_back();
    LineCrossings crossings;
    for (const LegCrossing& at : polygonCrossings(points, curve.closed(), ruler)) {
        const double from = parameters[at.leg];
        const double to = parameters[at.leg + 1];
        crossings.curve.push_back({from + at.part * (to - from), pointOn(points, at)});
    }
    crossings.polygon = pointsOn(made.points, polygonCrossings(made.points, made.closed, ruler));
    return crossings;
}

}  // namespace

std::optional<LineCrossings> lineCrossings(const Curve& curve, const PlaneLine& line) {
    if (const auto* spline = curve.as<BsplineCurve>()) return ofSpline(curve, *spline, line);
    if (const auto* bezier = curve.as<BezierCurve>()) return ofBezier(curve, *bezier, line);
    if (const auto* made = curve.as<SubdivisionCurve>()) return ofSubdivision(*made, line);
    return std::nullopt;
}

}  // namespace knotwork
