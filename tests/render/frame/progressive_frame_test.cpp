// Frames in rounds: whatever the rounds and stops, the film is that of render_frame.
#include "render/frame/progressive_frame.h"

#include <cmath>
#include <stop_token>
#include <string>

#include <gtest/gtest.h>

#include "core/error.h"
#include "render/threads/thread_arena.h"
#include "tests/render/frame/table_scene.h"
#include "tests/render/frame/ways_to_sample.h"

namespace carom::render {
namespace {

using test::adaptive_settings;
using test::expect_same;
using test::table;
using test::table_frame;
using test::table_tracks;

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

INSTANTIATE_TEST_SUITE_P(All, Progressive, testing::ValuesIn(test::ways_to_sample()),
                         test::name_of_way);

}  // namespace
}  // namespace carom::render
