// `sample` against `evaluate` and `pdf`, for every lobe and mixture.
#include <gtest/gtest.h>

#include "render/sampling/scalar_kernels.h"
#include "tests/render/direction_density.h"
#include "tests/render/material/material_samples.h"

namespace carom::render {
namespace {

using scalar::One;

using namespace test_materials;

const V3f kNormal = V3f(0.3f, -0.5f, 0.8f).normalized();
constexpr float kAngles[] = {0.1f, 0.8f, 1.35f};

struct Case {
    Named material;
    Layers layers;
    float angle;
};

std::vector<Case> cases() {
    std::vector<Case> list;
    for (const Named& material : all()) {
        for (const float angle : kAngles) {
            list.push_back({material, Layers::all, angle});
        }
        if (material.material.coat.weight.most() > 0) {
            list.push_back({material, Layers::base, kAngles[1]});
            if (material.material.coat.roughness.most() > 0) {
                list.push_back({material, Layers::coat, kAngles[1]});
            }
        }
    }
    return list;
}

TEST(BsdfSample, EveryLobeAndMixture_FollowsItsPdf) {
    const std::vector<Case> list = cases();
    test::DensityTest setup;
    setup.tests = static_cast<int>(list.size());
    setup.samples = 40'000;
    for (const Case& c : list) {
        SCOPED_TRACE(c.material.name + ", angle " + std::to_string(c.angle));
        const Material material = make(c.material.material);
        const V3f wo = tilted(kNormal, c.angle);
        const Bsdf bsdf(material, kNormal, wo);
        setup.seed += 1;
        test::expect_direction_density(
            [&](V3f u) -> std::optional<V3f> {
                // A delta lobe is not part of the density, whose integral falls short of 1 by its
                // probability.
                const auto sample = bsdf.sample(c.layers, V2f(u.x, u.y));
                return sample && !sample->is_delta ? std::optional<V3f>(sample->direction)
                                                   : std::nullopt;
            },
            [&](const V3f& wi) { return bsdf.pdf(c.layers, wi); }, kNormal, 1, setup);
    }
}

TEST(BsdfSample, EverySample_HasTheValueAndPdfThatEvaluateGives) {
    test::TestRandom random(7);
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.material.name + ", angle " + std::to_string(c.angle));
        const Material material = make(c.material.material);
        const V3f wo = tilted(kNormal, c.angle);
        const Bsdf bsdf(material, kNormal, wo);
        for (int i = 0; i < 300; ++i) {
            const float x = random.unit();
            const float y = random.unit();
            const auto sample = bsdf.sample(c.layers, V2f(x, y));
            if (!sample || sample->is_delta) {
                continue;
            }
            const BsdfValue value = bsdf.evaluate(c.layers, sample->direction);
            ASSERT_GT(sample->pdf, 0);
            ASSERT_NEAR(value.pdf, sample->pdf, 2e-3f * sample->pdf);
            for (int k = 0; k < 3; ++k) {
                ASSERT_NEAR(value.value[k], sample->weight[k] * sample->pdf,
                            2e-3f * value.value[k] + 1e-6f);
            }
        }
    }
}

TEST(BsdfSample, CoatAndBaseFollowedApart_AddUpToTheWhole) {
    test::TestRandom random(11);
    for (const Named& named : all()) {
        SCOPED_TRACE(named.name);
        const Material material = make(named.material);
        const V3f wo = tilted(kNormal, 0.9f);
        const Bsdf bsdf(material, kNormal, wo);
        for (int i = 0; i < 100; ++i) {
            const float x = random.unit();
            const float y = random.unit();
            const auto basis = scalar::basis_around<One>(kNormal);
            const V3f wi = basis.to_world(scalar::sample_cosine_hemisphere<One>(V2f(x, y)));
            const V3f whole = bsdf.evaluate(Layers::all, wi).value;
            const V3f parts =
                bsdf.evaluate(Layers::coat, wi).value + bsdf.evaluate(Layers::base, wi).value;
            ASSERT_NEAR(whole.x, parts.x, 1e-5f * whole.x);
        }
    }
}

TEST(BsdfEvaluate, DirectionsBelowTheSurface_AreDark) {
    for (const Named& named : all()) {
        const Material material = make(named.material);
        const V3f wo = tilted(kNormal, 0.5f);
        const Bsdf bsdf(material, kNormal, wo);
        const BsdfValue value = bsdf.evaluate(Layers::all, -tilted(kNormal, 0.7f));
        EXPECT_EQ(value.value, V3f(0, 0, 0)) << named.name;
        EXPECT_EQ(value.pdf, 0) << named.name;
    }
}

TEST(BsdfEvaluate, SeenFromBehind_ScattersAlike) {
    const Material material = make(diffuse(0.8));
    const V3f wo = -tilted(kNormal, 0.5f);
    const V3f wi = -tilted(kNormal, 0.2f);
    EXPECT_GT(Bsdf(material, kNormal, wo).evaluate(Layers::all, wi).value.x, 0);
}

}  // namespace
}  // namespace carom::render
