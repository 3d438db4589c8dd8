// Values with closed forms.
#include <gtest/gtest.h>

#include "render/material/scalar_kernels.h"
#include "tests/render/material/material_samples.h"
#include "tests/render/statistics.h"

namespace carom::render {
namespace {

using scalar::One;

using namespace test_materials;

const V3f kNormal{0, 0, 1};

TEST(Fresnel, StraightOnAndGrazing_IsKnown) {
    EXPECT_NEAR(scalar::fresnel_dielectric<One>(1, 1.5f), 0.04f, 1e-7f);
    EXPECT_NEAR(scalar::fresnel_dielectric<One>(0, 1.5f), 1.0f, 1e-6f);
    EXPECT_NEAR(scalar::fresnel_dielectric<One>(0.3f, 1.0f), 0.0f, 1e-12f);
    // At Brewster's angle, tan = n, only the perpendicular part remains: ((n^2-1)/(n^2+1))^2 / 2.
    const float brewster = 1.0f / std::sqrt(1.0f + 2.25f);
    EXPECT_NEAR(scalar::fresnel_dielectric<One>(brewster, 1.5f),
                0.5f * std::pow(1.25f / 3.25f, 2.0f), 1e-6f);
}

TEST(SmoothCoat, BallOfThePeers_IsMirrorTimesFPlusBaseTimesOneMinusF) {
    StandardMaterial ball;
    ball.base = Vec3(0.7, 0.4, 0.1);
    ball.coat.weight = 1;
    const Material material = make(ball);
    for (const float angle : {0.0f, 0.6f, 1.2f, 1.5f}) {
        const V3f wo = tilted(kNormal, angle);
        const Bsdf bsdf(material, kNormal, wo);
        const float fresnel = scalar::fresnel_dielectric<One>(wo.z, 1.5f);
        const auto coat = bsdf.sample(Layers::coat, V2f(0.5f, 0.5f));
        ASSERT_TRUE(coat && coat->is_delta);
        EXPECT_NEAR(coat->weight.x, fresnel, 1e-6f);
        EXPECT_NEAR(coat->direction.z, wo.z, 1e-6f);
        EXPECT_NEAR(coat->direction.x, -wo.x, 1e-6f);
        const V3f wi = tilted(kNormal, 0.4f);
        const V3f value = bsdf.evaluate(Layers::all, wi).value;
        EXPECT_NEAR(value.x, (1 - fresnel) * 0.7f * kInversePi * wi.z, 1e-6f);
        EXPECT_NEAR(value.z, (1 - fresnel) * 0.1f * kInversePi * wi.z, 1e-6f);
        EXPECT_FALSE(bsdf.can_evaluate(Layers::coat));
        EXPECT_TRUE(bsdf.can_evaluate(Layers::base));
    }
}

TEST(SmoothMetal, Mirror_ReflectsBySchlick) {
    StandardMaterial chrome;
    chrome.base = Vec3(0.6, 0.6, 0.6);
    chrome.metal = 1;
    chrome.roughness = 0;
    const Material material = make(chrome);
    const V3f wo = tilted(kNormal, 1.0f);
    const auto sample = Bsdf(material, kNormal, wo).sample(Layers::all, V2f(0.5f, 0.5f));
    ASSERT_TRUE(sample && sample->is_delta);
    EXPECT_NEAR(sample->weight.x, scalar::fresnel_schlick<One>(wo.z, V3f(0.6f)).x, 1e-6f);
    EXPECT_FALSE(Bsdf(material, kNormal, wo).can_evaluate(Layers::all));
}

TEST(Lobes, GgxSheenAndDiffuse_AreReciprocal) {
    test::TestRandom random(5);
    const scalar::GgxOf<One> ggx(0.3f);
    for (int i = 0; i < 200; ++i) {
        float u[4];
        for (float& x : u) {
            x = random.unit();
        }
        const V3f a = scalar::sample_cosine_hemisphere<One>(V2f(u[0], u[1]));
        const V3f b = scalar::sample_cosine_hemisphere<One>(V2f(u[2], u[3]));
        const V3f m = (a + b).normalized();
        const float forth = ggx.reflection(a, b, m) / b.z;
        EXPECT_NEAR(forth, ggx.reflection(b, a, m) / a.z, 2e-4f * forth);
        const float shine = scalar::sheen_reflection<One>(a.z, b.z, (a + b).length2()) / b.z;
        EXPECT_NEAR(shine, scalar::sheen_reflection<One>(b.z, a.z, (a + b).length2()) / a.z,
                    2e-4f * shine);
    }
    const Material material = make(diffuse(0.7));
    const V3f a = tilted(kNormal, 0.3f);
    const V3f b = tilted(kNormal, 1.1f);
    EXPECT_NEAR(Bsdf(material, kNormal, a).evaluate(Layers::all, b).value.x / b.z,
                Bsdf(material, kNormal, b).evaluate(Layers::all, a).value.x / a.z, 1e-6f);
}

TEST(Ggx, Density_ProjectedOnTheSurface_IsOne) {
    // Integral of D(m) cos(m) over the hemisphere (Walter 2007, eq. 4).
    for (const float alpha : {0.05f, 0.3f, 1.0f}) {
        const scalar::GgxOf<One> ggx(alpha);
        double sum = 0;
        constexpr int kSteps = 20000;
        for (int i = 0; i < kSteps; ++i) {
            // Uniform in sin^2: dm cos = pi d(sin^2).
            const float sine2 = (static_cast<float>(i) + 0.5f) / kSteps;
            sum += static_cast<double>(ggx.density(V3f(std::sqrt(sine2), 0, std::sqrt(1 - sine2))));
        }
        EXPECT_NEAR(sum * static_cast<double>(kPi) / kSteps, 1.0, 2e-3) << alpha;
    }
}

TEST(AlbedoTable, BetweenNodes_IsCloseToTheIntegral) {
    const AlbedoTable table = AlbedoTable::of_mirrors(0.5f);
    const scalar::GgxOf<One> ggx(0.5f);
    for (const float cosine : {0.03f, 0.2f, 0.55f, 0.97f}) {
        const V3f wo(std::sqrt(1 - cosine * cosine), 0, cosine);
        double sum = 0;
        constexpr int kSteps = 200;
        for (int i = 0; i < kSteps * kSteps; ++i) {
            const V2f u((static_cast<float>(i % kSteps) + 0.5f) / kSteps,
                        (static_cast<float>(i / kSteps) + 0.5f) / kSteps);
            const V3f wi = scalar::reflect<One>(wo, ggx.sample_visible(wo, u));
            sum += wi.z > 0 ? static_cast<double>(ggx.sample_weight(wo, wi)) : 0.0;
        }
        EXPECT_NEAR(table.at(cosine), sum / (kSteps * kSteps), 2e-3) << cosine;
    }
}

TEST(Resolve, ShadingNormalTurnedAwayFromTheViewer_FallsBackToTheGeometricOne) {
    const Material material = make(diffuse(0.5));
    scalar::SurfacePointOf<scalar::One> hit{};
    hit.geometric_normal = kNormal;
    scalar::clear_texture_place<scalar::One>(hit);
    const auto point =
        scalar::texture_point<scalar::One>(hit, {true, true, false, false}, kNormal, 1e-3F, 1);
    const TexturesOfMaterial& textures = material.textures();
    const auto surface = scalar::resolve_surface<scalar::One>(
        List<TextureData>(textures.list()), textures.numbers(), point, kNormal,
        V3f(-1, 0, 0.1f).normalized(), V3f(0.9f, 0, 0.1f).normalized());
    EXPECT_EQ(surface.normal, kNormal);
}

}  // namespace
}  // namespace carom::render
