// The bytes of a fuzzer as numbers and splines, and the check that ends the run.
//
// When the bytes have been used up, zeros follow: every input is a case, and a longer one begins as
// the shorter did.
#pragma once

#include "geometry/b_function.hpp"
#include "geometry/bspline_curve.hpp"
#include "geometry/pose.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>
#include <vector>

namespace knotwork::fuzz {

/// Ends the program with a sentence where an identity does not hold.
inline void check(bool holds, const char* sentence, double found = 0, double allowed = 0) {
    if (holds) return;
    std::fprintf(stderr, "\nDoes not hold: %s (%.17g, allowed %.3g)\n", sentence, found, allowed);
    std::abort();
}

/// Not within: a NaN is not within anything.
inline void checkWithin(double found, double allowed, const char* sentence) {
    check(found <= allowed, sentence, found, allowed);
}

class Input {
public:
    Input(const std::uint8_t* data, std::size_t size) : bytes_(data, size) {}

    [[nodiscard]] bool empty() const noexcept { return bytes_.empty(); }

    std::uint8_t byte() {
        if (bytes_.empty()) return 0;
        const std::uint8_t first = bytes_.front();
        bytes_ = bytes_.subspan(1);
        return first;
    }
    int whole(int from, int to) { return from + byte() % (to - from + 1); }

    /// Any double at all.
    double anyNumber() {
        std::uint8_t raw[8];
        for (std::uint8_t& one : raw) one = byte();
        double value = 0;
        std::memcpy(&value, raw, sizeof value);
        return value;
    }
    /// In [0, 1], by 16 bits.
    double share() { return (256 * byte() + byte()) / 65535.0; }
    /// In [−1, 1].
    double real() { return 2 * share() - 1; }

    /// 0, or between `least` and 1, of any magnitude between.
    double gap(double least) {
        const int kind = byte();
        if (kind < 80) return 0;
        if (kind < 170) return 0.125 + share();
        return std::pow(least, share());
    }

private:
    std::span<const std::uint8_t> bytes_;
};

/// A spline of at most 24 points, most of them valid. Coordinates in [−1, 1], weights 1/4 … 4.
inline Result<BsplineCurve> splineOf(Input& input, int maxDegree) {
    const int degree = input.whole(1, maxDegree);
    const auto form = static_cast<Form>(input.whole(0, 2));
    const int count = input.whole(degree + 1, std::max(degree + 1, 24));
    const bool rational = input.whole(0, 3) == 0;
    const double start = input.whole(0, 7) == 0 ? 1e6 * input.real() : input.real();
    std::vector<double> knots{start};
    while (knots.size() < KnotVector::knotCount(degree, count, form)) {
        const auto index = static_cast<int>(knots.size());
        const bool joined = form == Form::clamped && (index <= degree || index > count);
        knots.push_back(knots.back() + (joined ? 0 : input.gap(1e-10)));
    }
    auto vector = KnotVector::make(std::move(knots), degree, count, form);
    if (!vector) return vector.error();
    std::vector<Vec3> points;
    std::vector<double> weights;
    for (int i = 0; i < count; ++i) {
        const double x = input.real();
        const double y = input.real();
        points.emplace_back(x, y, input.real());
        if (rational) weights.push_back(std::pow(4.0, input.real()));
    }
    return BsplineCurve::make(std::move(vector).value(), std::move(points), 3, std::move(weights));
}

/// Both ends, every knot and its neighbours in the domain, and some others.
inline std::vector<double> parametersOf(Input& input, const Interval& domain,
                                        std::span<const double> knots) {
    std::vector<double> ts{domain.start, domain.end};
    for (const double knot : knots) {
        for (const double t : {std::nextafter(knot, -1e300), knot, std::nextafter(knot, 1e300)}) {
            if (domain.contains(t)) ts.push_back(t);
        }
    }
    for (int i = 0; i < 4; ++i) {
        // The sum rounds, at times past the end.
        ts.push_back(std::min(domain.start + domain.length() * input.share(), domain.end));
    }
    return ts;
}

/// None, or any: turned, moved, and scaled in its plane.
inline Pose poseOf(Input& input) {
    Pose pose;
    if (input.whole(0, 1) == 0) return pose;
    pose.translate = {input.real(), input.real(), input.real()};
    pose.axis = {input.real(), input.real(), input.real()};
    pose.angle = 10 * input.real();
    pose.scale = {2 * input.real(), 2 * input.real(), 1};
    return pose;
}

/// Families and operations up to four deep; refused ones are linear.
inline BFunction blendOf(Input& input, int depth = 3) {
    const auto orLinear = [](Result<BFunction> made) { return made ? *made : BFunction(); };
    switch (input.whole(0, depth > 0 ? 9 : 5)) {
        case 0:
            return BFunction();
        case 1:
            return orLinear(BFunction::makeTrigonometric(input.whole(1, 20)));
        case 2: {
            const int p = input.whole(0, 20);
            return orLinear(BFunction::makePolynomial(p, input.whole(0, 20)));
        }
        case 3:
            return orLinear(BFunction::makeRational(1 + 49 * input.share(), 4 * input.share()));
        case 4: {
            const double alpha = 4 * input.share();
            const double beta = 100 * input.share();
            const double gamma = 4 * input.share();
            return orLinear(BFunction::makeExpoRational(alpha, beta, gamma, input.share()));
        }
        case 5:
            return orLinear(BFunction::makeLogistic(1000 * input.share()));
        case 6:
            return orLinear(BFunction::makeDual(blendOf(input, depth - 1)));
        case 7:
            return orLinear(BFunction::makeSymmetrised(blendOf(input, depth - 1)));
        case 8: {
            const BFunction outer = blendOf(input, depth - 1);
            return orLinear(BFunction::makeComposed(outer, blendOf(input, depth - 1)));
        }
        default: {
            const BFunction first = blendOf(input, depth - 1);
            return orLinear(BFunction::makeMixed(first, blendOf(input, depth - 1), input.share()));
        }
    }
}

}  // namespace knotwork::fuzz
