// Frames in rounds: whatever the rounds and stops, the film is that of render_frame.
#include "render/frame/progressive_frame.h"

#include <array>
#include <cmath>
#include <stop_token>
#include <string>

#include <gtest/gtest.h>

#include "core/error.h"
#include "render/threads/thread_arena.h"
#include "tests/render/frame/table_scene.h"

namespace carom::render {
namespace {

using test::small_settings;
using test::table;
using test::table_frame;
using test::table_tracks;

RenderSettings settings_with_channels() {
    RenderSettings settings = small_settings(50, 37, 8);
    settings.filter = PixelFilter::blackman_harris;
    settings.filter_width = 1.5;
    settings.aovs = {"depth", "cryptomatte_object", "normal", "variance", "object_id"};
    return settings;
}

RenderSettings adaptive_settings() {
    RenderSettings settings = settings_with_channels();
    settings.noise = 0.02;
    settings.max_samples = 40;
    return settings;
}

RenderSettings distributed_settings() {
    RenderSettings settings = small_settings(40, 30, 1);
    settings.integrator = IntegratorKind::distributed;
    settings.distributed.pixel_samples = 3;
    settings.distributed.blur_samples = 2;
    settings.distributed.shadow_samples = 2;
    return settings;
}

void expect_same(const Film& film, const Film& expected) {
    EXPECT_EQ(film.width, expected.width);
    EXPECT_EQ(film.height, expected.height);
    EXPECT_EQ(film.rgba, expected.rgba);
    ASSERT_EQ(film.aovs.size(), expected.aovs.size());
    for (std::size_t i = 0; i < film.aovs.size(); ++i) {
        EXPECT_EQ(film.aovs[i].name, expected.aovs[i].name);
        EXPECT_EQ(film.aovs[i].values, expected.aovs[i].values) << film.aovs[i].name;
    }
    EXPECT_EQ(film.notes, expected.notes);
    EXPECT_EQ(film.statistics.camera_rays, expected.statistics.camera_rays);
    EXPECT_EQ(film.statistics.scattered_rays, expected.statistics.scattered_rays);
    EXPECT_EQ(film.statistics.shadow_rays, expected.statistics.shadow_rays);
}

class Progressive : public testing::TestWithParam<RenderSettings> {
  protected:
    PreparedScene scene_{test::table().scene, GetParam()};
    Film expected_ = render_frame(scene_, table_tracks(), table_frame(), GetParam());
    ProgressiveFrame frame_{scene_, table_tracks(), table_frame(), GetParam()};
};

TEST_P(Progressive, Rounds_GiveTheFilmOfRenderFrame) {
    for (int samples = 1; !frame_.finished(); samples *= 2) {
        frame_.refine(samples);
        EXPECT_EQ(frame_.samples(), std::min(samples, frame_.most_samples()));
    }
    expect_same(frame_.film(), expected_);
    const std::uint64_t rays = frame_.statistics().camera_rays;
    frame_.refine(10000);
    EXPECT_EQ(frame_.statistics().camera_rays, rays) << "a finished frame takes no more samples";
}

TEST_P(Progressive, StoppedRounds_GoOnWhereTheyWere) {
    ThreadArena arena(2);
    int stops = 0;
    for (int samples = 1; !frame_.finished(); samples *= 2) {
        bool is_stopped = true;
        for (int attempt = 1; is_stopped; ++attempt) {
            // The other thread is in the middle of a tile when one has finished enough of them.
            std::stop_source stop;
            int tiles = 0;
            WorkContext context;
            context.stop = stop.get_token();
            context.progress = [&](double) {
                tiles += 1;
                if (tiles == attempt) {
                    stop.request_stop();
                }
            };
            is_stopped = false;
            try {
                arena.execute([&] { frame_.refine(samples, context); });
            } catch (const Stopped&) {
                is_stopped = true;
                stops += 1;
                EXPECT_EQ(frame_.picture().rgba.size(), expected_.rgba.size());
            }
        }
    }
    EXPECT_GT(stops, 4);
    expect_same(frame_.film(), expected_);
}

TEST_P(Progressive, StopBeforeTheFirstSample_AddsNothing) {
    std::stop_source stop;
    stop.request_stop();
    WorkContext context;
    context.stop = stop.get_token();
    EXPECT_THROW(frame_.refine(1, context), Stopped);
    EXPECT_THROW((void)frame_.picture(context), Stopped);
    EXPECT_EQ(frame_.samples(), 0);
    EXPECT_EQ(frame_.statistics().camera_rays, 0u);
    for (const float value : frame_.picture().rgba) {
        ASSERT_TRUE(std::isfinite(value));
    }
}

TEST_P(Progressive, Channel_IsTheSameWithoutBeingAskedForInTheSettings) {
    RenderSettings settings = GetParam();
    settings.aovs = {"normal"};
    const Film film = render_frame(scene_, table_tracks(), table_frame(), settings);
    settings.aovs.clear();
    ProgressiveFrame frame(scene_, table_tracks(), table_frame(), settings);
    frame.refine(10000);
    const std::vector<Channel> normal = frame.channels("normal");
    ASSERT_EQ(normal.size(), 3u);
    for (std::size_t i = 0; i < normal.size(); ++i) {
        EXPECT_EQ(normal[i].values, film.aovs[i].values);
    }
    EXPECT_THROW((void)frame.channels("normals"), Error);
}

TEST(ProgressiveFrame, Progress_NeverFallsAndEndsAtOneInEachRound) {
    const RenderSettings settings = adaptive_settings();
    const PreparedScene scene(table().scene, settings);
    ProgressiveFrame frame(scene, table_tracks(), table_frame(), settings);
    for (const int samples : {2, 12, 10000}) {
        double last = 0;
        WorkContext context;
        context.progress = [&](double fraction) {
            EXPECT_GE(fraction, last);
            last = fraction;
        };
        frame.refine(samples, context);
        EXPECT_EQ(last, 1);
    }
}

std::string name_of(const testing::TestParamInfo<RenderSettings>& tested) {
    return std::array{"Even", "Adaptive", "Distributed"}.at(tested.index);
}

INSTANTIATE_TEST_SUITE_P(All, Progressive,
                         testing::Values(settings_with_channels(), adaptive_settings(),
                                         distributed_settings()),
                         name_of);

}  // namespace
}  // namespace carom::render
