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

TEST(LightSet, ConstantEnvironment_IsNotSampled) {
    const LightSet lights(two_lights());
    EXPECT_EQ(lights.area_light_count(), 2u);
    EXPECT_EQ(lights.lights().size(), 2u);
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
