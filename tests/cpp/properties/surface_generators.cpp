#include "properties/surface_generators.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <utility>

namespace knotwork::test {

namespace {

template <class T>
T sound(Result<T> made) {
    if (!made.ok()) RC_FAIL(made.error().path + ": " + made.error().message);
    return std::move(made).value();
}

/// The knots in the domain and its ends, each once.
std::vector<double> stops(const Interval& domain, std::span<const double> knots) {
    std::vector<double> ts{domain.start, domain.end};
    for (const double knot : knots) {
        if (domain.contains(knot)) ts.push_back(knot);
    }
    std::sort(ts.begin(), ts.end());
    ts.erase(std::unique(ts.begin(), ts.end()), ts.end());
    return ts;
}

double oneOf(const std::vector<double>& ts) {
    return ts[static_cast<std::size_t>(*whole(0, static_cast<int>(ts.size()) - 1))];
}

void addFromAllSides(double u, double v, std::vector<SurfacePlace>& places) {
    for (const Side sideU : {Side::left, Side::right}) {
        for (const Side sideV : {Side::left, Side::right}) places.push_back({u, v, sideU, sideV});
    }
}

PatchCut anyCut() {
    const auto kind = static_cast<PatchKind>(*whole(0, 2));
    return {kind, {*whole(1, 4), *whole(1, 4)}};
}

const char* nameOf(PatchKind kind) {
    return kind == PatchKind::subSurface ? "sub-surface" : kind == PatchKind::plane ? "plane"
                                                                                    : "bezier";
}

}  // namespace

BsplineSurface SurfaceCase::surface() const {
    return sound(BsplineSurface::make(u.knotVector(), v.knotVector(), points, weights));
}

SurfaceCase SurfaceCase::transposed() const {
    SurfaceCase turned{v, u, {}, {}};
    const auto rows = static_cast<std::size_t>(u.count);
    const auto columns = static_cast<std::size_t>(v.count);
    for (std::size_t j = 0; j < columns; ++j) {
        for (std::size_t i = 0; i < rows; ++i) {
            turned.points.push_back(points[i * columns + j]);
            if (!weights.empty()) turned.weights.push_back(weights[i * columns + j]);
        }
    }
    return turned;
}

void showValue(const SurfaceCase& surface, std::ostream& out) {
    out << "{ type: 'bspline-surface', degree: [" << surface.u.degree << ", " << surface.v.degree
        << "], form: ['" << text(surface.u.form) << "', '" << text(surface.v.form)
        << "'], points: [";
    const auto columns = static_cast<std::size_t>(surface.v.count);
    for (std::size_t k = 0; k < surface.points.size(); ++k) {
        out << (k % columns == 0 ? "[" : "") << text(surface.points[k])
            << (k % columns + 1 == columns ? "], " : ", ");
    }
    out << "], knots: [" << text(surface.u.knots) << ", " << text(surface.v.knots) << ']';
    if (!surface.weights.empty()) out << ", weights (row by row): " << text(surface.weights);
    out << " }";
}

rc::Gen<SurfaceCase> anySurface(const SurfaceOptions& options) {
    return rc::gen::exec([options] {
        SurfaceCase surface;
        surface.u = *anyKnots(options.maxDegree, options.maxSpans, options.nearlyEqualKnots);
        surface.v = *anyKnots(options.maxDegree, options.maxSpans, options.nearlyEqualKnots);
        const bool rational = options.rational && *whole(0, 2) == 2;
        for (int k = 0; k < surface.u.count * surface.v.count; ++k) {
            surface.points.push_back(*spacePoint(1, 3));
            if (rational) surface.weights.push_back(0.25 + std::abs(*real(2.75)));
        }
        return surface;
    });
}

ParametricSurface ModelCase::surface() const {
    return sound(ParametricSurface::make(name, parameters));
}

void showValue(const ModelCase& model, std::ostream& out) {
    out << "{ type: 'parametric-surface', name: '" << model.name << "', parameters: {";
    for (const NamedValue& one : model.parameters) {
        out << ' ' << one.first << ": " << text(std::vector<double>{one.second}) << ',';
    }
    out << " } }";
}

rc::Gen<ModelCase> anyModelSurface() {
    return rc::gen::exec([] {
        const auto all = surfaceModels();
        const auto& model =
            all[static_cast<std::size_t>(*whole(0, static_cast<int>(all.size()) - 1))];
        ModelCase chosen{std::string(model.name), {}};
        for (const auto& parameter : model.parameters) {
            chosen.parameters.emplace_back(parameter.name, 0.5 + std::abs(*real(2)));
        }
        return chosen;
    });
}

void showValue(const BlendDirectionCase& along, std::ostream& out) {
    out << along.count << " patches, " << (along.form == BlendForm::open ? "open" : "closed")
        << ", knots " << text(along.knots) << ", " << along.blend.spec;
}

rc::Gen<BlendDirectionCase> anyBlendDirection(const Interval& domain) {
    return rc::gen::exec([domain] {
        const auto count = static_cast<std::size_t>(*whole(2, 4));
        const BlendForm form = *whole(0, 1) == 0 ? BlendForm::open : BlendForm::closed;
        BFunctionCase blend = *anyBFunction(1);
        std::vector<double> knots = *blendingKnots(domain, blendingKnotCount(count, form));
        return BlendDirectionCase{count, form, std::move(blend), std::move(knots)};
    });
}

BlendingSurface BlendingSurfaceCase::surface() const {
    return sound(
        BlendingSurface::make(model.surface(), u.direction(), v.direction(), cut, poses));
}

void showValue(const BlendingSurfaceCase& blending, std::ostream& out) {
    out << "{ type: 'blending-surface', model: ";
    showValue(blending.model, out);
    out << ", kind: '" << nameOf(blending.cut.kind) << "', degree: [" << blending.cut.degree[0]
        << ", " << blending.cut.degree[1] << "], along u: ";
    showValue(blending.u, out);
    out << ", along v: ";
    showValue(blending.v, out);
    out << ", poses: [";
    for (const Pose& pose : blending.poses) out << "{ " << text(pose) << " }, ";
    out << "] }";
}

rc::Gen<BlendingSurfaceCase> anyBlendingSurface() {
    return rc::gen::exec([] {
        ModelCase model = *anyModelSurface();
        const Rectangle whole = model.surface().domain();
        BlendDirectionCase u = *anyBlendDirection(whole.u);
        BlendDirectionCase v = *anyBlendDirection(whole.v);
        const PatchCut cut = anyCut();
        std::vector<Pose> poses;
        for (std::size_t k = 0; k < u.count * v.count; ++k) poses.push_back(*somePose());
        return BlendingSurfaceCase{std::move(model), std::move(u), std::move(v), cut,
                                   std::move(poses)};
    });
}

std::vector<SurfacePlace> placesOf(const Rectangle& domain, std::span<const double> knotsU,
                                   std::span<const double> knotsV) {
    const std::vector<double> stopsU = stops(domain.u, knotsU);
    const std::vector<double> stopsV = stops(domain.v, knotsV);
    const std::vector<double> us = *parametersOf(domain.u, stopsU, 3);
    const std::vector<double> vs = *parametersOf(domain.v, stopsV, 3);
    std::vector<SurfacePlace> places;
    for (const double u : stopsU) {
        for (const double v : stopsV) addFromAllSides(u, v, places);
    }
    for (const double u : us) addFromAllSides(u, oneOf(vs), places);
    for (const double v : vs) addFromAllSides(oneOf(us), v, places);
    return places;
}

}  // namespace knotwork::test
