// A scene to try things on, and commands that it must carry out, or must refuse and be as before.
#pragma once

#include "scene/scene.hpp"
#include "support/json_text.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace knotwork::test {

/// A spline and a blend, with two effects.
inline constexpr const char* twoObjects = R"({
    "knotwork": 1, "title": "Two",
    "objects": [
        {"type": "bspline-curve", "degree": 2, "points": [[0,0],[1,2],[3,3],[5,0],[6,2]],
         "knots": [0,0,0,1,3,4,4,4]},
        {"id": "blend", "type": "blending-curve", "bFunction": {"family": "expo-rational"},
         "model": {"type": "parametric-curve", "name": "circle"}, "locals": {"count": 5}}],
    "effects": [{"target": "blend", "kind": "simulate", "rotate": {"angle": 1}, "seed": 3},
                {"target": "c1", "kind": "colour", "to": "#FFcc00", "period": 2.5}]})";

inline scene::Scene twoScene() { return scene::Scene::open(json(twoObjects)).value(); }

inline void expectDone(scene::Scene& on, std::string_view command) {
    const auto done = on.execute(json(command));
    EXPECT_TRUE(done.ok()) << command << ": "
                           << (done.ok() ? "" : done.error().path + " " + done.error().message);
}

inline void expectRefused(scene::Scene& on, std::string_view command, Code code,
                          std::string_view path) {
    const std::string before = scene::dumpJson(on.document());
    const auto done = on.execute(json(command));
    ASSERT_FALSE(done.ok()) << command;
    EXPECT_EQ(codeName(done.error().code), codeName(code)) << command << done.error().message;
    EXPECT_EQ(done.error().path, path) << command;
    EXPECT_EQ(scene::dumpJson(on.document()), before) << command;
}

}  // namespace knotwork::test
