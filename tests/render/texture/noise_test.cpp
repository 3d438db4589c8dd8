#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "render/texture/noise_grid.h"
#include "render/texture/scalar_kernels.h"
#include "tests/render/statistics.h"

namespace carom::render {
namespace {

using scalar::One;

float noise(const V3f& position, std::uint32_t seed) {
    return scalar::gradient_noise<One>(position, seed);
}

/// The noise of a NoiseGrid at any point of the plane, computed directly.
float periodic_noise(const V2f& position, int period_x, int period_y, std::uint32_t seed) {
    const auto x = scalar::noise_cell<One>(position.x);
    const auto y = scalar::noise_cell<One>(position.y);
    const auto wrapped = [](std::uint32_t cell, int period) {
        const int rest = static_cast<std::int32_t>(cell) % period;
        return static_cast<std::uint32_t>(rest < 0 ? rest + period : rest);
    };
    const auto towards_corner = [&](std::uint32_t i, std::uint32_t j) {
        const V2f gradient =
            lattice_gradient(wrapped(x.index + i, period_x), wrapped(y.index + j, period_y), seed);
        return gradient.x * (x.offset - static_cast<float>(i)) +
               gradient.y * (y.offset - static_cast<float>(j));
    };
    const float u = scalar::noise_fade<One>(x.offset);
    const float low = scalar::between<One>(towards_corner(0, 0), towards_corner(1, 0), u);
    const float high = scalar::between<One>(towards_corner(0, 1), towards_corner(1, 1), u);
    return std::clamp(scalar::between<One>(low, high, scalar::noise_fade<One>(y.offset)), -1.0f,
                      1.0f);
}

TEST(MixBits, DifferentInputs_GiveDifferentOutputs) {
    EXPECT_EQ(scalar::mix_bits<One>(0), 0u);
    EXPECT_NE(scalar::mix_bits<One>(1), scalar::mix_bits<One>(2));
    EXPECT_LT(scalar::unit_float<One>(0xffffffffu), 1.0f);
}

TEST(GradientNoise, OnTheLattice_IsZeroAndElsewhereBoundedWithMeanZero) {
    EXPECT_EQ(noise(V3f(3, -7, 12), 5), 0);
    EXPECT_EQ(periodic_noise(V2f(-3, 8), 50, 50, 5), 0);
    test::TestRandom random(1);
    double sum3 = 0;
    double sum2 = 0;
    double squares = 0;
    constexpr int kSamples = 50'000;
    for (int i = 0; i < kSamples; ++i) {
        const float x = random.between(-100, 100);
        const float y = random.between(-100, 100);
        const float z = random.between(-100, 100);
        const float n3 = noise(V3f(x, y, z), 9);
        const float n2 = periodic_noise(V2f(x, y), 1000, 1000, 9);
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
        EXPECT_NEAR(noise(before, 3), noise(after, 3), 1e-4f);
    }
}

TEST(GradientNoise, OtherSeed_IsAnotherPattern) {
    EXPECT_NE(noise(V3f(0.3f, 0.4f, 0.2f), 1), noise(V3f(0.3f, 0.4f, 0.2f), 2));
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
    const V3f place(0.37f, 5.21f, 2.83f);
    EXPECT_EQ(scalar::fractal_noise<One>(place, 1, 0, 7), noise(place, 7));
    EXPECT_NE(scalar::fractal_noise<One>(place, 4, 0, 7),
              scalar::fractal_noise<One>(place, 4, 0.3f, 7));
    EXPECT_EQ(scalar::fractal_noise<One>(place, 4, 0.7f, 7), 0);
}

TEST(BandWeight, FallsFromOneToZero) {
    EXPECT_EQ(scalar::band_weight<One>(0, 1), 1);
    EXPECT_EQ(scalar::band_weight<One>(1.0f / 3, 1), 1);
    EXPECT_EQ(scalar::band_weight<One>(1.0f / 1.5f, 1), 0);
    EXPECT_GT(scalar::band_weight<One>(0.4f, 1), scalar::band_weight<One>(0.5f, 1));
}

TEST(SmoothStep, MiddleIsHalfAndEndsAreFlat) {
    EXPECT_EQ(scalar::smooth_step<One>(0, 0.1f), 0.5f);
    EXPECT_EQ(scalar::smooth_step<One>(-0.06f, 0.1f), 0);
    EXPECT_EQ(scalar::smooth_step<One>(0.06f, 0.1f), 1);
}

}  // namespace
}  // namespace carom::render
