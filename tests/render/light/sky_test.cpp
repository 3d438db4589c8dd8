#include "render/light/sky.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "render/light/environment.h"
#include "tests/render/direction_density.h"
#include "tests/render/light/light_samples.h"

namespace carom::render {
namespace {

Sky clear_sky(double elevation) {
    Sky sky;
    sky.sun = Vec3(std::cos(elevation), 0, std::sin(elevation));
    return sky;
}

double luminance_at(const Sky& sky, double azimuth, double elevation) {
    return luminance(environment_radiance(
        sky, V3f(Vec3(std::cos(azimuth) * std::cos(elevation),
                      std::sin(azimuth) * std::cos(elevation), std::sin(elevation)))));
}

// The model's own formula for the zenith: 5.39 kcd/m^2 at turbidity 3 and 45 degrees.
TEST(Sky, Zenith_HasTheModelsLuminanceAndIsBlue) {
    const double chi = (4.0 / 9 - 3.0 / 120) * (M_PI / 2);
    const double kcd = (4.0453 * 3 - 4.9710) * std::tan(chi) - 0.2155 * 3 + 2.4192;
    const V3f zenith = environment_radiance(clear_sky(M_PI / 4), V3f(0, 0, 1));
    EXPECT_NEAR(luminance(zenith), 1000 * kcd / 179, 0.01 * 1000 * kcd / 179);
    EXPECT_GT(zenith.z, 1.5f * zenith.x);
    EXPECT_GT(zenith.y, zenith.x);
}

TEST(Sky, Light_IsSymmetricAboutTheSunAndBrightestAtIt) {
    const Sky sky = clear_sky(0.6);
    for (const double azimuth : {0.3, 1.2, 2.8}) {
        EXPECT_NEAR(luminance_at(sky, azimuth, 0.4), luminance_at(sky, -azimuth, 0.4), 1e-3);
        EXPECT_LT(luminance_at(sky, azimuth, 0.6), luminance_at(sky, 0, 0.6));
    }
    // Opposite to the sun, the horizon is brighter than the sky above it.
    EXPECT_GT(luminance_at(sky, M_PI, 0.1), luminance_at(sky, M_PI, 1.0));
    Sky hazy = sky;
    hazy.turbidity = 6;
    EXPECT_GT(luminance_at(hazy, 0, 0.6) / luminance_at(hazy, M_PI, 0.6), 1);
}

TEST(Sky, AsEnvironment_ShinesFromItsSunAndIsSampledByItsDensity) {
    EnvironmentLight light;
    light.sky = clear_sky(0.7);
    const Environment environment(light);
    ASSERT_TRUE(environment.is_sampled());
    for (const V3f& direction :
         {V3f(0.6f, 0.3f, 0.74f).normalized(), V3f(-0.5f, -0.5f, 0.7f).normalized()}) {
        const float exact = luminance(environment_radiance(*light.sky, direction));
        EXPECT_NEAR(luminance(environment.radiance(direction)), exact, 0.02 * exact);
    }
    test::DensityTest setup;
    setup.tests = 1;
    test::expect_direction_density(
        [&](const V3f& u) -> std::optional<V3f> {
            const auto sample = light_sample(environment, V2f(u.x, u.y));
            return sample ? std::optional(sample->direction) : std::nullopt;
        },
        [&](const V3f& direction) { return pdf(environment, direction); }, V3f(0, 0, 1), 2, setup);
}

TEST(Sky, Ground_IsADiffuseSurfaceUnderTheSky) {
    Sky sky = clear_sky(0.9);
    sky.ground = Vec3(0.5, 0.5, 0.5);
    const LinearImage picture = sky_picture(sky);
    V3f irradiance(0, 0, 0);
    for (int row = 0; row < picture.height / 2; ++row) {
        const double polar = M_PI * (row + 0.5) / picture.height;
        const double weight =
            std::sin(polar) * std::cos(polar) * 2 * M_PI * M_PI / (picture.width * picture.height);
        for (int column = 0; column < picture.width; ++column) {
            irradiance += picture.pixels[static_cast<std::size_t>(row * picture.width + column)] *
                          static_cast<float>(weight);
        }
    }
    const V3f& ground = picture.pixels.back();
    EXPECT_NEAR(ground.y, irradiance.y * 0.5 / M_PI, 1e-3 * ground.y);
}

TEST(Sky, ASunBelowTheHorizon_IsAnError) {
    EXPECT_THROW((void)sky_picture(clear_sky(-0.1)), Error);
    Sky thick = clear_sky(0.5);
    thick.turbidity = 11;
    EXPECT_THROW((void)sky_picture(thick), Error);
}

}  // namespace
}  // namespace carom::render
