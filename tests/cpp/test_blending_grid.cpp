// Grids of blending surfaces: the quick rows against the surface by itself.
#include "support/blending_surfaces.hpp"
#include "support/surface_grids.hpp"

#include <gtest/gtest.h>

namespace knotwork {
namespace {

using test::expectGrid;

TEST(BlendingGrid, HasThePointsAndNormalsOfEveryKindAndForm) {
    for (const auto& [blends, blendU, blendV] : test::blendPairs()) {
        for (const auto& [name, surface] : test::blendingSpecimens(blendU, blendV)) {
            expectGrid(surface, 13, 24, name + " by " + blends);
        }
    }
}

TEST(BlendingGrid, ColumnsAndRowsThatMeetKnotsAreThoseOnTheRight) {
    for (const auto& [name, cut] : test::allPatchCuts()) {
        std::vector<Pose> poses = test::somePoses(20, 5, false);
        const auto surface =
            BlendingSurface::make(test::model("plane", {{"width", 4}, {"height", 3}}),
                                  {5, BlendForm::open, {}, {0, 1, 2, 2, 4}},
                                  {4, BlendForm::open, {}, {0, 1, 1, 3}}, cut, poses)
                .value();
        expectGrid(surface, 9, 13, name);
    }
}

TEST(BlendingGrid, SubSurfacesThatNobodyMovedHaveTheGridOfTheModel) {
    const auto erb = BFunction::makeExpoRational().value();
    for (const auto& [name, surface] : test::blendingSpecimens(erb, erb, false)) {
        expectGrid(surface, 11, 15, name);
    }
}

TEST(BlendingGrid, PatchesOfAHighDegreeOrALowOneAreRowsOfPolynomialsToo) {
    const auto cubic = BFunction::makePolynomial(1, 1).value();
    for (const auto& [u, v] : {std::pair{9, 8}, {4, 25}, {25, 7}, {5, 2}, {2, 1}, {1, 3}}) {
        expectGrid(test::blendOver(test::model("torus"), {8, 6, BlendForm::closed, BlendForm::closed,
                                                          {PatchKind::bezier, {u, v}}, cubic, cubic}),
                   9, 10, std::to_string(u) + " × " + std::to_string(v));
    }
}

TEST(BlendingGrid, ABlendOfABlendHasAGridToo) {
    const auto cubic = BFunction::makePolynomial(1, 1).value();
    const Surface inner = test::blendOver(
        test::model("torus"), {4, 3, BlendForm::closed, BlendForm::closed, {}, cubic, cubic});
    expectGrid(test::blendOver(inner, {3, 5, BlendForm::closed, BlendForm::closed, {}, cubic, {}}),
               7, 9, "nested");
}

TEST(BlendingGrid, SeamsMeetThemselvesToTheBit) {
    const auto cubic = BFunction::makePolynomial(1, 1).value();
    const std::size_t nu = 12;
    const std::size_t nv = 31;
    for (const auto& [name, surface] : test::blendingSpecimens(cubic, cubic)) {
        const test::Grid grid = test::gridOf(surface, nu, nv);
        for (std::size_t j = 0; surface.closed().u && j < nv; ++j) {
            EXPECT_EQ(grid.points[j], grid.points[(nu - 1) * nv + j]) << name;
            EXPECT_EQ(grid.normals[j], grid.normals[(nu - 1) * nv + j]) << name;
        }
        for (std::size_t i = 0; surface.closed().v && i < nu; ++i) {
            EXPECT_EQ(grid.points[i * nv], grid.points[i * nv + nv - 1]) << name;
            EXPECT_EQ(grid.normals[i * nv], grid.normals[i * nv + nv - 1]) << name;
        }
    }
}

TEST(BlendingGrid, PolesHaveNormals) {
    const auto cubic = BFunction::makePolynomial(1, 1).value();
    const std::size_t nu = 9;
    const std::size_t nv = 5;
    for (const auto& [name, cut] : test::allPatchCuts()) {
        if (cut.kind == PatchKind::plane) continue;  // what is left of them at a pole is a line
        const test::Grid grid = test::gridOf(
            test::blendOver(test::model("sphere"),
                            {8, 5, BlendForm::closed, BlendForm::open, cut, cubic, cubic, false}),
            nu, nv);
        for (std::size_t i = 0; i < nu; ++i) {
            EXPECT_LE(glm::length(grid.normals[i * nv] - Vec3(0, 0, -1)), 1e-6) << name;
            EXPECT_LE(glm::length(grid.normals[i * nv + nv - 1] - Vec3(0, 0, 1)), 1e-6) << name;
        }
    }
}

}  // namespace
}  // namespace knotwork
