#include "render/acceleration/vector_tier.h"

#include <gtest/gtest.h>

namespace carom::render {
namespace {

TEST(VectorTier, NameOfAnOption_IsThatOfKeys) {
    EXPECT_EQ(tier_named("avx2"), "AVX2");
    EXPECT_EQ(tier_named("sse4"), "SSE4");
    EXPECT_EQ(tier_named("ssse3"), "SSSE3");
    EXPECT_FALSE(tier_named("scalar").empty());
    EXPECT_EQ(tier_named("abacus"), "");
}

TEST(VectorTier, EveryMachine_HasTheLowestAndItsOwn) {
    EXPECT_TRUE(machine_has_tier(tier_named("scalar")));
    EXPECT_TRUE(machine_has_tier(simd_tier()));
    EXPECT_FALSE(machine_has_tier("ABACUS"));
    EXPECT_FALSE(machine_has_tier(""));
}

TEST(VectorTier, Limit_HoldsUntilItEnds) {
    const std::string_view usual = simd_tier();
    for (const std::string_view option : kTierOptions) {
        const std::string_view tier = tier_named(option);
        if (!machine_has_tier(tier)) {
            continue;
        }
        const TierLimit limit(tier);
        EXPECT_EQ(simd_tier(), tier);
    }
    EXPECT_EQ(simd_tier(), usual);
}

}  // namespace
}  // namespace carom::render
