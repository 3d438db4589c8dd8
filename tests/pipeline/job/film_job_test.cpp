#include "pipeline/job/film_job.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "core/error.h"
#include "pipeline/job/film_plan.h"
#include "pipeline/job/job_metadata.h"
#include "pipeline/store/frame_store.h"
#include "render/frame/frame.h"
#include "tests/pipeline/job/tiny_shot.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::read_text;
using carom::testing::ScratchFolder;
using ::testing::IsSupersetOf;
using ::testing::Pair;

sim::Bake make_bake() {
    sim::Bake bake;
    bake.timeline = carom::testing::tiny_timeline();
    return bake;
}

TEST(FilmJob, OneAndTwoThreads_WriteTheSameFilm) {
    const ScratchFolder folder;
    const Shot shot = carom::testing::tiny_shot();
    FilmJobOptions options;
    for (const int threads : {1, 2}) {
        options.threads = threads;
        options.output = folder.path(std::to_string(threads) + ".mkv");
        options.cache_folder = folder.path("cache" + std::to_string(threads));
        EXPECT_EQ(make_film(shot, make_bake(), options, {}, {}).rendered, 9);
    }
    EXPECT_EQ(read_text(folder.path("1.mkv")), read_text(folder.path("2.mkv")));
    const sim::Timeline timeline = carom::testing::tiny_timeline();
    const FilmSource source(shot, timeline);
    const Hash128 key = source.key(source.inputs(3));
    EXPECT_EQ(read_text(FrameStore(folder.path("cache1/frames")).path_of(key)),
              read_text(FrameStore(folder.path("cache2/frames")).path_of(key)));
    options.output = folder.path("3.mkv");
    EXPECT_EQ(make_film(shot, make_bake(), options, {}, {}).rendered, 0);
    EXPECT_EQ(read_text(folder.path("3.mkv")), read_text(folder.path("1.mkv")));
}

TEST(FilmJob, OneFrame_IsTheSameAsInTheFilm) {
    const ScratchFolder folder;
    const Shot shot = carom::testing::tiny_shot();
    FilmJobOptions options;
    options.cache_folder = folder.path();
    const sim::Bake bake = make_bake();
    const render::Film frame = make_frame(shot, bake, 4, options, {}, {});
    EXPECT_EQ(frame.width, 32);
    EXPECT_EQ(frame.height, 18);
    const FilmSource source(shot, bake.timeline);
    const auto stored = FrameStore(folder.path("frames")).read(source.key(source.inputs(4)));
    ASSERT_TRUE(stored);
    EXPECT_EQ(frame.rgba, stored->rgba);
    EXPECT_THROW((void)make_frame(shot, bake, 12, options, {}, {}), Error);
}

/// The second camera moves and fades in from frame 4 to 7, so that these mix two pictures.
Shot fading_shot() {
    Shot shot = carom::testing::tiny_shot();
    shot.cameras.push_back(shot.cameras[0]);
    shot.cameras[0].video_end = {8, 24};
    shot.cameras[0].time_map = {{8, 24}, 0};  // reversed: `motion` changes its sign
    shot.cameras[1].name = "second";
    shot.cameras[1].video_start = {4, 24};
    shot.cameras[1].fade = {4, 24};
    shot.cameras[1].position = BezierPath{{{{0.3, -0.8, 0.3}, "", 0}, {{0.2, -0.6, 0.3}, "", 0}}};
    shot.render.aovs = {"motion"};
    return shot;
}

TEST(FrameRenderer, Frames_AreThoseOfTheFilmBeforeTheStoreRoundsThem) {
    const ScratchFolder folder;
    const Shot shot = fading_shot();
    FilmJobOptions options;
    options.cache_folder = folder.path();
    const sim::Bake bake = make_bake();
    const FrameRenderer render = make_frame_renderer(shot, bake.timeline, 1);
    for (const std::int64_t number : {2, 5, 7, 10}) {
        SCOPED_TRACE(number);
        const render::Film stored = make_frame(shot, bake, number, options, {}, {});
        const render::Film frame = render(number, {});
        ASSERT_EQ(frame.rgba.size(), stored.rgba.size());
        for (std::size_t i = 0; i < frame.rgba.size(); ++i) {
            // Half precision keeps 11 bits (IEEE 754, binary16).
            EXPECT_NEAR(frame.rgba[i], stored.rgba[i], std::abs(frame.rgba[i]) / 2048 + 1e-7);
        }
        ASSERT_EQ(frame.aovs.size(), stored.aovs.size());
        EXPECT_EQ(frame.aovs.at(0).values, stored.aovs.at(0).values);
        EXPECT_EQ(frame.statistics.camera_rays, (number > 4 && number < 8 ? 2U : 1U) * 2 * 32 * 18);
    }
    EXPECT_THROW((void)render(12, {}), Error);
}

TEST(FrameRenderer, ProgressOfAFade_CoversBothPictures) {
    const Shot shot = fading_shot();
    const sim::Bake bake = make_bake();
    std::vector<double> fractions{0};
    const auto note = [&](double fraction) { fractions.push_back(fraction); };
    (void)make_frame_renderer(shot, bake.timeline, 1)(5, {note, {}});
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_EQ(fractions.back(), 1);
    EXPECT_THAT(fractions, ::testing::Contains(0.5));
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW((void)make_frame_renderer(shot, bake.timeline)(5, {{}, stop.get_token()}),
                 Stopped);
}

TEST(FilmJob, StopBeforeTheStart_RendersNothing) {
    const ScratchFolder folder;
    std::stop_source stop;
    stop.request_stop();
    FilmJobOptions options;
    options.output = folder.path("film.mkv");
    options.cache_folder = folder.path("cache");
    EXPECT_THROW(
        (void)make_film(carom::testing::tiny_shot(), make_bake(), options, {}, stop.get_token()),
        Stopped);
    EXPECT_EQ(read_text(options.output), "");
}

TEST(JobMetadata, ExportedFrame_NamesShotFrameTimesAndClamp) {
    Shot shot = carom::testing::tiny_shot();
    shot.render.clamp = 10;
    const std::string revision = std::to_string(render::kRendererRevision);
    EXPECT_THAT(
        exported_frame_metadata(shot, carom::testing::tiny_timeline(), 6),
        IsSupersetOf({Pair("shot", "tiny"), Pair("camera", "still"), Pair("frame", "6"),
                      Pair("video_time", "0.25"), Pair("scene_time", "0.25"), Pair("samples", "2"),
                      Pair("clamp", "10"), Pair("renderer_revision", revision.c_str())}));
    EXPECT_EQ(stored_frame_metadata(shot).count("frame"), 0u);
    EXPECT_EQ(video_metadata(shot).at("title"), "tiny");
    EXPECT_EQ(stored_frame_metadata(shot).count("rays_camera"), 0u);  // unknown
    render::RenderStatistics counts;
    counts.camera_rays = 7;
    counts.shadow_rays = 9;
    counts.reflection_rays = 3;
    EXPECT_EQ(stored_frame_metadata(shot, counts).at("rays_camera"), "7");
    EXPECT_EQ(stored_frame_metadata(shot, counts).count("rays_reflection"), 0u);  // path
    shot.render.integrator = render::IntegratorKind::distributed;
    EXPECT_EQ(stored_frame_metadata(shot, counts).at("rays_reflection"), "3");
    EXPECT_EQ(stored_frame_metadata(shot, counts).at("rays_shadow"), "9");
    shot.render.integrator = render::IntegratorKind::path;
    shot.render.clamp = 0;
    EXPECT_EQ(video_metadata(shot).at("clamp"), "off");
    render::Film stored;
    stored.notes["rays_camera"] = "11";
    EXPECT_EQ(
        exported_frame_metadata(shot, carom::testing::tiny_timeline(), 6, stored).at("rays_camera"),
        "11");
}

}  // namespace
}  // namespace carom::pipeline
