// Model curves that tests make by name; one that is refused fails the test and is a circle.
#pragma once

#include "geometry/parametric_curve.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace knotwork::test {

using Parameters = std::vector<NamedValue>;

inline ParametricCurve make(std::string_view name, const Parameters& parameters = {},
                            std::optional<Interval> domain = std::nullopt) {
    auto made = ParametricCurve::make(name, parameters, domain);
    EXPECT_TRUE(made.ok()) << name;
    return made.ok() ? std::move(made).value() : ParametricCurve::make("circle").value();
}

inline std::vector<Vec3> rowsOf(const ParametricCurve& curve, double t, std::size_t count) {
    std::vector<Vec3> rows(count);
    curve.derivatives(t, rows);
    return rows;
}

}  // namespace knotwork::test
