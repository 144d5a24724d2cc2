#include "geometry/blending_triangle.hpp"

#include "geometry/surface.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace knotwork {

namespace {

// Quotients of numbers below this have no digits left: values of B-functions are right to 2e-13.
constexpr double leastMiddle = 1e-9;
/// Triangulations begin with a cell between all breaks: beyond so many a finer grid will do.
constexpr std::size_t mostBreaks = 256;
constexpr std::size_t mostTerms = gradedSize(maxTriangleOrder);

// ---- Places ------------------------------------------------------------------------------------

Barycentric barycentric(double u, double v) noexcept { return {1 - u, u * (1 - v), u * v}; }

/// From which side a coordinate is approached whose Taylor series along the diagonal into the sides
/// of a place begins with these two terms.
Side sideOf(double slope, double bend) noexcept {
    return slope > 0 || (slope == 0 && bend > 0) ? Side::right : Side::left;
}

/// A place of the unit square as one of a patch; the ends to the bit.
double stretched(const Interval& to, double share) noexcept {
    return share == 1 ? to.end : to.start + share * to.length();
}

SurfacePlace placeOn(const Rectangle& whole, const SurfacePlace& at) noexcept {
    const Barycentric coordinates = barycentric(at.u, at.v);
    const double du = at.sideU == Side::left ? -1 : 1;
    const double dv = at.sideV == Side::left ? -1 : 1;
    return {stretched(whole.u, coordinates[1]), stretched(whole.v, coordinates[2]),
            sideOf((1 - at.v) * du - at.u * dv, -du * dv), sideOf(at.v * du + at.u * dv, du * dv)};
}

// ---- Series ------------------------------------------------------------------------------------

/// The series over the unit square of a patch over another rectangle.
void takeSeries(const Surface& patch, const Rectangle& whole, const SurfacePlace& at,
                std::size_t order, std::span<Vec3> terms) noexcept {
    std::array<Vec3, (maxTriangleOrder + 1) * (maxTriangleOrder + 1)> rows;
    const SurfaceOrders orders{static_cast<int>(order), static_cast<int>(order)};
    derivatives(patch, at, orders, rows);
    double factorU = 1;  // length^i / i!
    for (std::size_t i = 0; i <= order; ++i) {
        if (i > 0) factorU *= whole.u.length() / static_cast<double>(i);
        double factor = factorU;
        for (std::size_t j = 0; i + j <= order; ++j) {
            if (j > 0) factor *= whole.v.length() / static_cast<double>(j);
            terms[gradedAt(i, j)] = factor * rows[orders.at(i, j)];
        }
    }
}

/// A series in x and y at (u (1 − v), uv) as one in u and v: first by p = x + y, of which u is the
/// value, and q = y, then by q = uv; each by Horner's rule. `between` is as long as `terms`.
void collapse(double u, double v, std::size_t order, std::span<Vec3> terms,
              std::span<Vec3> between) noexcept {
    std::fill(between.begin(), between.end(), Vec3(0));
    for (std::size_t i = order + 1; i-- > 0;) {
        timesBilinear({0, 1, -1, 0}, order - i, between);  // x = p − q
        for (std::size_t j = 0; i + j <= order; ++j) between[gradedAt(0, j)] += terms[gradedAt(i, j)];
    }
    std::fill(terms.begin(), terms.end(), Vec3(0));
    for (std::size_t j = order + 1; j-- > 0;) {
        timesBilinear({0, v, u, 1}, order - j, terms);
        for (std::size_t i = 0; i + j <= order; ++i) terms[gradedAt(i, 0)] += between[gradedAt(i, j)];
    }
}

// ---- Breaks ------------------------------------------------------------------------------------

using Numbers = std::vector<double>;

void addInside(std::span<const double> knots, const Interval& domain, Numbers& shares) {
    for (const double knot : knots) {
        const double share = (knot - domain.start) / domain.length();
        if (share > 0 && share < 1) shares.push_back(share);
    }
}

void sortOnce(Numbers& numbers) {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

/// Both, and the ends; nothing where there are none.
Numbers breaksOf(Numbers breaks, const Numbers& others) {
    breaks.insert(breaks.end(), others.begin(), others.end());
    if (breaks.empty()) return breaks;
    breaks.insert(breaks.end(), {0.0, 1.0});
    sortOnce(breaks);
    if (breaks.size() <= mostBreaks) return breaks;
    breaks.resize(mostBreaks);
    for (std::size_t i = 0; i < mostBreaks; ++i) breaks[i] = uniformParameter({0, 1}, i, mostBreaks);
    return breaks;
}

}  // namespace

// ---- Making ------------------------------------------------------------------------------------

BlendingTriangle::BlendingTriangle(const std::array<Surface, 3>& locals, TriangleBlend blend)
    : locals_(std::make_shared<const std::vector<Surface>>(locals.begin(), locals.end())),
      over_{knotwork::domain(locals[0]), knotwork::domain(locals[1]),
            knotwork::domain(locals[2])},
      blend_(std::move(blend)) {
    findBreaks();
}

Result<BlendingTriangle> BlendingTriangle::make(const std::array<Surface, 3>& locals,
                                                TriangleBlend blend) {
    if (!blend.blend && blend.order != 1 && blend.order != 2) {
        return refuse(Code::outOfRange, "order",
                      "The order is " + std::to_string(blend.order) +
                          "; the weights of triangles have order 1 or 2, or a B-function.");
    }
    const double middle = blend.blend ? blend.blend->value(1.0 / 3) : 1;
    if (!(middle >= leastMiddle)) {
        return refuse(Code::outOfRange, "bFunction",
                      "B(1/3) is " + formatNumber(middle) +
                          ", and the weights in the middle of the triangle are quotients of it; "
                          "choose a less steep B-function, with at least 1e-9 there.");
    }
    BlendingTriangle triangle(locals, std::move(blend));
    if (auto checked = checkNesting(triangle.nesting(), "locals"); !checked) return checked.error();
    return triangle;
}

void BlendingTriangle::findBreaks() {
    Numbers xs;
    Numbers ys;
    for (std::size_t k = 0; k < 3; ++k) {
        addInside(knotwork::breaksU(local(k)), over_[k].u, xs);
        addInside(knotwork::breaksV(local(k)), over_[k].v, ys);
    }
    sortOnce(xs);
    sortOnce(ys);
    Numbers mirrored;  // on the side u = 1, where x = 1 − v
    for (const double x : xs) mirrored.push_back(1 - x);
    breaksU_ = std::make_shared<const Numbers>(breaksOf(xs, ys));
    breaksV_ = std::make_shared<const Numbers>(breaksOf(std::move(mirrored), ys));
    knotsX_ = std::make_shared<const Numbers>(std::move(xs));
    knotsY_ = std::make_shared<const Numbers>(std::move(ys));
}

bool BlendingTriangle::crossed(const Rectangle& cell) const noexcept {
    const auto through = [](const Numbers& knots, double from, double to) {
        const auto next = std::upper_bound(knots.begin(), knots.end(), from);
        return next != knots.end() && *next < to;
    };
    const auto& [u, v] = cell;
    return through(*knotsX_, u.start * (1 - v.end), u.end * (1 - v.start)) ||
           through(*knotsY_, u.start * v.start, u.end * v.end);
}

SurfaceNesting BlendingTriangle::nesting() const noexcept {
    SurfaceNesting all{0, 0};
    for (const Surface& patch : *locals_) {
        const SurfaceNesting inner = nestingOf(patch);
        all.depth = std::max(all.depth, inner.depth + 1);
        all.evaluations += inner.evaluations;
    }
    return all;
}

// ---- Evaluating --------------------------------------------------------------------------------

const Surface& BlendingTriangle::local(std::size_t corner) const noexcept {
    return (*locals_)[corner];
}

Barycentric BlendingTriangle::weights(double u, double v) const noexcept {
    return TriangleWeights(blend_, barycentric(u, v), 0).values();
}

void BlendingTriangle::takePatch(std::size_t corner, const SurfacePlace& at, std::size_t order,
                                 std::span<Vec3> terms) const noexcept {
    const Surface& patch = local(corner);
    const SurfacePlace own = placeOn(over_[corner], at);
    if (const auto* triangle = patch.as<BlendingTriangle>()) {  // is over the unit square itself
        triangle->series(own, order, terms);
    } else {
        takeSeries(patch, over_[corner], own, order, terms);
    }
}

void BlendingTriangle::series(const SurfacePlace& at, std::size_t order,
                              std::span<Vec3> terms) const noexcept {
    const TriangleWeights weights(blend_, barycentric(at.u, at.v), order);
    const std::size_t size = gradedSize(order);
    std::array<Vec3, mostTerms> first;
    std::array<Vec3, mostTerms> second;
    const auto base = std::span<Vec3>(first).first(size);
    const auto other = std::span<Vec3>(second).first(size);
    takePatch(weights.base(), at, order, base);
    // As base + Σ weight · (patch − base) whatever is the same for all patches is kept exactly.
    std::copy(base.begin(), base.end(), terms.begin());
    for (std::size_t which = 0; which < 2; ++which) {
        if (weights.vanishes(which)) continue;
        takePatch(weights.corner(which), at, order, other);
        for (std::size_t k = 0; k < size; ++k) other[k] -= base[k];
        addProduct<Vec3>(weights.series(which), weights.order(), other, order, terms);
    }
    if (order > 0) collapse(at.u, at.v, order, terms.first(size), other);
}

/// The entries with a + b ≤ total; the others are left as they are.
void BlendingTriangle::takeWithin(const SurfacePlace& at, const SurfaceOrders& orders,
                                  std::size_t total, std::span<Vec3> rows) const noexcept {
    std::array<Vec3, mostTerms> terms;
    series(at, total, terms);
    double factorU = 1;  // a!
    for (std::size_t a = 0; a <= static_cast<std::size_t>(orders.u) && a <= total; ++a) {
        if (a > 1) factorU *= static_cast<double>(a);
        double factor = factorU;
        for (std::size_t b = 0; b < orders.columns() && a + b <= total; ++b) {
            if (b > 1) factor *= static_cast<double>(b);
            rows[orders.at(a, b)] = factor * terms[gradedAt(a, b)];
        }
    }
}

void BlendingTriangle::derivatives(const SurfacePlace& at, const SurfaceOrders& orders,
                                   std::span<Vec3> rows) const noexcept {
    const auto wanted = static_cast<std::size_t>(orders.u + orders.v);
    if (wanted > maxTriangleOrder) {
        std::fill_n(rows.begin(), orders.size(), Vec3(std::numeric_limits<double>::quiet_NaN()));
    }
    takeWithin(at, orders, std::min(wanted, maxTriangleOrder), rows);
}

void BlendingTriangle::derivativesWithin(const SurfacePlace& at, int order,
                                         std::span<Vec3> rows) const noexcept {
    takeWithin(at, {order, order}, static_cast<std::size_t>(order), rows);
}

}  // namespace knotwork
