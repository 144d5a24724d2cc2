// The formulae of traces: written in a short notation, delivered as MathML.
//
//     c_{2}^{(1)}        sub- and superscripts; braces group
//     \frac{a}{b}        fractions
//     \table{a & = & b \\ c & = & d}     rows; \matrix{…} the same in parentheses
//     \alpha \sum \le \cdot \cdots \vdots
// Letters are identifiers, digits numbers, everything else operators. What this makes is
// well-formed and escaped whatever is in it.
#pragma once

#include "scene/trace_parts.hpp"

#include <span>
#include <string>
#include <string_view>

namespace knotwork::scene {

/// A whole `<math>` element, with its namespace.
[[nodiscard]] std::string mathml(std::string_view notation);

// Pieces of notation.
/// A number for reading; `1.5\cdot 10^{-9}` where it is very small or large.
[[nodiscard]] std::string noted(double value, const Reading& reading = {});
/// `a-b`, b in parentheses where it is negative.
[[nodiscard]] std::string notedDifference(double a, double b, const Reading& reading);
[[nodiscard]] std::string noted(const Vec3& point, int dimension, const Reading& reading);
/// `c_{3}`, `c_{3}^{(1)}`, `b_{2,3}`.
[[nodiscard]] std::string indexedTerm(std::string_view letter, std::size_t index);
[[nodiscard]] std::string indexedTerm(std::string_view letter, std::size_t first,
                                      std::size_t second);
[[nodiscard]] std::string levelTerm(std::string_view letter, std::size_t index, std::size_t level);
[[nodiscard]] std::string fraction(std::string_view above, std::string_view below);
/// `\matrix{…}` of numbers.
[[nodiscard]] std::string notedMatrix(std::span<const std::vector<double>> rows);

/// Rows of a table, of which a long one loses its middle.
class NotedRows {
public:
    void add(std::string row) { rows_.push_back(std::move(row)); }
    [[nodiscard]] std::string table() const;

private:
    std::vector<std::string> rows_;
};

}  // namespace knotwork::scene
