#include "geometry/surface_tessellation.hpp"

#include "geometry/grid_line.hpp"
#include "geometry/surface_differential.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace knotwork {

namespace {

using Key = std::pair<double, double>;

constexpr int taylorOrder = 6;
/// A closed direction begins with so many cells, so that no triangle spans the whole of it.
constexpr std::size_t leastAround = 4;
/// So many cells will not do, however roughly they are counted.
constexpr double hopeless = 100.0 * static_cast<double>(mostTriangleVertices);

struct Bends {
    double uu = 0;
    double uv = 0;
    double vv = 0;

    void raise(const Bends& other) noexcept {
        uu = std::max(uu, other.uu);
        uv = std::max(uv, other.uv);
        vv = std::max(vv, other.vv);
    }
};

/// max|Suu| h_u², max|Suv| h_u h_v and max|Svv| h_v² over a cell.
Bends bendsAtCentre(const Surface& surface, const Rectangle& cell) noexcept {
    constexpr SurfaceOrders orders{taylorOrder, taylorOrder};
    std::array<Vec3, orders.size()> rows;
    const double halfU = cell.u.length() / 2;
    const double halfV = cell.v.length() / 2;
    derivativesWithin(surface, {cell.u.start + halfU, cell.v.start + halfV}, taylorOrder, rows);
    Bends bends;
    double factorU = 1;  // half^a / a!, over the whole of S
    for (std::size_t a = 0; a <= taylorOrder; ++a) {
        if (a > 0) factorU *= halfU / static_cast<double>(a);
        double factor = factorU;
        for (std::size_t b = 0; a + b <= taylorOrder; ++b) {
            if (b > 0) factor *= halfV / static_cast<double>(b);
            const double term = factor * glm::length(rows[orders.at(a, b)]);
            bends.uu += 4 * static_cast<double>(a) * (static_cast<double>(a) - 1) * term;
            bends.uv += 4 * static_cast<double>(a * b) * term;
            bends.vv += 4 * static_cast<double>(b) * (static_cast<double>(b) - 1) * term;
        }
    }
    return bends;
}

Bends bendsInCorner(const Surface& surface, const Rectangle& cell, bool endU, bool endV) noexcept {
    constexpr SurfaceOrders orders{2, 2};
    std::array<Vec3, orders.size()> rows;
    const SurfacePlace at{endU ? cell.u.end : cell.u.start, endV ? cell.v.end : cell.v.start,
                          endU ? Side::left : Side::right, endV ? Side::left : Side::right};
    derivativesWithin(surface, at, 2, rows);
    const double u = cell.u.length();
    const double v = cell.v.length();
    return {u * u * glm::length(rows[orders.at(2, 0)]), u * v * glm::length(rows[orders.at(1, 1)]),
            v * v * glm::length(rows[orders.at(0, 2)])};
}

double errorOf(const Bends& bends) noexcept { return (bends.uu + 2 * bends.uv + bends.vv) / 8; }

/// Those of a cell that the centre already finds too large are not looked at any closer.
Bends bendsBetweenKnots(const Surface& surface, const Rectangle& cell, double tolerance) noexcept {
    Bends bends = bendsAtCentre(surface, cell);
    if (errorOf(bends) > tolerance) return bends;
    for (const bool endU : {false, true}) {
        for (const bool endV : {false, true}) {
            bends.raise(bendsInCorner(surface, cell, endU, endV));
        }
    }
    return bends;
}

bool crossed(const Surface& surface, const Rectangle& cell) noexcept {
    const auto* triangle = surface.as<BlendingTriangle>();
    return triangle != nullptr && triangle->crossed(cell);
}

/// What the slopes in the corners of a cell tell that knots run across, beyond which its centre does
/// not see. Over h, J of slope takes a second derivative of J/h somewhere; a crease in the middle is
/// J h/4 away from the straight line, as far as one of 2J/h.
Bends slopesAcross(const Surface& surface, const Rectangle& cell) noexcept {
    constexpr SurfaceOrders orders{1, 1};
    std::array<std::array<Vec3, orders.size()>, 4> rows;
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const bool endU = corner >= 2;
        const bool endV = corner % 2 == 1;
        const SurfacePlace at{endU ? cell.u.end : cell.u.start, endV ? cell.v.end : cell.v.start,
                              endU ? Side::left : Side::right, endV ? Side::left : Side::right};
        derivativesWithin(surface, at, 1, rows[corner]);
    }
    const auto jump = [&](std::size_t from, std::size_t to, std::size_t a, std::size_t b) {
        return 2 * glm::length(rows[to][orders.at(a, b)] - rows[from][orders.at(a, b)]);
    };
    const double u = cell.u.length();
    const double v = cell.v.length();
    return {u * std::max(jump(0, 2, 1, 0), jump(1, 3, 1, 0)),
            std::max({u * jump(0, 1, 1, 0), u * jump(2, 3, 1, 0), v * jump(0, 2, 0, 1),
                      v * jump(1, 3, 0, 1)}),
            v * std::max(jump(0, 1, 0, 1), jump(2, 3, 0, 1))};
}

Bends bendsOf(const Surface& surface, const Rectangle& cell, double tolerance) noexcept {
    Bends bends = bendsBetweenKnots(surface, cell, tolerance);
    if (errorOf(bends) <= tolerance && crossed(surface, cell)) {
        bends.raise(slopesAcross(surface, cell));
    }
    return bends;
}

/// The knots in the domain, its ends included, each once.
std::vector<double> startsOf(const Interval& domain, std::span<const double> knots, bool closed) {
    std::vector<double> starts{domain.start};
    for (const double knot : knots) {
        if (knot > starts.back() && knot < domain.end) starts.push_back(knot);
    }
    starts.push_back(domain.end);
    if (!closed || starts.size() > leastAround) return starts;
    starts.clear();
    for (std::size_t i = 0; i <= leastAround; ++i) {
        starts.push_back(uniformParameter(domain, i, leastAround + 1));
    }
    for (const double knot : knots) {
        if (domain.contains(knot)) starts.push_back(knot);
    }
    std::sort(starts.begin(), starts.end());
    starts.erase(std::unique(starts.begin(), starts.end()), starts.end());
    return starts;
}

Interval firstHalf(const Interval& whole) noexcept {
    return {whole.start, whole.start + whole.length() / 2};
}
Interval secondHalf(const Interval& whole) noexcept {
    return {whole.start + whole.length() / 2, whole.end};
}

bool divisible(const Interval& interval) noexcept {
    const double middle = interval.start + interval.length() / 2;
    return interval.start < middle && middle < interval.end;
}

Error tooMany(double tolerance) {
    return refuse(Code::tooLarge, "tolerance",
                  "Within " + formatNumber(tolerance) +
                      " more than 262144 vertices would be needed; enlarge the tolerance.");
}

/// Halving a direction quarters what it bends: about so many cells will be left of one that bends
/// everywhere as in that of its corners where it bends least.
double expectedCells(const Surface& surface, const Rectangle& cell, double tolerance) noexcept {
    const auto halved = [tolerance](double bend) {
        return std::max(1.0, std::sqrt(bend / (8 * tolerance)));
    };
    double least = std::numeric_limits<double>::infinity();
    for (const bool endU : {false, true}) {
        for (const bool endV : {false, true}) {
            const Bends bends = bendsInCorner(surface, cell, endU, endV);
            least = std::min(least, halved(bends.uu) * halved(bends.vv));
        }
    }
    return least;
}

/// Cells within the tolerance, halved from those between the knots.
class Cells {
public:
    Cells(const Surface& surface, double tolerance)
        : surface_(surface), tolerance_(tolerance), whole_(domain(surface)) {
        const ClosedDirections closed = closedDirections(surface);
        const auto us = startsOf(whole_.u, breaksU(surface), closed.u);
        const auto vs = startsOf(whole_.v, breaksV(surface), closed.v);
        for (std::size_t i = 0; i + 1 < us.size(); ++i) {
            for (std::size_t j = 0; j + 1 < vs.size(); ++j) {
                open_.push_back({{us[i], us[i + 1]}, {vs[j], vs[j + 1]}});
                if (expectedCells(surface, open_.back(), tolerance) > hopeless) {
                    open_.clear();
                    return;
                }
            }
        }
    }

    /// Looks at so many cells at most. Whether there are more to look at.
    bool look(std::size_t count) {
        for (; count > 0 && !open_.empty(); --count) {
            if (open_.size() + done_.size() > mostTriangleVertices) {
                giveUp();
                break;
            }
            const Rectangle cell = open_.back();
            open_.pop_back();
            lookAt(cell);
        }
        return !open_.empty();
    }

    /// Those that were found; none where they are too many.
    [[nodiscard]] const std::vector<Rectangle>& done() const noexcept { return done_; }

private:
    void lookAt(const Rectangle& cell) {
        const Bends bends = bendsOf(surface_, cell, tolerance_);
        const bool alongU = bends.uu != bends.vv ? bends.uu > bends.vv
                                                 : cell.u.length() / whole_.u.length() >=
                                                       cell.v.length() / whole_.v.length();
        if (errorOf(bends) <= tolerance_ || !divisible(alongU ? cell.u : cell.v)) {
            done_.push_back(cell);
        } else if (alongU) {
            open_.push_back({firstHalf(cell.u), cell.v});
            open_.push_back({secondHalf(cell.u), cell.v});
        } else {
            open_.push_back({cell.u, firstHalf(cell.v)});
            open_.push_back({cell.u, secondHalf(cell.v)});
        }
    }
    void giveUp() noexcept {
        open_.clear();
        done_.clear();
    }

    const Surface& surface_;
    double tolerance_;
    Rectangle whole_;
    std::vector<Rectangle> open_;
    std::vector<Rectangle> done_;
};

/// All corners of the cells, each once, by lines of either direction. The end of a closed direction
/// is its start.
class Corners {
public:
    Corners(const Rectangle& whole, ClosedDirections closed, std::span<const Rectangle> cells)
        : whole_(whole), closed_(closed) {
        for (const Rectangle& cell : cells) {
            for (const double u : {cell.u.start, cell.u.end}) {
                for (const double v : {cell.v.start, cell.v.end}) {
                    byU_.push_back(key(u, v));
                }
            }
        }
        sortOnce(byU_);
        for (const Key& corner : byU_) byV_.emplace_back(corner.second, corner.first);
        sortOnce(byV_);
    }

    [[nodiscard]] const std::vector<Key>& all() const noexcept { return byU_; }
    [[nodiscard]] std::uint32_t vertex(double u, double v) const noexcept {
        const auto found = std::lower_bound(byU_.begin(), byU_.end(), key(u, v));
        return static_cast<std::uint32_t>(found - byU_.begin());
    }

    /// The vertices of a cell, counter-clockwise, those of its neighbours on its sides included.
    void polygon(const Rectangle& cell, std::vector<std::uint32_t>& corners) const {
        const auto [u0, u1] = std::pair(cell.u.start, cell.u.end);
        const auto [v0, v1] = std::pair(cell.v.start, cell.v.end);
        corners.clear();
        corners.push_back(vertex(u0, v0));
        for (const Key& on : between(byV_, key(u0, v0).second, cell.u)) {
            corners.push_back(vertex(on.second, v0));
        }
        corners.push_back(vertex(u1, v0));
        for (const Key& on : between(byU_, key(u1, v0).first, cell.v)) {
            corners.push_back(vertex(u1, on.second));
        }
        corners.push_back(vertex(u1, v1));
        const auto top = between(byV_, key(u0, v1).second, cell.u);
        for (std::size_t i = top.size(); i-- > 0;) corners.push_back(vertex(top[i].second, v1));
        corners.push_back(vertex(u0, v1));
        const auto left = between(byU_, key(u0, v0).first, cell.v);
        for (std::size_t i = left.size(); i-- > 0;) corners.push_back(vertex(u0, left[i].second));
    }

private:
    [[nodiscard]] Key key(double u, double v) const noexcept {
        return {closed_.u && u == whole_.u.end ? whole_.u.start : u,
                closed_.v && v == whole_.v.end ? whole_.v.start : v};
    }
    static void sortOnce(std::vector<Key>& keys) {
        std::sort(keys.begin(), keys.end());
        keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    }

    /// What stands on the line strictly inside the interval.
    static std::span<const Key> between(const std::vector<Key>& keys, double line,
                                        const Interval& interval) {
        const auto first = std::upper_bound(keys.begin(), keys.end(), Key{line, interval.start});
        const auto last = std::lower_bound(first, keys.end(), Key{line, interval.end});
        return std::span(keys).subspan(static_cast<std::size_t>(first - keys.begin()),
                                       static_cast<std::size_t>(last - first));
    }

    Rectangle whole_;
    ClosedDirections closed_;
    std::vector<Key> byU_;  // (u, v), ascending: the vertices
    std::vector<Key> byV_;  // (v, u)
};

/// The vertices and triangles as they come.
class Builder {
public:
    explicit Builder(const Surface& surface) : surface_(surface) {}

    std::uint32_t add(double u, double v) {
        const auto number = static_cast<std::uint32_t>(made_.parameters.size() / 2);
        const SurfacePlace at = *placeInDomain(surface_, u, v);
        append(made_.positions, pointAt(surface_, at));
        append(made_.normals, unitNormal(surface_, at));
        made_.parameters.push_back(u);
        made_.parameters.push_back(v);
        return number;
    }

    /// Four corners are two triangles over the shorter diagonal, more a fan about the middle.
    void fill(const Rectangle& cell, std::span<const std::uint32_t> corners) {
        if (corners.size() == 4) {
            const bool first = apart(corners[0], corners[2]) <= apart(corners[1], corners[3]);
            const std::size_t from = first ? 0 : 1;
            triangle(corners[from], corners[from + 1], corners[from + 2]);
            triangle(corners[from], corners[from + 2], corners[(from + 3) % 4]);
            return;
        }
        const std::uint32_t middle = add(cell.u.start + cell.u.length() / 2,
                                         cell.v.start + cell.v.length() / 2);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            triangle(middle, corners[i], corners[(i + 1) % corners.size()]);
        }
    }

    [[nodiscard]] SurfaceTriangles take() { return std::move(made_); }

private:
    static void append(std::vector<double>& list, const Vec3& v) {
        list.insert(list.end(), {v.x, v.y, v.z});
    }
    [[nodiscard]] double apart(std::uint32_t a, std::uint32_t b) const noexcept {
        const double* p = &made_.positions[3 * a];
        const double* q = &made_.positions[3 * b];
        return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        made_.triangles.insert(made_.triangles.end(), {a, b, c});
    }

    const Surface& surface_;
    SurfaceTriangles made_;
};

// What things weigh, in tenths of a microsecond.
constexpr double cellWeight = 40;    // its bounds
constexpr double cornerWeight = 10;  // a point and a normal
constexpr double fillWeight = 5;     // triangles of a cell
constexpr std::size_t cellsAtOnce = 256;
constexpr double usualCells = 4096;  // as long as nothing is known

/// A triangulation on its way. The loops keep it.
class Triangulation {
public:
    Triangulation(SlicedWork& work, const Surface& surface, double tolerance,
                  std::function<void(Result<SurfaceTriangles>)> done)
        : work_(work), surface_(surface), tolerance_(tolerance), done_(std::move(done)),
          cells_(surface_, tolerance), builder_(surface_) {}

    static void plan(const std::shared_ptr<Triangulation>& self) {
        self->work_.step(cellWeight * usualCells, [self] {
            if (self->cells_.look(cellsAtOnce)) return plan(self);
            if (self->cells_.done().empty()) return self->done_(tooMany(self->tolerance_));
            self->planCorners(self);
        });
    }

private:
    void planCorners(const std::shared_ptr<Triangulation>& self) {
        const auto& cells = cells_.done();
        corners_.emplace(domain(surface_), closedDirections(surface_), cells);
        const auto& all = corners_->all();
        const auto loop = [this](std::size_t count, double weight, SlicedWork::Run run) {
            work_.loop(count, weight * static_cast<double>(count), std::move(run));
        };
        loop(all.size(), cornerWeight, [self, &all](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                self->builder_.add(all[i].first, all[i].second);
            }
        });
        loop(cells.size(), fillWeight, [self, &cells](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                self->corners_->polygon(cells[i], self->polygon_);
                self->builder_.fill(cells[i], self->polygon_);
            }
        });
        work_.step(0, [self] { self->done_(self->builder_.take()); });
    }

    SlicedWork& work_;
    Surface surface_;
    double tolerance_;
    std::function<void(Result<SurfaceTriangles>)> done_;
    Cells cells_;
    Builder builder_;
    std::optional<Corners> corners_;
    std::vector<std::uint32_t> polygon_;
};

// ---- Isolines ----------------------------------------------------------------------------------

[[nodiscard]] SurfacePlace placeOn(const Surface& surface, const Isoline& line, double t) {
    return *placeInDomain(surface, line.alongU ? t : line.at, line.alongU ? line.at : t);
}

/// The cell of a part of the line, without extent in the other direction.
Rectangle cellOn(const Isoline& line, const Interval& part) noexcept {
    const Interval point{line.at, line.at};
    return line.alongU ? Rectangle{part, point} : Rectangle{point, part};
}

void append(std::vector<double>& xyz, const Vec3& point) {
    xyz.insert(xyz.end(), {point.x, point.y, point.z});
}

}  // namespace

void planTriangles(SlicedWork& work, const Surface& surface, double tolerance,
                   std::function<void(Result<SurfaceTriangles>)> done) {
    Triangulation::plan(
        std::make_shared<Triangulation>(work, surface, tolerance, std::move(done)));
}

Result<SurfaceTriangles> trianglesWithin(const Surface& surface, double tolerance) {
    SlicedWork work;
    Result<SurfaceTriangles> made = SurfaceTriangles{};
    planTriangles(work, surface, tolerance,
                  [&made](Result<SurfaceTriangles> result) { made = std::move(result); });
    work.finish();
    return made;
}

std::vector<double> isolinePoints(const Surface& surface, const Isoline& line, std::size_t count) {
    const Rectangle whole = domain(surface);
    const ClosedDirections closed = closedDirections(surface);
    const GridLine steps = line.alongU ? GridLine{whole.u, closed.u, count}
                                       : GridLine{whole.v, closed.v, count};
    std::vector<double> xyz;
    xyz.reserve(3 * count);
    for (std::size_t i = 0; i < count; ++i) {
        append(xyz, pointAt(surface, placeOn(surface, line, steps.at(i).parameter)));
    }
    return xyz;
}

Result<std::vector<double>> isolineWithin(const Surface& surface, const Isoline& line,
                                          double tolerance) {
    const Rectangle whole = domain(surface);
    const ClosedDirections closed = closedDirections(surface);
    const auto starts = line.alongU ? startsOf(whole.u, breaksU(surface), closed.u)
                                    : startsOf(whole.v, breaksV(surface), closed.v);
    std::vector<Interval> open;  // the next one last
    for (std::size_t i = starts.size(); i-- > 1;) open.push_back({starts[i - 1], starts[i]});
    std::vector<double> xyz;
    append(xyz, pointAt(surface, placeOn(surface, line, starts.front())));
    while (!open.empty()) {
        if (xyz.size() / 3 + open.size() > mostTriangleVertices) return tooMany(tolerance);
        const Interval part = open.back();
        open.pop_back();
        const Bends bends = bendsOf(surface, cellOn(line, part), tolerance);
        if ((line.alongU ? bends.uu : bends.vv) / 8 <= tolerance || !divisible(part)) {
            append(xyz, pointAt(surface, placeOn(surface, line, part.end)));
        } else {
            open.push_back(secondHalf(part));
            open.push_back(firstHalf(part));
        }
    }
    return xyz;
}

}  // namespace knotwork
