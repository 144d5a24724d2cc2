#include "geometry/parameter.hpp"

#include <algorithm>
#include <cmath>

namespace knotwork {

namespace {

std::string rangeText(const ParameterDescription& d) {
    std::string text(d.integer ? "an integer in " : "a number in ");
    text += d.minOpen ? '(' : '[';
    text += formatNumber(d.min) + ", " + formatNumber(d.max);
    text += d.maxOpen ? ')' : ']';
    return text;
}

bool inRange(const ParameterDescription& d, double value) {
    return (d.minOpen ? value > d.min : value >= d.min) &&
           (d.maxOpen ? value < d.max : value <= d.max);
}

std::string knownNames(std::span<const ParameterDescription> descriptions) {
    if (descriptions.empty()) return "none";
    std::string names;
    for (const ParameterDescription& description : descriptions) {
        if (!names.empty()) names += ", ";
        names += description.name;
    }
    return names;
}

}  // namespace

std::optional<Error> checkParameter(const ParameterDescription& description, double value,
                                    std::string path) {
    const auto complain = [&](Code code) {
        return refuse(code, std::move(path),
                      std::string(description.name) + " is " + formatNumber(value) +
                          " and must be " + rangeText(description));
    };
    if (!std::isfinite(value)) return complain(Code::notFinite);
    if (description.integer && value != std::trunc(value)) return complain(Code::notInteger);
    if (!inRange(description, value)) return complain(Code::outOfRange);
    return std::nullopt;
}

Result<std::vector<double>> readParameters(std::span<const ParameterDescription> descriptions,
                                           std::span<const NamedValue> given,
                                           std::string_view parent) {
    std::vector<double> values;
    for (const ParameterDescription& description : descriptions) {
        values.push_back(description.defaultValue);
    }
    for (const NamedValue& one : given) {
        const auto& name = one.first;  // a lambda cannot capture a structured binding in clang 14
        const double value = one.second;
        const auto found =
            std::find_if(descriptions.begin(), descriptions.end(),
                         [&name](const ParameterDescription& d) { return d.name == name; });
        std::string path = joinPath(parent, name);
        if (found == descriptions.end()) {
            return refuse(
                Code::unknownField, std::move(path),
                "there is no parameter \"" + name + "\" here; known: " + knownNames(descriptions));
        }
        if (auto error = checkParameter(*found, value, std::move(path))) return *std::move(error);
        values[static_cast<std::size_t>(found - descriptions.begin())] = value;
    }
    return values;
}

}  // namespace knotwork
