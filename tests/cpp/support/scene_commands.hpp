// Commands that a scene must carry out, or must refuse and be as before.
#pragma once

#include "scene/scene.hpp"
#include "support/json_text.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace knotwork::test {

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
