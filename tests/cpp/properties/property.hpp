// How a property is checked: on many random cases from a seed of its own, so that every run sees
// the same ones. What fails is printed as small as it can be made, with the seed.
//
// In the environment KNOTWORK_SEED replaces the seed and KNOTWORK_CASES multiplies the cases:
//     KNOTWORK_SEED=7 KNOTWORK_CASES=50 build/native/knotwork_tests --gtest_filter='*Property*'
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>

namespace knotwork::test {

inline std::uint64_t numberOf(const char* variable, std::uint64_t otherwise) {
    const char* text = std::getenv(variable);
    return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

/// FNV-1a of the test's name: the seeds differ, and moving a test does not change its cases.
inline std::uint64_t seedOf(const std::string& name) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char letter : name) {
        hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3U;
    }
    return hash;
}

/// Checks a callable that picks its input with `*generator` and asserts with RC_ASSERT.
template <class Property>
void holds(int cases, const Property& property) {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    rc::detail::TestMetadata metadata;
    metadata.description = std::string(info->test_suite_name()) + '.' + info->name();
    rc::detail::TestParams params;
    params.seed = numberOf("KNOTWORK_SEED", seedOf(metadata.description));
    params.maxSuccess = cases * static_cast<int>(numberOf("KNOTWORK_CASES", 1));
    const auto result = rc::detail::checkTestable(property, metadata, params);
    if (result.template is<rc::detail::SuccessResult>()) return;
    std::ostringstream message;
    rc::detail::printResultMessage(result, message);
    FAIL() << message.str() << "\nKNOTWORK_SEED=" << params.seed << " repeats this";
}

}  // namespace knotwork::test
