#include "scene/object_trace.hpp"

#include "scene/json_values.hpp"
#include "scene/trace_algorithms.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace knotwork::scene {

namespace {

/// What an algorithm is asked for.
struct Request {
    const Json& given;
    const Body& body;
    double parameter;

    [[nodiscard]] double number(std::string_view key, double otherwise) const {
        return numberOr(given, key, otherwise);
    }
};

template <class Kind>
Result<Trace> traceAt(const Request& request, Result<Trace> (*trace)(const Kind&, double)) {
    const auto t = parameterInDomain(*request.body.curve(), request.number("t", request.parameter));
    if (!t) return t.error();
    return trace(*request.body.as<Kind>(), *t);
}

Result<Trace> boehm(const Request& request) {
    return traceBoehm(*request.body.as<BsplineCurve>(), request.number("knot", request.parameter));
}

/// The knots with one more in the middle of every span of the domain.
std::vector<double> halved(const KnotVector& vector) {
    const Interval domain = vector.domain();
    std::vector<double> refined;
    double last = 0;
    for (const double t : vector.knots()) {
        const bool span = !refined.empty() && last < t && last >= domain.start && t <= domain.end;
        if (span) refined.push_back((last + t) / 2);
        refined.push_back(t);
        last = t;
    }
    return refined;
}

Result<Trace> oslo(const Request& request) {
    const auto& spline = *request.body.as<BsplineCurve>();
    const Json* knots = member(request.given, "knots");
    return traceOslo(spline, knots != nullptr ? numbersOf(*knots) : halved(spline.knotVector()));
}

Result<Trace> subdivision(const Request& request, Result<Trace> (*trace)(const CurveSubdivision&)) {
    CurveSubdivision input = request.body.as<SubdivisionCurve>()->subdivision();
    input.levels = static_cast<int>(request.number("levels", input.levels));
    if (input.scheme != CurveScheme::fourPoint) {
        input.degree = splineDegree(input);  // Chaikin's scheme is that of degree 2
        input.scheme = CurveScheme::laneRiesenfeld;
    }
    return trace(input);
}

Result<Trace> catmullClark(const Request& request) {
    const SubdivisionSurface& surface = *request.body.subdivision();
    return traceCatmullClark(surface.control,
                             static_cast<int>(request.number("levels", surface.levels)));
}

Result<Trace> blend(const Request& request) {
    if (request.body.curve() != nullptr) return traceAt<BlendingCurve>(request, traceBlend);
    const Surface& surface = *request.body.surface();
    const Rectangle whole = domain(surface);
    const auto at =
        placeInDomain(surface, request.number("u", (whole.u.start + whole.u.end) / 2),
                      request.number("v", (whole.v.start + whole.v.end) / 2));
    if (!at) return at.error();
    return traceBlend(*request.body.as<BlendingSurface>(), *at);
}

bool isSpline(const Body& body) { return body.as<BsplineCurve>() != nullptr; }
bool isBlend(const Body& body) {
    return body.as<BlendingCurve>() != nullptr || body.as<BlendingSurface>() != nullptr;
}
bool isMesh(const Body& body) { return body.subdivision() != nullptr; }
bool subdivides(const Body& body, bool fourPoint) {
    const auto* curve = body.as<SubdivisionCurve>();
    return curve != nullptr && (curve->subdivision().scheme == CurveScheme::fourPoint) == fourPoint;
}

struct Algorithm {
    std::string_view name;
    bool (*suits)(const Body& body);
    Result<Trace> (*trace)(const Request& request);
};

constexpr std::array algorithms{
    Algorithm{"de-boor", isSpline,
              [](const Request& r) { return traceAt<BsplineCurve>(r, traceDeBoor); }},
    Algorithm{"cox-de-boor", isSpline,
              [](const Request& r) { return traceAt<BsplineCurve>(r, traceCoxDeBoor); }},
    Algorithm{"factor-matrices", isSpline,
              [](const Request& r) { return traceAt<BsplineCurve>(r, traceFactorMatrices); }},
    Algorithm{"boehm", isSpline, boehm},
    Algorithm{"oslo", isSpline, oslo},
    Algorithm{"lane-riesenfeld", [](const Body& body) { return subdivides(body, false); },
              [](const Request& r) { return subdivision(r, traceLaneRiesenfeld); }},
    Algorithm{"four-point", [](const Body& body) { return subdivides(body, true); },
              [](const Request& r) { return subdivision(r, traceFourPoint); }},
    Algorithm{"blend", isBlend, blend},
    Algorithm{"catmull-clark", isMesh, catmullClark},
};

Error unsuited(const Body& body, const std::string& name) {
    std::string names;
    for (const Algorithm& one : algorithms) {
        if (one.suits(body)) names += (names.empty() ? "" : ", ") + std::string(one.name);
    }
    return refuse(Code::notSupported, "trace.algorithm",
                  "\"" + name + "\" does not work on an object of this type; " +
                      (names.empty() ? "none does." : "choose one of " + names + "."));
}

/// Errors about the curve, which is the object itself, have its path; others that of the trace.
Error seenFromObject(Error error) {
    for (const std::string_view part : {"curve.", "surface.", "mesh."}) {
        if (!error.path.starts_with(part)) continue;
        error.path.erase(0, part.size());
        return error;
    }
    return error.under("trace");
}

}  // namespace

std::optional<Curve> measuredCurve(const Body& body) {
    if (body.curve() != nullptr) return *body.curve();
    const PointCloud* cloud = body.cloud();
    if (cloud == nullptr || !cloud->fit) return std::nullopt;
    return Curve(cloud->fit->curve);
}

Result<double> parameterOf(const Json& spec, const Body& body) {
    const auto curve = measuredCurve(body);
    if (!curve) return 0.0;
    const Interval whole = domain(*curve);
    const Json* given = member(spec, "t");
    if (given == nullptr) return (whole.start + whole.end) / 2;
    return parameterInDomain(*curve, given->get<double>());
}

Result<ObjectTrace> traceOf(const Json& spec, const Body& body, double parameter) {
    const Json* given = member(spec, "trace");
    if (given == nullptr) return ObjectTrace{};
    const std::string name = stringOr(*given, "algorithm", "");
    const auto algorithm =
        std::find_if(algorithms.begin(), algorithms.end(), [&](const Algorithm& one) {
            return one.name == name && one.suits(body);
        });
    if (algorithm == algorithms.end()) return unsuited(body, name);
    auto made = algorithm->trace({*given, body, parameter});
    if (!made) return seenFromObject(made.error());
    const auto asked = static_cast<std::size_t>(numberOr(*given, "frame", 0));
    const std::size_t frames = made->frames.size();
    return ObjectTrace{std::make_shared<const Trace>(std::move(*made)),
                       std::min(asked, frames > 0 ? frames - 1 : 0)};
}

}  // namespace knotwork::scene
