// Many parameters spread uniformly over an interval, two at a time.
#pragma once

#include "geometry/interval.hpp"
#include "geometry/simd.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace knotwork {

/// Samples first, first+1, … of `total` over an interval as pairs of the very numbers that
/// uniformParameter() gives, but for the last of all (index total-1), which it takes from the end of
/// the interval.
class UniformPairs {
public:
    UniformPairs(const Interval& over, std::size_t first, std::size_t total) noexcept
        : start_(simd::splat(over.start)), length_(simd::splat(over.length())),
          intervals_(simd::splat(static_cast<double>(total - 1))) {
        const std::array<double, 2> indices{static_cast<double>(first),
                                            static_cast<double>(first + 1)};
        index_ = simd::load(indices.data());
    }

    [[nodiscard]] simd::Double2 next() noexcept {
        const simd::Double2 t = start_ + length_ * index_ / intervals_;
        index_ = index_ + simd::splat(2);
        return t;
    }

private:
    simd::Double2 start_;
    simd::Double2 length_;
    simd::Double2 intervals_;
    simd::Double2 index_;
};

/// ts[i] = uniformParameter(over, first + i, total).
inline void uniformParameters(const Interval& over, std::size_t first, std::size_t total,
                              std::span<double> ts) noexcept {
    if (total < 2) {
        for (double& t : ts) t = over.start;
        return;
    }
    UniformPairs pairs(over, first, total);
    std::size_t i = 0;
    for (; i + 2 <= ts.size(); i += 2) simd::store(&ts[i], pairs.next());
    if (i < ts.size()) ts[i] = uniformParameter(over, first + i, total);
    if (!ts.empty() && first + ts.size() == total) ts.back() = over.end;
}

}  // namespace knotwork
