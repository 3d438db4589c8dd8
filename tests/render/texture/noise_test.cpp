#include "render/texture/noise.h"

#include <gtest/gtest.h>

#include "render/texture/noise_grid.h"
#include "tests/render/statistics.h"

namespace carom::render {
namespace {

TEST(MixBits, DifferentInputs_GiveDifferentOutputs) {
    EXPECT_EQ(mix_bits(0), 0u);
    EXPECT_NE(mix_bits(1), mix_bits(2));
    EXPECT_LT(unit_float(0xffffffffu), 1.0f);
}

TEST(GradientNoise, OnTheLattice_IsZeroAndElsewhereBoundedWithMeanZero) {
    EXPECT_EQ(gradient_noise(V3f(3, -7, 12), 5), 0);
    EXPECT_EQ(gradient_noise(V2f(-3, 8), 5), 0);
    test::TestRandom random(1);
    double sum3 = 0;
    double sum2 = 0;
    double squares = 0;
    constexpr int kSamples = 50'000;
    for (int i = 0; i < kSamples; ++i) {
        const float x = random.between(-100, 100);
        const float y = random.between(-100, 100);
        const float z = random.between(-100, 100);
        const float n3 = gradient_noise(V3f(x, y, z), 9);
        const float n2 = gradient_noise(V2f(x, y), 9);
        ASSERT_LE(std::abs(n3), 1);
        ASSERT_LE(std::abs(n2), 1);
        sum3 += n3;
        sum2 += n2;
        squares += n3 * n3;
    }
    EXPECT_NEAR(sum3 / kSamples, 0, 0.01);
    EXPECT_NEAR(sum2 / kSamples, 0, 0.01);
    EXPECT_GT(squares / kSamples, 0.02);
}

TEST(GradientNoise, AcrossCells_IsContinuous) {
    for (float x = -2; x < 2; x += 1) {
        const V3f before(x - 1e-5f, 0.3f, 0.7f);
        const V3f after(x + 1e-5f, 0.3f, 0.7f);
        EXPECT_NEAR(gradient_noise(before, 3), gradient_noise(after, 3), 1e-4f);
    }
}

TEST(GradientNoise, OtherSeed_IsAnotherPattern) {
    EXPECT_NE(gradient_noise(V3f(0.3f, 0.4f, 0.2f), 1), gradient_noise(V3f(0.3f, 0.4f, 0.2f), 2));
}

TEST(NoiseGrid, AtEveryTexel_HasTheBitsOfPeriodicNoise) {
    constexpr int kSize = 64;
    const NoiseGrid grid(kSize, 13, 5, 77);
    std::vector<float> row(kSize);
    for (int y = 0; y < kSize; ++y) {
        grid.row(y, row);
        for (int x = 0; x < kSize; ++x) {
            const V2f at((static_cast<float>(x) + 0.5f) * 13 / kSize,
                         (static_cast<float>(y) + 0.5f) * 5 / kSize);
            ASSERT_EQ(row[static_cast<std::size_t>(x)], periodic_noise(at, 13, 5, 77));
        }
    }
}

TEST(PeriodicNoise, OnePeriodOn_IsTheSame) {
    for (float x = 0.05f; x < 5; x += 0.37f) {
        const float here = periodic_noise(V2f(x, 0.6f * x), 5, 3, 7);
        EXPECT_NEAR(periodic_noise(V2f(x + 5, 0.6f * x - 3), 5, 3, 7), here, 1e-5f);
    }
    EXPECT_NEAR(periodic_noise(V2f(4.9999f, 0.5f), 5, 3, 7),
                periodic_noise(V2f(0.0001f, 0.5f), 5, 3, 7), 1e-3f);
}

TEST(FractalNoise, CoarserFootprint_LeavesFewerOctavesAndInTheEndNothing) {
    const V2f place(0.37f, 5.21f);
    EXPECT_EQ(fractal_noise(place, 1, 0, 7), gradient_noise(place, 7));
    EXPECT_NE(fractal_noise(place, 4, 0, 7), fractal_noise(place, 4, 0.3f, 7));
    EXPECT_EQ(fractal_noise(place, 4, 0.7f, 7), 0);
}

TEST(BandWeight, FallsFromOneToZero) {
    EXPECT_EQ(band_weight(0, 1), 1);
    EXPECT_EQ(band_weight(1.0f / 3, 1), 1);
    EXPECT_EQ(band_weight(1.0f / 1.5f, 1), 0);
    EXPECT_GT(band_weight(0.4f, 1), band_weight(0.5f, 1));
}

TEST(SmoothStep, MiddleIsHalfAndEndsAreFlat) {
    EXPECT_EQ(smooth_step(0, 0.1f), 0.5f);
    EXPECT_EQ(smooth_step(-0.06f, 0.1f), 0);
    EXPECT_EQ(smooth_step(0.06f, 0.1f), 1);
}

}  // namespace
}  // namespace carom::render
