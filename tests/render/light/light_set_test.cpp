#include "render/light/light_set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace carom::render {
namespace {

std::vector<LightDescription> two_lights() {
    RectangleLight lamp;
    lamp.centre = Vec3(0, 0, 1.5);
    SphereLight bulb;
    bulb.centre = Vec3(2, 0, 1);
    return {{"lamp", lamp}, {"sky", EnvironmentLight{}}, {"bulb", bulb}};
}

TEST(LightSet, Choice_IsInProportionToImportanceAndLeavesAnEvenNumber) {
    const LightSet lights(two_lights());
    ASSERT_EQ(lights.area_light_count(), 2u);
    ASSERT_EQ(lights.sampled_count(), 2u);  // the constant environment is not sampled
    const V3f point(0.5f, 0, 0);
    const V3f normal(0, 0, 1);
    const float total = lights.importance(0, point, normal) + lights.importance(1, point, normal);
    constexpr int kSteps = 10'000;
    double chosen[2] = {0, 0};
    double rest[2] = {0, 0};
    for (int i = 0; i < kSteps; ++i) {
        const auto choice = lights.choose(point, normal, (static_cast<float>(i) + 0.5f) / kSteps);
        ASSERT_TRUE(choice);
        EXPECT_FLOAT_EQ(choice->total, total);
        EXPECT_FLOAT_EQ(choice->probability,
                        lights.importance(choice->light, point, normal) / total);
        ASSERT_TRUE(choice->u >= 0 && choice->u < 1);
        chosen[choice->light] += 1;
        rest[choice->light] += choice->u;
    }
    for (const std::size_t light : {0u, 1u}) {
        EXPECT_NEAR(chosen[light] / kSteps, lights.importance(light, point, normal) / total, 2e-4);
        EXPECT_NEAR(rest[light] / chosen[light], 0.5, 0.01);
    }
    EXPECT_TRUE(lights.choose(point, normal, 0));
    EXPECT_TRUE(lights.choose(point, normal, 0x1.fffffep-1f));
}

TEST(LightSet, NothingShinesOnThePoint_NothingIsChosen) {
    const LightSet lights({two_lights()[0]});
    EXPECT_FALSE(lights.choose(V3f(0, 0, 3), V3f(0, 0, 1), 0.5f));
}

TEST(LightSet, SecondEnvironment_IsAnErrorThatNamesIt) {
    std::vector<LightDescription> lights = two_lights();
    lights.push_back({"second sky", EnvironmentLight{}});
    try {
        const LightSet set(lights);
        FAIL();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("'second sky'"));
    }
}

TEST(LightSet, UnusableLight_IsAnErrorThatNamesIt) {
    const auto message = [](const LightDescription& light) -> std::string {
        try {
            const LightSet set({light});
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    };
    RectangleLight flat;
    flat.edge_u = Vec3(0, 0, 0);
    EXPECT_EQ(message({"lamp", flat}), "light 'lamp': the rectangle has no area");
    RectangleLight skewed;
    skewed.normal = Vec3(0.6, 0, 0.8);
    EXPECT_EQ(message({"lamp", skewed}),
              "light 'lamp': edges and normal of the rectangle are not at right angles to each "
              "other");
    SphereLight point;
    point.radius = 0;
    EXPECT_EQ(message({"bulb", point}), "light 'bulb': the radius is not above 0");
    SphereLight dark;
    dark.radiance = Vec3(1, -1, 1);
    EXPECT_EQ(message({"bulb", dark}),
              "light 'bulb': the radiance is negative, infinite or not a number");
}

}  // namespace
}  // namespace carom::render
