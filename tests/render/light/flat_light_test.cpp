// Disks, directional profiles, and lamps in shades.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "render/light/area_light.h"
#include "render/light/light_power.h"
#include "render/light/light_tree.h"
#include "render/light/scalar_kernels.h"
#include "render/light/shade_inside.h"
#include "tests/render/direction_density.h"
#include "tests/render/light/light_samples.h"

namespace carom::render {
namespace {

using scalar::One;

constexpr double kPiDouble = std::numbers::pi;

DiskLight disk() {
    DiskLight light;
    light.centre = Vec3(0.3, -0.2, 1.4);
    light.radius = 0.25;
    light.normal = Vec3(0.28, 0, -0.96);
    light.radiance = Vec3(20, 18, 15);
    return light;
}

ShadeLight shade() {
    ShadeLight light;
    light.centre = Vec3(0, 0, 1);
    light.shape = {0.2, 0.05, 0.24, 0.6};
    light.disk_radius = 0.07;
    light.depth = 0.16;
    light.albedo = Vec3(0.85, 0.8, 0.5);
    light.radiance = Vec3(30, 30, 30);
    return light;
}

/// A mean with its standard error.
struct Estimate {
    double mean = 0;
    double error = 0;
};

template <class Draw>
Estimate estimate(int samples, const Draw& draw) {
    test::TestRandom random(17);
    double sum = 0;
    double squares = 0;
    for (int i = 0; i < samples; ++i) {
        const float x = random.unit();
        const float y = random.unit();
        const double value = draw(x, y);
        sum += value;
        squares += value * value;
    }
    const double mean = sum / samples;
    return {mean, std::sqrt(std::max(0.0, squares / samples - mean * mean) / samples)};
}

/// Irradiance of a surface, by samples of the light. `channel`: of the colour.
Estimate irradiance_of(const AreaLightConstants& light, const V3f& point, const V3f& normal,
                       int channel = 0) {
    return estimate(200'000, [&](float x, float y) {
        const auto sample = light_sample(light, point, V2f(x, y));
        const float cosine = sample ? std::max(0.0F, sample->direction.dot(normal)) : 0;
        return sample ? static_cast<double>(sample->radiance[channel] * cosine / sample->pdf) : 0;
    });
}

/// The same by directions that are uniform over the hemisphere, as a path finds the light.
Estimate found_irradiance_of(const AreaLightConstants& light, const V3f& point, const V3f& normal,
                             int channel = 0) {
    const auto basis = scalar::basis_around<One>(normal);
    return estimate(2'000'000, [&](float x, float y) {
        const float sine = std::sqrt(1 - x * x);
        const float turn = 2 * kPi * y;
        const V3f direction = basis.to_world(V3f(sine * std::cos(turn), sine * std::sin(turn), x));
        const float t = (light.centre - point).dot(light.normal) / direction.dot(light.normal);
        const V3f place = point + direction * t;
        if (!(t > 0) || (place - light.centre).length() > light.radius) {
            return 0.0;
        }
        const V3f emitted = scalar::emitted_by_area_light<One>(light, place, -direction);
        return static_cast<double>(emitted[channel] * x * 2 * kPi);
    });
}

/// Of a unit radiance: pi times the fraction of the hemisphere's projection that a disk covers,
/// which faces the surface on its axis.
double irradiance_on_axis(double radius, double distance) {
    return kPiDouble * radius * radius / (radius * radius + distance * distance);
}

TEST(DiskLight, IrradianceOnItsAxis_IsItsShareOfTheHemisphere) {
    DiskLight light = disk();
    light.normal = Vec3(0, 0, -1);
    const AreaLightConstants emitter = constants_of(light);
    const Estimate found = irradiance_of(emitter, V3f(0.3f, -0.2f, 0.9f), V3f(0, 0, 1));
    EXPECT_NEAR(found.mean, 20 * irradiance_on_axis(0.25, 0.5), 4 * found.error);
    EXPECT_LT(found.error, 0.002 * found.mean);
}

TEST(DiskLight, EverySample_LiesOnItAndHasItsPdf) {
    const AreaLightConstants emitter = constants_of(disk());
    const V3f point(0.2f, 0.1f, 0);
    test::TestRandom random(5);
    for (int i = 0; i < 500; ++i) {
        const float x = random.unit();
        const auto sample = light_sample(emitter, point, V2f(x, random.unit()));
        ASSERT_TRUE(sample);
        const V3f place = point + sample->direction * sample->distance - V3f(disk().centre);
        EXPECT_LE(place.length(), 0.25f * 1.0001f);
        EXPECT_NEAR(place.dot(V3f(disk().normal)), 0, 1e-5f);
        EXPECT_NEAR(
            scalar::pdf_of_area_light<One>(emitter, point, sample->direction, sample->distance) /
                sample->pdf,
            1, 1e-5);
        EXPECT_EQ(sample->radiance, V3f(20, 18, 15));
    }
}

TEST(DiskLight, FromBehind_GivesNothing) {
    const AreaLightConstants emitter = constants_of(disk());
    const V3f above(0, 0, 2);
    EXPECT_FALSE(light_sample(emitter, above, V2f(0.5f, 0.5f)));
    EXPECT_EQ(scalar::importance_of_area_light<One>(emitter, above, V3f(0, 0, -1)), 0);
    EXPECT_EQ(scalar::emitted_by_area_light<One>(emitter, emitter.centre, V3f(0, 0, 1)), V3f(0));
}

TEST(DiskLight, Bounds_HoldItAndItsAxis) {
    const LightBounds bounds = bounds_of(constants_of(disk()));
    for (int i = 0; i < 64; ++i) {
        const double turn = i * kPiDouble / 32;
        const V3f place(disk().centre + 0.9999 * disk().radius *
                                            (std::cos(turn) * Vec3(0.96, 0, 0.28) +
                                             std::sin(turn) * Vec3(0, 1, 0)));
        EXPECT_TRUE(bounds.box.intersects(place));
    }
    EXPECT_LT((bounds.axis - V3f(disk().normal)).length(), 1e-6f);
    EXPECT_EQ(bounds.spread, 0);
}

/// The power through a hemisphere around a small light, over its area: pi x radiance of a matt one.
TEST(FlatLights, WithABeam_KeepTheirPower) {
    for (const double beam : {0.0, 0.5, 1.0, 4.0}) {
        DiskLight light;
        light.centre = Vec3(0, 0, 0);
        light.normal = Vec3(0, 0, 1);
        light.radiance = Vec3(3, 3, 3);
        light.beam = beam;
        const AreaLightConstants emitter = constants_of(light);
        const Estimate power = estimate(200'000, [&](float x, float y) {
            const float sine = std::sqrt(1 - x * x);
            const V3f direction(sine * std::cos(2 * kPi * y), sine * std::sin(2 * kPi * y), x);
            const V3f emitted =
                scalar::emitted_by_area_light<One>(emitter, V3f(0.02f, 0, 0), direction);
            return static_cast<double>(emitted.x * x * 2 * kPi);
        });
        EXPECT_NEAR(power.mean, 3 * kPiDouble, 4 * power.error + 1e-5) << beam;
        EXPECT_NEAR(emitter.intensity,
                    3 * (beam / 2 + 1) * luminance(Vec3(1, 1, 1)) * kPiDouble * 0.01, 1e-4)
            << beam;
    }
}

TEST(FlatLights, WithABeam_AreFoundAsTheyAreSampled) {
    DiskLight light = disk();
    light.beam = 3;
    const AreaLightConstants emitter = constants_of(light);
    const V3f point(0.9f, 0.3f, 0.5f);
    const V3f normal = V3f(-0.3f, -0.1f, 1).normalized();
    const Estimate sampled = irradiance_of(emitter, point, normal);
    const Estimate found = found_irradiance_of(emitter, point, normal);
    EXPECT_NEAR(sampled.mean, found.mean, 4 * std::hypot(sampled.error, found.error));
    EXPECT_LT(found.error, 0.01 * found.mean);
}

TEST(ShadeLight, WithABlackInside_IsItsDiskSeenThroughTheOpening) {
    ShadeLight light = shade();
    light.albedo = Vec3(0, 0, 0);
    const AreaLightConstants emitter = constants_of(light);
    const Estimate found = irradiance_of(emitter, V3f(0, 0, 0), V3f(0, 0, 1));
    EXPECT_NEAR(found.mean, 30 * irradiance_on_axis(0.07, 1.16), 4 * found.error);
}

/// A ray through the opening, traced through the inside by many short steps.
V3f marched(const ShadeLight& light, const Vec3& position, const Vec3& out) {
    const Vec3 step = -out * 1e-5;
    Vec3 at = position;
    const ShadeConstants inside = shade_inside(light).constants;
    for (;;) {
        at += step;
        const double height = (light.centre - at).dot(light.normal);
        const Vec3 beside = at - light.centre + height * light.normal;
        if (height >= light.depth) {
            return beside.length() < light.disk_radius ? inside.disk : inside.ceiling;
        }
        if (beside.length() > light.shape.radius_at(height)) {
            const double place = height / light.depth * (ShadeConstants::kNodes - 1);
            const int node = std::min(static_cast<int>(place), ShadeConstants::kNodes - 2);
            const auto share = static_cast<float>(place - node);
            return inside.wall[node] * (1 - share) + inside.wall[node + 1] * share;
        }
    }
}

TEST(ShadeLight, ARayThroughTheOpening_SeesWhereItLeavesTheInside) {
    ShadeLight light = shade();
    light.normal = Vec3(0.6, 0, -0.8);
    test::TestRandom random(3);
    for (const double bulge : {0.0, 0.5, 1.0}) {
        light.shape.bulge = bulge;
        const AreaLightConstants emitter = constants_of(light);
        for (int i = 0; i < 40; ++i) {
            const double turn = 2 * kPiDouble * static_cast<double>(random.unit());
            const double radius = 0.199 * std::sqrt(static_cast<double>(random.unit()));
            const Vec3 place = light.centre + radius * (std::cos(turn) * Vec3(0.8, 0, 0.6) +
                                                        std::sin(turn) * Vec3(0, 1, 0));
            const Vec3 sideways(static_cast<double>(random.unit()) - 0.5,
                                static_cast<double>(random.unit()) - 0.5, 0);
            const Vec3 out = (light.normal + 1.5 * sideways).normalized();
            const V3f expected = marched(light, place, out);
            const V3f found = scalar::emitted_by_area_light<One>(emitter, V3f(place), V3f(out));
            EXPECT_LT((found - expected).length(), 0.01f * expected.length())
                << bulge << ' ' << i << ' ' << found << ' ' << expected;
        }
    }
}

/// Two equal coaxial disks: the opening gets what the closed form says of the disk's light.
TEST(ShadeLight, DeepBlackCylinder_LetsThroughTheExchangeOfItsEnds) {
    ShadeLight light;
    light.shape = {0.1, 0.1, 0.3, 0};
    light.disk_radius = 0.1;
    light.depth = 0.3;
    light.albedo = Vec3(0, 0, 0);
    light.radiance = Vec3(1, 1, 1);
    const double ratio = 0.3 / 0.1;
    const double factor = 1 + 0.5 * ratio * ratio - ratio * std::sqrt(0.25 * ratio * ratio + 1);
    EXPECT_NEAR(shade_inside(light).mean_radiance.x, factor, 1e-9);
}

TEST(ShadeLight, PowerThroughTheOpening_IsThatOfItsRadiance) {
    for (const double bulge : {0.0, 1.0}) {
        ShadeLight light = shade();
        light.shape.bulge = bulge;
        const AreaLightConstants emitter = constants_of(light);
        const Vec3 flux = *power_of({"", light});
        for (int channel = 0; channel < 3; ++channel) {
            test::TestRandom places(29);
            const Estimate power = estimate(400'000, [&](float x, float y) {
                const auto on_disk = scalar::sample_disk<One>({places.unit(), places.unit()});
                const V3f place =
                    emitter.centre + emitter.edge_u * on_disk.x + emitter.edge_v * on_disk.y;
                const float cosine = std::sqrt(x);
                const float sine = std::sqrt(1 - x);
                const V3f out(sine * std::cos(2 * kPi * y), sine * std::sin(2 * kPi * y), -cosine);
                return static_cast<double>(
                    scalar::emitted_by_area_light<One>(emitter, place, out)[channel] * kPi *
                    emitter.area);
            });
            EXPECT_NEAR(power.mean, flux[channel], 4 * power.error + 2e-3 * flux[channel]);
        }
        EXPECT_GT(flux.x, flux.z);
    }
}

/// Nearly all light of a disk that is too small to absorb any leaves a white inside.
TEST(ShadeLight, WhiteInside_KeepsNothing) {
    ShadeLight light;
    light.shape = {0.2, 0.2, 0.2, 0};
    light.disk_radius = 1e-3;
    light.depth = 0.1;
    light.radiance = Vec3(1, 1, 1);
    double last = 0;
    for (const double albedo : {0.5, 0.9, 0.99}) {
        light.albedo = Vec3(albedo, albedo, albedo);
        const double share = power_of({"", light})->x / (kPiDouble * kPiDouble * 1e-6);
        EXPECT_GT(share, last);
        EXPECT_LT(share, 1);
        last = share;
    }
    EXPECT_GT(last, 0.985);
}

TEST(ShadeLight, IsFoundAsItIsSampled) {
    const AreaLightConstants emitter = constants_of(shade());
    const V3f normal = V3f(-0.2f, 0.1f, 1).normalized();
    for (const V3f& point : {V3f(0.1f, 0.05f, 0.4f), V3f(0.7f, -0.3f, 0.55f)}) {
        for (const int channel : {0, 2}) {
            const Estimate sampled = irradiance_of(emitter, point, normal, channel);
            const Estimate found = found_irradiance_of(emitter, point, normal, channel);
            EXPECT_NEAR(sampled.mean, found.mean, 4 * std::hypot(sampled.error, found.error));
            EXPECT_LT(found.error, 0.03 * found.mean);
        }
    }
}

/// The mean of one over the density is the solid angle in which there are samples.
TEST(ShadeLight, Density_IsOfAllSamplesTogether) {
    const AreaLightConstants emitter = constants_of(shade());
    EXPECT_GT(emitter.shade.disk_chance, 0.2F);
    for (const V3f& point : {V3f(0, 0, 0.2f), V3f(0.5f, -0.3f, 0.45f), V3f(1.5f, 0, 0.9f)}) {
        const Estimate sampled = estimate(400'000, [&](float x, float y) {
            const auto sample = light_sample(emitter, point, V2f(x, y));
            EXPECT_TRUE(!sample || std::abs(sample->direction.length() - 1) < 1e-5f);
            return sample ? static_cast<double>(1 / sample->pdf) : 0;
        });
        AreaLightConstants plain = emitter;
        plain.shade = ShadeConstants();
        const Estimate exact = estimate(400'000, [&](float x, float y) {
            return static_cast<double>(1 / light_sample(plain, point, V2f(x, y))->pdf);
        });
        EXPECT_NEAR(sampled.mean, exact.mean, 4 * std::hypot(sampled.error, exact.error));
    }
}

TEST(ShadeLight, PointsForReflections_GiveTheSameLight) {
    const AreaLightConstants emitter = constants_of(shade());
    const V3f normal(0, 0, 1);
    for (const V3f& receiver : {V3f(0.1f, 0.05f, 0.4f), V3f(0.7f, -0.3f, 0.55f)}) {
        const Estimate connected = estimate(400'000, [&](float x, float y) {
            const auto target =
                scalar::sample_point_of_area_light<One>(emitter, receiver, 0.03f, V2f(x, y));
            const V3f way = target.position - receiver;
            const V3f direction = way.normalized();
            const V3f emitted =
                scalar::emitted_by_area_light<One>(emitter, target.position, -direction);
            return static_cast<double>(emitted.x * direction.dot(normal) *
                                       -direction.dot(target.normal) /
                                       (way.length2() * target.pdf));
        });
        const Estimate sampled = irradiance_of(emitter, receiver, normal);
        EXPECT_NEAR(connected.mean, sampled.mean, 4 * std::hypot(connected.error, sampled.error));
        EXPECT_LT(connected.error, 0.01 * connected.mean);
    }
}

/// Samples of the opening alone would vary by the contrast of the disk and the wall.
TEST(ShadeLight, Samples_FollowTheBrightness) {
    const AreaLightConstants emitter = constants_of(shade());
    AreaLightConstants blind = emitter;
    blind.shade.disk_chance = 0;
    const V3f point(0.2f, 0, 0);
    const V3f normal(0, 0, 1);
    EXPECT_LT(irradiance_of(emitter, point, normal).error,
              0.5 * irradiance_of(blind, point, normal).error);
}

TEST(ShadeLight, Problems_AreNamed) {
    const auto problem = [](auto change) {
        ShadeLight light = shade();
        change(light);
        const LightProblem found = problem_of(light);
        return found.what == nullptr ? std::string() : std::string(found.field) + ": " + found.what;
    };
    EXPECT_EQ(problem([](ShadeLight&) {}), "");
    EXPECT_EQ(problem([](ShadeLight& light) { light.shape.height = 0; }),
              "shade: the radius or the height is not above 0");
    EXPECT_EQ(problem([](ShadeLight& light) { light.shape.bulge = 1.5; }),
              "bulge: the bulge is not from 0 to 1");
    EXPECT_EQ(problem([](ShadeLight& light) { light.depth = 0.3; }),
              "depth: the disk does not lie between the opening and the top of the shade");
    EXPECT_EQ(problem([](ShadeLight& light) { light.disk_radius = 0.19; }),
              "disk: the disk does not fit into the shade at its depth");
    EXPECT_EQ(problem([](ShadeLight& light) { light.albedo.y = 1; }),
              "albedo: the inside's albedo is not from 0 to 0.99");
}

}  // namespace
}  // namespace carom::render
