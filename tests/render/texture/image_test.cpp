#include "render/texture/image.h"

#include <cmath>
#include <filesystem>

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "render/texture/number_mask.h"
#include "render/texture/texture.h"
#include "tests/render/texture/temporary_picture.h"
#include "tests/render/texture/texture_values.h"

namespace carom::render {
namespace {

using scalar::One;
using test::TemporaryPicture;

TEST(ReadLinearImage, EightBitColours_AreDecodedFromSrgbUnlessLinear) {
    const TemporaryPicture file(".png");
    file.write<std::uint8_t>(2, 1, 3, OIIO::TypeDesc::UINT8, {0, 128, 255, 10, 20, 30});
    const LinearImage decoded = read_linear_image(file.path(), false);
    ASSERT_EQ(decoded.width, 2);
    EXPECT_EQ(decoded.pixels[0].x, 0);
    EXPECT_NEAR(decoded.pixels[0].y, 0.21586f, 1e-5f);  // ((128/255 + 0.055) / 1.055)^2.4
    EXPECT_EQ(decoded.pixels[0].z, 1);
    EXPECT_NEAR(decoded.pixels[1].x, 10.0f / 255 / 12.92f, 1e-6f);
    const LinearImage linear = read_linear_image(file.path(), true);
    EXPECT_NEAR(linear.pixels[0].y, 128.0f / 255, 1e-6f);
}

TEST(ReadLinearImage, FloatFile_IsTakenAsLinear) {
    const TemporaryPicture file(".exr");
    file.write<float>(1, 1, 3, OIIO::TypeDesc::FLOAT, {0.5f, 2.0f, 100.0f});
    EXPECT_EQ(read_linear_image(file.path(), false).pixels[0], V3f(0.5f, 2.0f, 100.0f));
}

TEST(ReadLinearImage, GreyWithAlpha_BecomesGrey) {
    const TemporaryPicture file(".png");
    file.write<std::uint8_t>(1, 1, 2, OIIO::TypeDesc::UINT8, {255, 255});
    EXPECT_EQ(read_linear_image(file.path(), false).pixels[0], V3f(1, 1, 1));
}

TEST(ReadLinearImage, MissingFile_IsNamed) {
    try {
        (void)read_linear_image("/nowhere/felt.png", false);
        FAIL();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("image '/nowhere/felt.png' cannot be read"));
    }
}

TEST(ReadLinearImage, ValuesThatLightCannotHave_AreClampedAndCounted) {
    const TemporaryPicture file(".exr");
    file.write<float>(3, 1, 3, OIIO::TypeDesc::FLOAT, {0, 0, 1, 2, -1, 0, INFINITY, 0, 0});
    const LinearImage image = read_linear_image(file.path(), false);
    EXPECT_EQ(image.pixels[1], V3f(2, 0, 0));
    EXPECT_EQ(image.pixels[2], V3f(65504, 0, 0));
    EXPECT_EQ(image.clamped, 2u);
    EXPECT_EQ(image.transparent, 0u);
}

TEST(ReadLinearImage, TransparentPixels_ShowTheBackground) {
    const TemporaryPicture file(".png");
    file.write<std::uint8_t>(3, 1, 4, OIIO::TypeDesc::UINT8,
                             {255, 0, 0, 255, 255, 0, 0, 51, 9, 9, 9, 0});
    const LinearImage image = read_linear_image(file.path(), false, V3f(0, 0.5f, 1));
    EXPECT_EQ(image.pixels[0], V3f(1, 0, 0));
    EXPECT_NEAR(image.pixels[1].x, 0.2f, 1e-6f);
    EXPECT_NEAR(image.pixels[1].y, 0.4f, 1e-6f);
    EXPECT_EQ(image.pixels[2], V3f(0, 0.5f, 1));
    EXPECT_EQ(image.transparent, 2u);
}

TEST(MipPyramid, AtTexelCentres_GivesTheTexels) {
    const CoverageMask mask(2, 2, {0, 255, 255, 0}, Wrap::clamp);
    EXPECT_EQ(scalar::look_up_coverage<One>(mask.tables(), {0.25f, 0.25f}, 0), 0);
    EXPECT_EQ(scalar::look_up_coverage<One>(mask.tables(), {0.75f, 0.25f}, 0), 1);
    EXPECT_EQ(scalar::look_up_coverage<One>(mask.tables(), {0.5f, 0.5f}, 0), 0.5f);
}

TEST(MipPyramid, OutsideTheSquare_WrapsAsTold) {
    const CoverageMask once(4, 1, {0, 0, 0, 255}, Wrap::clamp);
    EXPECT_EQ(scalar::look_up_coverage<One>(once.tables(), {7.0f, 0.5f}, 0), 1);
    EXPECT_EQ(scalar::look_up_coverage<One>(once.tables(), {-0.125f, 0.5f}, 0), 0);
    const CoverageMask tile(4, 1, {0, 0, 0, 255}, Wrap::repeat);
    EXPECT_EQ(scalar::look_up_coverage<One>(tile.tables(), {-0.125f, 0.5f}, 0), 1);
    EXPECT_EQ(scalar::look_up_coverage<One>(tile.tables(), {3.125f, 0.5f}, 0), 0);
    // Half-way between the last texel and the first.
    EXPECT_EQ(scalar::look_up_coverage<One>(tile.tables(), {1.0f, 0.5f}, 0), 0.5f);
}

TEST(MipPyramid, WideFootprint_GivesTheMean) {
    std::vector<std::uint8_t> texels(64 * 64, 0);
    for (std::size_t i = 0; i < texels.size(); i += 2) {
        texels[i] = 255;
    }
    const CoverageMask mask(64, 64, texels, Wrap::repeat);
    EXPECT_EQ(mask.level_count(), 7u);
    EXPECT_NEAR(scalar::look_up_coverage<One>(mask.tables(), {0.3f, 0.6f}, 1.0f), 0.5f, 0.01f);
    EXPECT_NEAR(scalar::look_up_coverage<One>(mask.tables(), {0.3f, 0.6f}, 100.0f), 0.5f, 0.01f);
}

TEST(MipPyramid, OddSizes_ShrinkToOneTexel) {
    const CoverageMask mask(5, 3, std::vector<std::uint8_t>(15, 51), Wrap::clamp);
    EXPECT_EQ(mask.level_count(), 4u);
    EXPECT_NEAR(scalar::look_up_coverage<One>(mask.tables(), {0.9f, 0.1f}, 2), 0.2f, 1e-6f);
}

/// No pixel is read: only sizes count.
RawPicture empty_picture(int width, int height, int channels, PictureValues kind) {
    RawPicture picture{width, height, channels, false, {}};
    picture.values = std::move(kind);
    return picture;
}

TEST(ImagePyramid, BeyondWhat31BitsReach_DoesNotFit) {
    const std::vector<std::uint8_t> bytes;
    const std::vector<std::uint16_t> words;
    const std::vector<float> numbers;
    // 14,400 x 14,400 pixels overflowed once; 2^28 are the most with CAROM_LIMITS=4.
    for (const int side : {14'400, 16'384}) {
        EXPECT_TRUE(ImagePyramid::fits(empty_picture(side, side, 1, bytes)));
        EXPECT_TRUE(ImagePyramid::fits(empty_picture(side, side, 3, bytes)));
        EXPECT_TRUE(ImagePyramid::fits(empty_picture(side, side, 1, words)));
        EXPECT_TRUE(ImagePyramid::fits(empty_picture(side, side, 3, words)));
        EXPECT_TRUE(ImagePyramid::fits(empty_picture(side, side, 1, numbers)));
    }
    EXPECT_FALSE(ImagePyramid::fits(empty_picture(14'400, 14'400, 3, numbers)));
    EXPECT_FALSE(ImagePyramid::fits(empty_picture(14'400, 14'400, 4, bytes)));
    // 3 bytes of each pixel, and those that may be read behind the last one.
    EXPECT_TRUE(ImagePyramid::fits(empty_picture(26'754, 26'754, 3, bytes)));
    EXPECT_FALSE(ImagePyramid::fits(empty_picture(26'755, 26'755, 3, bytes)));
}

TEST(ImagePyramid, IntegersOfAFile_TakeTheirOwnRoom) {
    RawPicture picture =
        empty_picture(3, 2, 1, std::vector<std::uint8_t>{0, 51, 102, 153, 204, 255});
    const ImagePyramid grey(std::move(picture), true);
    const ImageTables tables = grey.tables();
    EXPECT_TRUE(tables.is_grey);
    EXPECT_FALSE(tables.has_16_bits);
    EXPECT_EQ(tables.codes[5], 255);
    const auto at = [&](const V2f& uv, float width) {
        return scalar::look_up_image<One>(tables, {uv, V2f(width, 0), V2f(0, width)}).colour;
    };
    // Texels' centres, around the edges too; the half float nearest to 0.2 is 0.19995.
    EXPECT_NEAR(at({0.5f, 0.25f}, 0).x, 0.2f, 1e-4f);
    EXPECT_EQ(at({0.5f, 0.25f}, 0).y, at({0.5f, 0.25f}, 0).z);
    EXPECT_NEAR(at({1.0f, 0.25f}, 0).x, 0.2f,
                1e-4f);  // between 0.4 and 0
    EXPECT_NEAR(at({-1 / 6.0f, 0.75f}, 0).x, 1, 1e-4f);
    // The whole picture in one texel: the mean of those of four, and of the last column.
    EXPECT_NEAR(at({0.1f, 0.1f}, 10).x, 0.5f * (0.4f + 0.7f), 1e-3f);
}

/// 64 by 64 texels, in columns of black and white four texels wide.
ImagePyramid stripes() {
    std::vector<std::uint8_t> codes;
    for (int i = 0; i < 64 * 64; ++i) {
        codes.push_back(i % 64 / 4 % 2 == 0 ? 0 : 255);
    }
    return ImagePyramid(empty_picture(64, 64, 1, codes), true);
}

// A pixel that is long along the stripes and narrow across them sees their colours; one that is
// long across them sees their mean.
TEST(ImagePyramid, LongPixels_AreFilteredAlongTheirLength) {
    const ImagePyramid picture = stripes();
    const ImageTables tables = picture.tables();
    const auto at = [&](float x, const V2f& along, const V2f& across) {
        return scalar::look_up_image<One>(tables, {V2f(x / 64, 0.5f), along / 64, across / 64})
            .colour.x;
    };
    for (const float length : {1.0f, 3.0f, 7.0f, 10.0f}) {
        EXPECT_NEAR(at(2, V2f(0, length), V2f(1, 0)), 0, 0.01) << length;
        EXPECT_NEAR(at(6, V2f(0, length), V2f(1, 0)), 1, 0.01) << length;
        EXPECT_NEAR(at(6, V2f(1, 0), V2f(0, length)), 1, 0.01) << length;
    }
    for (const float x : {2.0f, 3.0f, 5.5f}) {
        EXPECT_NEAR(at(x, V2f(24 / 0.7f, 0), V2f(0, 1)), 0.5, 0.07) << x;
        EXPECT_NEAR(at(x, V2f(500, 0), V2f(0, 500)), 0.5, 0.01) << x;
    }
}

// As a pixel grows, its colour changes gradually: levels are blended.
TEST(ImagePyramid, GrowingPixels_ChangeGradually) {
    const ImagePyramid picture = stripes();
    const ImageTables tables = picture.tables();
    float last = 1;
    for (float width = 0.5f; width < 100; width *= 1.01f) {
        const float value =
            scalar::look_up_image<One>(
                tables, {V2f(6.0f / 64, 0.5f), V2f(width / 64, 0), V2f(0, width / 64)})
                .colour.x;
        EXPECT_NEAR(value, last, 0.02) << width;
        last = value;
    }
    EXPECT_NEAR(last, 0.5, 0.01);
}

/// Two by two texels: red and green above blue and white, on a surface whose uv covers 4 m by 2 m.
class PlacedImage : public ::testing::Test {
  protected:
    PlacedImage() {
        file_.write<float>(2, 2, 3, OIIO::TypeDesc::FLOAT, {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1});
        image_.file = file_.path();
    }

    V3f at(float u, float v) {
        SurfacePoint point;
        point.uv = V2f(u, v);
        point.uv_metres = V2f(4, 2);
        point.u_gradient = V3f(0.25f, 0, 0);
        point.v_gradient = V3f(0, 0.5f, 0);
        return test::colour_of(Texture(image_, images_), point, 0);
    }

    const V3f kRed{1, 0, 0}, kGreen{0, 1, 0}, kBlue{0, 0, 1}, kWhite{1, 1, 1};
    TemporaryPicture file_{".exr"};
    ImageTexture image_;
    ImageCache images_;
};

TEST_F(PlacedImage, ByItself_FillsTheSurfaceUpright) {
    EXPECT_EQ(at(0.25f, 0.25f), kBlue);
    EXPECT_EQ(at(0.75f, 0.25f), kWhite);
    EXPECT_EQ(at(0.25f, 0.75f), kRed);
    EXPECT_EQ(at(0.75f, 0.75f), kGreen);
}

TEST_F(PlacedImage, Scale_RepeatsFromTheLowerLeft) {
    image_.scale = Vec2(2, 0.5);
    EXPECT_EQ(at(0.125f, 0.5f), kBlue);
    EXPECT_EQ(at(0.375f, 0.5f), kWhite);
    EXPECT_EQ(at(0.625f, 0.5f), kBlue);
}

TEST_F(PlacedImage, Size_IsInMetresOfTheSurface) {
    image_.size = Vec2(1, 4);
    EXPECT_EQ(at(0.25f / 4, 0.5f), kBlue);  // a quarter metre in; 1 m up of 4 m
    EXPECT_EQ(at(0.75f / 4, 0.5f), kWhite);
    EXPECT_EQ(at(1.25f / 4, 0.5f), kBlue);
}

TEST_F(PlacedImage, Offset_MovesThePicture) {
    image_.offset = Vec2(0.5, 0);
    EXPECT_EQ(at(0.75f, 0.25f), kBlue);
    EXPECT_EQ(at(0.25f, 0.25f), kWhite);
}

TEST_F(PlacedImage, Rotation_TurnsItCounterClockwise) {
    image_.placement.rotation = std::acos(-1.0) / 2;
    // What was to the right of the corner is now above it.
    const V3f above = at(-0.25f, 0.75f);
    EXPECT_NEAR((above - kWhite).length(), 0, 1e-5);
    EXPECT_NEAR((at(-0.75f, 0.25f) - kRed).length(), 0, 1e-5);
}

}  // namespace
}  // namespace carom::render
