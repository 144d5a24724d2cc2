// Blending curves with local curves of every kind, and what the theorems compare.
#pragma once

#include "geometry/curve.hpp"
#include "support/model_curves.hpp"

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace knotwork::test {

struct NamedCut {
    std::string name;
    LocalCut cut;
};

inline std::vector<NamedCut> allCuts() {
    return {{"sub-curve", {LocalKind::subCurve, 3}}, {"line", {LocalKind::line, 3}},
            {"arc", {LocalKind::arc, 3}},            {"Bézier 1", {LocalKind::bezier, 1}},
            {"Bézier 3", {LocalKind::bezier, 3}},    {"Bézier 6", {LocalKind::bezier, 6}},
            {"Bézier 9", {LocalKind::bezier, 9}},    {"B-spline 3", {LocalKind::bspline, 3}},
            {"B-spline 7", {LocalKind::bspline, 7}}, {"B-spline 1", {LocalKind::bspline, 1}}};
}

struct NamedBlend {
    std::string name;
    BFunction blend;
};

inline std::vector<NamedBlend> someBlends() {
    const auto cubic = BFunction::makePolynomial(1, 1).value();
    return {{"linear", BFunction()},
            {"polynomial(1,1)", cubic},
            {"polynomial(2,3)", BFunction::makePolynomial(2, 3).value()},
            {"polynomial(3,1)", BFunction::makePolynomial(3, 1).value()},
            {"trigonometric(2)", BFunction::makeTrigonometric(2).value()},
            {"rational(3,2)", BFunction::makeRational(3, 2).value()},
            {"expo-rational", BFunction::makeExpoRational().value()},
            {"logistic", BFunction::makeLogistic(0.5).value()},
            {"composed", BFunction::makeComposed(cubic, cubic).value()}};
}

inline std::vector<Pose> somePoses(std::size_t count, unsigned seed, bool flat = true) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> share(-1, 1);
    std::vector<Pose> poses(count);
    for (Pose& pose : poses) {
        pose.translate = {share(engine), share(engine), flat ? 0 : share(engine)};
        pose.axis = flat ? Vec3(0, 0, 1) : Vec3(share(engine), share(engine), 1);
        pose.angle = share(engine);
        pose.scale = {1 + 0.3 * share(engine), 1 + 0.3 * share(engine), flat ? 1 : 1.2};
    }
    return poses;
}

/// Knots over [from, to] with spans that differ by up to a factor of three.
inline std::vector<double> unevenKnots(double from, double to, std::size_t number, unsigned seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> width(1, 3);
    std::vector<double> knots{0};
    while (knots.size() < number) knots.push_back(knots.back() + width(engine));
    const double scale = (to - from) / knots.back();
    for (double& knot : knots) knot = from + scale * knot;
    knots.back() = to;
    return knots;
}

template <std::size_t N>
std::array<Vec3, N> rowsOf(const Curve& curve, double t, Side side = Side::right) {
    std::array<Vec3, N> rows;
    rows.fill(Vec3(99));
    evaluate(curve, t, side, rows);
    return rows;
}

inline void expectNear(const Vec3& a, const Vec3& b, double tolerance, const std::string& where) {
    EXPECT_LE(glm::length(a - b), tolerance)
        << where << ": " << a.x << ' ' << a.y << ' ' << a.z << " against " << b.x << ' ' << b.y
        << ' ' << b.z;
}

}  // namespace knotwork::test
