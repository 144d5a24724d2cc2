// The published and independently computed values in tests/truth/cases.json.
#pragma once

#include "geometry/vec.hpp"
#include "support/rational.hpp"

#include <nlohmann/json.hpp>

#include <fstream>
#include <string>
#include <vector>

namespace knotwork::test {

[[nodiscard]] inline const nlohmann::json& truth(const char* name) {
    static const nlohmann::json cases = [] {
        std::ifstream file(KNOTWORK_SOURCE_DIR "/tests/truth/cases.json");
        return nlohmann::json::parse(file);
    }();
    return cases.at(name);
}

/// An array of fractions.
[[nodiscard]] inline std::vector<Rational> rationals(const nlohmann::json& texts) {
    std::vector<Rational> values;
    for (const auto& text : texts) values.push_back(Rational::parse(text.get<std::string>()));
    return values;
}

[[nodiscard]] inline std::vector<double> doubles(const std::vector<Rational>& exact) {
    std::vector<double> values;
    for (const Rational& value : exact) values.push_back(value.value());
    return values;
}

/// A list of points of two fractions each, in the plane z = 0.
[[nodiscard]] inline std::vector<Vec3> planarPoints(const nlohmann::json& texts) {
    std::vector<Vec3> points;
    for (const auto& text : texts) {
        const auto exact = rationals(text);
        points.emplace_back(exact[0].value(), exact[1].value(), 0);
    }
    return points;
}

}  // namespace knotwork::test
