// Blending surfaces for tests: every kind of patch, on models that are closed in both directions, in
// one or in none, with numbers of patches that differ between the directions.
#pragma once

#include "geometry/surface.hpp"
#include "support/blends.hpp"
#include "support/surfaces.hpp"

#include <string>
#include <vector>

namespace knotwork::test {

struct NamedPatchCut {
    std::string name;
    PatchCut cut;
};

inline std::vector<NamedPatchCut> allPatchCuts() {
    return {{"sub-surfaces", {PatchKind::subSurface, {3, 3}}},
            {"planes", {PatchKind::plane, {3, 3}}},
            {"Bézier patches (3, 3)", {PatchKind::bezier, {3, 3}}},
            {"Bézier patches (2, 5)", {PatchKind::bezier, {2, 5}}}};
}

struct BlendingOptions {
    std::size_t nu = 4;
    std::size_t nv = 3;
    BlendForm formU = BlendForm::open;
    BlendForm formV = BlendForm::open;
    PatchCut cut{};
    BFunction blendU{};
    BFunction blendV{};
    bool posed = true;
};

/// Over all of the model, with knots of uneven gaps.
inline BlendingSurface blendOver(const Surface& model, const BlendingOptions& o) {
    const Rectangle whole = domain(model);
    BlendDirection u{o.nu, o.formU, o.blendU,
                     unevenKnots(whole.u.start, whole.u.end, blendingKnotCount(o.nu, o.formU), 3)};
    BlendDirection v{o.nv, o.formV, o.blendV,
                     unevenKnots(whole.v.start, whole.v.end, blendingKnotCount(o.nv, o.formV), 4)};
    const auto poses = o.posed ? somePoses(o.nu * o.nv, 17, false) : std::vector<Pose>{};
    return BlendingSurface::make(model, std::move(u), std::move(v), o.cut, poses).value();
}

struct NamedBlendingSurface {
    std::string name;
    BlendingSurface surface;
};

/// The spiral shell and the half-turned strip do not return to where they began along u: closed all
/// the same, they blend into patches of one period earlier.
inline std::vector<NamedBlendingSurface> blendingSpecimens(const BFunction& u, const BFunction& v,
                                                           bool posed = true) {
    using enum BlendForm;
    struct Named {
        std::string name;
        Surface model;
        std::size_t nu;
        std::size_t nv;
        BlendForm formU;
        BlendForm formV;
    };
    const std::vector<Named> models{
        {"torus", model("torus"), 5, 3, closed, closed},
        {"cylinder", model("cylinder", {{"height", 2}}), 3, 4, closed, open},
        {"plane", model("plane", {{"width", 3}, {"height", 2}}), 3, 5, open, open},
        {"shell", model("seashell", {{"turns", 1.5}}), 6, 4, closed, closed},
        {"strip", model("moebius"), 2, 3, closed, closed},
        {"net", someSurface({3, 4, Form::closed, Form::clamped, 7, 7}), 4, 3, closed, open}};
    std::vector<NamedBlendingSurface> all;
    for (const Named& one : models) {
        for (const NamedPatchCut& cut : allPatchCuts()) {
            all.push_back({cut.name + " of a " + one.name,
                           blendOver(one.model, {one.nu, one.nv, one.formU, one.formV, cut.cut, u,
                                                 v, posed})});
        }
    }
    return all;
}

/// Two B-functions, of different families where there are any.
struct BlendPair {
    std::string name;
    BFunction u;
    BFunction v;
};

inline std::vector<BlendPair> blendPairs() {
    const auto blends = someBlends();
    std::vector<BlendPair> pairs;
    for (std::size_t k = 0; k < blends.size(); ++k) {
        const NamedBlend& other = blends[(k + 4) % blends.size()];
        pairs.push_back({blends[k].name + " and " + other.name, blends[k].blend, other.blend});
    }
    return pairs;
}

}  // namespace knotwork::test
