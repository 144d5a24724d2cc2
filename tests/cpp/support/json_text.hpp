// JSON that tests write as text; text that is none fails the test.
#pragma once

#include "scene/json.hpp"

#include <gtest/gtest.h>

#include <string_view>

namespace knotwork::test {

inline scene::Json json(std::string_view text) {
    auto parsed = scene::parseJson(text);
    EXPECT_TRUE(parsed.ok()) << text;
    return parsed.ok() ? *parsed : scene::Json();
}

}  // namespace knotwork::test
