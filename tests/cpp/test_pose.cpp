#include "geometry/pose.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace knotwork {
namespace {

void expectNear(const Vec3& a, const Vec3& b, double tolerance) {
    EXPECT_LE(glm::length(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(Pose, TheDefaultIsTheIdentityToTheBit) {
    const Affine placed = affineOf(Pose{}, Vec3(3, 4, 5));
    EXPECT_EQ(placed, Affine{});
    const Vec3 p(0.1, -0.7, 1e9);
    EXPECT_EQ(placed.point(p), p);
}

TEST(Pose, AQuarterTurnAboutZTurnsAgainstTheClock) {
    expectNear(rotation({0, 0, 7}, std::numbers::pi / 2) * Vec3(1, 0, 0), {0, 1, 0}, 1e-15);
    expectNear(rotation({1, 0, 0}, std::numbers::pi / 2) * Vec3(0, 1, 0), {0, 0, 1}, 1e-15);
    expectNear(rotation({0, 1, 0}, std::numbers::pi / 2) * Vec3(0, 0, 1), {1, 0, 0}, 1e-15);
}

TEST(Pose, ARotationKeepsLengthsAndItsAxis) {
    const Vec3 axis(1, -2, 0.5);
    const Mat3 turn = rotation(axis, 2.3);
    expectNear(turn * axis, axis, 1e-15);
    expectNear(Vec3(glm::length(turn * Vec3(3, 1, 2)), 0, 0), {glm::length(Vec3(3, 1, 2)), 0, 0},
               1e-15);
}

TEST(Pose, ScalesThenRotatesAboutTheOriginThenTranslates) {
    Pose pose;
    pose.scale = {2, 3, 1};
    pose.angle = std::numbers::pi / 2;
    pose.translate = {10, 0, 0};
    const Vec3 origin(1, 1, 0);
    // (2,1) is one to the right of the origin: scaled 2 to the right, turned 2 up, moved by 10.
    expectNear(affineOf(pose, origin).point({2, 1, 0}), {11, 3, 0}, 1e-14);
    expectNear(affineOf(pose, origin).point(origin), {11, 1, 0}, 1e-14);
}

TEST(Pose, ComposingAppliesTheInnerMapFirst) {
    Pose turn;
    turn.angle = 0.4;
    Pose move;
    move.translate = {1, 2, 3};
    const Affine a = affineOf(turn, Vec3(0.0));
    const Affine b = affineOf(move, Vec3(0.0));
    const Vec3 p(0.3, 0.2, 0.1);
    expectNear(compose(a, b).point(p), a.point(b.point(p)), 1e-15);
}

TEST(Pose, WhatCannotBeAPoseIsRefusedWithItsPath) {
    Pose flat;
    flat.scale.y = 0;
    EXPECT_EQ(checkPose(flat).error().path, "scale");
    EXPECT_EQ(checkPose(flat).error().code, Code::outOfRange);
    Pose aimless;
    aimless.axis = Vec3(0.0);
    aimless.angle = 1;
    EXPECT_EQ(checkPose(aimless).error().path, "rotate.axis");
    Pose lost;
    lost.translate.x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(checkPose(lost).error().code, Code::notFinite);
    Pose spinning;
    spinning.angle = std::numeric_limits<double>::infinity();
    EXPECT_EQ(checkPose(spinning).error().code, Code::notFinite);
    EXPECT_EQ(checkPose(spinning).error().path, "rotate.angle");
    EXPECT_TRUE(checkPose(Pose{}).ok());
}

}  // namespace
}  // namespace knotwork
