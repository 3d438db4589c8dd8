#include "render/light/environment.h"

#include <filesystem>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "render/sampling/scalar_kernels.h"
#include "tests/render/direction_density.h"
#include "tests/render/light/light_samples.h"

namespace carom::render {
namespace {

using scalar::One;

/// A sky with a bright spot, in a temporary file.
class EnvironmentImage : public ::testing::Test {
  protected:
    static constexpr int kWidth = 64;
    static constexpr int kHeight = 32;

    void SetUp() override {
        path_ = (std::filesystem::temp_directory_path() /
                 ("carom_environment_test_" +
                  std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()) +
                  ".exr"))
                    .string();
        std::vector<float> pixels;
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const bool sun = x >= 40 && x < 43 && y >= 8 && y < 10;
                const bool black = y >= 20;
                pixels.push_back(sun ? 50.0f : (black ? 0.0f : 0.5f));
                pixels.push_back(sun ? 45.0f : (black ? 0.0f : 0.6f));
                pixels.push_back(sun ? 30.0f : (black ? 0.0f : 0.9f));
            }
        }
        const auto file = OIIO::ImageOutput::create(path_);
        ASSERT_TRUE(file);
        ASSERT_TRUE(file->open(path_, OIIO::ImageSpec(kWidth, kHeight, 3, OIIO::TypeDesc::FLOAT)));
        ASSERT_TRUE(file->write_image(OIIO::TypeDesc::FLOAT, pixels.data()));
        ASSERT_TRUE(file->close());
        light_.image = path_;
        light_.radiance = Vec3(2, 2, 2);
    }

    void TearDown() override { std::filesystem::remove(path_); }

    std::string path_;
    EnvironmentLight light_;
};

TEST_F(EnvironmentImage, Samples_FollowPdf) {
    const Environment environment(light_);
    ASSERT_TRUE(environment.is_sampled());
    test::DensityTest setup;
    setup.tests = 1;
    setup.samples = 200'000;
    setup.columns = kWidth;  // the density jumps from pixel to pixel
    setup.rows = kHeight;
    const double pi = std::numbers::pi;
    test::expect_square_density(
        [&](V3f u) -> std::optional<Vec2> {
            const auto sample = light_sample(environment, V2f(u.x, u.y));
            if (!sample) {
                return std::nullopt;
            }
            const V3f d = sample->direction;
            return Vec2(0.5 - std::atan2(d.y, d.x) / (2 * pi), std::acos(d.z) / pi);
        },
        [&](const Vec2& place) {
            const double azimuth = (0.5 - place.x) * 2 * pi;
            const double sine = std::sin(place.y * pi);
            const V3f d(
                Vec3(sine * std::cos(azimuth), sine * std::sin(azimuth), std::cos(place.y * pi)));
            return pdf(environment, d) * 2 * pi * pi * sine;
        },
        setup);
}

TEST_F(EnvironmentImage, EverySample_HasItsRadianceAndPdf) {
    light_.rotation = -2;
    const Environment environment(light_);
    test::TestRandom random(3);
    int differing = 0;
    for (int i = 0; i < 1000; ++i) {
        const float x = random.unit();
        const float y = random.unit();
        const auto sample = light_sample(environment, V2f(x, y));
        ASSERT_TRUE(sample);
        EXPECT_NEAR((environment.radiance(sample->direction) - sample->radiance).length(), 0,
                    0.02f);
        // At the very edge of a pixel the direction may round to the neighbour.
        differing +=
            std::abs(pdf(environment, sample->direction) / sample->pdf - 1) > 1e-3f ? 1 : 0;
    }
    EXPECT_LT(differing, 5);
}

TEST_F(EnvironmentImage, SampledIrradiance_EqualsTheIntegralOfRadiance) {
    const Environment environment(light_);
    const V3f normal = V3f(0.3f, -0.4f, 0.8f).normalized();
    double integral = 0;
    constexpr int kSteps = 600;
    for (int j = 0; j < kSteps; ++j) {
        for (int i = 0; i < kSteps; ++i) {
            const V2f u((static_cast<float>(j) + 0.5f) / kSteps,
                        (static_cast<float>(i) + 0.5f) / kSteps);
            const V3f d = scalar::sample_cone<One>(u, 2);
            integral += std::max(0.0f, d.dot(normal)) * environment.radiance(d).y;
        }
    }
    integral *= 4 * static_cast<double>(kPi) / (kSteps * kSteps);
    test::TestRandom random(21);
    double sum = 0;
    double squares = 0;
    constexpr int kSamples = 100'000;
    for (int i = 0; i < kSamples; ++i) {
        const float x = random.unit();
        const float y = random.unit();
        const auto sample = light_sample(environment, V2f(x, y));
        const double value =
            std::max(0.0f, sample->direction.dot(normal)) * sample->radiance.y / sample->pdf;
        sum += value;
        squares += value * value;
    }
    const double mean = sum / kSamples;
    const double error = std::sqrt((squares / kSamples - mean * mean) / kSamples);
    EXPECT_NEAR(mean, integral, 4 * error + 0.002 * integral);
}

TEST_F(EnvironmentImage, MiddleColumn_LiesTowardsXAndRotatesCounterClockwise) {
    // The sun's columns 40 to 42 are right of the middle: towards -y as seen from inside.
    const float u = 41.5f / kWidth;
    const float azimuth = (0.5f - u) * 2 * kPi;
    const float polar = kPi * 9.0f / kHeight;
    const V3f sun(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                  std::cos(polar));
    EXPECT_LT(sun.y, 0);
    EXPECT_GT(Environment(light_).radiance(sun).x, 90);
    light_.rotation = 0.5;
    const V3f turned(std::sin(polar) * std::cos(azimuth + 0.5f),
                     std::sin(polar) * std::sin(azimuth + 0.5f), std::cos(polar));
    EXPECT_GT(Environment(light_).radiance(turned).x, 90);
    EXPECT_LT(Environment(light_).radiance(sun).x, 10);
}

TEST_F(EnvironmentImage, MissingFile_IsNamed) {
    light_.image = "/nowhere/sky.exr";
    try {
        const Environment environment(light_);
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("/nowhere/sky.exr"), std::string::npos);
    }
}

TEST(ConstantEnvironment, Radiance_IsTheSameEverywhereAndNotSampled) {
    EnvironmentLight light;
    light.radiance = Vec3(0.1, 0.2, 0.3);
    const Environment environment(light);
    EXPECT_FALSE(environment.is_sampled());
    EXPECT_EQ(environment.radiance(V3f(0, 0, 1)), V3f(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(Environment().radiance(V3f(0, 1, 0)), V3f(0, 0, 0));
}

}  // namespace
}  // namespace carom::render
