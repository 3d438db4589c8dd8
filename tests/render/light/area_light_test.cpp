#include "render/light/area_light.h"

#include <gtest/gtest.h>

#include "render/light/scalar_kernels.h"
#include "tests/render/direction_density.h"
#include "tests/render/light/light_samples.h"

namespace carom::render {
namespace {

using scalar::One;

RectangleLight lamp() {
    RectangleLight light;
    light.centre = Vec3(0.3, -0.2, 1.4);
    light.edge_u = Vec3(0.6, 0, 0);
    light.edge_v = Vec3(0, 0.25, 0);
    light.normal = Vec3(0, 0, -1);
    light.radiance = Vec3(20, 18, 15);
    return light;
}

SphereLight bulb() {
    SphereLight light;
    light.centre = Vec3(-0.5, 0.4, 0.9);
    light.radius = 0.3;
    light.radiance = Vec3(5, 6, 7);
    return light;
}

/// Distance along `direction` to the rectangle, or a negative number.
double distance_to(const RectangleLight& light, const V3f& point, const V3f& direction) {
    const Vec3 o(point);
    const Vec3 d(direction);
    const double t = (light.centre - o).dot(light.normal) / d.dot(light.normal);
    const Vec3 p = o + d * t - light.centre;
    const bool inside = std::abs(p.dot(light.edge_u)) <= light.edge_u.length2() &&
                        std::abs(p.dot(light.edge_v)) <= light.edge_v.length2();
    return inside ? t : -1;
}

/// Irradiance (per unit radiance) of a polygon entirely above the horizon: half the sum over its
/// edges of the angle that the edge subtends times the cosine between the normal and the edge's
/// plane (Lambert 1760; in this form Arvo 1995, "Analytic methods for simulated light transport",
/// eq. 2.2).
double polygon_irradiance(const std::vector<Vec3>& corners, const Vec3& point, const Vec3& normal) {
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 a = (corners[i] - point).normalized();
        const Vec3 b = (corners[(i + 1) % corners.size()] - point).normalized();
        sum += std::acos(a.dot(b)) * a.cross(b).normalized().dot(normal);
    }
    return std::abs(0.5 * sum);
}

TEST(RectangleLight, FromBehind_GivesNothing) {
    EXPECT_FALSE(light_sample(constants_of(lamp()), V3f(0, 0, 2), V2f(0.5f, 0.5f)));
}

TEST(RectangleLight, Samples_FollowPdf) {
    const RectangleLight light = lamp();
    const AreaLightConstants emitter = constants_of(light);
    for (const V3f& point : {V3f(0, 0, 0), V3f(1.5f, 0.2f, 1.0f)}) {
        test::DensityTest setup;
        setup.tests = 4;
        // Positions on the light, (0, 0) to (1, 1); the density per solid angle is converted to one
        // per position.
        test::expect_square_density(
            [&](V3f u) -> std::optional<Vec2> {
                const auto sample = light_sample(emitter, point, V2f(u.x, u.y));
                EXPECT_TRUE(sample.has_value());
                const Vec3 place =
                    Vec3(point) + Vec3(sample->direction) * sample->distance - light.centre;
                return Vec2(0.5 + 0.5 * place.dot(light.edge_u) / light.edge_u.length2(),
                            0.5 + 0.5 * place.dot(light.edge_v) / light.edge_v.length2());
            },
            [&](const Vec2& place) {
                const Vec3 to_light = light.centre + light.edge_u * (2 * place.x - 1) +
                                      light.edge_v * (2 * place.y - 1) - Vec3(point);
                const double distance = to_light.length();
                const double per_place =
                    -to_light.dot(light.normal) / distance * 0.6 / (distance * distance);
                return per_place * scalar::pdf_of_area_light<One>(emitter, point,
                                                                  V3f(to_light / distance),
                                                                  static_cast<float>(distance));
            },
            setup);
    }
}

TEST(SphereLight, Samples_FollowPdf) {
    const AreaLightConstants emitter = constants_of(bulb());
    const V3f centre(bulb().centre);
    for (const V3f& point : {V3f(0, 0, 0), V3f(-0.5f, 0.4f, 0.55f)}) {
        test::DensityTest setup;
        setup.tests = 4;
        const float distance = (centre - point).length();
        test::expect_direction_density(
            [&](V3f u) -> std::optional<V3f> {
                const auto sample = light_sample(emitter, point, V2f(u.x, u.y));
                EXPECT_TRUE(sample.has_value());
                return sample->direction;
            },
            [&](const V3f& direction) {
                return scalar::pdf_of_area_light<One>(emitter, point, direction, 1);
            },
            (centre - point) / distance, scalar::one_minus_cos_of_sphere<One>(0.3f, distance),
            setup);
    }
}

TEST(AreaLights, EverySample_LiesOnTheLightAndHasItsPdf) {
    test::TestRandom random(5);
    const AreaLightConstants rectangle = constants_of(lamp());
    const AreaLightConstants sphere = constants_of(bulb());
    const V3f point(0.2f, 0.1f, 0);
    for (int i = 0; i < 500; ++i) {
        const float x = random.unit();
        const float y = random.unit();
        const auto on_rectangle = light_sample(rectangle, point, V2f(x, y));
        ASSERT_TRUE(on_rectangle);
        EXPECT_NEAR(distance_to(lamp(), point, on_rectangle->direction), on_rectangle->distance,
                    1e-5);
        EXPECT_NEAR(scalar::pdf_of_area_light<One>(rectangle, point, on_rectangle->direction,
                                                   on_rectangle->distance) /
                        on_rectangle->pdf,
                    1, 1e-5);
        const auto on_sphere = light_sample(sphere, point, V2f(x, y));
        ASSERT_TRUE(on_sphere);
        const V3f place = point + on_sphere->direction * on_sphere->distance;
        EXPECT_NEAR((place - V3f(bulb().centre)).length(), 0.3f, 1e-3f);
        EXPECT_EQ(scalar::pdf_of_area_light<One>(sphere, point, on_sphere->direction, 1),
                  on_sphere->pdf);
    }
}

TEST(RectangleLight, Irradiance_IsLambertsFormula) {
    const RectangleLight light = lamp();
    const AreaLightConstants emitter = constants_of(light);
    const V3f point(0, 0, 0.1f);
    const V3f normal = V3f(0.2f, 0.1f, 1).normalized();
    test::TestRandom random(9);
    double sum = 0;
    double squares = 0;
    constexpr int kSamples = 100'000;
    for (int i = 0; i < kSamples; ++i) {
        const float x = random.unit();
        const float y = random.unit();
        const auto sample = light_sample(emitter, point, V2f(x, y));
        const double value =
            sample->direction.dot(normal) *
            scalar::emitted_by_area_light<One>(
                emitter, point + sample->direction * sample->distance, -sample->direction)
                .x /
            sample->pdf;
        sum += value;
        squares += value * value;
    }
    const double mean = sum / kSamples;
    const double error = std::sqrt((squares / kSamples - mean * mean) / kSamples);
    const std::vector<Vec3> corners{
        light.centre + light.edge_u + light.edge_v, light.centre - light.edge_u + light.edge_v,
        light.centre - light.edge_u - light.edge_v, light.centre + light.edge_u - light.edge_v};
    const double exact = light.radiance.x * polygon_irradiance(corners, Vec3(point), Vec3(normal));
    EXPECT_NEAR(mean, exact, 4 * error);
    EXPECT_LT(error, 0.005 * exact);
}

TEST(SphereLight, Irradiance_IsPiTimesSquareOfTheRatio) {
    // pi L (R / d)^2 cos(theta) while the sphere is entirely above the horizon.
    const AreaLightConstants emitter = constants_of(bulb());
    const V3f point(0, 0, 0);
    const V3f normal(0, 0, 1);
    test::TestRandom random(13);
    double sum = 0;
    double squares = 0;
    constexpr int kSamples = 100'000;
    for (int i = 0; i < kSamples; ++i) {
        const float x = random.unit();
        const float y = random.unit();
        const auto sample = light_sample(emitter, point, V2f(x, y));
        const double value =
            sample->direction.dot(normal) *
            scalar::emitted_by_area_light<One>(
                emitter, point + sample->direction * sample->distance, -sample->direction)
                .x /
            sample->pdf;
        sum += value;
        squares += value * value;
    }
    const double mean = sum / kSamples;
    const double error = std::sqrt((squares / kSamples - mean * mean) / kSamples);
    const double distance2 = bulb().centre.length2();
    const double exact =
        static_cast<double>(kPi) * 5 * 0.09 / distance2 * 0.9 / std::sqrt(distance2);
    EXPECT_NEAR(mean, exact, 4 * error);
    EXPECT_LT(error, 0.005 * exact);
}

TEST(RectangleLight, PointBehindIt_GetsNothing) {
    const AreaLightConstants emitter = constants_of(lamp());
    const V3f above(0, 0, 2);
    EXPECT_FALSE(light_sample(emitter, above, V2f(0.5f, 0.5f)));
    EXPECT_EQ(scalar::importance_of_area_light<One>(emitter, above, V3f(0, 0, -1)), 0);
    EXPECT_EQ(scalar::pdf_of_area_light<One>(emitter, above, V3f(0, 0, -1), 0.6f), 0);
    EXPECT_EQ(scalar::emitted_by_area_light<One>(emitter, emitter.centre, V3f(0, 0, 1)),
              V3f(0, 0, 0));
    EXPECT_EQ(scalar::emitted_by_area_light<One>(emitter, emitter.centre, V3f(0, 0, -1)),
              V3f(20, 18, 15));
}

TEST(SphereLight, PointInsideIt_IsNotSampled) {
    const AreaLightConstants emitter = constants_of(bulb());
    EXPECT_FALSE(light_sample(emitter, V3f(-0.5f, 0.4f, 1.0f), V2f(0.5f, 0.5f)));
    EXPECT_EQ(scalar::pdf_of_area_light<One>(emitter, V3f(-0.5f, 0.4f, 1.0f), V3f(0, 0, 1), 1), 0);
}

TEST(AreaLights, PartlyAboveTheHorizon_AreStillChosen) {
    const AreaLightConstants sphere = constants_of(bulb());
    const V3f point(0, 0, 0);
    const V3f towards = (V3f(bulb().centre) - point).normalized();
    const V3f sideways = towards.cross(V3f(0, 0, 1)).normalized();
    EXPECT_GT(scalar::importance_of_area_light<One>(sphere, point,
                                                    (sideways - towards * 0.1f).normalized()),
              0);
    EXPECT_EQ(scalar::importance_of_area_light<One>(sphere, point, -towards), 0);
}

}  // namespace
}  // namespace carom::render
