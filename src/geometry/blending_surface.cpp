#include "geometry/blending_surface.hpp"

#include "geometry/surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace knotwork {

namespace {

constexpr std::size_t maximumPatches = 10'000;
constexpr std::size_t maximumCoefficients = 500'000;
constexpr std::size_t maximumRows = maxSurfaceOrder + 1;

// ---- What is refused ---------------------------------------------------------------------------

Result<Done> checkCounts(std::size_t nu, std::size_t nv) {
    for (std::size_t direction = 0; direction < 2; ++direction) {
        const std::size_t count = direction == 0 ? nu : nv;
        if (count >= 2 && count <= maximumPatches) continue;
        return refuse(count < 2 ? Code::outOfRange : Code::tooLarge, indexed("locals", direction),
                      std::to_string(count) +
                          " patches in this direction; a blending surface has at least 2 in each, "
                          "and at most 10000 in all.");
    }
    if (nu * nv <= maximumPatches) return Done{};
    return refuse(Code::tooLarge, "locals",
                  std::to_string(nu) + " by " + std::to_string(nv) +
                      " patches; a blending surface has at most 10000.");
}

Result<Done> checkDegrees(const PatchCut& cut, std::size_t patches) {
    if (cut.kind != PatchKind::bezier) return Done{};
    for (std::size_t direction = 0; direction < 2; ++direction) {
        const int degree = cut.degree[direction];
        if (degree >= 1 && degree <= maxSurfaceOrder) continue;
        return refuse(degree < 1 ? Code::outOfRange : Code::tooLarge, indexed("degree", direction),
                      "The degree is " + std::to_string(degree) + "; Bézier patches have 1 to 25.");
    }
    const std::size_t coefficients = patches * cut.orders().size();
    if (coefficients <= maximumCoefficients) return Done{};
    return refuse(Code::tooLarge, "locals",
                  std::to_string(patches) + " patches of this degree have " +
                      std::to_string(coefficients) +
                      " coefficients; at most 500000 are supported: lower the degree, or cut fewer "
                      "patches.");
}

/// Fills in the knots of direction 0 (u) or 1 (v) where none are given, and checks them.
Result<Done> settleKnots(BlendDirection& along, const Interval& domain, std::size_t direction) {
    const std::size_t needed = blendingKnotCount(along.count, along.form);
    if (along.knots.empty()) along.knots = uniformKnots(domain, needed);
    if (along.knots.size() != needed) {
        return refuse(Code::knotsCount, indexed("knots", direction),
                      std::to_string(along.knots.size()) + " knots for " +
                          std::to_string(along.count) + " patches; " +
                          (along.closed() ? "a closed" : "an open") + " direction needs " +
                          std::to_string(needed) + ".");
    }
    const auto checked = checkBlendingKnots(along.knots, along.count, along.form);
    if (!checked) return ofDirection(checked.error(), direction);
    return Done{};
}

Result<Done> checkPoses(std::span<const Pose> poses, std::size_t count) {
    if (!poses.empty() && poses.size() != count) {
        return refuse(Code::wrongLength, "poses", "There must be one pose for each patch.");
    }
    for (std::size_t k = 0; k < poses.size(); ++k) {
        if (auto checked = checkPose(poses[k]); !checked) {
            return checked.error().under(indexed("poses", k));
        }
    }
    return Done{};
}

// ---- Weights -----------------------------------------------------------------------------------

/// The weights of the two patches that meet in one direction, with derivatives in the parameter of
/// the surface. Sums of weighted patches are taken as base + Σ weight · (patch − base), where the
/// base is the patch that counts more: whatever is the same for all patches is then kept exactly.
struct Weights {
    BlendingSpan span;
    std::size_t base;  // 0 the first, 1 the second
    std::array<double, maximumRows> second;

    Weights(const BlendDirection& along, double t, Side side, int order) noexcept
        : span(along.spanAt(t, side)) {
        const auto rows = std::span<double>(second).first(static_cast<std::size_t>(order) + 1);
        if (order == 0) {
            second[0] = along.blend.value(span.ratio());
        } else {
            along.blend.derivatives(span.ratio(), rows);
            double power = 1;
            for (double& row : rows) {
                row *= power;
                power /= span.length;
            }
        }
        base = second[0] > 0.5 ? 1 : 0;
    }

    /// The k-th derivative of the weight of the first patch or the second.
    [[nodiscard]] double at(std::size_t which, std::size_t k) const noexcept {
        if (which == 1) return second[k];
        return k == 0 ? 1 - second[0] : -second[k];
    }
    [[nodiscard]] bool vanishes(std::size_t which, int order) const noexcept {
        for (std::size_t k = 0; k <= static_cast<std::size_t>(order); ++k) {
            if (at(which, k) != 0) return false;
        }
        return true;
    }
    [[nodiscard]] std::size_t index(std::size_t which) const noexcept {
        return which == 0 ? span.first : span.second;
    }
};

/// Adds the derivatives of β(u) γ(v) times a patch, whose matrix `rows` is used up: Leibniz' rule
/// first along v, in place, then along u.
void addWeighted(const Weights& u, std::size_t a, const Weights& v, std::size_t b,
                 const SurfaceOrders& orders, std::span<Vec3> rows, std::span<Vec3> sum) noexcept {
    const std::size_t lines = static_cast<std::size_t>(orders.u) + 1;
    for (std::size_t line = 0; line < lines; ++line) {
        for (std::size_t n = orders.columns(); n-- > 0;) {
            Vec3 term(0);
            double binomial = 1;
            for (std::size_t k = 0; k <= n; ++k) {
                term += binomial * v.at(b, k) * rows[orders.at(line, n - k)];
                binomial *= static_cast<double>(n - k) / static_cast<double>(k + 1);
            }
            rows[orders.at(line, n)] = term;
        }
    }
    for (std::size_t m = 0; m < lines; ++m) {
        double binomial = 1;
        for (std::size_t k = 0; k <= m; ++k) {
            const double factor = binomial * u.at(a, k);
            for (std::size_t n = 0; n < orders.columns(); ++n) {
                sum[orders.at(m, n)] += factor * rows[orders.at(m - k, n)];
            }
            binomial *= static_cast<double>(m - k) / static_cast<double>(k + 1);
        }
    }
}

using Matrix = std::array<Vec3, maximumRows * maximumRows>;

// ---- Breaks ------------------------------------------------------------------------------------

/// Adds the model's breaks inside (from, to), as they stand at t − shift; a closed model repeats
/// them by its period.
void addBreaks(std::span<const double> knots, const Interval& domain, bool closed,
               const Interval& part, double shift, std::vector<double>& breaks) {
    const double period = closed ? domain.length() : 0;
    const auto turn = [&](double t) {
        return closed ? std::floor((t - shift - domain.start) / period) : 0;
    };
    constexpr double mostTurns = 1000;  // beyond that a surface is not looked at piece by piece
    if (turn(part.end) - turn(part.start) > mostTurns) return;
    for (double k = turn(part.start); k <= turn(part.end); ++k) {
        for (const double knot : knots) {
            const double t = knot + k * period + shift;
            if (t > part.start && t < part.end) breaks.push_back(t);
        }
    }
}

std::vector<double> breaksAlong(const BlendDirection& along, std::span<const double> ofModel,
                                const Interval& domain, bool modelClosed) {
    std::vector<double> breaks;
    std::vector<double> inside;
    for (std::size_t i = 0; i + 1 < along.knots.size(); ++i) {
        const Interval part{along.knots[i], along.knots[i + 1]};
        if (!(part.length() > 0)) continue;
        breaks.push_back(part.start);
        const BlendingSpan span = along.spanAt(part.start, Side::right);
        inside.clear();
        addBreaks(ofModel, domain, modelClosed, part, 0, inside);
        if (span.shift != 0) addBreaks(ofModel, domain, modelClosed, part, span.shift, inside);
        std::sort(inside.begin(), inside.end());
        // One break that comes by two ways differs by rounding.
        const double rounding = 1e-14 * std::max(std::abs(part.start), std::abs(part.end));
        for (const double t : inside) {
            if (t > breaks.back() + rounding && t < part.end - rounding) breaks.push_back(t);
        }
    }
    breaks.push_back(along.knots.back());
    return breaks;
}

}  // namespace

// ---- Making ------------------------------------------------------------------------------------

BlendingSurface::BlendingSurface(std::shared_ptr<const Surface> model, BlendDirection u,
                                 BlendDirection v, const PatchCut& cut)
    : model_(std::move(model)), u_(std::move(u)), v_(std::move(v)), cut_(cut) {
    const Rectangle whole = knotwork::domain(*model_);
    const ClosedDirections turns = closedDirections(*model_);
    modelTurnsU_ = turns.u && u_.domain().length() == whole.u.length();
    modelTurnsV_ = turns.v && v_.domain().length() == whole.v.length();
    findBreaks();
}

Result<BlendingSurface> BlendingSurface::make(Surface model, BlendDirection u, BlendDirection v,
                                              const PatchCut& cut, std::span<const Pose> poses) {
    if (auto checked = checkCounts(u.count, v.count); !checked) return checked.error();
    const std::size_t count = u.count * v.count;
    if (auto checked = checkDegrees(cut, count); !checked) return checked.error();
    const Rectangle whole = knotwork::domain(model);
    if (auto checked = settleKnots(u, whole.u, 0); !checked) return checked.error();
    if (auto checked = settleKnots(v, whole.v, 1); !checked) return checked.error();
    if (auto checked = checkPoses(poses, count); !checked) return checked.error();
    BlendingSurface surface(std::make_shared<const Surface>(std::move(model)), std::move(u),
                            std::move(v), cut);
    if (auto checked = checkNesting(surface.nesting(), "model"); !checked) return checked.error();
    if (auto done = surface.cutPatches(poses); !done) return done.error();
    return surface;
}

Result<Done> BlendingSurface::cutPatches(std::span<const Pose> poses) {
    const std::size_t size = cut_.orders().size();
    std::vector<Vec3> matrices(u_.count * v_.count * size);
    std::vector<PatchPlace> places;
    places.reserve(u_.count * v_.count);
    for (std::size_t i = 0; i < u_.count; ++i) {
        for (std::size_t j = 0; j < v_.count; ++j) {
            const SurfacePlace at{u_.knots[i], v_.knots[j], blendingSide(u_.knots, i),
                                  blendingSide(v_.knots, j)};
            const std::size_t k = places.size();
            const auto matrix = std::span<Vec3>(matrices).subspan(k * size, size);
            if (auto done = cutPatch(*model_, cut_, at, matrix); !done) return done.error();
            places.emplace_back(matrix[0], poses.empty() ? Pose{} : poses[k]);
        }
    }
    matrices_ = std::make_shared<const std::vector<Vec3>>(std::move(matrices));
    places_ = std::make_shared<const std::vector<PatchPlace>>(std::move(places));
    return Done{};
}

void BlendingSurface::findBreaks() {
    const bool ofModel = cutsModel();
    const Rectangle whole = knotwork::domain(*model_);
    const ClosedDirections turns = closedDirections(*model_);
    const std::span<const double> none;
    breaksU_ = std::make_shared<const std::vector<double>>(
        breaksAlong(u_, ofModel ? knotwork::breaksU(*model_) : none, whole.u, turns.u));
    breaksV_ = std::make_shared<const std::vector<double>>(
        breaksAlong(v_, ofModel ? knotwork::breaksV(*model_) : none, whole.v, turns.v));
}

SurfaceNesting BlendingSurface::nesting() const noexcept {
    if (!cutsModel()) return {};
    const SurfaceNesting inner = nestingOf(*model_);
    const bool shiftsU = u_.closed() && !modelTurnsU_;
    const bool shiftsV = v_.closed() && !modelTurnsV_;
    return {inner.depth + 1, inner.evaluations * (shiftsU ? 2 : 1) * (shiftsV ? 2 : 1)};
}

BlendingSurface BlendingSurface::withPoses(std::span<const Pose> poses) const {
    std::vector<PatchPlace> places;
    places.reserve(places_->size());
    for (std::size_t k = 0; k < places_->size(); ++k) {
        places.emplace_back((*places_)[k].origin(), poses[k]);
    }
    BlendingSurface posed = *this;
    posed.places_ = std::make_shared<const std::vector<PatchPlace>>(std::move(places));
    return posed;
}

BlendingSurface BlendingSurface::withPose(std::size_t i, std::size_t j, const Pose& pose) const {
    std::vector<PatchPlace> places = *places_;
    places[i * v_.count + j] = PatchPlace(place(i, j).origin(), pose);
    BlendingSurface posed = *this;
    posed.places_ = std::make_shared<const std::vector<PatchPlace>>(std::move(places));
    return posed;
}

bool BlendingSurface::isModel() const noexcept {
    const bool shifts = (u_.closed() && !modelTurnsU_) || (v_.closed() && !modelTurnsV_);
    return cutsModel() && !shifts && domain() == knotwork::domain(*model_) &&
           std::all_of(places_->begin(), places_->end(),
                       [](const PatchPlace& place) { return place.pose().isIdentity(); });
}

// ---- Evaluating --------------------------------------------------------------------------------

void BlendingSurface::patch(std::size_t i, std::size_t j, const SurfacePlace& at,
                            const SurfaceOrders& orders, std::span<Vec3> rows) const noexcept {
    if (cut_.kind == PatchKind::subSurface) {
        knotwork::derivatives(*model_, at, orders, rows);
    } else {
        polynomialDerivatives(matrix(i, j), cut_.orders(), at.u - u_.knots[i], at.v - v_.knots[j],
                              orders, rows);
    }
    place(i, j).place(rows);
}

/// The four patches that are blended at a place.
class BlendingSurface::Patches {
public:
    Patches(const BlendingSurface& surface, const SurfacePlace& at, const Weights& u,
            const Weights& v, const SurfaceOrders& orders) noexcept
        : surface_(surface), at_(at), u_(u), v_(v), orders_(orders) {}

    /// The derivatives of the patch a along u and b along v. A model is evaluated only where the
    /// last one was taken of it at another place.
    void take(std::size_t a, std::size_t b, std::span<Vec3> rows) noexcept {
        const SurfacePlace at = placeOf(a, b);
        if (!surface_.cutsModel()) {
            surface_.patch(u_.index(a), v_.index(b), at, orders_, rows);
            return;
        }
        if (!seen_ || seen_->u != at.u || seen_->v != at.v) {
            knotwork::derivatives(*surface_.model_, at, orders_, {model_.data(), orders_.size()});
            seen_ = at;
        }
        std::copy_n(model_.begin(), orders_.size(), rows.begin());
        surface_.place(u_.index(a), v_.index(b)).place(rows);
    }

    /// Whether this patch is the same as the base: one model, placed alike.
    [[nodiscard]] bool alike(std::size_t a, std::size_t b) const noexcept {
        const SurfacePlace at = placeOf(a, b);
        const SurfacePlace base = placeOf(u_.base, v_.base);
        return surface_.cutsModel() && at.u == base.u && at.v == base.v &&
               surface_.place(u_.index(a), v_.index(b)).placement() ==
                   surface_.place(u_.index(u_.base), v_.index(v_.base)).placement();
    }

private:
    [[nodiscard]] SurfacePlace placeOf(std::size_t a, std::size_t b) const noexcept {
        return {a == 1 ? u_.span.t - surface_.shiftU(u_.span) : u_.span.t,
                b == 1 ? v_.span.t - surface_.shiftV(v_.span) : v_.span.t, at_.sideU, at_.sideV};
    }

    const BlendingSurface& surface_;
    SurfacePlace at_;
    const Weights& u_;
    const Weights& v_;
    SurfaceOrders orders_;
    std::optional<SurfacePlace> seen_;
    Matrix model_;  // the model's derivatives there
};

void BlendingSurface::derivatives(const SurfacePlace& at, const SurfaceOrders& orders,
                                  std::span<Vec3> rows) const noexcept {
    const Weights u(u_, at.u, at.sideU, orders.u);
    const Weights v(v_, at.v, at.sideV, orders.v);
    Patches patches(*this, at, u, v, orders);
    patches.take(u.base, v.base, rows);
    Matrix sum;
    std::fill_n(sum.begin(), orders.size(), Vec3(0));
    Matrix other;
    const std::span<Vec3> others(other.data(), orders.size());
    for (const auto& [a, b] : {std::pair{u.base, 1 - v.base}, std::pair{1 - u.base, v.base},
                              std::pair{1 - u.base, 1 - v.base}}) {
        if (u.vanishes(a, orders.u) || v.vanishes(b, orders.v)) continue;
        if (patches.alike(a, b)) continue;
        patches.take(a, b, others);
        for (std::size_t k = 0; k < others.size(); ++k) others[k] -= rows[k];
        addWeighted(u, a, v, b, orders, others, sum);
    }
    for (std::size_t k = 0; k < orders.size(); ++k) rows[k] += sum[k];
}

}  // namespace knotwork
