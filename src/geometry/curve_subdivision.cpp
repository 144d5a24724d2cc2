#include "geometry/curve_subdivision.hpp"

#include "geometry/knot_vector.hpp"
#include "geometry/simd.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace knotwork {

namespace {

using simd::Double2;

constexpr double largestCoordinate = 1e12;

// ---- What may be asked for ---------------------------------------------------------------------

std::size_t fewestPoints(const CurveSubdivision& subdivision) noexcept {
    if (subdivision.closed) return 3;
    return static_cast<std::size_t>(std::max(splineDegree(subdivision), 1)) + 1;
}

Result<Done> checkPoints(const CurveSubdivision& subdivision) {
    const std::size_t count = subdivision.points.size();
    if (count > static_cast<std::size_t>(maxPointCount)) {
        return refuse(Code::tooLarge, "points",
                      std::to_string(count) + " points; a polygon to be subdivided has at most " +
                          std::to_string(maxPointCount) + ".");
    }
    if (const std::size_t fewest = fewestPoints(subdivision); count < fewest) {
        return refuse(Code::wrongLength, "points",
                      std::to_string(count) + " points are too few; " +
                          (subdivision.closed ? "a closed polygon needs " : "this scheme needs ") +
                          "at least " + std::to_string(fewest) + ".");
    }
    for (std::size_t i = 0; i < count; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const double coordinate = subdivision.points[i][axis];
            if (std::abs(coordinate) <= largestCoordinate) continue;
            return refuse(std::isfinite(coordinate) ? Code::outOfRange : Code::notFinite,
                          indexed("points", i),
                          "A coordinate is " + formatNumber(coordinate) +
                              "; coordinates lie in ±1e12.");
        }
    }
    return Done{};
}

Result<Done> checkRule(const CurveSubdivision& subdivision) {
    const bool hasDegree = subdivision.scheme == CurveScheme::laneRiesenfeld;
    if (hasDegree && (subdivision.degree < 1 || subdivision.degree > maxDegree)) {
        return refuse(subdivision.degree < 1 ? Code::outOfRange : Code::tooLarge, "degree",
                      "The degree is " + std::to_string(subdivision.degree) +
                          "; it can be 1 to " + std::to_string(maxDegree) + ".");
    }
    const double tension = subdivision.tension;
    if (subdivision.scheme == CurveScheme::fourPoint && !(std::abs(tension) <= 1)) {
        return refuse(std::isfinite(tension) ? Code::outOfRange : Code::notFinite, "tension",
                      "The tension is " + formatNumber(tension) +
                          "; it can be -1 to 1, and 1/16 keeps cubics.");
    }
    return Done{};
}

Error tooManyLevels(std::string message) {
    return refuse(Code::tooLarge, "levels", std::move(message) + " Take fewer levels.");
}

// ---- Weights -----------------------------------------------------------------------------------

std::size_t lostPerLevel(const CurveSubdivision& subdivision) noexcept {
    if (subdivision.closed) return 0;
    return static_cast<std::size_t>(std::max(splineDegree(subdivision), 1));
}

SubdivisionMask splineMask(int degree) noexcept {
    const auto d = static_cast<std::size_t>(degree);
    std::array<double, maxDegree + 2> m{};  // C(d+1, k) / 2^d, exact
    m[0] = std::ldexp(1.0, -degree);
    for (std::size_t row = 1; row <= d + 1; ++row) {
        for (std::size_t k = row; k > 0; --k) m[k] += m[k - 1];
    }
    SubdivisionMask mask;
    mask.taps = (d + 1) / 2 + 1;
    for (std::size_t s = 0; s < mask.taps; ++s) {
        if (2 * s <= d) mask.even[s] = m[d - 2 * s];
        mask.odd[s] = m[d + 1 - 2 * s];
    }
    return mask;
}

SubdivisionMask fourPointMask(double w) noexcept {
    SubdivisionMask mask;
    mask.even = {0, 1, 0, 0};
    mask.odd = {-w, 0.5 + w, 0.5 + w, -w};
    mask.taps = 4;
    mask.lead = 1;
    return mask;
}

// ---- One level ---------------------------------------------------------------------------------
//
// Two q at a time. Every kernel is written with differences or averages, so that equal coordinates
// stay equal to the bit and a planar polygon stays in its plane.

struct Refined {
    Double2 even;
    Double2 odd;
};

struct QuadraticKernel {
    explicit QuadraticKernel(const SubdivisionMask&) noexcept {}
    [[nodiscard]] Refined at(const double* p) const noexcept {
        const Double2 half = simd::splat(0.5);
        const Double2 a = simd::load(p);
        const Double2 b = simd::load(p + 1);
        const Double2 middle = half * (a + b);
        return {half * (a + middle), half * (middle + b)};
    }
};

struct CubicKernel {
    explicit CubicKernel(const SubdivisionMask&) noexcept {}
    [[nodiscard]] Refined at(const double* p) const noexcept {
        const Double2 half = simd::splat(0.5);
        const Double2 b = simd::load(p + 1);
        const Double2 before = simd::load(p) + b;
        const Double2 after = b + simd::load(p + 2);
        return {half * before, simd::splat(0.125) * (before + after) + half * b};
    }
};

struct FourPointKernel {
    explicit FourPointKernel(const SubdivisionMask& mask) noexcept : tension(-mask.odd[0]) {}
    [[nodiscard]] Refined at(const double* p) const noexcept {
        const Double2 b = simd::load(p + 1);
        const Double2 inner = b + simd::load(p + 2);
        const Double2 outer = simd::load(p) + simd::load(p + 3);
        return {b, simd::splat(0.5) * inner + simd::splat(tension) * (inner - outer)};
    }
    double tension;
};

struct MaskKernel {
    explicit MaskKernel(const SubdivisionMask& given) noexcept : mask(given) {}
    [[nodiscard]] Refined at(const double* p) const noexcept {
        const Double2 centre = simd::load(p + mask.taps / 2);
        Refined sums{simd::splat(0), simd::splat(0)};
        for (std::size_t s = 0; s < mask.taps; ++s) {
            const Double2 away = simd::load(p + s) - centre;
            sums.even = sums.even + simd::splat(mask.even[s]) * away;
            sums.odd = sums.odd + simd::splat(mask.odd[s]) * away;
        }
        return {centre + sums.even, centre + sums.odd};
    }
    const SubdivisionMask& mask;
};

/// 4 · pairs numbers from the first 2 · pairs + taps − 1 of `from`.
template <class Kernel>
void refineRow(const Kernel& kernel, const double* from, std::size_t pairs, double* to) noexcept {
    for (std::size_t i = 0; i < pairs; ++i) {
        const Refined found = kernel.at(from + 2 * i);
        simd::store(to + 4 * i, simd::firstFirst(found.even, found.odd));
        simd::store(to + 4 * i + 2, simd::secondSecond(found.even, found.odd));
    }
}

/// The same of three rows, as 4 · pairs triples.
template <class Kernel>
void refineTriples(const Kernel& kernel, const std::array<const double*, 3>& from,
                   std::size_t pairs, double* xyz) noexcept {
    for (std::size_t i = 0; i < pairs; ++i, xyz += 12) {
        const Refined x = kernel.at(from[0] + 2 * i);
        const Refined y = kernel.at(from[1] + 2 * i);
        const Refined z = kernel.at(from[2] + 2 * i);
        simd::store(xyz, simd::firstFirst(x.even, y.even));
        simd::store(xyz + 2, simd::firstFirst(z.even, x.odd));
        simd::store(xyz + 4, simd::firstFirst(y.odd, z.odd));
        simd::store(xyz + 6, simd::secondSecond(x.even, y.even));
        simd::store(xyz + 8, simd::secondSecond(z.even, x.odd));
        simd::store(xyz + 10, simd::secondSecond(y.odd, z.odd));
    }
}

/// `work` with the kernel for the mask.
template <class Work>
void withKernel(CurveScheme scheme, int degree, const SubdivisionMask& mask,
                const Work& work) noexcept {
    if (scheme == CurveScheme::fourPoint) return work(FourPointKernel(mask));
    if (degree == 2) return work(QuadraticKernel(mask));
    if (degree == 3) return work(CubicKernel(mask));
    return work(MaskKernel(mask));
}

// ---- Polygons ----------------------------------------------------------------------------------

template <class T>
T continued(const T* p, std::ptrdiff_t count, bool closed, std::ptrdiff_t i) noexcept {
    if (closed) return p[(i % count + count) % count];
    if (i < 0) return 2.0 * p[0] - continued(p, count, closed, -i);
    const std::ptrdiff_t last = count - 1;
    if (i > last) return 2.0 * p[last] - continued(p, count, closed, 2 * last - i);
    return p[i];
}

/// So many levels are left to blocks. Each costs a block the reach of the mask once more.
constexpr int mostLocalLevels = 6;
constexpr std::size_t blockSize = 512;  // 12 kB of points beside 14 kB of rows
/// A row of the level before the last: half of a block, what the mask reaches, and rounding up.
constexpr std::size_t rowSize = blockSize / 2 + 32;

/// How far blocks read past a polygon: each level adds `lead` before and `taps` and some rounding
/// up after, and halves what the next one has added.
std::size_t padBefore(const SubdivisionMask& mask) noexcept { return 2 * mask.lead; }
std::size_t padAfter(const SubdivisionMask& mask) noexcept { return 2 * mask.taps + 8; }

/// What of a level is made for a block: vertices start, start + 1, …, 4 · pairs of them.
struct Part {
    std::ptrdiff_t start = 0;
    std::size_t pairs = 0;
};

struct Plan {
    std::array<Part, mostLocalLevels> parts{};  ///< the last of them is the block itself
    std::ptrdiff_t start = 0;                   ///< the first vertex that is read of the base
};

/// From the block down to the base: what each level needs of the one before. An odd start is rounded
/// down to an even one.
Plan planOf(const SubdivisionMask& mask, std::size_t levels, std::size_t first,
            std::size_t points) noexcept {
    Plan plan;
    plan.start = static_cast<std::ptrdiff_t>(first);
    std::size_t count = points;
    for (std::size_t level = levels; level-- > 0;) {
        const std::ptrdiff_t q = plan.start >> 1;
        const std::ptrdiff_t end = (plan.start + static_cast<std::ptrdiff_t>(count) + 1) >> 1;
        plan.parts[level] = {2 * q, static_cast<std::size_t>(end - q + 1) / 2};
        plan.start = q - static_cast<std::ptrdiff_t>(mask.lead);
        count = 2 * plan.parts[level].pairs + mask.taps - 1;
    }
    return plan;
}

}  // namespace

int splineDegree(const CurveSubdivision& subdivision) noexcept {
    switch (subdivision.scheme) {
        case CurveScheme::laneRiesenfeld: return subdivision.degree;
        case CurveScheme::chaikin: return 2;
        case CurveScheme::fourPoint: break;
    }
    return 0;
}

std::uint64_t subdividedCount(const CurveSubdivision& subdivision) noexcept {
    const std::uint64_t lost = lostPerLevel(subdivision);
    return ((subdivision.points.size() - lost) << subdivision.levels) + lost;
}

Result<Done> checkSubdivision(const CurveSubdivision& subdivision, std::size_t most) {
    if (auto rule = checkRule(subdivision); !rule) return rule;
    if (auto points = checkPoints(subdivision); !points) return points;
    if (subdivision.levels < 0) {
        return refuse(Code::outOfRange, "levels",
                      std::to_string(subdivision.levels) + " levels; there are 0 or more.");
    }
    if (subdivision.levels > maxSubdivisionLevels) {
        return tooManyLevels(std::to_string(subdivision.levels) + " levels; there are at most " +
                             std::to_string(maxSubdivisionLevels) + ".");
    }
    if (const std::uint64_t count = subdividedCount(subdivision); count > most) {
        return tooManyLevels("The final polygon would have " + std::to_string(count) +
                             " points; it can have " + std::to_string(most) + ".");
    }
    return Done{};
}

Vec3 continuedVertex(const CurveSubdivision& subdivision, std::ptrdiff_t i) noexcept {
    return continued(subdivision.points.data(),
                     static_cast<std::ptrdiff_t>(subdivision.points.size()), subdivision.closed, i);
}

SubdivisionMask subdivisionMask(const CurveSubdivision& subdivision) noexcept {
    SubdivisionMask mask = subdivision.scheme == CurveScheme::fourPoint
                               ? fourPointMask(subdivision.tension)
                               : splineMask(splineDegree(subdivision));
    mask.lost = lostPerLevel(subdivision);
    return mask;
}

FinalPolygon::FinalPolygon(const CurveSubdivision& subdivision)
    : scheme_(subdivision.scheme),
      degree_(splineDegree(subdivision)),
      closed_(subdivision.closed),
      mask_(subdivisionMask(subdivision)),
      localLevels_(std::min(subdivision.levels, mostLocalLevels)),
      size_(static_cast<std::size_t>(subdividedCount(subdivision))) {
    std::size_t count = subdivision.points.size();
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double>& row = base_[static_cast<std::size_t>(axis)];
        row.resize(padBefore(mask_) + count + padAfter(mask_));
        for (std::size_t i = 0; i < count; ++i) {
            row[padBefore(mask_) + i] = subdivision.points[i][axis];
        }
    }
    pad(base_, count);
    for (int level = localLevels_; level < subdivision.levels; ++level) {
        base_ = refined(base_, count);
        count = 2 * count - mask_.lost;
        pad(base_, count);
    }
}

void FinalPolygon::pad(Rows& rows, std::size_t count) const noexcept {
    const auto before = static_cast<std::ptrdiff_t>(padBefore(mask_));
    const auto after = static_cast<std::ptrdiff_t>(padAfter(mask_));
    const auto size = static_cast<std::ptrdiff_t>(count);
    for (std::vector<double>& row : rows) {
        double* p = row.data() + before;
        for (std::ptrdiff_t i = -before; i < 0; ++i) p[i] = continued(p, size, closed_, i);
        for (std::ptrdiff_t i = size; i < size + after; ++i) p[i] = continued(p, size, closed_, i);
    }
}

FinalPolygon::Rows FinalPolygon::refined(const Rows& coarse, std::size_t count) const {
    const std::size_t points = 2 * count - mask_.lost;
    const std::size_t before = padBefore(mask_);
    Rows fine;
    withKernel(scheme_, degree_, mask_, [&](const auto& kernel) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            fine[axis].resize(before + points + padAfter(mask_));
            refineRow(kernel, coarse[axis].data() + before - mask_.lead, (points + 3) / 4,
                      fine[axis].data() + before);
        }
    });
    return fine;
}

void FinalPolygon::points(std::size_t first, std::span<double> xyz) const noexcept {
    const std::size_t total = xyz.size() / 3;
    for (std::size_t done = 0; done < total; done += blockSize) {
        const std::size_t count = std::min(blockSize, total - done);
        if (count % 4 == 0) {
            block(first + done, count, xyz.data() + 3 * done);
        } else {
            std::array<double, 3 * blockSize> whole;  // kernels write four points at a time
            block(first + done, count, whole.data());
            std::copy_n(whole.data(), 3 * count, xyz.data() + 3 * done);
        }
    }
}

void FinalPolygon::block(std::size_t first, std::size_t points, double* xyz) const noexcept {
    const std::size_t before = padBefore(mask_);
    if (localLevels_ == 0) {
        for (std::size_t i = 0; i < points; ++i) {
            for (const auto& row : base_) *xyz++ = row[before + first + i];
        }
        return;
    }
    const auto levels = static_cast<std::size_t>(localLevels_);
    const Plan plan = planOf(mask_, levels, first, points);
    std::array<const double*, 3> from;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        from[axis] = base_[axis].data() + static_cast<std::ptrdiff_t>(before) + plan.start;
    }
    std::array<std::array<std::array<double, rowSize>, 3>, 2> scratch;
    withKernel(scheme_, degree_, mask_, [&](const auto& kernel) {
        for (std::size_t level = 0; level + 1 < levels; ++level) {
            const Part& part = plan.parts[level];
            const std::ptrdiff_t wanted =
                plan.parts[level + 1].start / 2 - static_cast<std::ptrdiff_t>(mask_.lead);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                double* to = scratch[level % 2][axis].data();
                refineRow(kernel, from[axis], part.pairs, to);
                from[axis] = to + (wanted - part.start);
            }
        }
        refineTriples(kernel, from, plan.parts[levels - 1].pairs, xyz);
    });
}

}  // namespace knotwork
