// Dual, symmetrised, composed and mixed B-functions.
#include "geometry/b_function.hpp"
#include "geometry/jet.hpp"

#include <algorithm>
#include <array>

namespace knotwork::b_function {

namespace {

using RowBuffer = std::array<double, Jet::maxOrder + 1>;

/// The rows of `of`, as many as `like` has.
std::span<double> rowsOf(const BFunction& of, double t, RowBuffer& buffer,
                         std::span<const double> like) noexcept {
    const auto rows = std::span(buffer).first(like.size());
    of.derivatives(t, rows);
    return rows;
}

Jet toJet(std::span<const double> rows) noexcept {
    Jet jet = Jet::constant(0, static_cast<int>(rows.size()) - 1);
    double factorial = 1;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        if (k > 1) factorial *= static_cast<double>(k);
        jet[static_cast<int>(k)] = rows[k] / factorial;
    }
    return jet;
}

Powers smaller(const Powers& a, const Powers& b) noexcept {
    return {std::min(a[0], b[0]), std::min(a[1], b[1])};
}

}  // namespace

double Dual::value(double t) const noexcept { return 1 - of->value(1 - t); }

void Dual::derivatives(double t, std::span<double> rows) const noexcept {
    of->derivatives(1 - t, rows);
    reflectRows(rows);
}

Powers Dual::powers() const noexcept {
    const Powers powers = of->powers();
    return {powers[1], powers[0]};
}

bool Dual::symmetric() const noexcept { return of->symmetric(); }

double Symmetrised::value(double t) const noexcept {
    return 0.5 * (of->value(t) + (1 - of->value(1 - t)));
}

void Symmetrised::derivatives(double t, std::span<double> rows) const noexcept {
    RowBuffer buffer;
    const auto mirrored = rowsOf(*of, 1 - t, buffer, rows);
    reflectRows(mirrored);
    of->derivatives(t, rows);
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k] = 0.5 * (rows[k] + mirrored[k]);
}

// Near an end both B and its dual rise with a positive first term: nothing cancels in their sum.
Powers Symmetrised::powers() const noexcept {
    const Powers powers = of->powers();
    return smaller(powers, {powers[1], powers[0]});
}

double Composed::value(double t) const noexcept { return outer->value(inner->value(t)); }

void Composed::derivatives(double t, std::span<double> rows) const noexcept {
    RowBuffer innerBuffer;
    RowBuffer outerBuffer;
    const auto innerRows = rowsOf(*inner, t, innerBuffer, rows);
    const auto outerRows = rowsOf(*outer, innerRows[0], outerBuffer, rows);
    const Jet result = compose(toJet(outerRows), toJet(innerRows));
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k] = result.derivative(static_cast<int>(k));
}

Powers Composed::powers() const noexcept {
    const Powers a = outer->powers();
    const Powers b = inner->powers();
    return {a[0] * b[0], a[1] * b[1]};
}

bool Composed::symmetric() const noexcept { return outer->symmetric() && inner->symmetric(); }

double Mixed::value(double t) const noexcept {
    return weight * first->value(t) + (1 - weight) * second->value(t);
}

void Mixed::derivatives(double t, std::span<double> rows) const noexcept {
    RowBuffer buffer;
    const auto others = rowsOf(*second, t, buffer, rows);
    first->derivatives(t, rows);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        rows[k] = weight * rows[k] + (1 - weight) * others[k];
    }
}

Powers Mixed::powers() const noexcept {
    if (weight == 1) return first->powers();
    if (weight == 0) return second->powers();
    return smaller(first->powers(), second->powers());
}

bool Mixed::symmetric() const noexcept {
    return (weight == 0 || first->symmetric()) && (weight == 1 || second->symmetric());
}

}  // namespace knotwork::b_function
