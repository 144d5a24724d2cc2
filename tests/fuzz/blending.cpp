// Blends of any models, knots, poses and B-functions: refused, or a curve that is the sum of its
// local curves by weights that sum to one, whole at every knot.
#include "fuzz/input.hpp"

#include "geometry/curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>

using namespace knotwork;

namespace {

constexpr double rounding = 1e-9;  // relative to the size of the local curves

Curve modelOf(fuzz::Input& input) {
    static constexpr const char* names[] = {"circle",  "helix", "butterfly", "lissajous",
                                            "viviani", "rose",  "spiral",    "torus-knot"};
    if (input.whole(0, 2) > 0) {
        if (auto spline = fuzz::splineOf(input, 5)) return Curve(*std::move(spline));
    }
    return Curve(ParametricCurve::make(names[input.whole(0, 7)]).value());
}

std::vector<double> knotsOf(fuzz::Input& input, const Interval& domain, std::size_t number) {
    if (input.whole(0, 3) == 0) return {};
    std::vector<double> knots{domain.start + domain.length() * input.real() / 4};
    while (knots.size() < number) {
        knots.push_back(knots.back() + domain.length() * input.gap(1e-11));
    }
    if (input.whole(0, 15) == 0) knots[input.byte() % number] = input.anyNumber();
    return knots;
}

/// Whether knots lie where the model is: far from it, polynomials of degree 25 overflow, and
/// rational ones have poles wherever they are continued.
bool near(const Interval& knots, const Curve& model) {
    const auto* spline = model.as<BsplineCurve>();
    const bool rational = spline != nullptr && spline->rational() && !spline->closed();
    const Interval whole = domain(model);
    const double reach = rational ? 0 : 100 * whole.length();
    return knots.start >= whole.start - reach && knots.end <= whole.end + reach;
}

/// Σ weight · local, each local where the curve takes it, and the size of what is summed.
void checkSum(const BlendingCurve& curve, double t) {
    const auto weights = curve.blendBasis(t);
    const double period = curve.domain().length();
    const Side side = t == curve.domain().end ? Side::left : Side::right;
    const bool last = curve.closed() && t >= curve.knots()[curve.knots().size() - 2];
    Vec3 sum(0);
    double total = 0;
    double size = 1;
    for (std::size_t j = 0; j < weights.size(); ++j) {
        fuzz::check(weights[j] >= 0, "weights are not negative", weights[j]);
        total += weights[j];
        if (weights[j] == 0) continue;
        const bool wraps = last && j == 0;
        Vec3 point;
        curve.locals()[j].evaluate(wraps ? t - period : t, side, {&point, 1});
        size = std::max(size, glm::length(point));
        sum += weights[j] * point;
    }
    fuzz::checkWithin(std::abs(total - 1), 1e-14, "weights sum to one");
    Vec3 found;
    curve.evaluate(t, side, {&found, 1});
    fuzz::checkWithin(glm::length(found - sum) / size, rounding, "the curve is the weighted sum");
}

void checkRows(const BlendingCurve& curve, double t) {
    for (const Side side : {Side::left, Side::right}) {
        std::array<Vec3, 4> rows;
        std::array<Vec3, 1> point;
        curve.evaluate(t, side, rows);
        curve.evaluate(t, side, point);
        fuzz::check(isFinite(rows[0]), "every point is finite");
        const double size = 1 + glm::length(rows[0]);
        fuzz::checkWithin(glm::length(rows[0] - point[0]) / size, rounding,
                          "a point alone is the first of the rows");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Input input(data, size);
    const Curve model = modelOf(input);
    const auto count = static_cast<std::size_t>(input.whole(0, 12));
    const BlendForm form = input.whole(0, 1) == 0 ? BlendForm::open : BlendForm::closed;
    const BFunction blend = fuzz::blendOf(input);
    const std::size_t number = count + (form == BlendForm::closed ? 1 : 0);
    std::vector<double> knots = knotsOf(input, domain(model), std::max<std::size_t>(number, 1));
    std::vector<Pose> poses;
    for (std::size_t j = 0; j < count; ++j) poses.push_back(fuzz::poseOf(input));
    const auto kind = static_cast<LocalKind>(input.whole(0, 4));
    const int highest = kind == LocalKind::bspline ? 7 : maxDegree;
    const LocalCut cut{kind, static_cast<std::size_t>(input.whole(1, highest))};
    const auto curve = BlendingCurve::fromModel(model, count, form, blend, knots, poses, cut);
    if (!curve) {
        fuzz::check(curve.error().message.size() > 10, "a refusal says why");
        return 0;
    }
    if (!near(curve->domain(), model)) return 0;
    for (const double t : fuzz::parametersOf(input, curve->domain(), curve->knots())) {
        checkRows(*curve, t);
        if (curve->domain().contains(t)) checkSum(*curve, t);
    }
    return 0;
}
