#include "render/texture/texture.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/render/texture/texture_values.h"

namespace carom::render {
namespace {

SurfacePoint on_plane(float x, float y) {
    SurfacePoint point;
    point.geometric_normal = V3f(0, 0, 1);
    point.shading_normal = V3f(0, 0, 1);
    point.object_position = V3f(x, y, 0);
    return point;
}

TEST(Texture, Constant_IsTheSameEverywhere) {
    ImageCache images;
    const Texture texture(Vec3(0.1, 0.2, 0.3), images);
    EXPECT_EQ(test::colour_of(texture, on_plane(3, 4), 0), V3f(0.1f, 0.2f, 0.3f));
    EXPECT_FALSE(texture.has_relief());
}

TEST(Texture, MissingImage_IsAnErrorOnConstruction) {
    ImageCache images;
    EXPECT_THROW(Texture(ImageTexture{"/nowhere/wood.png"}, images), Error);
}

TEST(Texture, ClothOnAStandingWall_IsNotStretched) {
    ImageCache images;
    const Texture texture(ClothTexture{}, images);
    SurfacePoint wall = on_plane(0.01f, 0.02f);
    wall.geometric_normal = V3f(1, 0, 0);
    const V3f low = test::colour_of(texture, wall, 0);
    wall.object_position.z += 0.0013f;
    EXPECT_NE(test::colour_of(texture, wall, 0), low);
}

TEST(Texture, ReliefOfCloth_LiesInTheSurface) {
    ImageCache images;
    const Texture texture(ClothTexture{}, images);
    EXPECT_TRUE(texture.has_relief());
    const SurfacePoint point = on_plane(0.01234f, 0.00567f);
    EXPECT_EQ(test::relief_of(texture, point, 0).colour, test::colour_of(texture, point, 0));
    const V3f shift = test::relief_of(texture, point, 0).normal_shift;
    EXPECT_EQ(shift.z, 0);
    EXPECT_GT(shift.length(), 0);
}

}  // namespace
}  // namespace carom::render
