#include "geometry/surface.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace knotwork {

namespace {

struct Entered {
    double parameter;
    Side side;
};

Result<Entered> enter(const Interval& domain, bool closed, double t, const char* name) {
    if (!std::isfinite(t)) {
        return refuse(Code::notFinite, name,
                      "The parameter " + std::string(name) + " is " + formatNumber(t) +
                          "; give a finite number.");
    }
    if (closed) return Entered{wrapParameter(domain, t, Side::right), Side::right};
    if (domain.contains(t)) return Entered{t, t == domain.end ? Side::left : Side::right};
    return refuse(Code::outOfRange, name,
                  "The parameter " + std::string(name) + " = " + formatNumber(t) +
                      " lies outside the domain [" + formatNumber(domain.start) + ", " +
                      formatNumber(domain.end) + "].");
}

}  // namespace

Rectangle domain(const Surface& surface) noexcept {
    return std::visit([](const auto& kind) { return kind.domain(); }, surface.kind());
}

ClosedDirections closedDirections(const Surface& surface) noexcept {
    return std::visit([](const auto& kind) { return kind.closed(); }, surface.kind());
}

Result<SurfacePlace> placeInDomain(const Surface& surface, double u, double v) {
    const Rectangle whole = domain(surface);
    const ClosedDirections closed = closedDirections(surface);
    const auto alongU = enter(whole.u, closed.u, u, "u");
    if (!alongU) return alongU.error();
    const auto alongV = enter(whole.v, closed.v, v, "v");
    if (!alongV) return alongV.error();
    return SurfacePlace{alongU->parameter, alongV->parameter, alongU->side, alongV->side};
}

void derivatives(const Surface& surface, const SurfacePlace& at, const SurfaceOrders& orders,
                 std::span<Vec3> rows) noexcept {
    std::visit([&](const auto& kind) { kind.derivatives(at, orders, rows); }, surface.kind());
}

void derivativesWithin(const Surface& surface, const SurfacePlace& at, int order,
                       std::span<Vec3> rows) noexcept {
    if (const auto* triangle = surface.as<BlendingTriangle>()) {
        triangle->derivativesWithin(at, order, rows);
    } else {
        derivatives(surface, at, {order, order}, rows);
    }
}

Vec3 pointAt(const Surface& surface, const SurfacePlace& at) noexcept {
    Vec3 point;
    derivatives(surface, at, {}, {&point, 1});
    return point;
}

std::span<const double> breaksU(const Surface& surface) noexcept {
    return std::visit([](const auto& kind) { return kind.breaksU(); }, surface.kind());
}

std::span<const double> breaksV(const Surface& surface) noexcept {
    return std::visit([](const auto& kind) { return kind.breaksV(); }, surface.kind());
}

}  // namespace knotwork
