#include "geometry/sliced_work.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <string>

namespace knotwork {
namespace {

/// A work whose steps queue loops that queue loops, and which writes down what it does.
void plan(SlicedWork& work, std::string& log) {
    work.step(1, [&] {
        log += '(';
        for (int k = 0; k < 3; ++k) {
            work.step(2, [&] {
                log += '[';
                work.loop(7, 21, [&](std::size_t first, std::size_t last) {
                    for (std::size_t i = first; i < last; ++i) log += std::to_string(i);
                });
                work.step(0, [&] { log += ']'; });
            });
        }
        work.step(0, [&] { log += ')'; });
    });
    work.loop(0, 5, [&](std::size_t, std::size_t) { log += "never"; });
    work.loop(100, 50, [&](std::size_t first, std::size_t last) {
        log.append(last - first, '.');
    });
}

std::string whole() {
    SlicedWork work;
    std::string log;
    plan(work, log);
    work.finish();
    return log;
}

TEST(SlicedWork, DoesItsLoopsInOrderAndNestedOnesWhereTheyBelong) {
    EXPECT_EQ(whole(), "([0123456][0123456][0123456])" + std::string(100, '.'));
}

TEST(SlicedWork, DoesTheSameWhereverTheSlicesEnd) {
    for (const double weight : {0.0, 1e-9, 0.5, 1.0, 3.7, 10.0, 1e300}) {
        SlicedWork work;
        std::string log;
        plan(work, log);
        std::size_t slices = 1;
        while (work.advance(weight)) ++slices;
        EXPECT_EQ(log, whole()) << weight;
        EXPECT_TRUE(work.done());
        if (weight <= 0.5) {
            EXPECT_GE(slices, 100U) << weight;  // a slice has no more elements than fit
        }
    }
}

TEST(SlicedWork, AFractionGrowsFromZeroToOne) {
    SlicedWork work;
    std::string log;
    plan(work, log);
    double former = work.fraction();
    EXPECT_EQ(former, 0);
    bool between = false;
    while (work.advance(0.5)) {
        EXPECT_GE(work.fraction(), former);
        EXPECT_LE(work.fraction(), 1);
        between = between || (former > 0.4 && former < 0.6);
        former = work.fraction();
    }
    EXPECT_TRUE(between);
    EXPECT_NEAR(work.fraction(), 1, 1e-12);
}

TEST(SlicedWork, AfterAStopNothingIsDoneAndNothingIsKept) {
    const auto kept = std::make_shared<int>(0);
    SlicedWork work;
    work.step(1, [&work, kept] {
        *kept += 1;
        work.step(1, [kept] { *kept += 10; });
        work.stop();
    });
    work.loop(5, 5, [kept](std::size_t, std::size_t) { *kept += 100; });
    EXPECT_EQ(kept.use_count(), 3);
    EXPECT_FALSE(work.advance(std::numeric_limits<double>::max()));
    EXPECT_EQ(*kept, 1);
    EXPECT_EQ(kept.use_count(), 1);
}

TEST(SlicedWork, AnEndedWorkFreesWhatItsLoopsHeld) {
    const auto kept = std::make_shared<int>(0);
    {
        SlicedWork work;
        work.loop(10, 10, [kept](std::size_t, std::size_t) {});
        EXPECT_TRUE(work.advance(3));
        EXPECT_EQ(kept.use_count(), 2);
    }
    EXPECT_EQ(kept.use_count(), 1);
}

}  // namespace
}  // namespace knotwork
