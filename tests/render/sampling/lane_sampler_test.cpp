// The sampler in vector lanes returns the bits of a single lane, on every instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/render/sampling/lane_sampler_test.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "render/sampling/kernels-inl.h"

#ifndef CAROM_SAMPLES_OF_LANES
#define CAROM_SAMPLES_OF_LANES
namespace carom::test {

/// Samples of one lane each, and their numbers.
struct LaneSamples {
    static constexpr int kMost = 16;

    alignas(64) std::uint32_t pixel_hash[kMost];
    alignas(64) std::uint32_t reversed_sample[kMost];
    alignas(64) std::uint32_t set[kMost];
    std::uint32_t block_set = 0;
    alignas(64) float four[4][kMost];
    alignas(64) float block[8][kMost];  // the x coordinates first
    alignas(64) float camera[5][kMost];
    alignas(64) float one[kMost];
    int lanes = 0;
    const char* target = "";
};

}  // namespace carom::test
#endif

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

HWY_ATTR void fill(test::LaneSamples& samples) {
    using L = Lanes;
    const auto load = [](const std::uint32_t* words)
                          HWY_ATTR { return hn::Load(L::WordTag(), words); };
    const SamplerOf<L> sampler(load(samples.pixel_hash), load(samples.reversed_sample));
    const L::Word set = load(samples.set);
    L::Value numbers[5];
    L::Value x[4], y[4];
    sampler.get_camera_sample(numbers);
    for (int i = 0; i < 5; ++i) {
        L::store(numbers[i], samples.camera[i]);
    }
    L::Value four[4];
    sampler.get_4d(set, four);
    sampler.get_2d_block(samples.block_set, x, y);
    for (int i = 0; i < 4; ++i) {
        L::store(four[i], samples.four[i]);
        L::store(x[i], samples.block[i]);
        L::store(y[i], samples.block[4 + i]);
    }
    L::store(sampler.get_1d(set), samples.one);
    samples.lanes = L::count();
    samples.target = hwy::TargetName(HWY_TARGET);
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <array>

#include <gtest/gtest.h>

#include "render/sampling/sampler.h"
#include "render/sampling/scalar_kernels.h"
#include "tests/render/every_target.h"
#include "tests/render/statistics.h"

namespace carom::render {

HWY_EXPORT(fill);

namespace {

void expect_same_numbers(const test::LaneSamples& lanes, int lane) {
    const scalar::SamplerOf<scalar::One> one(lanes.pixel_hash[lane], lanes.reversed_sample[lane]);
    float camera[5], four[4], x[4], y[4];
    one.get_camera_sample(camera);
    one.get_4d(lanes.set[lane], four);
    one.get_2d_block(lanes.block_set, x, y);
    for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(lanes.camera[i][lane], camera[i]) << i;
    }
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(lanes.four[i][lane], four[i]) << i;
        EXPECT_EQ(lanes.block[i][lane], x[i]) << i;
        EXPECT_EQ(lanes.block[4 + i][lane], y[i]) << i;
    }
    EXPECT_EQ(lanes.one[lane], one.get_1d(lanes.set[lane]));
}

TEST(LaneSampler, EveryInstructionSet_SameBitsAsOneSampleAtATime) {
    test::TestRandom random(9);
    for (int run = 0; run < 200; ++run) {
        test::LaneSamples lanes;
        for (int i = 0; i < test::LaneSamples::kMost; ++i) {
            const SampleStream stream(random.next(), random.next() % 5000, random.next() % 5000,
                                      random.next() % (1u << (run % 30)));
            lanes.pixel_hash[i] = stream.pixel_hash();
            lanes.reversed_sample[i] = stream.reversed_sample();
            lanes.set[i] = random.next();
        }
        lanes.block_set = random.next();
        test::for_each_instruction_set([&](const char*) {
            HWY_DYNAMIC_DISPATCH(fill)(lanes);
            SCOPED_TRACE(lanes.target);
            for (int i = 0; i < lanes.lanes; ++i) {
                expect_same_numbers(lanes, i);
            }
        });
    }
}

}  // namespace
}  // namespace carom::render

#endif
