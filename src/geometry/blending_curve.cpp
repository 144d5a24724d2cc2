#include "geometry/blending_curve.hpp"

#include "geometry/curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace knotwork {

namespace {

constexpr std::size_t maximumLocals = 10'000;
constexpr double maximumParameter = 1e9;
constexpr std::size_t maximumRows = 26;  // derivatives up to the 25th

Result<Done> checkCount(std::size_t count) {
    if (count >= 2 && count <= maximumLocals) return Done{};
    return refuse(count > maximumLocals ? Code::tooLarge : Code::outOfRange, "locals.count",
                  std::to_string(count) + " local curves; a blending curve has 2 to 10000.");
}

Result<Done> checkOneKnot(std::span<const double> knots, std::size_t i) {
    const std::string path = indexed("knots", i);
    const double t = knots[i];
    if (!std::isfinite(t)) {
        return refuse(Code::notFinite, path, "The knot is " + formatNumber(t) + ", not a number.");
    }
    if (std::abs(t) > maximumParameter) {
        return refuse(Code::outOfRange, path,
                      "The knot is " + formatNumber(t) + "; knots lie within ±1e9.");
    }
    if (i > 0 && t < knots[i - 1]) {
        return refuse(Code::knotsDecreasing, path,
                      "The knot " + formatNumber(t) + " comes after " +
                          formatNumber(knots[i - 1]) + "; knots must not decrease.");
    }
    if (i > 1 && t == knots[i - 2]) {
        return refuse(Code::knotsMultiplicity, path,
                      "The knot " + formatNumber(t) +
                          " stands three times; two equal knots make a break, more have no meaning.");
    }
    return Done{};
}

Result<Done> checkGaps(std::span<const double> knots) {
    const double length = knots.back() - knots.front();
    const double largest = std::max(std::abs(knots.front()), std::abs(knots.back()));
    if (!(length >= 1e-6) || length < 1e-9 * largest) {
        return refuse(Code::outOfRange, "knots",
                      "The knots span only " + formatNumber(length) +
                          "; the domain must be at least 1e-6 and 1e-9 of the largest knot.");
    }
    const double least =
        std::max(1e-12 * length, 8 * std::numeric_limits<double>::epsilon() * largest);
    for (std::size_t i = 1; i < knots.size(); ++i) {
        const double gap = knots[i] - knots[i - 1];
        if (gap != 0 && gap < least) {
            return refuse(Code::outOfRange, indexed("knots", i),
                          "The knot lies " + formatNumber(gap) +
                              " after the one before it; make them equal or part them by at least " +
                              formatNumber(least) + ".");
        }
    }
    return Done{};
}

Result<Done> checkKnots(std::span<const double> knots, std::size_t count, BlendForm form) {
    const std::size_t needed = form == BlendForm::closed ? count + 1 : count;
    if (knots.size() != needed) {
        return refuse(Code::knotsCount, "knots",
                      std::to_string(knots.size()) + " knots for " + std::to_string(count) +
                          " local curves; " +
                          (form == BlendForm::closed ? "a closed" : "an open") +
                          " blending curve needs " + std::to_string(needed) + ".");
    }
    for (std::size_t i = 0; i < knots.size(); ++i) {
        if (auto checked = checkOneKnot(knots, i); !checked) return checked;
    }
    const bool seamIsDouble = form == BlendForm::closed && knots[0] == knots[1] &&
                              knots[needed - 1] == knots[needed - 2];
    if (seamIsDouble) {
        return refuse(Code::knotsMultiplicity, indexed("knots", needed - 1),
                      "The seam of a closed curve is one knot: it is doubled at both ends, which "
                      "makes three equal knots.");
    }
    return checkGaps(knots);
}

Result<Done> checkPoses(std::span<const Pose> poses, std::size_t count) {
    if (!poses.empty() && poses.size() != count) {
        return refuse(Code::wrongLength, "poses", "There must be one pose for each local curve.");
    }
    for (std::size_t j = 0; j < poses.size(); ++j) {
        if (auto checked = checkPose(poses[j]); !checked) {
            return checked.error().under(indexed("poses", j));
        }
    }
    return Done{};
}

std::vector<double> uniformKnots(const Interval& over, std::size_t number) {
    std::vector<double> knots(number);
    for (std::size_t i = 0; i < number; ++i) knots[i] = uniformParameter(over, i, number);
    return knots;
}

const Pose& poseOf(std::span<const Pose> poses, std::size_t j) {
    static constexpr Pose rest{};
    return poses.empty() ? rest : poses[j];
}

Interval supportOf(std::span<const double> knots, std::size_t j, BlendForm form) noexcept {
    const std::size_t last = knots.size() - 1;
    if (form == BlendForm::open) {
        return {knots[j == 0 ? 0 : j - 1], knots[std::min(j + 1, last)]};
    }
    const double period = knots.back() - knots.front();
    return {j == 0 ? knots[last - 1] - period : knots[j - 1], knots[j + 1]};
}

/// From where a local curve is seen: the left where nothing of it is to the right of its knot.
Side seenFrom(std::span<const double> knots, std::size_t j) noexcept {
    return j + 1 == knots.size() || knots[j + 1] == knots[j] ? Side::left : Side::right;
}

double binomial(std::size_t n, std::size_t k) noexcept {
    double value = 1;
    for (std::size_t i = 1; i <= k; ++i) {
        value = value * static_cast<double>(n - k + i) / static_cast<double>(i);
    }
    return value;
}

/// rows of first + B (second − first) by Leibniz' rule; `blend[l]` is the l-th derivative of B with
/// respect to the global parameter. `first` and the result may be the same rows. The convex form of
/// the zeroth term gives each local curve exactly where B is 0 or 1.
void leibniz(std::span<const double> blend, std::span<const Vec3> first,
             std::span<const Vec3> second, std::span<Vec3> rows) noexcept {
    for (std::size_t j = rows.size(); j-- > 0;) {
        Vec3 sum = (1 - blend[0]) * first[j] + blend[0] * second[j];
        for (std::size_t l = 1; l <= j; ++l) {
            sum += binomial(j, l) * blend[l] * (second[j - l] - first[j - l]);
        }
        rows[j] = sum;
    }
}

/// A local curve's point on one side of a knot of its source.
Vec3 placedPoint(const LocalCurve& local, double t, Side side) noexcept {
    Vec3 point;
    local.evaluate(t, side, {&point, 1});
    return point;
}

/// The blend of two placements of one point of the model that both locals are cut from.
Vec3 blendedPoint(double weight, const LocalCurve& first, const LocalCurve& second, double t,
                  Side side) noexcept {
    Vec3 point;
    evaluate(first.source(), first.rate() * t + first.shift(), side, {&point, 1});
    return (1 - weight) * first.placement().point(point) + weight * second.placement().point(point);
}

}  // namespace

BlendingCurve::BlendingCurve(std::shared_ptr<const Curve> model, std::vector<LocalCurve> locals,
                             BlendForm form, BFunction blend, std::vector<double> knots)
    : model_(std::move(model)), form_(form), blend_(std::move(blend)), knots_(std::move(knots)) {
    const bool planar = std::all_of(locals.begin(), locals.end(),
                                    [](const LocalCurve& local) { return local.planar(); });
    dimension_ = planar ? 2 : 3;
    locals_ = std::make_shared<const std::vector<LocalCurve>>(std::move(locals));
}

Result<BlendingCurve> BlendingCurve::fromModel(Curve model, std::size_t count, BlendForm form,
                                               BFunction blend, std::vector<double> knots,
                                               std::span<const Pose> poses) {
    if (auto checked = checkCount(count); !checked) return checked.error();
    if (auto checked = checkPoses(poses, count); !checked) return checked.error();
    if (knots.empty()) {
        knots = uniformKnots(knotwork::domain(model), form == BlendForm::closed ? count + 1 : count);
    }
    if (auto checked = checkKnots(knots, count, form); !checked) return checked.error();
    const auto shared = std::make_shared<const Curve>(std::move(model));
    std::vector<LocalCurve> locals;
    locals.reserve(count);
    for (std::size_t j = 0; j < count; ++j) {
        locals.emplace_back(shared, 1.0, 0.0, knots[j], seenFrom(knots, j), poseOf(poses, j),
                            supportOf(knots, j, form));
    }
    return BlendingCurve(shared, std::move(locals), form, std::move(blend), std::move(knots));
}

Result<BlendingCurve> BlendingCurve::fromLocals(std::vector<Curve> sources, BlendForm form,
                                                BFunction blend, std::vector<double> knots,
                                                bool fit, std::span<const Pose> poses) {
    const std::size_t count = sources.size();
    if (auto checked = checkCount(count); !checked) {
        return refuse(checked.error().code, "locals", checked.error().message);
    }
    if (auto checked = checkPoses(poses, count); !checked) return checked.error();
    if (knots.empty()) {
        const std::size_t number = form == BlendForm::closed ? count + 1 : count;
        knots = uniformKnots({0, static_cast<double>(number - 1)}, number);
    }
    if (auto checked = checkKnots(knots, count, form); !checked) return checked.error();
    std::vector<LocalCurve> locals;
    locals.reserve(count);
    for (std::size_t j = 0; j < count; ++j) {
        double rate = 1;
        double shift = 0;
        if (fit) {
            const Interval from = knotwork::domain(sources[j]);
            const Interval onto = supportOf(knots, j, form);
            // A support of length zero lies at a doubled end knot, where the local is never seen.
            rate = onto.length() > 0 ? from.length() / onto.length() : 1;
            shift = from.start - rate * onto.start;
        }
        locals.emplace_back(std::make_shared<const Curve>(std::move(sources[j])), rate, shift,
                            knots[j], seenFrom(knots, j), poseOf(poses, j),
                            supportOf(knots, j, form));
    }
    return BlendingCurve(nullptr, std::move(locals), form, std::move(blend), std::move(knots));
}

/// Where t falls: between local `first`, centred at `start`, and local `second`, which is evaluated
/// at t − shift (the period for a closed curve's wrapped local, otherwise 0).
struct BlendingCurve::Span {
    std::size_t first = 0;
    std::size_t second = 0;
    double start = 0;
    double length = 1;
    double shift = 0;
    double t = 0;  // wrapped into the domain
};

BlendingCurve::Span BlendingCurve::spanAt(double t, Side side) const noexcept {
    const double from = knots_.front();
    const double to = knots_.back();
    const double period = to - from;
    if (closed()) {
        const bool inside = side == Side::right ? from <= t && t < to : from < t && t <= to;
        if (!inside) {
            t -= period * std::floor((t - from) / period);
            if (side == Side::right && t >= to) t = from;
            if (side == Side::left && t <= from) t = to;
        }
    }
    const auto begin = knots_.begin();
    auto after = side == Side::right ? std::upper_bound(begin, knots_.end(), t)
                                     : std::lower_bound(begin, knots_.end(), t);
    std::size_t end = std::clamp<std::size_t>(static_cast<std::size_t>(after - begin), 1,
                                              knots_.size() - 1);
    // Only at the two ends can the span found be empty (a double end knot): go inwards.
    while (knots_[end] == knots_[end - 1] && knots_[end] < to) ++end;
    while (knots_[end] == knots_[end - 1]) --end;
    const bool wraps = closed() && end == locals_->size();
    return {end - 1, wraps ? 0 : end, knots_[end - 1], knots_[end] - knots_[end - 1],
            wraps ? period : 0, t};
}

void BlendingCurve::evaluate(double t, Side side, std::span<Vec3> rows) const noexcept {
    const Span span = spanAt(t, side);
    const LocalCurve& first = (*locals_)[span.first];
    const LocalCurve& second = (*locals_)[span.second];
    // Sub-curves of one model need the model only once: the blend is one of affine maps.
    const bool oneModel = span.shift == 0 && first.runsWith(second);
    if (rows.size() == 1) {
        const double weight = blend_.value((span.t - span.start) / span.length);
        rows[0] = oneModel ? blendedPoint(weight, first, second, span.t, side)
                           : (1 - weight) * placedPoint(first, span.t, side) +
                                 weight * placedPoint(second, span.t - span.shift, side);
        return;
    }
    std::array<double, maximumRows> blend{};
    const std::span<double> blendRows(blend.data(), rows.size());
    blend_.derivatives((span.t - span.start) / span.length, blendRows);
    double power = 1;
    for (double& row : blendRows) {
        row *= power;
        power /= span.length;
    }
    std::array<Vec3, maximumRows> secondRows{};
    const std::span<Vec3> others(secondRows.data(), rows.size());
    if (oneModel) {
        knotwork::evaluate(first.source(), first.rate() * span.t + first.shift(), side, rows);
        std::copy(rows.begin(), rows.end(), others.begin());
        second.place(others);
        first.place(rows);
    } else {
        first.evaluate(span.t, side, rows);
        second.evaluate(span.t - span.shift, side, others);
    }
    leibniz(blendRows, rows, others, rows);
}

void BlendingCurve::points(std::span<const double> ts, std::span<Vec3> out) const noexcept {
    for (std::size_t i = 0; i < ts.size(); ++i) {
        const Side side = ts[i] == knots_.back() ? Side::left : Side::right;
        evaluate(ts[i], side, out.subspan(i, 1));
    }
}

std::vector<double> BlendingCurve::blendBasis(double t) const {
    const Span span = spanAt(t, t == knots_.back() ? Side::left : Side::right);
    std::vector<double> weights(locals_->size(), 0.0);
    const double value = blend_.value((span.t - span.start) / span.length);
    weights[span.first] += 1 - value;
    weights[span.second] += value;
    return weights;
}

Interval BlendingCurve::support(std::size_t j) const noexcept {
    return supportOf(knots_, j, form_);
}

BlendingCurve BlendingCurve::withPoses(std::span<const Pose> poses) const {
    std::vector<LocalCurve> posed;
    posed.reserve(locals_->size());
    for (std::size_t j = 0; j < locals_->size(); ++j) {
        posed.push_back((*locals_)[j].withPose(poses[j]));
    }
    return BlendingCurve(model_, std::move(posed), form_, blend_, knots_);
}

}  // namespace knotwork
