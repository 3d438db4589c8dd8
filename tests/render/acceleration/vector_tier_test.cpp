#include "render/acceleration/vector_tier.h"

#include <gtest/gtest.h>

#include "render/acceleration/embree_handles.h"

namespace carom::render {
namespace {

/// Whether Embree traces eight rays together, which it does from AVX on.
bool embree_has_eight_lanes() {
    const EmbreeDevice device;
    return rtcGetDeviceProperty(device.get(), RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED) != 0;
}

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

TEST(VectorTier, Limit_HoldsForOurKernelsAndEmbreeUntilItEnds) {
    const std::string_view usual = simd_tier();
    const bool usual_lanes = embree_has_eight_lanes();
    EXPECT_EQ(usual_lanes, usual == "AVX2");
    for (const std::string_view option : kTierOptions) {
        const std::string_view tier = tier_named(option);
        if (!machine_has_tier(tier)) {
            continue;
        }
        const TierLimit limit(tier);
        EXPECT_EQ(simd_tier(), tier);
        EXPECT_EQ(embree_has_eight_lanes(), tier == "AVX2");
    }
    EXPECT_EQ(simd_tier(), usual);
    EXPECT_EQ(embree_has_eight_lanes(), usual_lanes);
}

}  // namespace
}  // namespace carom::render
