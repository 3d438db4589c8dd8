#include "render/acceleration/flush_denormals.h"

#include <atomic>
#include <cstddef>
#include <limits>

#include <gtest/gtest.h>

#include "render/threads/thread_arena.h"

namespace carom::render {
namespace {

bool denormals_survive() {
    volatile float smallest = std::numeric_limits<float>::min();
    volatile float half = smallest * 0.5f;
    return half != 0;
}

TEST(FlushDenormals, WhileAlive_DenormalsAreZero) {
    EXPECT_TRUE(denormals_survive());
    {
        const FlushDenormals mode;
        EXPECT_FALSE(denormals_survive());
        { const FlushDenormals nested; }
        EXPECT_FALSE(denormals_survive());
    }
    EXPECT_TRUE(denormals_survive());
}

TEST(FlushDenormals, InEveryTask_HoldsThereAndLeavesNoTrace) {
    std::atomic<int> surviving = 0;
    std::atomic<int> surviving_within = 0;
    parallel_for(500, [&](std::size_t) {
        {
            const FlushDenormals mode;
            surviving_within += denormals_survive() ? 1 : 0;
        }
        surviving += denormals_survive() ? 1 : 0;
    });
    EXPECT_EQ(surviving_within, 0);
    EXPECT_EQ(surviving, 500);
}

}  // namespace
}  // namespace carom::render
