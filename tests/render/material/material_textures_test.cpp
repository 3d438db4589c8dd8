#include "render/material/material_textures.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "render/material/material.h"
#include "tests/render/statistics.h"
#include "tests/render/texture/temporary_picture.h"

namespace carom::render {
namespace {

using scalar::One;
using test::TemporaryPicture;

constexpr OIIO::TypeDesc kBytes = OIIO::TypeDesc::UINT8;
constexpr OIIO::TypeDesc kWords = OIIO::TypeDesc::UINT16;
constexpr OIIO::TypeDesc kFloats = OIIO::TypeDesc::FLOAT;

ImageTexture picture_of(const TemporaryPicture& file) {
    ImageTexture image;
    image.file = file.path();
    return image;
}

/// On the plane z = 0 of an object along the world's axes, uv in metres.
struct Place {
    V2f at{0, 0};
    float width = 1e-6F;  // of a pixel, m
    V3f normal{0, 0, 1};
    V3f position{0, 0, 0};
    std::optional<V3f> towards_viewer{};  // none: straight above
};

scalar::ResolvedOf<One> resolve(const TexturesOfMaterial& textures, const Place& place) {
    scalar::SurfacePointOf<One> point{};
    point.geometric_normal = point.shading_normal = place.normal;
    point.object_position = place.position + V3f(place.at.x, place.at.y, 0);
    point.uv = place.at;
    point.uv_metres = {1, 1};
    point.u_gradient = {1, 0, 0};
    point.v_gradient = {0, 1, 0};
    point.x_axis = {1, 0, 0};
    point.y_axis = {0, 1, 0};
    point.z_axis = {0, 0, 1};
    const V3f wo = place.towards_viewer.value_or(place.normal);
    const auto textured =
        scalar::texture_point<One>(point, textures.numbers().needs, wo, place.width, 0.1F);
    return scalar::resolve_surface<One>(List<TextureData>(textures.list()), textures.numbers(),
                                        textured, place.normal, place.normal, wo);
}

scalar::ResolvedOf<One> resolve(const StandardMaterial& material, const Place& place) {
    ImageCache images;
    return resolve(TexturesOfMaterial(material, images), place);
}

NumberTexture number_of(const ImageTexture& image, PictureChannel channel = {},
                        const Vec2& range = {0, 1}) {
    NumberTexture number{image, range};
    std::get<ImageTexture>(number.pattern).channel = channel;
    return number;
}

TEST(MaterialTextures, ChannelsOfOnePicture_GiveSeveralNumbersByOneLookUp) {
    const TemporaryPicture file(".png");
    file.write<std::uint8_t>(1, 1, 3, kBytes, {51, 102, 204});
    StandardMaterial material;
    material.metal = number_of(picture_of(file), PictureChannel::blue);
    material.roughness = number_of(picture_of(file), PictureChannel::green);
    material.specular = number_of(picture_of(file), PictureChannel::red, Vec2(1, 0.5));
    material.coat.weight = number_of(picture_of(file), PictureChannel::luminance);
    ImageCache images;
    const TexturesOfMaterial textures(material, images);
    EXPECT_EQ(textures.list().size(), 2U);  // with the base
    const auto found = resolve(textures, {});
    EXPECT_NEAR(found.numbers[kMetal], 0.8F, 1e-3F);
    EXPECT_NEAR(found.numbers[kRoughness], 0.16F, 1e-3F) << "alpha is the square";
    EXPECT_NEAR(found.numbers[kSpecular], 0.9F, 1e-3F);
    EXPECT_NEAR(found.numbers[kCoatWeight], 0.2126F * 0.2F + 0.7152F * 0.4F + 0.0722F * 0.8F,
                1e-3F);
    EXPECT_EQ(found.numbers[kSheen], 0);
}

TEST(MaterialTextures, NumbersOfAnEncodedPicture_AreTheFilesOwn) {
    const TemporaryPicture file(".png");
    file.write<std::uint8_t>(1, 1, 1, kBytes, {51});
    StandardMaterial material;
    material.base = picture_of(file);
    material.metal = number_of(picture_of(file));
    const auto found = resolve(material, {});
    EXPECT_NEAR(found.numbers[kMetal], 0.2F, 1e-3F);
    EXPECT_NEAR(found.base.x, 0.0331F, 1e-3F) << "sRGB";
}

TEST(MaterialTextures, PatternsGiveNumbers) {
    CheckerTexture checker;
    checker.even = Vec3(0.25, 0.25, 0.25);
    checker.odd = Vec3(0.75, 0.75, 0.75);
    StandardMaterial material;
    material.sheen = NumberTexture{checker, {0, 1}};
    EXPECT_NEAR(resolve(material, {{0.05F, 0.05F}}).numbers[kSheen], 0.25F, 1e-4F);
    EXPECT_NEAR(resolve(material, {{0.15F, 0.05F}}).numbers[kSheen], 0.75F, 1e-4F);
    EXPECT_NEAR(resolve(material, {{0.15F, 0.05F}, 1.0F}).numbers[kSheen], 0.5F, 0.02F);
}

TEST(MaterialTextures, MixOfMixes_BlendsByMasks) {
    const TemporaryPicture mask(".png");
    mask.write<std::uint8_t>(2, 1, 1, kBytes, {0, 255});
    const MixTexture inner{Vec3(1, 0, 0), Vec3(0, 1, 0), 0.25};
    const MixTexture outer{std::make_shared<const MixTexture>(inner), Vec3(0, 0, 1),
                           number_of(picture_of(mask))};
    StandardMaterial material;
    material.base = std::make_shared<const MixTexture>(outer);
    const V3f left = resolve(material, {{0.25F, 0.5F}}).base;
    const V3f right = resolve(material, {{0.75F, 0.5F}}).base;
    EXPECT_NEAR((left - V3f(0.75F, 0.25F, 0)).length(), 0, 1e-5F);
    EXPECT_NEAR((right - V3f(0, 0, 1)).length(), 0, 1e-5F);
}

/// A decal: the mask is the picture's own alpha, and the colour at its edge is not darkened.
TEST(MaterialTextures, MixByThePicturesOwnAlpha_LaysItOnTheOtherTexture) {
    const TemporaryPicture file(".png");
    file.write<std::uint8_t>(2, 1, 4, kBytes, {255, 0, 0, 255, 0, 0, 0, 0});
    const MixTexture decal{Vec3(0, 0, 1), picture_of(file), number_of(picture_of(file))};
    StandardMaterial material;
    material.base = std::make_shared<const MixTexture>(decal);
    EXPECT_NEAR((resolve(material, {{0.25F, 0.5F}}).base - V3f(1, 0, 0)).length(), 0, 1e-3F);
    EXPECT_NEAR((resolve(material, {{0.75F, 0.5F}}).base - V3f(0, 0, 1)).length(), 0, 1e-3F);
    const V3f edge = resolve(material, {{0.5F, 0.5F}}).base;
    EXPECT_NEAR((edge - V3f(0.5F, 0, 0.5F)).length(), 0, 1e-3F);
}

/// Many programs write an alpha of 1.
TEST(MaterialTextures, OpaqueAlphaOfAMask_DoesNotCount) {
    const TemporaryPicture file(".png");
    file.write<std::uint8_t>(2, 1, 4, kBytes, {0, 0, 0, 255, 255, 255, 255, 255});
    StandardMaterial material;
    material.opacity = number_of(picture_of(file));
    ImageCache images;
    const TexturesOfMaterial textures(material, images);
    EXPECT_EQ(textures.numbers().opacity.channel, PictureChannel::luminance);
    EXPECT_FALSE(textures.list().back().image.picture.has_alpha);
    EXPECT_TRUE(textures.list().back().image.picture.codes.exists());
}

TEST(MaterialTextures, TransparentPicture_ShowsItsBackgroundOrWhatIsOpaque) {
    const TemporaryPicture file(".png");
    file.write<std::uint8_t>(2, 1, 4, kBytes, {255, 0, 0, 255, 0, 0, 0, 0});
    StandardMaterial material;
    ImageTexture image = picture_of(file);
    material.base = image;
    EXPECT_NEAR(resolve(material, {{0.75F, 0.5F}}).base.y, 0.8F, 1e-3F);
    image.background = Vec3(0, 0.5, 0);
    material.base = image;
    EXPECT_NEAR(resolve(material, {{0.75F, 0.5F}}).base.y, 0.5F, 1e-3F);
    image.background.reset();
    material.base = image;
    material.opacity = number_of(image);
    ImageCache images;
    const TexturesOfMaterial cut(material, images);
    EXPECT_NEAR(resolve(cut, {{0.5F, 0.5F}}).base.x, 1, 1e-3F) << "no fringe";
    SurfacePoint point;
    point.uv_metres = {1, 1};
    point.u_gradient = V3f(1, 0, 0);
    point.v_gradient = V3f(0, 1, 0);
    for (const auto& [u, opacity] : {std::pair(0.25F, 1.0F), {0.5F, 0.5F}, {0.75F, 0.0F}}) {
        point.uv = {u, 0.5F};
        EXPECT_NEAR(cut.opacity_at(point), opacity, 1e-3F) << u;
    }
}

/// Red, green, blue and white from the lower left on.
class FourColours {
  public:
    FourColours() {
        file_.write<std::uint8_t>(2, 2, 3, kBytes,
                                  {0, 0, 255, 255, 255, 255, 255, 0, 0, 0, 255, 0});
        image_ = picture_of(file_);
    }
    [[nodiscard]] char at(const Placement& placement, const V3f& position, const V3f& normal) {
        image_.placement = placement;
        StandardMaterial material;
        material.base = image_;
        const V3f colour = resolve(material, {{0, 0}, 1e-6F, normal, position}).base;
        return colour.x > 0.5F ? (colour.y > 0.5F ? 'w' : 'r') : colour.y > 0.5F ? 'g' : 'b';
    }

  private:
    TemporaryPicture file_{".png"};
    ImageTexture image_;
};

TEST(Placement, PlanarMapping_IsUprightAsSeenFromItsSide) {
    FourColours colours;
    const auto seen = [&](const Vec3& facing, const V3f& place) {
        return colours.at({Mapping::planar, facing, 0}, place, V3f(facing));
    };
    EXPECT_EQ(seen({0, 0, 1}, {0.75F, 0.25F, 9}), 'g') << "right is x, up is y";
    EXPECT_EQ(seen({0, 0, 1}, {0.25F, 0.75F, 9}), 'b');
    EXPECT_EQ(seen({1, 0, 0}, {9, 0.75F, 0.25F}), 'g') << "right is y, up is z";
    EXPECT_EQ(seen({0, 1, 0}, {-0.75F, 9, 0.25F}), 'g') << "right is -x, up is z";
    EXPECT_EQ(seen({-1, 0, 0}, {9, -0.75F, 0.25F}), 'g');
    EXPECT_EQ(seen({0, -1, 0}, {0.75F, 9, 0.25F}), 'g');
    EXPECT_EQ(seen({0, 0, -1}, {-0.75F, 0.25F, 9}), 'g');
    // Halfway between +x and +y: right is (-1, 1, 0) / sqrt(2).
    EXPECT_EQ(seen({1, 1, 0}, {-0.53F, 0.53F, 0.25F}), 'g');
}

TEST(Placement, BoxMapping_FollowsTheAxisThatTheSurfaceFacesMost) {
    FourColours colours;
    const auto seen = [&](const V3f& normal, const V3f& place) {
        return colours.at({Mapping::box, {0, 0, 1}, 0}, place, normal.normalized());
    };
    EXPECT_EQ(seen({0.2F, 0.1F, 1}, {0.75F, 0.25F, 9}), 'g');
    EXPECT_EQ(seen({1, 0.1F, 0.2F}, {9, 0.75F, 0.25F}), 'g');
    EXPECT_EQ(seen({0.2F, -1, 0.1F}, {0.75F, 9, 0.25F}), 'g');
}

TEST(Placement, SphericalMapping_IsLongitudeAndLatitude) {
    FourColours colours;
    const auto seen = [&](const V3f& place) {
        return colours.at({Mapping::spherical, {0, 0, 1}, 0}, place, place.normalized());
    };
    EXPECT_EQ(seen({1, 1, -1}), 'r') << "an eighth of a turn, below the equator";
    EXPECT_EQ(seen({1, -1, -1}), 'g');
    EXPECT_EQ(seen({1, 1, 1}), 'b');
    EXPECT_EQ(seen({1, -1, 1}), 'w');
}

TEST(Placement, PatternByUv_LiesAlongTheSurfaceInMetres) {
    CheckerTexture checker;
    checker.placement.mapping = Mapping::uv;
    StandardMaterial material;
    material.base = checker;
    // Whatever the place in the object.
    EXPECT_NEAR(resolve(material, {{0.05F, 0.05F}, 1e-6F, {0, 0, 1}, {0.1F, 0, 0.1F}}).base.x, 0.8F,
                1e-4F);
    EXPECT_NEAR(resolve(material, {{0.15F, 0.05F}, 1e-6F, {0, 0, 1}, {0.1F, 0, 0.1F}}).base.x, 0.2F,
                1e-4F);
}

/// A ramp that rises by `depth` over a picture of 64 texels, 1 m wide.
TEST(Relief, RampOfHeights_TurnsTheNormalByItsSlope) {
    const TemporaryPicture file(".tif");
    std::vector<std::uint16_t> values;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            values.push_back(static_cast<std::uint16_t>(1000 * x));
        }
    }
    file.write<std::uint16_t>(64, 64, 1, kWords, values);
    const double slope = 1000 * 64 / 65535.0;  // of heights 0 to 1 over the picture
    StandardMaterial material;
    material.relief = HeightTexture{number_of(picture_of(file)), 0.2};
    const V3f normal = resolve(material, {{0.5F, 0.5F}}).normal;
    const double tilt = 0.2 * slope;
    EXPECT_NEAR(normal.x, -tilt / std::hypot(1, tilt), 1e-3);
    EXPECT_NEAR(normal.y, 0, 1e-5);
    // A picture of twice the size is half as steep.
    ImageTexture large = picture_of(file);
    large.size = Vec2(2, 2);
    material.relief = HeightTexture{number_of(large), 0.2};
    const double half = tilt / 2;
    EXPECT_NEAR(resolve(material, {{1, 1}}).normal.x, -half / std::hypot(1, half), 1e-3);
    // Turned by a quarter, it rises upwards.
    large.placement.rotation = std::numbers::pi / 2;
    material.relief = HeightTexture{number_of(large), 0.2};
    const V3f turned = resolve(material, {{-1, 1}}).normal;
    EXPECT_NEAR(turned.y, -half / std::hypot(1, half), 1e-3);
    EXPECT_NEAR(turned.x, 0, 1e-4);
}

TEST(Relief, HeightsOfOtherTextures_TurnTheNormalLikewise) {
    const TemporaryPicture file(".tif");
    std::vector<std::uint16_t> values;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            values.push_back(static_cast<std::uint16_t>(1000 * y));
        }
    }
    file.write<std::uint16_t>(64, 64, 1, kWords, values);
    // A mix that is as high as the picture; its rows run down.
    MixTexture mix{Vec3(0, 0, 0), Vec3(1, 1, 1), number_of(picture_of(file))};
    StandardMaterial material;
    material.relief = HeightTexture{{std::make_shared<const MixTexture>(mix), {0, 1}}, 0.2};
    const double tilt = 0.2 * 1000 * 64 / 65535.0;
    for (const float width : {1e-4F, 1e-2F}) {
        const V3f normal = resolve(material, {{0.5F, 0.52F}, width}).normal;
        EXPECT_NEAR(normal.y, tilt / std::hypot(1, tilt), 5e-3) << width;
        EXPECT_NEAR(normal.x, 0, 1e-3) << width;
    }
}

TEST(Relief, PictureOfNormals_LeansThem) {
    const TemporaryPicture file(".exr");
    // (0.6, 0, 0.8) and flat.
    file.write<float>(1, 1, 3, kFloats, {0.8F, 0.5F, 0.9F});
    StandardMaterial material;
    material.relief = NormalPicture{picture_of(file), 1};
    V3f normal = resolve(material, {}).normal;
    EXPECT_NEAR((normal - V3f(0.6F, 0, 0.8F)).length(), 0, 2e-3F);
    material.relief = NormalPicture{picture_of(file), 0.5};
    normal = resolve(material, {}).normal;
    EXPECT_NEAR((normal - V3f(0.375F, 0, 1).normalized()).length(), 0, 2e-3F);
}

/// Fine relief that a pixel cannot show becomes gloss: of Beckmann's facets alpha^2 is twice the
/// variance of the slopes in each direction.
TEST(Relief, SlopesBelowThePixel_BecomeRoughness) {
    constexpr int kSide = 256;
    const TemporaryPicture file(".exr");
    test::TestRandom random(5);
    std::vector<float> values;
    double square = 0;
    for (int i = 0; i < kSide * kSide; ++i) {
        const float x = random.between(-0.3F, 0.3F);
        const float y = random.between(-0.3F, 0.3F);
        const V3f normal = V3f(x, y, 1).normalized();
        for (int c = 0; c < 3; ++c) {
            values.push_back(0.5F + 0.5F * normal[c]);
        }
        square += static_cast<double>(x * x + y * y);
    }
    file.write<float>(kSide, kSide, 3, kFloats, values);
    const double variance = square / (kSide * kSide);
    StandardMaterial material;
    material.roughness = 0.3;
    material.coat = {1, 1.5, 0};
    for (const double strength : {1.0, 0.5}) {
        material.relief = NormalPicture{picture_of(file), strength};
        const auto far = resolve(material, {{0.3F, 0.4F}, 2});
        const double added = variance * strength * strength;
        EXPECT_NEAR(far.numbers[kCoatRoughness], std::sqrt(added), 0.02 * std::sqrt(added));
        EXPECT_NEAR(far.numbers[kRoughness], std::hypot(0.09, std::sqrt(added)), 0.01);
        EXPECT_NEAR(far.normal.z, 1, 1e-3);
        // Seen so closely that one texel fills the pixel, the coat is a mirror.
        const auto near = resolve(material, {{0.3F, 0.4F}, 1e-7F});
        EXPECT_EQ(near.numbers[kCoatRoughness], 0);
        EXPECT_NEAR(near.numbers[kRoughness], 0.09, 1e-3);
    }
}

TEST(MaterialTextures, MissingPictureOfAnyParameter_IsNamed) {
    ImageTexture missing;
    missing.file = "/nowhere/rough.png";
    const std::vector<std::function<void(StandardMaterial&)>> uses{
        [&](StandardMaterial& m) {
            m.roughness = NumberTexture{missing, {0, 1}};
        },
        [&](StandardMaterial& m) {
            m.opacity = NumberTexture{missing, {0, 1}};
        },
        [&](StandardMaterial& m) { m.emission = missing; },
        [&](StandardMaterial& m) {
            m.relief = NormalPicture{missing, 1};
        },
        [&](StandardMaterial& m) {
            m.relief = HeightTexture{{missing, {0, 1}}, 0.001};
        }};
    for (const auto& use : uses) {
        StandardMaterial material;
        use(material);
        ImageCache images;
        try {
            const TexturesOfMaterial textures(material, images);
            ADD_FAILURE() << "no error";
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr("/nowhere/rough.png"));
        }
    }
}

TEST(MaterialTextures, ClothIsBrighterAgainstItsNap) {
    ClothTexture cloth;
    cloth.variation = 0;
    StandardMaterial material;
    const auto green = [&](double nap, const V3f& towards) {
        cloth.nap = nap;
        material.base = cloth;
        return resolve(material, {{0.1F, 0.2F}, 0.01F, {0, 0, 1}, {}, towards}).base.y;
    };
    const V3f from_x(0.8F, 0, 0.6F);
    const V3f from_minus_x(-0.8F, 0, 0.6F);
    const V3f from_y(0, 0.8F, 0.6F);
    const auto mean = static_cast<float>(cloth.colour.y);
    EXPECT_EQ(green(0, from_x), green(0, from_minus_x));
    EXPECT_NEAR(green(1, from_x) / mean, 1.24F, 1e-5F);
    EXPECT_NEAR(green(1, from_minus_x) / mean, 0.76F, 1e-5F);
    EXPECT_NEAR(green(-0.5, from_x) / mean, 0.88F, 1e-5F);
    EXPECT_NEAR(green(1, from_y) / mean, 1, 1e-5F);
}

}  // namespace
}  // namespace carom::render
