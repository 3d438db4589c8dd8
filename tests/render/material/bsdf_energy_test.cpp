// No material scatters more light than it receives.
#include <gtest/gtest.h>

#include "render/sampling/scalar_kernels.h"
#include "tests/render/material/material_samples.h"
#include "tests/render/statistics.h"

namespace carom::render {
namespace {

using scalar::One;

using namespace test_materials;

const V3f kNormal{0, 0, 1};

/// Mean of the samples' weights: the directional albedo. The points are the additive recurrence of
/// Roberts 2018, "The unreasonable effectiveness of quasirandom sequences", in two dimensions.
V3f sampled_albedo(const Bsdf& bsdf, Layers layers) {
    constexpr int kSamples = 300'000;
    Vec3 sum(0, 0, 0);
    for (int i = 0; i < kSamples; ++i) {
        const auto at = [&](double step) {
            const double x = 0.5 + i * step;
            return static_cast<float>(x - std::floor(x)) * 0.9999999f;
        };
        const V2f u(at(0.7548776662466927), at(0.5698402909980532));
        if (const auto sample = bsdf.sample(layers, u)) {
            sum += Vec3(sample->weight);
        }
    }
    return V3f(sum / kSamples);
}

/// Integral of the value over the hemisphere, without delta lobes.
V3f integrated_albedo(const Bsdf& bsdf, Layers layers) {
    constexpr int kRings = 160;
    constexpr int kSectors = 160;
    Vec3 sum(0, 0, 0);
    for (int j = 0; j < kRings; ++j) {
        for (int i = 0; i < kSectors; ++i) {
            const V2f u((static_cast<float>(i) + 0.5f) / kSectors,
                        (static_cast<float>(j) + 0.5f) / kRings);
            // Uniform in the cosine.
            const V3f wi = scalar::sample_cone<One>(V2f(u.y, u.x), 1.0f);
            sum += Vec3(bsdf.evaluate(layers, wi).value);
        }
    }
    return V3f(sum * (2.0 * static_cast<double>(kPi) / (kRings * kSectors)));
}

TEST(BsdfEnergy, EveryMaterialAndAngle_ReflectsAtMostWhatArrives) {
    for (const Named& named : all()) {
        StandardMaterial white = named.material;
        white.base = Vec3(1, 1, 1);
        const Material material = make(white);
        for (float angle = 0.02f; angle < 1.56f; angle += 0.25f) {
            const V3f wo = tilted(kNormal, angle);
            const V3f albedo = sampled_albedo(Bsdf(material, kNormal, wo), Layers::all);
            EXPECT_LE(albedo.x, 1.002f) << named.name << ", angle " << angle;
            EXPECT_GT(albedo.x, 0.75f) << named.name << ", angle " << angle;
        }
    }
}

TEST(BsdfEnergy, SamplingAndQuadrature_GiveTheSameAlbedo) {
    for (const Named& named : all()) {
        const Material material = make(named.material);
        for (const float angle : {0.2f, 0.9f, 1.3f}) {
            const V3f wo = tilted(kNormal, angle);
            const Bsdf bsdf(material, kNormal, wo);
            const Layers layers = named.name == "smooth coat" ? Layers::base : Layers::all;
            const V3f sampled = sampled_albedo(bsdf, layers);
            const V3f integrated = integrated_albedo(bsdf, layers);
            for (int k = 0; k < 3; ++k) {
                EXPECT_NEAR(sampled[k], integrated[k], 0.006f)
                    << named.name << ", angle " << angle << ", channel " << k;
            }
        }
    }
}

TEST(BsdfEnergy, WhiteMetal_LosesNothingHoweverRough) {
    for (const double roughness : {0.2, 0.6, 1.0}) {
        StandardMaterial metal = diffuse(1);
        metal.base = Vec3(1, 1, 1);
        metal.metal = 1;
        metal.roughness = roughness;
        const Material material = make(metal);
        for (const float angle : {0.1f, 0.8f, 1.4f}) {
            const V3f wo = tilted(kNormal, angle);
            EXPECT_NEAR(sampled_albedo(Bsdf(material, kNormal, wo), Layers::all).x, 1.0f, 0.004f)
                << "roughness " << roughness << ", angle " << angle;
        }
    }
}

TEST(BsdfEnergy, EverySampleWeight_IsBoundedByItsProbability) {
    test::TestRandom random(3);
    for (const Named& named : all()) {
        const Material material = make(named.material);
        for (int i = 0; i < 5000; ++i) {
            const float angle = random.between(0.0f, 1.57f);
            const V3f wo = tilted(kNormal, angle);
            const float x = random.unit();
            const float y = random.unit();
            if (const auto sample = Bsdf(material, kNormal, wo).sample(Layers::all, V2f(x, y))) {
                ASSERT_TRUE(std::isfinite(sample->weight.x)) << named.name << " " << angle;
                ASSERT_GE(sample->weight.x, 0) << named.name << " " << angle;
                ASSERT_LE(sample->weight.x, 6.0f) << named.name << " " << angle;
            }
        }
    }
}

}  // namespace
}  // namespace carom::render
