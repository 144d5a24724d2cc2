// Knots put into splines of every form: refused, or the same curve from both sides of every knot.
#include "fuzz/input.hpp"

#include "geometry/refinement.hpp"

#include <algorithm>
#include <limits>

using namespace knotwork;

namespace {

constexpr double rounding = 1e-11;  // up to degree 25, with weights from 1/4 to 4

/// The knots of a closed curve are repeated a period on, where they are rounded: that moves the
/// curve by as much as it is of the smallest span.
double seamRounding(const KnotVector& knots) {
    if (!knots.closed()) return 0;
    const auto t = knots.extended();
    const double largest = std::max(std::abs(t.front()), std::abs(t.back()));
    double smallest = knots.period();
    for (std::size_t i = 1; i < t.size(); ++i) {
        if (t[i] > t[i - 1]) smallest = std::min(smallest, t[i] - t[i - 1]);
    }
    return 100 * std::numeric_limits<double>::epsilon() * largest / smallest;
}

void checkSame(fuzz::Input& input, const BsplineCurve& a, const BsplineCurve& b) {
    fuzz::check(a.domain() == b.domain(), "refinement keeps the domain");
    const double allowed = rounding + seamRounding(b.knotVector());
    for (const double t : fuzz::parametersOf(input, a.domain(), b.knotVector().knots())) {
        for (const Side side : {Side::left, Side::right}) {
            Vec3 before;
            Vec3 after;
            a.derivatives(t, side, {&before, 1});
            b.derivatives(t, side, {&after, 1});
            fuzz::checkWithin(glm::length(before - after), allowed, "refinement keeps the curve");
        }
    }
}

double anyKnot(fuzz::Input& input, const BsplineCurve& curve) {
    const Interval domain = curve.domain();
    switch (input.whole(0, 5)) {
        case 0:
            return input.anyNumber();
        case 1:
        case 2: {
            const auto knots = curve.knotVector().knots();
            return knots[input.byte() % knots.size()];
        }
        default:
            return domain.start + domain.length() * input.share();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Input input(data, size);
    const auto made = fuzz::splineOf(input, 25);
    if (!made) return 0;
    BsplineCurve curve = *made;
    for (int i = input.whole(1, 4); i > 0; --i) {
        const double t = anyKnot(input, curve);
        const int times = input.whole(-1, 26);
        const auto refined = insertKnot(curve, t, times);
        if (!refined) {
            fuzz::check(refined.error().path == "t" || refined.error().path == "times",
                        "a refusal names its argument");
            continue;
        }
        fuzz::check(
            refined->points().size() == curve.points().size() + static_cast<std::size_t>(times),
            "every knot brings a point");
        curve = *refined;
    }
    checkSame(input, *made, curve);
    return 0;
}
