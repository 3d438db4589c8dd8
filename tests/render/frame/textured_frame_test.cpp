// Frames of surfaces whose parameters vary.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/render/scene_builder.h"
#include "tests/render/texture/temporary_picture.h"

namespace carom::render {
namespace {

using test::camera;
using test::SceneBuilder;
using test::small_settings;
using test::static_frame;
using test::TemporaryPicture;

constexpr OIIO::TypeDesc kBytes = OIIO::TypeDesc::UINT8;

ImageTexture picture_of(const TemporaryPicture& file) {
    ImageTexture image;
    image.file = file.path();
    return image;
}

/// Black to white from left to right.
void write_ramp(const TemporaryPicture& file) {
    std::vector<std::uint8_t> values;
    for (int x = 0; x < 256; ++x) {
        values.push_back(static_cast<std::uint8_t>(x));
    }
    file.write<std::uint8_t>(256, 1, 1, kBytes, values);
}

Film frame_of(const SceneBuilder& builder, const CameraState& state, int samples, int side = 24) {
    const RenderSettings settings = small_settings(side, side, samples);
    return render_frame(PreparedScene(builder.scene, settings), {}, static_frame(state), settings);
}

/// Of a ball in a room of radiance 1.
Vec3 seen_in_furnace(const StandardMaterial& material) {
    SceneBuilder builder;
    builder.material("skin", material).environment(1);
    builder.sphere("ball", 0.5, Vec3(0, 0, 0), "skin");
    return test::mean_colour(frame_of(builder, camera(Vec3(0, -3, 0), Vec3(0, 0, 0), 0.25), 64));
}

TEST(TexturedFurnace, RoughnessOfAWhiteMetal_LosesNoEnergy) {
    const TemporaryPicture file(".png");
    write_ramp(file);
    StandardMaterial metal;
    metal.base = Vec3(1, 1, 1);
    metal.metal = 1;
    metal.roughness = NumberTexture{picture_of(file), {0, 1}};
    EXPECT_NEAR(seen_in_furnace(metal).x, 1, 0.01);
}

TEST(TexturedFurnace, EveryNumberOfAWhiteSurface_LosesLittle) {
    const TemporaryPicture file(".png");
    write_ramp(file);
    const NumberTexture ramp{picture_of(file), {0, 1}};
    StandardMaterial white;
    white.base = Vec3(1, 1, 1);
    white.metal = ramp;
    white.specular = ramp;
    white.roughness = NumberTexture{picture_of(file), {1, 0.1}};
    white.coat.weight = ramp;
    white.coat.roughness = ramp;
    const double seen = seen_in_furnace(white).x;
    EXPECT_LE(seen, 1.003);
    EXPECT_GT(seen, 0.95);
}

/// A constant number by a picture of it is that number.
TEST(TexturedFrame, PicturesOfConstants_ShowWhatConstantsShow) {
    const TemporaryPicture file(".png");
    file.write<std::uint8_t>(1, 1, 3, kBytes, {51, 102, 153});
    const auto channel = [&](PictureChannel which) {
        NumberTexture number{picture_of(file), {0, 1}};
        std::get<ImageTexture>(number.pattern).channel = which;
        return number;
    };
    const auto seen = [](const StandardMaterial& material) {
        SceneBuilder builder;
        builder.material("skin", material).diffuse("floor", 0.5);
        builder.object("floor", PlaneShape{}, Vec3(0, 0, -0.5), "floor");
        builder.sphere("ball", 0.5, Vec3(0, 0, 0), "skin").environment(0.2);
        builder.lamp(Vec3(0, 0, 2), 0.5, 0.5, 5);
        return test::mean_colour(
            frame_of(builder, camera(Vec3(0, -3, 0.6), Vec3(0, 0, 0), 0.45), 256));
    };
    StandardMaterial constant;
    constant.base = Vec3(0.7, 0.5, 0.3);
    constant.metal = 0.2;
    constant.roughness = 0.4;
    constant.specular = 0.6;
    constant.coat = {0.4, 1.5, 0.2};
    constant.sheen = 0.2;
    StandardMaterial textured = constant;
    textured.metal = channel(PictureChannel::red);
    textured.roughness = channel(PictureChannel::green);
    textured.specular = channel(PictureChannel::blue);
    textured.coat.weight = channel(PictureChannel::green);
    textured.coat.roughness = channel(PictureChannel::red);
    textured.sheen = channel(PictureChannel::red);
    const Vec3 a = seen(constant);
    const Vec3 b = seen(textured);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(b[c], a[c], 0.004 * a[c]) << c;
    }
}

TEST(TexturedFrame, Channels_HaveTheNormalsAndRoughnessOfPictures) {
    const TemporaryPicture rough(".png", "_rough");
    rough.write<std::uint8_t>(1, 1, 1, kBytes, {153});
    const TemporaryPicture normals(".png", "_normals");
    normals.write<std::uint8_t>(1, 1, 3, kBytes, {204, 128, 230});  // about (0.6, 0, 0.8)
    StandardMaterial material;
    material.roughness = NumberTexture{picture_of(rough), {0, 1}};
    material.relief = NormalPicture{picture_of(normals), 1};
    StandardMaterial plain;
    plain.roughness = 0.25;
    SceneBuilder builder;
    builder.material("textured", material).material("plain", plain).environment(1);
    builder.object("left", RectangleShape{{1, 2}}, Vec3(-0.5, 0, 0), "textured");
    builder.object("right", RectangleShape{{1, 2}}, Vec3(0.5, 0, 0), "plain");
    RenderSettings settings = small_settings(16, 16, 4);
    settings.aovs = {"normal", "roughness"};
    const FrameInput frame = static_frame(camera(Vec3(0, 0, 2), Vec3(0, 0, 0), 0.6));
    const Film film = render_frame(PreparedScene(builder.scene, settings), {}, frame, settings);
    const std::size_t left = 8 * 16 + 4;
    const std::size_t right = 8 * 16 + 12;
    EXPECT_NEAR(test::plane(film, "roughness.X")[left], 0.6F, 1e-3F);
    EXPECT_NEAR(test::plane(film, "roughness.X")[right], 0.25F, 1e-3F);
    EXPECT_NEAR(test::plane(film, "N.X")[left], 0.6F, 0.01F);
    EXPECT_NEAR(test::plane(film, "N.Z")[left], 0.8F, 0.01F);
    EXPECT_EQ(test::plane(film, "N.X")[right], 0);
}

/// Between the camera and a bright room.
TEST(CutOut, RaysPassByTheFractionThatIsNotThere) {
    for (const double opacity : {0.0, 0.3, 1.0}) {
        StandardMaterial veil;
        veil.base = Vec3(0, 0, 0);
        veil.opacity = opacity;
        SceneBuilder builder;
        builder.material("veil", veil).environment(1);
        builder.object("veil", RectangleShape{{4, 4}}, Vec3(0, 0, 0), "veil");
        const Film film = frame_of(builder, camera(Vec3(0, 0, 2), Vec3(0, 0, 0), 0.4), 64);
        EXPECT_NEAR(test::mean_colour(film).x, 1 - opacity, 0.01) << opacity;
        EXPECT_NEAR(test::pixel(film, 12, 12, 3), opacity, opacity == 0.3 ? 0.25 : 0) << "alpha";
    }
}

/// A closed surface is met twice.
TEST(CutOut, BallOfHalfOpacity_LetsAQuarterThrough) {
    StandardMaterial veil;
    veil.base = Vec3(0, 0, 0);
    veil.opacity = 0.5;
    SceneBuilder builder;
    builder.material("veil", veil).environment(1).sphere("veil", 5, Vec3(0, 0, 0), "veil");
    const Film film = frame_of(builder, camera(Vec3(0, 0, 12), Vec3(0, 0, 0), 0.2), 64);
    EXPECT_NEAR(test::mean_colour(film).x, 0.25, 0.01);
}

/// The shadow of a stencil has its holes: a lamp above a floor, half of which the stencil covers.
TEST(CutOut, ShadowsHaveItsHoles) {
    const TemporaryPicture file(".png");
    file.write<std::uint8_t>(2, 1, 4, kBytes, {0, 0, 0, 255, 0, 0, 0, 0});
    const auto seen = [&](const NumberSource& opacity, const Vec2& size, double x) {
        StandardMaterial stencil;
        stencil.base = Vec3(0, 0, 0);
        stencil.opacity = opacity;
        SceneBuilder builder;
        builder.diffuse("floor", 0.5).object("floor", PlaneShape{}, Vec3(0, 0, 0), "floor");
        builder.material("stencil", stencil);
        builder.object("stencil", RectangleShape{size}, Vec3(x, 0, 0.5), "stencil");
        builder.lamp(Vec3(0, 0, 2), 0.3, 0.3, 5);
        // Below the stencil.
        return frame_of(builder, camera(Vec3(0, -2, 0.25), Vec3(0, 0, 0), 0.5), 32);
    };
    // As a whole, and as the half of it that is opaque, a rectangle of its own.
    const Film cut = seen(NumberTexture{picture_of(file), {0, 1}}, Vec2(2, 2), 0);
    const Film half = seen(1, Vec2(1, 2), -0.5);
    // The mask is blurred over a texel, half of the stencil.
    EXPECT_NEAR(test::mean_colour(cut).x, test::mean_colour(half).x,
                0.05 * test::mean_colour(half).x);
    const Film whole = seen(1, Vec2(2, 2), 0);
    EXPECT_LT(test::mean_colour(whole).x, 0.8 * test::mean_colour(half).x);
}

TEST(CutOut, MovingBall_IsCutOutWhereItIs) {
    StandardMaterial veil;
    veil.base = Vec3(0, 0, 0);
    veil.opacity = 0.25;
    SceneBuilder builder;
    builder.material("veil", veil).environment(1);
    builder.sphere("veil", 0.2, Vec3(0, 0, 0), "veil", "ball");
    const RenderSettings settings = small_settings(24, 24, 64);
    FrameInput frame = static_frame(camera(Vec3(0, 0, 3), Vec3(0, 0, 0), 0.4));
    frame.scene_close = 0.02;
    const std::vector<sim::Track> tracks{
        test::straight_track("ball", Vec3(-0.3, 0, 0), Vec3(0.3, 0, 0), 0, 0.02)};
    const Film film = render_frame(PreparedScene(builder.scene, settings), tracks, frame, settings);
    // The pixel in the middle is covered for two thirds of the time, and each surface of the ball
    // holds back a quarter.
    const double covered = 0.4 / 0.6;
    EXPECT_NEAR(test::pixel(film, 12, 12, 0), 1 - covered * (1 - 0.75 * 0.75), 0.12);
}

}  // namespace
}  // namespace carom::render
