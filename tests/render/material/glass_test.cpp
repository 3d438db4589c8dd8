// Transmission: Snell, Fresnel, total reflection, rough boundaries.
#include <gtest/gtest.h>

#include "render/material/scalar_kernels.h"
#include "tests/render/direction_density.h"
#include "tests/render/material/material_samples.h"
#include "tests/render/statistics.h"

namespace carom::render {
namespace {

using scalar::One;

using namespace test_materials;

const V3f kNormal = V3f(0.3f, -0.5f, 0.8f).normalized();

StandardMaterial clear_glass(double ior) {
    StandardMaterial glass;
    glass.transmission = 1;
    glass.roughness = 0;
    glass.ior = ior;
    return glass;
}

/// From outside or, with `side` = -1, from inside.
V3f viewer(float angle, float side) {
    return tilted(kNormal, angle) * side;
}

struct Energy {
    double reflected = 0;
    double passed = 0;
};

Energy sampled_energy(const Bsdf& bsdf, const V3f& wo) {
    constexpr int kSamples = 200'000;
    Energy energy;
    const float side = wo.dot(kNormal);
    for (int i = 0; i < kSamples; ++i) {
        // Roberts 2018, as in bsdf_energy_test.cpp.
        const auto at = [&](double step) {
            const double x = 0.5 + i * step;
            return static_cast<float>(x - std::floor(x)) * 0.9999999f;
        };
        if (const auto s =
                bsdf.sample(Layers::all, V2f(at(0.7548776662466927), at(0.5698402909980532)))) {
            const bool passes = s->direction.dot(kNormal) * side < 0;
            (passes ? energy.passed : energy.reflected) += static_cast<double>(s->weight.x);
        }
    }
    return {energy.reflected / kSamples, energy.passed / kSamples};
}

TEST(ClearGlass, BothSides_DivideLightByFresnelAndBendItBySnell) {
    const Material material = make(clear_glass(1.5));
    for (const float side : {1.0f, -1.0f}) {
        for (const float angle : {0.0f, 0.3f, 0.6f}) {
            const V3f wo = viewer(angle, side);
            const Bsdf bsdf(material, kNormal, wo);
            EXPECT_FALSE(bsdf.can_evaluate(Layers::all));
            const float index = side > 0 ? 1.5f : 1 / 1.5f;
            const float fresnel = scalar::fresnel_dielectric<One>(std::cos(angle), index);
            const auto mirrored = bsdf.sample(Layers::all, V2f(0.99f * fresnel, 0.5f));
            const auto bent = bsdf.sample(Layers::all, V2f(1.01f * fresnel, 0.5f));
            ASSERT_TRUE(mirrored && mirrored->is_delta && bent && bent->is_delta);
            EXPECT_GT(mirrored->direction.dot(kNormal) * side, 0);
            EXPECT_LT(bent->direction.dot(kNormal) * side, 0);
            EXPECT_NEAR(mirrored->weight.x, 1, 1e-5f);
            EXPECT_NEAR(bent->weight.x, 1, 1e-5f);
            // n sin is conserved, in the plane of incidence.
            const V3f across_wo = wo - kNormal * wo.dot(kNormal);
            const V3f across_wi = bent->direction - kNormal * bent->direction.dot(kNormal);
            EXPECT_LT((across_wi * index + across_wo).length(), 2e-6f) << angle << " " << side;
        }
    }
}

TEST(ClearGlass, BeyondTheCriticalAngle_ReflectsEverything) {
    const Material material = make(clear_glass(1.5));
    const float critical = std::asin(1 / 1.5f);
    for (const float u : {0.0f, 0.5f, 0.999f}) {
        const V3f within = viewer(critical + 0.01f, -1);
        const auto sample = Bsdf(material, kNormal, within).sample(Layers::all, V2f(u, 0.3f));
        ASSERT_TRUE(sample);
        EXPECT_LT(sample->direction.dot(kNormal), 0);
        EXPECT_FLOAT_EQ(sample->weight.x, 1);
    }
    const V3f shallower = viewer(critical - 0.01f, -1);
    const auto sample = Bsdf(material, kNormal, shallower).sample(Layers::all, V2f(0.999f, 0.3f));
    ASSERT_TRUE(sample);
    EXPECT_GT(sample->direction.dot(kNormal), 0);
}

TEST(ClearGlass, Colour_AppliesAtTheSurfaceOrWithDistanceInside) {
    StandardMaterial tinted = clear_glass(1.5);
    tinted.transmission_colour = Vec3(0.9, 0.5, 0.1);
    const Material material = make(tinted);
    const auto sample = Bsdf(material, kNormal, kNormal).sample(Layers::all, V2f(0.9f, 0.5f));
    ASSERT_TRUE(sample);
    EXPECT_NEAR(sample->weight.y, 0.5f, 1e-6f);
    EXPECT_FLOAT_EQ(material.glass()->transmittance(1).y, 1);

    tinted.transmission_depth = 0.05;
    const Material deep = make(tinted);
    EXPECT_NEAR(deep.glass()->transmittance(0.05f).y, 0.5f, 1e-6f);
    EXPECT_NEAR(deep.glass()->transmittance(0.1f).z, 0.01f, 1e-6f);
    EXPECT_NEAR(Bsdf(deep, kNormal, kNormal).sample(Layers::all, V2f(0.9f, 0.5f))->weight.y, 1,
                1e-6f);
}

TEST(Glass, BothSidesAndAllAngles_KeepAllLightAndNoMore) {
    for (const Named& named : glasses()) {
        StandardMaterial white = named.material;
        white.base = Vec3(1, 1, 1);
        const Material material = make(white);
        for (const float side : {1.0f, -1.0f}) {
            for (const float angle : {0.02f, 0.5f, 0.9f, 1.2f, 1.45f}) {
                const V3f wo = viewer(angle, side);
                const Energy energy = sampled_energy(Bsdf(material, kNormal, wo), wo);
                const double sum = energy.reflected + energy.passed;
                SCOPED_TRACE(named.name + ", side " + std::to_string(side) + ", angle " +
                             std::to_string(angle));
                EXPECT_LE(sum, 1.004);
                EXPECT_GT(sum, white.coat.weight.most() > 0 ? 0.9 : 0.993);
            }
        }
    }
}

TEST(FrostedGlass, SmootherFacets_ApproachClearGlass) {
    StandardMaterial frosted = clear_glass(1.5);
    frosted.roughness = 0.08;
    const Material material = make(frosted);
    for (const float side : {1.0f, -1.0f}) {
        const V3f wo = viewer(0.4f, side);
        const Energy energy = sampled_energy(Bsdf(material, kNormal, wo), wo);
        const double fresnel = static_cast<double>(
            scalar::fresnel_dielectric<One>(std::cos(0.4f), side > 0 ? 1.5f : 1 / 1.5f));
        EXPECT_NEAR(energy.reflected, fresnel, 2e-3);
        EXPECT_NEAR(energy.passed, 1 - fresnel, 4e-3);
    }
}

TEST(FrostedGlass, EverySample_FollowsItsPdfAndHasItsValue) {
    test::DensityTest setup;
    setup.samples = 40'000;
    setup.tests = 18;
    setup.rows = 48;
    setup.columns = 48;
    for (const Named& named : glasses()) {
        if (named.material.roughness.most() == 0) {
            continue;
        }
        const Material material = make(named.material);
        for (const float side : {1.0f, -1.0f}) {
            for (const float angle : {0.1f, 0.8f, 1.35f}) {
                SCOPED_TRACE(named.name + ", side " + std::to_string(side) + ", angle " +
                             std::to_string(angle));
                const V3f wo = viewer(angle, side);
                const Bsdf bsdf(material, kNormal, wo);
                setup.seed += 1;
                int wrong = 0;
                test::expect_direction_density(
                    [&](V3f u) -> std::optional<V3f> {
                        const auto s = bsdf.sample(Layers::all, V2f(u.x, u.y));
                        if (!s) {
                            return std::nullopt;
                        }
                        const BsdfValue value = bsdf.evaluate(Layers::all, s->direction);
                        const float expected = s->weight.x * s->pdf;
                        wrong += std::abs(value.pdf - s->pdf) > 5e-3f * s->pdf ||
                                 std::abs(value.value.x - expected) > 5e-3f * expected + 1e-6f;
                        return s->direction;
                    },
                    [&](const V3f& wi) { return bsdf.pdf(Layers::all, wi); }, kNormal, 2, setup);
                EXPECT_LE(wrong, setup.samples / 1000);
            }
        }
    }
}

TEST(FrostedGlass, BasicRadiance_IsReciprocal) {
    // f(wo, wi) n_o^2 = f(wi, wo) n_i^2 for radiance (Walter 2007, section 2.2) is f(wo, wi) n_i^2
    // = f(wi, wo) n_o^2 for basic radiance, here without the scale for single scattering.
    StandardMaterial frosted = clear_glass(1.5);
    frosted.roughness = 0.5;
    const Material material = make(frosted);
    const auto numbers = material.numbers();
    for (const float angle : {0.1f, 0.5f, 0.9f}) {
        const auto out = scalar::sin_cos<One>(angle);
        const V3f wo(out.sine, 0, out.cosine);
        const V3f wi = V3f(-0.2f, 0.3f, -0.8f).normalized();
        const auto unscaled = [&](bool is_inside, const V3f& viewer_side, const V3f& far_side) {
            const auto lobe = scalar::glass_lobe<scalar::One>(
                numbers.glass, numbers.tables, numbers.first, is_inside, viewer_side);
            return scalar::glass_towards<scalar::One>(lobe, viewer_side, far_side, true).value /
                   (lobe.scale * std::abs(far_side.z));
        };
        const float inward = unscaled(false, wo, wi);
        const float outward = unscaled(true, V3f(wi.x, wi.y, -wi.z), V3f(wo.x, wo.y, -wo.z));
        EXPECT_NEAR(inward, outward * 2.25f, 2e-3f * inward) << angle;
    }
}

}  // namespace
}  // namespace carom::render
