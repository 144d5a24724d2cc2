#include "scene/knot_adaptation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace knotwork::scene {

namespace {

bool areUniform(const KnotRow& row) {
    const auto usual = KnotVector::uniform(static_cast<int>(row.degree),
                                           static_cast<int>(row.count), row.form);
    return usual.ok() && std::equal(row.knots.begin(), row.knots.end(), usual->knots().begin(),
                                    usual->knots().end());
}

/// The middle of the span that t falls into, never an empty one, between two indices.
double midOfSpanNear(std::span<const double> knots, std::size_t first, std::size_t last, double t) {
    std::size_t end = first + 1;
    while (end < last && (knots[end] <= t || knots[end] == knots[end - 1])) ++end;
    while (end > first + 1 && knots[end] == knots[end - 1]) --end;
    return (knots[end - 1] + knots[end]) / 2;
}

/// The range of indices between whose knots the curve lives.
std::pair<std::size_t, std::size_t> domainIndices(std::size_t knots, std::size_t degree,
                                                  bool closed) {
    return closed ? std::pair{std::size_t{0}, knots - 1} : std::pair{degree, knots - 1 - degree};
}

double grevilleOf(std::span<const double> knots, std::size_t degree, bool closed, double index) {
    const auto [first, last] = domainIndices(knots.size(), degree, closed);
    const std::size_t points = closed ? last : knots.size() - degree - 1;
    const double share = points < 2 ? 0.5 : std::clamp(index / static_cast<double>(points - 1), 0.0, 1.0);
    return knots[first] + share * (knots[last] - knots[first]);
}

void insertKnotFor(std::vector<double>& knots, std::size_t degree, bool closed, std::size_t point) {
    const auto [first, last] = domainIndices(knots.size(), degree, closed);
    const double near = grevilleOf(knots, degree, closed, static_cast<double>(point) - 0.5);
    const double knot = midOfSpanNear(knots, first, last, near);
    knots.insert(std::upper_bound(knots.begin(), knots.end(), knot), knot);
}

void removeKnotFor(std::vector<double>& knots, std::size_t degree, bool closed, std::size_t point) {
    const auto [first, last] = domainIndices(knots.size(), degree, closed);
    if (last - first < 2) return;  // no inner knot: the points will be too few, and that is said
    const double near = grevilleOf(knots, degree, closed, static_cast<double>(point));
    auto nearest = knots.begin() + static_cast<std::ptrdiff_t>(first + 1);
    const auto end = knots.begin() + static_cast<std::ptrdiff_t>(last);
    for (auto at = nearest; at != end; ++at) {
        if (std::abs(*at - near) < std::abs(*nearest - near)) nearest = at;
    }
    knots.erase(nearest);
}

/// The end knots of a clamped vector from those of an open one, and back.
void changeEnds(std::vector<double>& knots, std::size_t degree, bool clamped) {
    const std::size_t last = knots.size() - 1;
    const double head = knots[degree];
    const double tail = knots[last - degree];
    const double step = (tail - head) / static_cast<double>(last - 2 * degree);
    for (std::size_t i = 0; i < degree; ++i) {
        const double away = clamped ? 0 : step * static_cast<double>(degree - i);
        knots[i] = head - away;
        knots[last - i] = tail + away;
    }
}

/// Of a closed vector from those of a clamped or open one.
std::vector<double> closedKnots(const KnotRow& row) {
    const std::size_t first = row.degree;
    const std::size_t last = row.count;
    std::vector<double> knots(row.knots.begin() + static_cast<std::ptrdiff_t>(first),
                              row.knots.begin() + static_cast<std::ptrdiff_t>(last + 1));
    const double step =
        (knots.back() - knots.front()) / static_cast<double>(last - first);
    for (std::size_t i = 1; i <= row.degree; ++i) {
        const bool given = row.form == Form::open && row.knots[last + i] > row.knots[last + i - 1];
        const double gap = given ? row.knots[last + i] - row.knots[last + i - 1] : step;
        knots.push_back(knots.back() + gap);
    }
    return knots;
}

}  // namespace

std::optional<std::vector<double>> knotsAfter(const KnotRow& before, const RowChange& after) {
    if (after.degree != before.degree || areUniform(before)) return std::nullopt;
    std::vector<double> knots = before.knots;
    if (after.form != before.form) {
        if (after.count != before.count || before.form == Form::closed) return std::nullopt;
        if (after.form == Form::closed) return closedKnots(before);
        changeEnds(knots, after.degree, after.form == Form::clamped);
        return knots;
    }
    const bool closed = before.form == Form::closed;
    if (after.count == before.count + 1) {
        insertKnotFor(knots, after.degree, closed, after.point);
    } else if (after.count + 1 == before.count) {
        removeKnotFor(knots, after.degree, closed, after.point);
    } else {
        return std::nullopt;
    }
    return knots;
}

std::vector<double> respaced(std::span<const double> knots, std::size_t wanted) {
    std::vector<double> spaced(wanted);
    for (std::size_t i = 0; i < wanted; ++i) {
        const double at = static_cast<double>(i * (knots.size() - 1)) / static_cast<double>(wanted - 1);
        const auto k = std::min(static_cast<std::size_t>(at), knots.size() - 2);
        const double share = at - static_cast<double>(k);
        spaced[i] = share == 0 ? knots[k] : (1 - share) * knots[k] + share * knots[k + 1];
    }
    spaced.back() = knots.back();
    return spaced;
}

}  // namespace knotwork::scene
