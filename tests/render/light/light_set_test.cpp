#include "render/light/light_set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/timeline/error.h"

namespace carom::render {
namespace {

std::vector<LightDescription> two_lights() {
    RectangleLight lamp;
    lamp.centre = Vec3(0, 0, 1.5);
    SphereLight bulb;
    bulb.centre = Vec3(2, 0, 1);
    return {{"lamp", lamp}, {"sky", EnvironmentLight{}}, {"bulb", bulb}};
}

TEST(LightSet, Choice_IsInProportionToImportance) {
    const LightSet lights(two_lights());
    ASSERT_EQ(lights.area_light_count(), 2u);
    ASSERT_EQ(lights.sampled_count(), 2u);  // the constant environment is not sampled
    const V3f point(0.5f, 0, 0);
    const V3f normal(0, 0, 1);
    const float total = lights.total_importance(point, normal);
    const float first = lights.importance(0, point, normal) / total;
    for (const float u :
         {0.0f, 0.3f, 0.999f * first, std::min(0.99999994f, 1.001f * first), 0.99999994f}) {
        const auto choice = lights.choose(point, normal, total, u);
        ASSERT_TRUE(choice);
        EXPECT_EQ(choice->light, u < first ? 0u : 1u);
        EXPECT_FLOAT_EQ(choice->probability,
                        lights.importance(choice->light, point, normal) / total);
    }
}

TEST(LightSet, NothingShinesOnThePoint_NothingIsChosen) {
    const LightSet lights({two_lights()[0]});
    const V3f above(0, 0, 3);
    const float total = lights.total_importance(above, V3f(0, 0, 1));
    EXPECT_EQ(total, 0);
    EXPECT_FALSE(lights.choose(above, V3f(0, 0, 1), total, 0.5f));
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

}  // namespace
}  // namespace carom::render
