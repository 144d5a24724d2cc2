// The part of the session that holds and evaluates curves.
#include "bindings/marshal.hpp"
#include "bindings/session.hpp"
#include "geometry/simd.hpp"
#include "geometry/tessellation.hpp"
#include "geometry/triples.hpp"

#include <algorithm>

namespace knotwork::bindings {

using scene::Made;

namespace {

/// How many numbers from the first one on are seen to lie in the interval, two at a look.
std::size_t countWithin(const Interval& whole, std::span<const double> numbers) noexcept {
    const simd::Double2 start = simd::splat(whole.start);
    const simd::Double2 end = simd::splat(whole.end);
    std::size_t i = 0;
    for (; i + 2 <= numbers.size(); i += 2) {
        const simd::Double2 pair = simd::load(&numbers[i]);
        if (!simd::inBoth((pair >= start) & (end >= pair))) break;
    }
    return i;
}

}  // namespace

int Session::holdCurve(CurveValue value) {
    const Curve& curve = value.curve;
    const Interval whole = domain(curve);
    block_[0] = whole.start;
    block_[1] = whole.end;
    block_[2] = isClosed(curve) ? 1 : 0;
    block_[3] = dimension(curve);
    block_[4] = static_cast<double>(curve.kind().index());
    return hold(std::make_unique<CurveValue>(std::move(value)));
}

int Session::holdCurve(Result<Made<Curve>> made) {
    if (!made) return refuse(made.error());
    return holdCurve({std::move(made->value), std::move(made->spec), std::nullopt, {}});
}

int Session::curve(unsigned bytes) {
    const std::span<const std::uint8_t> given = inputBytes(bytes);
    if (auto usual = readUsualBspline(given)) {
        return holdCurve({std::move(*usual), std::nullopt, std::nullopt,
                          {given.begin(), given.end()}});
    }
    auto spec = readCbor(given);
    if (!spec) return refuse(spec.error());
    return holdCurve(scene::makeCurve(*spec));
}

/// Bytes are kept of B-spline curves only; those that made the curve make it again, with its
/// specification. A curve that was computed has neither.
const scene::Json& Session::specOf(CurveValue& held) {
    if (!held.spec) {
        const auto given = readCbor(held.source);
        auto made = given ? scene::makeCurve(*given) : Result<Made<Curve>>(given.error());
        held.spec = made ? std::move(made->spec) : scene::specOf(held.curve);
        held.source = {};
    }
    return *held.spec;
}

std::string Session::curveSpec(int handle) {
    auto* held = find<CurveValue>(handle);
    return held ? scene::dumpJson(specOf(*held)) : std::string();
}

bool Session::curvePoint(int handle, double t) {
    const auto* held = find<CurveValue>(handle);
    if (!held) return false;
    const auto inside = parameterInDomain(held->curve, t);
    if (!inside) return refuse(inside.error());
    write(pointAt(held->curve, *inside), block_.data());
    return true;
}

bool Session::curveDerivatives(int handle, double t, int n, int side) {
    const auto* held = find<CurveValue>(handle);
    if (!held) return false;
    if (auto order = checkDerivative(n, "n"); !order) return refuse(order.error());
    const auto inside = parameterInDomain(held->curve, t);
    if (!inside) return refuse(inside.error());
    const bool left = side < 0 || (side == 0 && *inside == domain(held->curve).end);
    std::array<Vec3, maximumDerivative + 1> rows{};
    evaluate(held->curve, *inside, left ? Side::left : Side::right,
             {rows.data(), rowsOf(n)});
    for (std::size_t k = 0; k < rowsOf(n); ++k) write(rows[k], block_.data() + 3 * k);
    return true;
}

bool Session::curveSample(int handle, unsigned first, unsigned count, unsigned total) {
    auto* held = find<CurveValue>(handle);
    if (!held) return false;
    if (!held->sampler) held->sampler.emplace(held->curve);
    const std::size_t points = std::min<std::size_t>(count, blockPoints);
    held->sampler->uniform(first, points, total, {block_.data(), 3 * points});
    return true;
}

bool Session::enterDomain(const Curve& curve, unsigned first, std::size_t count) {
    const Interval whole = domain(curve);
    for (std::size_t i = countWithin(whole, {parameters_.data(), count}); i < count; ++i) {
        if (whole.contains(parameters_[i])) continue;
        const auto inside = parameterInDomain(curve, parameters_[i]);
        if (!inside) {
            Error error = inside.error();
            error.path = indexed("ts", first + i);
            return refuse(std::move(error));
        }
        parameters_[i] = *inside;
    }
    return true;
}

bool Session::curveAt(int handle, unsigned first, unsigned count, int derivatives) {
    auto* held = find<CurveValue>(handle);
    if (!held) return false;
    if (auto order = checkDerivative(derivatives, "derivatives"); !order) {
        return refuse(order.error());
    }
    const std::size_t points =
        std::min<std::size_t>(count, blockPoints / rowsOf(derivatives));
    if (!enterDomain(held->curve, first, points)) return false;
    if (!held->sampler) held->sampler.emplace(held->curve);
    held->sampler->at({parameters_.data(), points}, derivatives,
                      {block_.data(), 3 * points * rowsOf(derivatives)});
    return true;
}

int Session::curvePolyline(int handle, double tolerance) {
    const auto* held = find<CurveValue>(handle);
    if (!held) return -1;
    if (auto distance = checkTolerance(tolerance); !distance) {
        refuse(distance.error());
        return -1;
    }
    auto line = polylineWithin(held->curve, tolerance);
    if (!line) {
        refuse(line.error());
        return -1;
    }
    const std::size_t points = line->parameters.size();
    line->xyz.insert(line->xyz.end(), line->parameters.begin(), line->parameters.end());
    return leave(std::move(line->xyz), points);
}

std::string Session::parametricCurves() const {
    return scene::dumpJson(scene::describeParametricCurves());
}

}  // namespace knotwork::bindings
