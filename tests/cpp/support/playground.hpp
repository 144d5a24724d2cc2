// A view of a real scene with a mouse over it, and no browser.
#pragma once

#include "app/view.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

namespace knotwork::app {

using scene::Json;

inline std::shared_ptr<scene::Scene> sceneOf(const char* text) {
    const auto json = scene::parseJson(text);
    EXPECT_TRUE(json.ok());
    auto scene = scene::Scene::open(*json);
    EXPECT_TRUE(scene.ok()) << (scene.ok() ? "" : scene.error().path + ": " + scene.error().message);
    return std::make_shared<scene::Scene>(std::move(*scene));
}

inline constexpr const char* spline = R"({"knotwork":1,"objects":[{"id":"s","type":"bspline-curve",
    "degree":3,"points":[[-4,-2],[-3,2],[-1,2],[0,-1],[2,-2],[4,0]]}]})";
inline constexpr const char* blend = R"({"knotwork":1,"view":{"panes":["curve"]},"objects":[
    {"id":"b","type":"blending-curve","bFunction":{"family":"expo-rational"},
     "model":{"type":"parametric-curve","name":"circle"},"locals":{"count":4},"form":"closed",
     "show":{"handles":true}}],
    "effects":[{"target":"b","kind":"rotate","angle":1.5707963267948966,"period":4}]})";

/// A view of a scene with a mouse over it.
struct Playground {
    explicit Playground(const char* document) : scene(sceneOf(document)) {
        view.resize(1000, 600, 1);
        view.attach(scene);
        view.setReducedMotion(true);
        EXPECT_NE(view.figure(), nullptr);
    }
    bool event(const char* kind, const Pixel& at, int buttons, int modifiers = 0,
               const char* type = "mouse") {
        time += 0.1;
        return view.pointer({kind, at, buttons, modifiers, type, time});
    }
    bool click(const Pixel& at, const char* type = "mouse") {
        const bool taken = event("down", at, 1, 0, type);
        event("up", at, 0, 0, type);
        return taken;
    }
    void drag(const Pixel& from, const Pixel& to, int modifiers = 0) {
        event("down", from, 1);
        event("move", {(from.x + to.x) / 2 + 40, (from.y + to.y) / 2 - 30}, 1, modifiers);
        event("move", to, 1, modifiers);
        event("up", to, 0, modifiers);
    }
    Pixel pixelOf(const std::string& path) {
        const Figure* figure = view.figure();
        view.select(path);
        EXPECT_TRUE(view.selected()) << path;
        const PaneFigure* pane = figure->find(view.selected()->pane);
        return pane->sight.toPixels(view.selected()->at);
    }
    const Json& at(const char* path) {
        const Json* value = valueAt(scene->state(), path);
        EXPECT_NE(value, nullptr) << path;
        static const Json none;
        return value != nullptr ? *value : none;
    }
    double unitsPerPixel() { return view.figure()->find(Pane::curve)->sight.unitsPerPixel(); }

    std::shared_ptr<scene::Scene> scene;
    View view{1};
    double time = 100;
};

}  // namespace knotwork::app
