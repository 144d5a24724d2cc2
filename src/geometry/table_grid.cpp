#include "geometry/table_grid.hpp"

#include "geometry/surface_kernels.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace knotwork {

TableColumns::TableColumns(std::size_t columns, std::size_t terms, std::size_t components,
                           double least)
    : terms_(terms),
      components_(components),
      stride_(columns + 1),  // a pair may begin in the last column
      most_(1 / least),
      values_(terms * stride_),
      slopes_(terms * stride_) {}

void TableColumns::add(std::size_t j, std::size_t first, const double* values,
                       const double* slopes, std::size_t step) {
    if (runs_.empty() || runs_.back().term != first) runs_.push_back({j, 0, first});
    ++runs_.back().count;
    for (std::size_t k = 0; k < terms_; ++k) {
        values_[k * stride_ + j] = values[k * step];
        slopes_[k * stride_ + j] = slopes[k * step];
    }
}

template <std::size_t Components>
void TableColumns::run(std::size_t from, std::size_t to, const double* row, double* positions,
                       double* normals) noexcept {
    const auto note = [&](std::size_t j, double inverse) {
        if (!(inverse < most_)) unclear_.push_back(j);
    };
    for (std::size_t j = from; j < to; j += 2, positions += 6, normals += 6) {
        const kernels::RowTable table{&values_[j], &slopes_[j], stride_, row, terms_};
        if (j + 2 <= to) {
            const simd::Double2 inverse =
                kernels::tablePair<Components>(table, positions, normals);
            note(j, simd::first(inverse));
            note(j + 1, simd::second(inverse));
            continue;
        }
        std::array<double, 6> position;
        std::array<double, 6> normal;
        note(j, simd::first(kernels::tablePair<Components>(table, position.data(),
                                                           normal.data())));
        std::copy_n(position.begin(), 3, positions);
        std::copy_n(normal.begin(), 3, normals);
    }
}

void TableColumns::columns(std::size_t first, std::size_t count, const double* row,
                           double* positions, double* normals) noexcept {
    unclear_.clear();
    for (const Run& each : runs_) {
        const std::size_t from = std::max(first, each.first);
        const std::size_t to = std::min(first + count, each.first + each.count);
        if (from >= to) continue;
        const double* terms = row + 2 * components_ * each.term;
        double* position = positions + 3 * (from - first);
        double* normal = normals + 3 * (from - first);
        if (components_ == 4) {
            run<4>(from, to, terms, position, normal);
        } else {
            run<3>(from, to, terms, position, normal);
        }
    }
}

namespace {

constexpr double clearly = 1e-6;  // as in bspline_grid.cpp

/// The factors of one direction, term by term: values and derivatives in turn.
template <class Factors>
std::vector<double> factorTable(std::size_t terms, const GridLine& line, Factors factors) {
    std::vector<double> table(2 * terms * line.count);
    for (std::size_t i = 0; i < line.count; ++i) {
        factors(line.at(i).parameter, std::span(table).subspan(2 * terms * i, 2 * terms));
    }
    return table;
}

/// The largest value (0) or derivative (1) of every term.
std::vector<double> largestFactors(std::span<const double> table, std::size_t terms,
                                   std::size_t order) {
    std::vector<double> largest(terms);
    for (std::size_t at = 0; at < table.size(); at += 2 * terms) {
        for (std::size_t k = 0; k < terms; ++k) {
            largest[k] = std::max(largest[k], std::abs(table[at + 2 * k + order]));
        }
    }
    return largest;
}

double bound(const std::vector<double>& along, const std::vector<double>& across) noexcept {
    double sum = 0;
    for (std::size_t k = 0; k < along.size(); ++k) sum += along[k] * across[k];
    return sum;
}

double leastNormal(std::span<const double> u, std::span<const double> v, std::size_t terms) {
    const double su = bound(largestFactors(u, terms, 1), largestFactors(v, terms, 0));
    const double sv = bound(largestFactors(u, terms, 0), largestFactors(v, terms, 1));
    return clearly * su * sv;
}

std::vector<double> tableU(const ParametricSurface& surface, const GridLine& line) {
    return factorTable(surface.axes().size(), line, [&](double u, std::span<double> factors) {
        surface.factorsU(u, 1, factors);
    });
}

std::vector<double> tableV(const ParametricSurface& surface, const GridLine& line) {
    return factorTable(surface.axes().size(), line, [&](double v, std::span<double> factors) {
        surface.factorsV(v, 1, factors);
    });
}

}  // namespace

ProductGrid::ProductGrid(const ParametricSurface& surface, const GridLine& u, const GridLine& v)
    : rowSize_(6 * surface.axes().size()),
      rows_(rowSize_ * u.count),
      columns_(v.count, surface.axes().size(), 3,
               leastNormal(tableU(surface, u), tableV(surface, v), surface.axes().size())) {
    const std::size_t terms = surface.axes().size();
    const std::vector<double> along = tableU(surface, u);
    for (std::size_t i = 0; i < u.count; ++i) {
        for (std::size_t k = 0; k < terms; ++k) {
            double* to = &rows_[i * rowSize_ + 6 * k + surface.axes()[k]];
            to[0] = along[2 * (terms * i + k)];
            to[3] = along[2 * (terms * i + k) + 1];
        }
    }
    const std::vector<double> across = tableV(surface, v);
    for (std::size_t j = 0; j < v.count; ++j) {
        const double* factors = &across[2 * terms * j];
        columns_.add(j, 0, factors, factors + 1, 2);
    }
}

}  // namespace knotwork
