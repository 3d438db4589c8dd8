#include <atomic>
#include <stop_token>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "render/frame/check_settings.h"
#include "render/threads/thread_arena.h"
#include "tests/render/frame/table_scene.h"

namespace carom::render {
namespace {

using test::camera;
using test::SceneBuilder;
using test::small_settings;
using test::static_frame;
using test::table;
using test::table_frame;
using test::table_tracks;

std::string message_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(RenderFrame, OneThreadAndTwo_GiveTheSameBits) {
    RenderSettings settings = small_settings(70, 41, 8);
    settings.filter = PixelFilter::blackman_harris;
    settings.filter_width = 1.5;
    settings.aovs = {"depth", "normal", "albedo", "motion", "object_id", "variance"};
    const PreparedScene scene(table().scene, settings);
    const auto render_with = [&](int threads) {
        ThreadArena arena(threads);
        Film film;
        arena.execute([&] { film = render_frame(scene, table_tracks(), table_frame(), settings); });
        return film;
    };
    const Film one = render_with(1);
    const Film two = render_with(2);
    EXPECT_EQ(one.rgba, two.rgba);
    ASSERT_EQ(one.aovs.size(), two.aovs.size());
    for (std::size_t i = 0; i < one.aovs.size(); ++i) {
        EXPECT_EQ(one.aovs[i].values, two.aovs[i].values) << one.aovs[i].name;
    }
    EXPECT_EQ(one.statistics.camera_rays, 70u * 41u * 8u);
    EXPECT_EQ(one.statistics.scattered_rays, two.statistics.scattered_rays);
    EXPECT_EQ(one.statistics.shadow_rays, two.statistics.shadow_rays);
    for (const float value : one.rgba) {
        ASSERT_TRUE(std::isfinite(value) && value >= 0);
    }
}

TEST(RenderFrame, OtherSeed_ChangesTheNoiseAndNotTheMean) {
    const RenderSettings settings = small_settings(40, 24, 16);
    const PreparedScene scene(table().scene, settings);
    FrameInput frame = table_frame();
    const Film a = render_frame(scene, table_tracks(), frame, settings);
    frame.seed = 2;
    const Film b = render_frame(scene, table_tracks(), frame, settings);
    EXPECT_NE(a.rgba, b.rgba);
    const Vec3 mean_a = test::mean_colour(a);
    const Vec3 mean_b = test::mean_colour(b);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(mean_a[c], mean_b[c], 0.02 * mean_a[c]) << c;
    }
}

TEST(RenderFrame, Progress_NeverFallsAndEndsAtOne) {
    const RenderSettings settings = small_settings(64, 48, 1);
    const PreparedScene scene(table().scene, settings);
    double last = 0;
    WorkContext context;
    context.progress = [&](double fraction) {
        EXPECT_GE(fraction, last);
        last = fraction;
    };
    (void)render_frame(scene, table_tracks(), table_frame(), settings, context);
    EXPECT_EQ(last, 1);
}

TEST(RenderFrame, StopRequested_ThrowsStopped) {
    RenderSettings settings = small_settings(64, 48, 65536);
    const PreparedScene scene(table().scene, settings);
    std::stop_source source;
    WorkContext context;
    context.stop = source.get_token();
    source.request_stop();
    EXPECT_THROW((void)render_frame(scene, table_tracks(), table_frame(), settings, context),
                 Stopped);
}

TEST(RenderFrame, StopRequestedWhileRendering_EndsSoon) {
    // It would take hours without a stop.
    RenderSettings settings = small_settings(640, 480, 65536);
    const PreparedScene scene(table().scene, settings);
    std::stop_source source;
    WorkContext context;
    context.stop = source.get_token();
    std::jthread stopper([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        source.request_stop();
    });
    EXPECT_THROW((void)render_frame(scene, table_tracks(), table_frame(), settings, context),
                 Stopped);
}

TEST(RenderFrame, EmptyScene_IsBlackAndTransparent) {
    const RenderSettings settings = small_settings(17, 3, 2);
    const Film film =
        render_frame(PreparedScene({}, settings), {}, static_frame(CameraState{}), settings);
    ASSERT_EQ(film.rgba.size(), 17u * 3u * 4u);
    for (const float value : film.rgba) {
        EXPECT_EQ(value, 0);
    }
}

TEST(RenderFrame, Clamp_BoundsIndirectLightAndNothingElse) {
    SceneBuilder builder;
    builder.diffuse("wall", 0.8).sphere("wall", 1, Vec3(0, 0, 0), "wall");
    builder.bulb(Vec3(0, 0, 0), 0.1, 100);
    RenderSettings settings = small_settings(8, 8, 8);
    const FrameInput frame = static_frame(camera(Vec3(0, -0.5, 0.3), Vec3(0, -0.9, 0.9), 0.6));
    const PreparedScene scene(builder.scene, settings);
    settings.max_bounces = 0;
    const double direct = test::range_of_means(render_frame(scene, {}, frame, settings)).first;
    settings.max_bounces = 4;
    settings.clamp = 0.01;
    const auto [least, most] = test::range_of_means(render_frame(scene, {}, frame, settings));
    EXPECT_GT(least, direct);
    EXPECT_LE(most, direct + 0.0101);
}

TEST(RenderFrame, UnknownMaterial_IsAnErrorThatNamesIt) {
    SceneBuilder builder;
    builder.sphere("ball", 1, Vec3(0, 0, 0), "velvet");
    EXPECT_THAT(message_of([&] { PreparedScene(builder.scene, RenderSettings{}); }),
                testing::HasSubstr("'velvet'"));
}

TEST(RenderFrame, MaterialGivenTwice_IsAnErrorThatNamesIt) {
    SceneBuilder builder;
    builder.diffuse("felt", 0.5).diffuse("felt", 0.6);
    EXPECT_EQ(message_of([&] { PreparedScene(builder.scene, RenderSettings{}); }),
              "the scene has two materials named 'felt'");
}

TEST(RenderFrame, MissingTrack_IsAnErrorThatNamesIt) {
    const RenderSettings settings = small_settings(16, 16, 1);
    const PreparedScene scene(table().scene, settings);
    EXPECT_THAT(message_of([&] { (void)render_frame(scene, {}, table_frame(), settings); }),
                testing::HasSubstr("'a'"));
}

TEST(RenderFrame, UnusableSettings_AreAllNamedInOneSentence) {
    RenderSettings settings = small_settings(0, 16, 0);
    settings.aovs = {"depht"};
    FrameInput frame = table_frame();
    frame.switch_ratio = 1.5;
    const PreparedScene scene(table().scene, settings);
    EXPECT_EQ(
        message_of([&] { (void)render_frame(scene, {}, frame, settings); }),
        "the frame cannot be rendered: width is 0; it must lie between 1 and 16384; samples "
        "is 0; it must lie between 1 and 65536; there is no AOV 'depht'; switch_ratio is 1.5; "
        "it must lie between 0 and 1");
}

}  // namespace
}  // namespace carom::render
