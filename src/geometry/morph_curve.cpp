#include "geometry/morph_curve.hpp"

#include "geometry/curve.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace knotwork {

namespace {

/// The map of one interval onto another.
struct Onto {
    double rate = 1;
    double shift = 0;

    Onto(const Interval& from, const Interval& to) noexcept
        : rate(to.length() / from.length()), shift(to.start - rate * from.start) {
        if (from == to) *this = Onto();  // exactly
    }

private:
    constexpr Onto() noexcept = default;
};

std::shared_ptr<const Curve> between(std::shared_ptr<const Curve> from,
                                     const std::shared_ptr<const Curve>& to, double rate,
                                     double shift, double weight) {
    return std::make_shared<const Curve>(MorphCurve(std::move(from), to, rate, shift, weight));
}

Curve morphedBlend(const BlendingCurve& from, const std::shared_ptr<const Curve>& to,
                   double weight) {
    const Onto onto(from.domain(), domain(*to));
    // Local curves that share a source go on sharing one: that is how they are evaluated together.
    std::map<std::array<double, 2>, std::map<const Curve*, std::shared_ptr<const Curve>>> made;
    std::vector<LocalCurve> locals;
    locals.reserve(from.locals().size());
    for (std::size_t j = 0; j < from.locals().size(); ++j) {
        const LocalCurve& local = from.locals()[j];
        std::shared_ptr<const Curve>& source =
            made[{local.rate(), local.shift()}][&local.source()];
        if (source == nullptr) {
            // The source's own parameter s is that of the blend at t = (s − shift)/rate.
            source = between(local.sharedSource(), to, onto.rate / local.rate(),
                             onto.shift - onto.rate * local.shift() / local.rate(), weight);
        }
        locals.push_back(local.withSource(source, from.knots()[j]));
    }
    return from.withLocals(std::move(locals));
}

}  // namespace

MorphCurve::MorphCurve(std::shared_ptr<const Curve> from, std::shared_ptr<const Curve> to,
                       double rate, double shift, double weight)
    : from_(std::move(from)), to_(std::move(to)), rate_(rate), shift_(shift), weight_(weight) {
    const Interval whole = domain();
    breaks_ = breakParameters(*from_, whole);
    for (const double knot :
         breakParameters(*to_, {rate_ * whole.start + shift_, rate_ * whole.end + shift_})) {
        const double t = (knot - shift_) / rate_;
        if (t > whole.start && t < whole.end) breaks_.push_back(t);
    }
    std::sort(breaks_.begin(), breaks_.end());
    breaks_.erase(std::unique(breaks_.begin(), breaks_.end()), breaks_.end());
}

Interval MorphCurve::domain() const noexcept { return knotwork::domain(*from_); }

bool MorphCurve::closed() const noexcept { return isClosed(*from_) && isClosed(*to_); }

int MorphCurve::dimension() const noexcept {
    return std::max(knotwork::dimension(*from_), knotwork::dimension(*to_));
}

void MorphCurve::evaluate(double t, Side side, std::span<Vec3> rows) const noexcept {
    std::array<Vec3, 26> other;
    knotwork::evaluate(*from_, t, side, rows);
    knotwork::evaluate(*to_, rate_ * t + shift_, side, {other.data(), rows.size()});
    double power = weight_;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        rows[k] = (1 - weight_) * rows[k] + power * other[k];
        power *= rate_;
    }
}

Curve morphed(const Curve& from, const Curve& to, double weight) {
    const auto target = std::make_shared<const Curve>(to);
    if (const auto* blend = from.as<BlendingCurve>()) return morphedBlend(*blend, target, weight);
    const Onto onto(domain(from), domain(to));
    return MorphCurve(std::make_shared<const Curve>(from), target, onto.rate, onto.shift, weight);
}

}  // namespace knotwork
