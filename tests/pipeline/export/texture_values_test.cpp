#include "pipeline/export/textures/texture_values.h"

#include <cmath>

#include "core/colour.h"
#include "pipeline/export/textures/texture_group.h"
#include "tests/pipeline/export/picture_files.h"
#include "tests/pipeline/export/textured_shot.h"

namespace carom::pipeline {
namespace {

using carom::testing::image;
using carom::testing::PictureFiles;
using carom::testing::Pixel;
using Imath::V3f;
using render::ImageTexture;
using render::PictureChannel;

class TextureValues : public PictureFiles {
  protected:
    /// Red and green in the upper row, blue and white in the lower one.
    std::string four() const {
        return png("four.png", 2, {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 255}});
    }
    V3f colour(const render::ColourSource& source, const Vec2& c) {
        std::vector<PlacedTexture> textures;
        add_textures(source, textures);
        return colour_values(source, shared_texture(textures).value(), pictures_)(c);
    }
    float number(const render::NumberSource& source, const Vec2& c,
                 NumberUse use = NumberUse::usual) {
        std::vector<PlacedTexture> textures;
        add_textures(source, textures);
        return number_values(source, shared_texture(textures).value(), pictures_, use)(c);
    }

    PictureStore pictures_;
};

TEST_F(TextureValues, OfAPicture_BeginAtTheLowerLeft) {
    const ImageTexture picture = image(four());
    EXPECT_EQ(colour(picture, {0.25, 0.25}), V3f(0, 0, 1));
    EXPECT_EQ(colour(picture, {0.75, 0.25}), V3f(1, 1, 1));
    EXPECT_EQ(colour(picture, {0.25, 0.75}), V3f(1, 0, 0));
    EXPECT_EQ(colour(picture, {-0.25, 1.75}), V3f(0, 1, 0));  // repeats
    EXPECT_LT((colour(picture, {0.5, 0.5}) - V3f(0.5F)).length(), 1e-6F);
}

TEST_F(TextureValues, ScaleAndOffset_MoveThePicture) {
    ImageTexture picture = image(four());
    picture.scale = {2, 4};
    picture.offset = {0.5, 0};
    // The lower left pixel's centre is at ((0.25 + 0.5) / 2, 0.25 / 4).
    EXPECT_EQ(colour(picture, {0.375, 0.0625}), V3f(0, 0, 1));
    picture.scale = {1, 1};
    picture.size = Vec2(0.5, 0.25);
    EXPECT_EQ(colour(picture, {0.375, 0.0625}), V3f(0, 0, 1));
}

TEST_F(TextureValues, Background_IsSeenThroughAlpha) {
    ImageTexture picture = image(png("half.png", 1, {{255, 255, 255, 102}}, 4));
    picture.background = Vec3(0, 0, 1);
    picture.tint = {1, 0.5, 1};
    EXPECT_LT((colour(picture, {0, 0}) - V3f(0.4F, 0.2F, 1)).length(), 1e-6F);
}

TEST_F(TextureValues, NumbersOfAPicture_AreLinearChannelsWithARange) {
    ImageTexture picture = image(png("channels.png", 1, {{51, 102, 153, 51}}, 4));
    picture.background = Vec3(1, 1, 1);
    const auto value = [&](PictureChannel channel, NumberUse use = NumberUse::usual) {
        return number(carom::testing::number(picture, channel, {1, 3}), {0, 0}, use);
    };
    const V3f shown = 0.2F * V3f(0.2F, 0.4F, 0.6F) + V3f(0.8F);
    EXPECT_NEAR(value(PictureChannel::red), 1 + 2 * shown.x, 1e-6);
    EXPECT_NEAR(value(PictureChannel::green), 1 + 2 * shown.y, 1e-6);
    EXPECT_NEAR(value(PictureChannel::blue), 1 + 2 * shown.z, 1e-6);
    EXPECT_NEAR(value(PictureChannel::alpha), 1.4, 1e-6);
    EXPECT_NEAR(value(PictureChannel::automatic), 1 + 2 * luminance(shown), 1e-6);
    EXPECT_NEAR(value(PictureChannel::automatic, NumberUse::mask), 1.4, 1e-6);
}

// A picture on a wall: it is seen as much as its alpha says, in its own colour.
TEST_F(TextureValues, MixByAlpha_ShowsWhatIsOpaque) {
    const ImageTexture decal = image(png("decal.png", 1, {{255, 0, 0, 51}}, 4));
    render::MixTexture mix;
    mix.a = Vec3(0, 1, 0);
    mix.b = decal;
    mix.by = render::NumberTexture{decal};
    const V3f value = colour(std::make_shared<const render::MixTexture>(mix), {0, 0});
    EXPECT_LT((value - V3f(0.2F, 0.8F, 0)).length(), 1e-6F);
}

TEST_F(TextureValues, Mix_IsBetweenItsParts) {
    render::MixTexture mix;
    mix.a = Vec3(1, 0, 0);
    mix.b = image(four());
    mix.by = 0.25;
    EXPECT_EQ(colour(std::make_shared<const render::MixTexture>(mix), {0.25, 0.25}),
              V3f(0.75F, 0, 0.25F));
}

TEST_F(TextureValues, Checker_HasItsSquares) {
    render::CheckerTexture checker;
    checker.placement.mapping = render::Mapping::planar;
    checker.even = {1, 1, 1};
    checker.odd = {0, 0, 0};
    checker.size = 0.1;
    EXPECT_EQ(colour(checker, {0.05, 0.05}), V3f(1));
    EXPECT_EQ(colour(checker, {0.15, 0.05}), V3f(0));
    EXPECT_EQ(colour(checker, {0.15, 0.15}), V3f(1));
    EXPECT_EQ(colour(checker, {-0.05, 0.05}), V3f(0));
    EXPECT_EQ(colour(checker, {-0.0005, 0.05}), V3f(1));  // the renderer shifts edges
}

TEST_F(TextureValues, Relief_HasTheSlopesOfItsHeights) {
    // Heights that rise by 1 over the width: 0.2 m high over 0.8 m of the surface.
    const NumberAt ramp = [](const Vec2& c) { return static_cast<float>(0.2 * c.x + 0.1 * c.y); };
    const BakedGrid grid{4, 4, {{2, 1}, {0, 0}}};  // one repeat is half a coordinate wide
    const BakedPicture picture = bake_relief(grid, ramp, {0.8, 0.4});
    const V3f expected = V3f(-0.25F, -0.25F, 1).normalized();
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(picture.values[static_cast<std::size_t>(c)],
                    127.5 + 127.5 * static_cast<double>(expected[c]), 0.51);
    }
}

TEST_F(TextureValues, Codes_SurviveDecodingAndEncoding) {
    std::vector<Pixel> pixels;
    for (int code = 0; code < 256; ++code) {
        pixels.push_back({code, 255 - code, code / 2, code});
    }
    const ImageTexture picture = image(png("codes.png", 16, pixels, 4));
    const ImageTexture opaque = image(png("opaque.png", 16, pixels, 3));
    const BakedGrid grid{16, 16, {}};
    const EncodedPicture made =
        encode(bake_colour(grid, colour_values(opaque, placed(opaque), pictures_),
                           number_values(carom::testing::number(picture, PictureChannel::alpha),
                                         placed(picture), pictures_)),
               PictureFormat::png);
    EXPECT_EQ(made.alpha, AlphaKind::varied);
    EXPECT_EQ(pixels_of({reinterpret_cast<const char*>(made.bytes.data()), made.bytes.size()}),
              pixels);
}

TEST_F(TextureValues, SharedTexture_IsTheLargestOfWholeMultiples) {
    ImageTexture once = image("a.png");
    ImageTexture twice = image("b.png");
    twice.scale = {2, 2};
    ImageTexture odd = image("c.png");
    odd.scale = {1.5, 1.5};
    const auto shared = shared_texture({placed(twice), placed(once)});
    ASSERT_TRUE(shared);
    EXPECT_EQ(shared->tile, TextureTile{});
    EXPECT_TRUE(fit_together(placed(twice), placed(once)));
    EXPECT_FALSE(fit_together(placed(odd), placed(once)));
    once.placement.mapping = render::Mapping::box;
    EXPECT_FALSE(fit_together(placed(twice), placed(once)));
    EXPECT_FALSE(shared_texture({}));
}

// Wood of an object's own axes, a label by its uv and dirt by a box: the label is what is shown.
TEST_F(TextureValues, MixOfPlaces_ShowsThatOfItsFirstPicture) {
    ImageTexture dirt = image(four());
    dirt.placement.mapping = render::Mapping::box;
    render::MixTexture mix;
    mix.a = image(four());
    mix.b = dirt;
    mix.by = 0.5;
    const render::ColourSource source = std::make_shared<const render::MixTexture>(mix);
    EXPECT_EQ(colour(source, {0.25, 0.25}), V3f(0.25F, 0.25F, 0.75F));  // half of it is grey
}

}  // namespace
}  // namespace carom::pipeline
