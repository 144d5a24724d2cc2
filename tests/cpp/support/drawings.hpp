// Drawings for tests: of objects given as text, and what is in them.
#pragma once

#include "drawing/drawing.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace knotwork::test {

/// A scene of objects and effects given as JSON.
inline scene::Scene sceneOf(const std::vector<std::string>& objects,
                            const std::string& effects = "") {
    std::string list;
    for (const std::string& object : objects) list += (list.empty() ? "" : ",") + object;
    const std::string text =
        R"({"knotwork": 1, "objects": [)" + list + R"(], "effects": [)" + effects + "]}";
    auto opened = scene::Scene::open(scene::parseJson(text).value());
    EXPECT_TRUE(opened.ok()) << opened.error().path << ' ' << opened.error().message;
    return std::move(opened.value());
}

inline drawing::Drawing drawn(const std::vector<std::string>& objects, double tolerance = 1e-3,
                              const std::string& effects = "", double phase = 0) {
    drawing::Options options;
    options.moment.phase = phase;
    options.tolerance = tolerance;
    return drawing::draw(sceneOf(objects, effects).state(), options);
}

inline std::vector<const drawing::Shape*> withRole(const drawing::Drawing& drawing,
                                                   drawing::Role role,
                                                   drawing::Pane pane = drawing::Pane::curve) {
    std::vector<const drawing::Shape*> found;
    for (const drawing::Shape& shape : drawing.shapes) {
        if (shape.role == role && shape.pane == pane) found.push_back(&shape);
    }
    return found;
}

inline Vec3 positionIn(const drawing::Shape& shape, std::size_t i) {
    return {shape.positions.at(3 * i), shape.positions.at(3 * i + 1), shape.positions.at(3 * i + 2)};
}

/// To the bit.
inline void expectSame(const drawing::Drawing& a, const drawing::Drawing& b) {
    ASSERT_EQ(a.shapes.size(), b.shapes.size());
    for (std::size_t i = 0; i < a.shapes.size(); ++i) {
        EXPECT_EQ(a.shapes[i].object, b.shapes[i].object);
        EXPECT_EQ(a.shapes[i].role, b.shapes[i].role);
        EXPECT_EQ(a.shapes[i].path, b.shapes[i].path);
        EXPECT_EQ(a.shapes[i].positions, b.shapes[i].positions);
        EXPECT_EQ(a.shapes[i].normals, b.shapes[i].normals);
        EXPECT_EQ(a.shapes[i].indices, b.shapes[i].indices);
        EXPECT_EQ(a.shapes[i].colour, b.shapes[i].colour);
    }
    EXPECT_EQ(a.bounds.empty, b.bounds.empty);
    EXPECT_EQ(a.bounds.min, b.bounds.min);
    EXPECT_EQ(a.bounds.max, b.bounds.max);
}

}  // namespace knotwork::test
