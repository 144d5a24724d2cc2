#include "geometry/blending_curve.hpp"

#include "geometry/curve.hpp"
#include "geometry/local_cuts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace knotwork {

namespace {

constexpr std::size_t maximumLocals = 10'000;
constexpr std::size_t maximumRows = 26;  // derivatives up to the 25th

Result<Done> checkCount(std::size_t count) {
    if (count >= 2 && count <= maximumLocals) return Done{};
    return refuse(count > maximumLocals ? Code::tooLarge : Code::outOfRange, "locals.count",
                  std::to_string(count) + " local curves; a blending curve has 2 to 10000.");
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

const Pose& poseOf(std::span<const Pose> poses, std::size_t j) {
    static constexpr Pose rest{};
    return poses.empty() ? rest : poses[j];
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

/// Adds the breaks of a local curve that is evaluated at t − shift, those inside `over`.
void addBreaks(const LocalCurve& local, const Interval& over, double shift,
               std::vector<double>& breaks) {
    const Interval part{local.sourceParameter(over.start - shift),
                        local.sourceParameter(over.end - shift)};
    for (const double knot : breakParameters(local.source(), part)) {
        breaks.push_back((knot - local.shift()) / local.rate() + shift);
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
    setLocals(std::move(locals));
    findBreaks();
}

void BlendingCurve::setLocals(std::vector<LocalCurve> locals) {
    const bool planar = std::all_of(locals.begin(), locals.end(),
                                    [](const LocalCurve& local) { return local.planar(); });
    dimension_ = planar ? 2 : 3;
    locals_ = std::make_shared<const std::vector<LocalCurve>>(std::move(locals));
}

void BlendingCurve::findBreaks() {
    auto breaks = std::make_shared<std::vector<double>>();
    std::vector<double> inside;
    for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
        const Interval over{knots_[i], knots_[i + 1]};
        breaks->push_back(over.start);
        if (!(over.length() > 0)) continue;
        const Span span = spanAt(over.start, Side::right);
        const LocalCurve& first = (*locals_)[span.first];
        const LocalCurve& second = (*locals_)[span.second];
        inside.clear();
        addBreaks(first, over, 0, inside);
        if (span.shift != 0 || !first.runsWith(second)) addBreaks(second, over, span.shift, inside);
        std::sort(inside.begin(), inside.end());
        for (const double t : inside) {
            // One break that comes by two ways differs by rounding.
            const double rounding = 1e-14 * std::max(std::abs(over.start), std::abs(over.end));
            if (t > breaks->back() + rounding && t < over.end - rounding) breaks->push_back(t);
        }
    }
    breaks->push_back(knots_.back());
    breaks_ = std::move(breaks);
}

Result<BlendingCurve> BlendingCurve::fromModel(Curve model, std::size_t count, BlendForm form,
                                               BFunction blend, std::vector<double> knots,
                                               std::span<const Pose> poses, const LocalCut& cut) {
    if (auto checked = checkCount(count); !checked) return checked.error();
    if (auto checked = checkPoses(poses, count); !checked) return checked.error();
    if (knots.empty()) {
        knots = uniformKnots(knotwork::domain(model), blendingKnotCount(count, form));
    }
    if (auto checked = checkBlendingKnots(knots, count, form); !checked) return checked.error();
    const auto shared = std::make_shared<const Curve>(std::move(model));
    const LocalCutter cutter(*shared, cut);
    std::vector<LocalCurve> locals;
    locals.reserve(count);
    for (std::size_t j = 0; j < count; ++j) {
        const Side side = blendingSide(knots, j);
        const Interval over = blendingDomain(knots, j, form);
        std::shared_ptr<const Curve> source = shared;
        if (cut.kind != LocalKind::subCurve) {
            auto made = cutter.at(knots[j], side, over);
            if (!made) return made.error();
            source = std::make_shared<const Curve>(std::move(*made));
        }
        locals.emplace_back(std::move(source), 1.0, 0.0, knots[j], side, poseOf(poses, j), over);
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
        const std::size_t number = blendingKnotCount(count, form);
        knots = uniformKnots({0, static_cast<double>(number - 1)}, number);
    }
    if (auto checked = checkBlendingKnots(knots, count, form); !checked) return checked.error();
    std::vector<LocalCurve> locals;
    locals.reserve(count);
    for (std::size_t j = 0; j < count; ++j) {
        const Interval over = blendingDomain(knots, j, form);
        double rate = 1;
        double shift = 0;
        if (fit) {
            const Interval from = knotwork::domain(sources[j]);
            rate = from.length() / over.length();
            shift = from.start - rate * over.start;
        }
        // Neighbours that are copies of one curve run on one source.
        const bool same = j > 0 && &sources[j].kind() == &locals.back().source().kind();
        auto source = same ? locals.back().sharedSource()
                           : std::make_shared<const Curve>(sources[j]);
        locals.emplace_back(std::move(source), rate, shift, knots[j], blendingSide(knots, j),
                            poseOf(poses, j), over);
    }
    return BlendingCurve(nullptr, std::move(locals), form, std::move(blend), std::move(knots));
}

BlendingSpan BlendingCurve::spanAt(double t, Side side) const noexcept {
    return blendingSpan(knots_, form_, t, side);
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
    std::array<Vec3, maximumRows> secondRows;
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

std::vector<double> BlendingCurve::blendBasis(double t) const {
    const Span span = spanAt(t, t == knots_.back() ? Side::left : Side::right);
    std::vector<double> weights(locals_->size(), 0.0);
    const double value = blend_.value((span.t - span.start) / span.length);
    weights[span.first] += 1 - value;
    weights[span.second] += value;
    return weights;
}

BlendingCurve BlendingCurve::withPoses(std::span<const Pose> poses) const {
    std::vector<LocalCurve> posed;
    posed.reserve(locals_->size());
    for (std::size_t j = 0; j < locals_->size(); ++j) {
        posed.push_back((*locals_)[j].withPose(poses[j]));
    }
    BlendingCurve moved = *this;
    moved.setLocals(std::move(posed));
    return moved;
}

BlendingCurve BlendingCurve::withLocals(std::vector<LocalCurve> locals) const {
    BlendingCurve other = *this;
    for (LocalCurve& local : locals) local = local.withBreaks();
    other.setLocals(std::move(locals));
    other.findBreaks();
    return other;
}

}  // namespace knotwork
