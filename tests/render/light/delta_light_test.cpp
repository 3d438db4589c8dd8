#include "render/light/delta_light.h"

#include <cmath>

#include <gmock/gmock.h>

#include "core/error.h"
#include "render/light/light_set.h"
#include "tests/render/light/light_samples.h"

namespace carom::render {
namespace {

/// Irradiance perpendicular to the direction of the light.
V3f irradiance(const DeltaLight& light, const V3f& point) {
    const auto sample = light_sample(light, point);
    return sample ? sample->radiance / sample->pdf : V3f(0, 0, 0);
}

TEST(PointLight, Irradiance_FallsWithTheSquareOfTheDistance) {
    const DeltaLight light = *delta_light_of({"light", PointLight{{1, 2, 3}, {10, 20, 40}}});
    for (const float distance : {0.1f, 1.0f, 2.5f, 30.0f}) {
        const V3f arriving = irradiance(light, V3f(1, 2 + distance, 3));
        EXPECT_NEAR(arriving.x * distance * distance, 10, 1e-4);
        EXPECT_NEAR(arriving.z * distance * distance, 40, 1e-4);
    }
    EXPECT_FALSE(light_sample(light, V3f(1, 2, 3)));
    const auto sample = light_sample(light, V3f(1, 2, 0));
    EXPECT_EQ(sample->direction, V3f(0, 0, 1));
    EXPECT_EQ(sample->distance, 3);
}

TEST(PointLight, WithoutFalloff_GivesTheSameAtEveryDistance) {
    const DeltaLight light =
        *delta_light_of({"light", PointLight{{1, 2, 3}, {10, 20, 40}, Falloff::none}});
    for (const float distance : {0.1f, 1.0f, 2.5f, 30.0f}) {
        EXPECT_EQ(irradiance(light, V3f(1, 2 + distance, 3)), V3f(10, 20, 40));
        EXPECT_NEAR(scalar::importance_of_delta_light<scalar::One>(
                        light.constants(), V3f(1, 2 + distance, 3), V3f(0, -1, 0)),
                    luminance(V3f(10, 20, 40)), 1e-4);
        // For specular connections: the intensity that gives this irradiance there.
        EXPECT_NEAR(light.intensity(V3f(0, 1, 0), distance).x / (distance * distance), 10, 1e-4);
    }
    EXPECT_NEAR(light.irradiance_within(V3f(1, 50, 3), 1), luminance(V3f(10, 20, 40)), 1e-4);
}

TEST(SpotLight, Cone_IsFullInsideDarkOutsideAndSmoothBetween) {
    SpotLight spot;
    spot.position = Vec3(0, 0, 2);
    spot.direction = Vec3(0, 0, -2);
    spot.intensity = Vec3(8, 8, 8);
    spot.inner_angle = 0.3;
    spot.outer_angle = 0.5;
    const DeltaLight light = *delta_light_of({"light", spot});
    const auto at_angle = [&](double angle) {
        const double s = 2 * std::sin(angle);
        return irradiance(light, V3f(static_cast<float>(s), 0,
                                     2 - 2 * static_cast<float>(std::cos(angle))))
            .x;
    };
    EXPECT_NEAR(at_angle(0), 2, 1e-5);
    EXPECT_NEAR(at_angle(0.29), 2, 1e-5);
    EXPECT_EQ(at_angle(0.51), 0);
    const double middle = std::acos((std::cos(0.3) + std::cos(0.5)) / 2);
    EXPECT_NEAR(at_angle(middle), 1, 1e-4);
    float before = 2.0f;
    for (double angle = 0.3; angle < 0.51; angle += 0.01) {
        EXPECT_LE(at_angle(angle), before + 1e-5f);
        before = at_angle(angle);
    }
}

TEST(DirectionalLight, Irradiance_IsTheSameEverywhere) {
    const DeltaLight light = *delta_light_of({"light", DirectionalLight{{0, 3, -4}, {5, 6, 7}}});
    for (const V3f& point : {V3f(0, 0, 0), V3f(100, -3, 2)}) {
        EXPECT_EQ(irradiance(light, point), V3f(5, 6, 7));
        const V3f direction = light_sample(light, point)->direction;
        EXPECT_NEAR(direction.y, -0.6f, 1e-6f);
        EXPECT_NEAR(direction.z, 0.8f, 1e-6f);
    }
}

TEST(LightSet, DeltaLights_AreChosenByWhatTheyGive) {
    const LightSet lights({{"bulb", PointLight{{0, 0, 1}, {3, 3, 3}}},
                           {"room", EnvironmentLight{}},
                           {"sun", DirectionalLight{{0, 0, -1}, {1, 1, 1}}},
                           {"lamp", RectangleLight{}}});
    EXPECT_EQ(lights.area_light_count(), 1U);
    EXPECT_EQ(lights.lights().size(), 3U);
    EXPECT_FALSE(lights.is_delta(0));
    EXPECT_TRUE(lights.is_delta(1) && lights.is_delta(2));
    const V3f point(0, 0, 0);
    const V3f up(0, 0, 1);
    const auto importance = [&](std::size_t light, const V3f& normal) {
        return scalar::importance_of_delta_light<scalar::One>(lights.delta_light(light).constants(),
                                                              point, normal);
    };
    EXPECT_NEAR(importance(1, up), 3, 1e-5);
    EXPECT_NEAR(importance(2, up), 1, 1e-5);
    EXPECT_EQ(importance(1, -up), 0);
}

TEST(LightSet, WrongDeltaLights_AreErrorsThatNameThem) {
    const auto said = [](const auto& light) {
        try {
            const LightSet set({{"torch", light}});
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(said(SpotLight{{0, 0, 1}, {0, 0, 0}, {1, 1, 1}, 0.1, 0.2}),
              "light 'torch': the axis has no length");
    EXPECT_THAT(said(SpotLight{{0, 0, 1}, {0, 0, 1}, {1, 1, 1}, 0.3, 0.2}),
                testing::HasSubstr("0 <= inner <= outer"));
    EXPECT_THAT(said(PointLight{{0, 0, 1}, {-1, 1, 1}}), testing::HasSubstr("negative"));
    EXPECT_THAT(said(DirectionalLight{{0, 0, 0}, {1, 1, 1}}), testing::HasSubstr("no length"));
}

}  // namespace
}  // namespace carom::render
