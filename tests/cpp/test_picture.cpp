// What a view fits: all that is drawn, also what lies around the objects.
#include "app/picture.hpp"
#include "support/playground.hpp"

#include <gtest/gtest.h>

namespace knotwork::app {
namespace {

/// Three points whose smallest circle has the centre (0.5, 0) and the radius 1.5.
const char* cloud(bool deep) {
    return deep ? R"({"knotwork":1,"objects":[{"id":"p","type":"point-cloud",
                      "points":[[-1,0,0],[2,0,0],[0.5,0.1,0.2]],"show":{"sphere":true}}]})"
                : R"({"knotwork":1,"objects":[{"id":"p","type":"point-cloud",
                      "points":[[-1,0],[2,0],[0.5,0.1]],"show":{"sphere":true}}]})";
}

void expectBox(const drawing::Bounds& bounds, const Vec3& min, const Vec3& max) {
    constexpr double gate = 1e-12;
    for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(bounds.min[k], min[k], gate) << k;
        EXPECT_NEAR(bounds.max[k], max[k], gate) << k;
    }
}

TEST(LoopBounds, HoldTheSphereThatIsShownAroundPoints) {
    expectBox(loopBounds(sceneOf(cloud(false))->state()), {-1, -1.5, 0}, {2, 1.5, 0});
    expectBox(loopBounds(sceneOf(cloud(true))->state()), {-1, -1.5, -1.5}, {2, 1.5, 1.5});
}

TEST(LoopBounds, HoldTheCircleThatIsShownAroundACurve) {
    const auto scene = sceneOf(R"({"knotwork":1,"objects":[{"id":"c","type":"line-curve",
        "from":[-3,0],"to":[1,0],"show":{"sphere":true}}]})");
    expectBox(loopBounds(scene->state()), {-3, -2, 0}, {1, 2, 0});
}

}  // namespace
}  // namespace knotwork::app
