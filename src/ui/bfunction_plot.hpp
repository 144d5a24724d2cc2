// A B-function and its derivatives, one row each under one another on one parameter axis.
//
// Every row has its own scale with true numbers on it: a derivative of B has other units than B, and
// scaled into B's picture it would say something false about its size. B has the tallest row.
#pragma once

#include "ui/plot.hpp"

#include <array>
#include <string>
#include <vector>

namespace knotwork::ui {

/// One of several B-functions in the same rows.
struct BFunctionEntry {
    std::string name;
    Colour colour;
    bool dashed = false;
    std::array<double, 2> order{0, 0};
};

struct BFunctionContent {
    std::vector<Interval> values;  ///< row k: extent of the k-th derivative
    std::array<double, 2> order{0, 0};  ///< Hermite order at 0 and at 1, infinity allowed
    std::string orderWords = "order {0} at 0, {1} at 1";
    std::vector<BFunctionEntry> compared{};  ///< a line each of a legend, in place of the order
};

/// The words with the two orders in their places: `order 2 at 0, ∞ at 1`.
[[nodiscard]] std::string orderText(std::string words, const std::array<double, 2>& order);
/// `B`, `B′`, `B″`, `B‴`, then `B⁽⁴⁾`.
[[nodiscard]] std::string derivativeName(std::size_t order);

/// The interval of a derivative's row: its values with a little air, always with 0 in it.
[[nodiscard]] Interval rowInterval(const Interval& values) noexcept;

/// As many rows as are legible in the box, B always.
[[nodiscard]] std::vector<Plot> bFunctionPlots(const Box& box, const BFunctionContent& content,
                                               const Theme& colours);

}  // namespace knotwork::ui
