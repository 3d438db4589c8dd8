#include "pipeline/export/textures/texture_values.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/colour.h"
#include "pipeline/export/textures/texture_group.h"
#include "render/material/material_textures.h"
#include "render/material/scalar_kernels.h"
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

constexpr float kHalf = 3e-4F;  // error of colours that are half floats

class TextureValues : public PictureFiles {
  protected:
    /// Red and green in the upper row, blue and white in the lower one.
    std::string four() const {
        return png("four.png", 2, {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 255}});
    }
    TextureGroup group(const auto& source) {
        std::vector<PlacedTexture> textures;
        add_textures(source, textures);
        const TexturePlace place = shared_texture(textures).value().place;
        return texture_group(std::move(textures), {place}, pictures_).value();
    }
    V3f colour(const render::ColourSource& source, const Vec2& c) {
        return colour_values(source, group(source), pictures_)(c);
    }
    float number(const render::NumberSource& source, const Vec2& c,
                 NumberUse use = NumberUse::usual) {
        return number_values(source, group(source), pictures_, use)(c);
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
    EXPECT_LT((colour(picture, {0, 0}) - V3f(0.4F, 0.2F, 1)).length(), kHalf);
}

TEST_F(TextureValues, NumbersOfAPicture_AreLinearChannelsWithARange) {
    ImageTexture picture = image(png("channels.png", 1, {{51, 102, 153, 51}}, 4));
    picture.background = Vec3(1, 1, 1);
    const auto value = [&](PictureChannel channel, NumberUse use = NumberUse::usual) {
        return number(carom::testing::number(picture, channel, {1, 3}), {0, 0}, use);
    };
    const V3f shown = 0.2F * V3f(0.2F, 0.4F, 0.6F) + V3f(0.8F);
    EXPECT_NEAR(value(PictureChannel::red), 1 + 2 * shown.x, 2 * kHalf);
    EXPECT_NEAR(value(PictureChannel::green), 1 + 2 * shown.y, 2 * kHalf);
    EXPECT_NEAR(value(PictureChannel::blue), 1 + 2 * shown.z, 2 * kHalf);
    EXPECT_NEAR(value(PictureChannel::alpha), 1.4, 2 * kHalf);
    EXPECT_NEAR(value(PictureChannel::automatic), 1 + 2 * luminance(shown), 2 * kHalf);
    EXPECT_NEAR(value(PictureChannel::automatic, NumberUse::mask), 1.4, 2 * kHalf);
}

// A picture on a wall: it is seen as much as its alpha says, in its own colour.
TEST_F(TextureValues, MixByAlpha_ShowsWhatIsOpaque) {
    const ImageTexture decal = image(png("decal.png", 1, {{255, 0, 0, 51}}, 4));
    render::MixTexture mix;
    mix.a = Vec3(0, 1, 0);
    mix.b = decal;
    mix.by = render::NumberTexture{decal};
    const V3f value = colour(std::make_shared<const render::MixTexture>(mix), {0, 0});
    EXPECT_LT((value - V3f(0.2F, 0.8F, 0)).length(), kHalf);
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
    EXPECT_NEAR(colour(checker, {0.05, 0.05}).x, 1, 1e-4);
    EXPECT_NEAR(colour(checker, {0.15, 0.05}).x, 0, 1e-4);
    EXPECT_NEAR(colour(checker, {0.15, 0.15}).x, 1, 1e-4);
    EXPECT_NEAR(colour(checker, {-0.05, 0.05}).x, 0, 1e-4);
    EXPECT_NEAR(colour(checker, {-0.00137, 0.05}).x, 0.5F, 1e-3F);  // the renderer shifts edges
}

/// On the plane z = 0 of an object, over a pixel of that width (m).
V3f rendered(const render::ColourSource& source, const Vec2& place, double width) {
    using render::scalar::One;
    render::StandardMaterial material;
    material.base = source;
    render::ImageCache images;
    const render::TexturesOfMaterial textures(material, images);
    render::scalar::SurfacePointOf<One> point{};
    point.geometric_normal = {0, 0, 1};
    point.object_position = {static_cast<float>(place.x), static_cast<float>(place.y), 0};
    point.u_gradient = point.v_gradient = {0, 0, 0};
    point.uv = point.uv_metres = {0, 0};
    point.x_axis = {1, 0, 0};
    point.y_axis = {0, 1, 0};
    point.z_axis = {0, 0, 1};
    const auto& numbers = textures.numbers();
    const auto seen = render::scalar::texture_point<One>(
        point, numbers.needs, point.geometric_normal, static_cast<float>(width), 0.1F);
    return render::scalar::resolve_surface<One>(render::List<render::TextureData>(textures.list()),
                                                numbers, seen, point.geometric_normal,
                                                point.geometric_normal, point.geometric_normal)
        .base;
}

TEST_F(TextureValues, OfEveryKindOfTexture_AreThoseOfTheRenderer) {
    const render::Placement turned{render::Mapping::planar, {0, 0, 1}, 0.4};
    ImageTexture picture = image(four());
    picture.placement = turned;
    picture.size = Vec2(0.25, 0.25);
    picture.offset = {0.1, 0.3};
    picture.tint = {0.9, 0.5, 0.1};
    const render::CheckerTexture checker{{1, 0.5, 0}, {0, 0, 1}, 0.125, turned};
    render::WoodTexture wood;
    wood.placement = turned;
    render::ClothTexture cloth;
    cloth.placement = turned;
    const auto mix = std::make_shared<const render::MixTexture>(render::MixTexture{
        wood, picture, carom::testing::number(picture, PictureChannel::green, {0.2, 0.7})});
    for (const render::ColourSource& source :
         {render::ColourSource(picture), render::ColourSource(checker), render::ColourSource(wood),
          render::ColourSource(cloth), render::ColourSource(mix)}) {
        const TextureGroup textures = group(source);
        const Vec2 pixel = baked_grid(textures, pictures_).pixel();
        EXPECT_NEAR(pixel.x, pixel.y, 1e-3 * pixel.x);
        const ColourAt values = colour_values(source, textures, pictures_);
        float least = 1;
        float most = 0;
        for (int i = 0; i < 40; ++i) {
            const Vec2 place(0.011 * i - 0.2, 0.3 - 0.017 * i);
            const Vec2 c(std::cos(0.4) * place.x + std::sin(0.4) * place.y,
                         std::cos(0.4) * place.y - std::sin(0.4) * place.x);
            const V3f value = values(c);
            const V3f expected = rendered(source, place, pixel.x);
            EXPECT_LT((value - expected).length(), 2e-3F) << source.index() << " " << i;
            least = std::min(least, luminance(value));
            most = std::max(most, luminance(value));
        }
        EXPECT_GT(most - least, 1e-3F) << source.index();
    }
}

TEST_F(TextureValues, PatternInSpace_HasItsMean) {
    render::MixTexture mix{render::WoodTexture{}, image(four()), 0.5};
    const V3f wood(render::WoodTexture{}.mean_colour());
    EXPECT_LT((colour(std::make_shared<const render::MixTexture>(mix), {0.75, 0.25}) -
               (0.5F * wood + V3f(0.5F)))
                  .length(),
              1e-6F);
}

TEST_F(TextureValues, OpaqueAlpha_IsNoMask) {
    const ImageTexture picture = image(png("opaque.png", 1, {{51, 51, 51, 255}}, 4));
    const auto value =
        number(carom::testing::number(picture, PictureChannel::automatic), {0, 0}, NumberUse::mask);
    EXPECT_NEAR(value, 0.2F, 1e-4F);
    EXPECT_EQ(channel_of(picture, pictures_.facts(picture.file), NumberUse::mask),
              PictureChannel::luminance);
}

TEST_F(TextureValues, Relief_HasTheSlopesOfItsHeights) {
    std::vector<Pixel> ramp;
    for (int i = 0; i < 64; ++i) {
        const int height = 32 * (i % 8) + 4 * (i / 8);
        ramp.push_back({height, height, height});
    }
    ImageTexture picture = image(png("ramp.png", 8, ramp));
    picture.scale = {2, 1};  // a pixel is 0.05 m wide and high
    const render::Relief relief = render::HeightTexture{{picture, {0, 1}}, 0.5};
    const TextureGroup textures = group(relief);
    const BakedPicture made = bake_normals(baked_grid(textures, pictures_),
                                           normal_values(relief, textures, {0.8, 0.4}, pictures_));
    const float step = 0.5F / 255 / 0.05F;
    const V3f expected = V3f(-32 * step, 4 * step, 1).normalized();
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(made.values[static_cast<std::size_t>(3 * (3 * 8 + 4) + c)],
                    127.5F + 127.5F * expected[c], 0.51F);
    }
}

// A checker's squares are 0.2 m high steps, each in the middle between two pixels.
TEST_F(TextureValues, ReliefOfAPattern_HasSlopesAtItsEdges) {
    render::CheckerTexture checker;
    checker.placement.mapping = render::Mapping::planar;
    checker.even = {1, 1, 1};
    checker.odd = {0, 0, 0};
    checker.size = 0.1;
    const render::Relief relief = render::HeightTexture{{checker, {0, 1}}, 0.2};
    const ColourAt normal = normal_values(relief, group(relief), {1, 1}, pictures_);
    EXPECT_LT((normal({0.05, 0.05}) - V3f(0, 0, 1)).length(), 1e-4F);
    EXPECT_GT(normal({0.1 - 0.00137, 0.05}).x, 0.9F);  // it leans down, to the right
}

TEST_F(TextureValues, Codes_SurviveDecodingAndEncoding) {
    std::vector<Pixel> pixels;
    for (int code = 0; code < 256; ++code) {
        pixels.push_back({code, 255 - code, code / 2, code});
    }
    const ImageTexture picture = image(png("codes.png", 16, pixels, 4));
    const ImageTexture opaque = image(png("opaque.png", 16, pixels, 3));
    const render::NumberSource alpha = carom::testing::number(picture, PictureChannel::alpha);
    const BakedGrid grid{16, 16, {}};
    const EncodedPicture made = encode(
        bake_colour(grid, colour_values(opaque, group(render::ColourSource(opaque)), pictures_),
                    number_values(alpha, group(alpha), pictures_)),
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
