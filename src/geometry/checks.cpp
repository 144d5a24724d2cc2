#include "geometry/checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace knotwork {

namespace {

constexpr double smallestDomain = 1e-6;
constexpr double smallestRelativeDomain = 1e-9;
constexpr double largestParameter = 1e9;

}  // namespace

std::optional<Error> checkDomain(const Interval& domain) {
    const std::array ends{domain.start, domain.end};
    for (std::size_t i = 0; i < ends.size(); ++i) {
        if (!std::isfinite(ends[i])) {
            return refuse(Code::notFinite, indexed("domain", i),
                          "the domain ends at " + formatNumber(ends[i]));
        }
        if (std::abs(ends[i]) > largestParameter) {
            return refuse(
                Code::outOfRange, indexed("domain", i),
                "the domain reaches " + formatNumber(ends[i]) + "; parameters go from -1e9 to 1e9");
        }
    }
    const double reach = std::max(std::abs(domain.start), std::abs(domain.end));
    if (!(domain.length() >= std::max(smallestDomain, smallestRelativeDomain * reach))) {
        return refuse(
            Code::outOfRange, "domain",
            "the domain [" + formatNumber(domain.start) + ", " + formatNumber(domain.end) +
                "] must be ascending and at least 1e-6 (and 1e-9 of its larger end) long");
    }
    return std::nullopt;
}

std::optional<Error> checkCoordinates(const Vec3& point, std::string path) {
    for (int axis = 0; axis < 3; ++axis) {
        const double coordinate = point[axis];
        if (!std::isfinite(coordinate)) {
            return refuse(Code::notFinite, std::move(path),
                          formatNumber(coordinate) + " is not a finite coordinate");
        }
        if (std::abs(coordinate) > largestCoordinate) {
            return refuse(Code::outOfRange, std::move(path),
                          formatNumber(coordinate) + " is out of range; coordinates lie in ±1e12");
        }
    }
    return std::nullopt;
}

}  // namespace knotwork
