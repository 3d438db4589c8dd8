// Films whose pictures are denoised: what is stored, and that a frame has the same bytes wherever
// it is made.
#include <chrono>
#include <filesystem>
#include <thread>

#include <gtest/gtest.h>

#include "core/error.h"
#include "pipeline/job/film_job.h"
#include "pipeline/job/film_plan.h"
#include "pipeline/job/film_status.h"
#include "pipeline/job/film_worker.h"
#include "pipeline/job/scene_renderer.h"
#include "pipeline/store/cache_maintenance.h"
#include "pipeline/store/frame_store.h"
#include "render/film/image_file.h"
#include "tests/pipeline/job/tiny_shot.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::read_text;
using carom::testing::ScratchFolder;
using carom::testing::tiny_shot;
using carom::testing::tiny_timeline;

struct DenoisedFilm : ::testing::Test {
    ScratchFolder folder;
    Shot shot = tiny_shot();
    sim::Bake bake{tiny_timeline(), {}, {}, {}};
    Shot noisy = tiny_shot();

    DenoisedFilm() {
        shot.render.samples = 8;
        shot.render.for_denoiser = true;
        shot.output.denoise.strength = 1;
        noisy = shot;
        noisy.output.denoise.strength = 0;
    }

    [[nodiscard]] FilmJobOptions options(const std::string& cache = "cache") const {
        FilmJobOptions result;
        result.cache_folder = folder.path(cache);
        result.threads = 1;
        return result;
    }
    [[nodiscard]] FrameStore store(const std::string& cache = "cache") const {
        return FrameStore(folder.path(cache) + "/frames");
    }
    [[nodiscard]] Hash128 key(std::int64_t frame) const {
        const FilmSource source(shot, bake.timeline);
        return source.key(source.inputs(frame));
    }
    [[nodiscard]] Hash128 noisy_key(std::int64_t frame) const {
        const FilmSource source(shot, bake.timeline);
        return source.noisy_key(source.inputs(frame));
    }
    [[nodiscard]] render::Film frame(std::int64_t number, const FilmJobOptions& with) const {
        return make_frame(shot, bake, number, with, {}, {});
    }
};

TEST_F(DenoisedFilm, Picture_IsStoredBeforeAndAfter) {
    const render::Film film = frame(1, options());
    EXPECT_GT(film.statistics.camera_rays, 0u);
    EXPECT_TRUE(film.half_aovs.empty());
    ASSERT_NE(key(1), noisy_key(1));
    const auto before = store().read_noisy(noisy_key(1));
    EXPECT_FALSE(store().contains(noisy_key(1)));
    const auto after = store().read(key(1));
    ASSERT_TRUE(before && after);
    EXPECT_FALSE(before->half_aovs.empty());
    EXPECT_EQ(after->rgba, film.rgba);
    EXPECT_NE(before->rgba, film.rgba);
    const render::Film plain = make_frame(noisy, bake, 1, options(), {}, {});
    EXPECT_EQ(plain.rgba, before->rgba) << "the noisy picture is the frame's without denoising";
}

TEST_F(DenoisedFilm, OtherStrength_RendersNothing) {
    const render::Film full = frame(1, options());
    const auto before = store().read_noisy(noisy_key(1));
    const Hash128 old = key(1);
    shot.output.denoise.strength = 0.5;
    EXPECT_NE(key(1), old);
    const render::Film half = frame(1, options());
    EXPECT_EQ(half.statistics.camera_rays, 0u);
    for (std::size_t i = 0; i < half.rgba.size(); ++i) {
        ASSERT_NEAR(half.rgba[i], 0.5f * (full.rgba[i] + before->rgba[i]), 1e-3f);
    }
}

TEST_F(DenoisedFilm, Frame_HasTheSameBytesWhereverItIsMade) {
    const render::Film expected = frame(2, options());
    EXPECT_EQ(frame(2, options()).rgba, expected.rgba) << "from the store";
    const std::string path = store().path_of(key(2));
    const std::string bytes = read_text(path);
    std::filesystem::remove(path);
    EXPECT_EQ(frame(2, options()).rgba, expected.rgba) << "from the noisy picture in the store";
    EXPECT_EQ(read_text(path), bytes);
    FilmJobOptions with = options("other");
    with.threads = 3;
    EXPECT_EQ(frame(2, with).rgba, expected.rgba) << "with three threads";
    EXPECT_EQ(read_text(store("other").path_of(key(2))), bytes);
    with.no_store = true;
    with.cache_folder = folder.path("none");
    EXPECT_EQ(frame(2, with).rgba, expected.rgba) << "without a store";
    const FrameRenderer renderer = make_frame_renderer(shot, bake.timeline, 2);
    EXPECT_EQ(renderer(2, {}).rgba, expected.rgba) << "in memory";
}

TEST_F(DenoisedFilm, FilmAndFrames_ShowTheSame) {
    FilmJobOptions with = options();
    with.output = folder.path("film.mkv");
    const FilmJobResult made = make_film(shot, bake, with, {}, {});
    EXPECT_EQ(made.rendered, made.pictures);
    const auto stored = store().read(key(3));
    ASSERT_TRUE(stored);
    EXPECT_EQ(frame(3, options()).rgba, stored->rgba);
    const std::string film = read_text(with.output);
    with.output = folder.path("again.mkv");
    EXPECT_EQ(make_film(shot, bake, with, {}, {}).rendered, 0);
    EXPECT_EQ(read_text(with.output), film);
    with.no_store = true;
    with.output = folder.path("unstored.mkv");
    with.cache_folder = folder.path("none");
    static_cast<void>(make_film(shot, bake, with, {}, {}));
    EXPECT_EQ(read_text(with.output), film);
}

TEST_F(DenoisedFilm, DamagedNoisyPicture_IsRenderedAgain) {
    const render::Film expected = frame(1, options());
    std::filesystem::remove(store().path_of(key(1)));
    std::filesystem::resize_file(store().file_of(noisy_key(1), kNoisyExtension), 100);
    const render::Film again = frame(1, options());
    EXPECT_EQ(again.rgba, expected.rgba);
    EXPECT_GT(again.statistics.camera_rays, 0u);
}

TEST_F(DenoisedFilm, WithoutItsNoisyFrames_IsMadeAgainFromTheDenoisedOnes) {
    FilmJobOptions with = options();
    with.output = folder.path("film.mkv");
    static_cast<void>(make_film(shot, bake, with, {}, {}));
    const std::string film = read_text(with.output);
    PruneOptions features;
    features.only_noisy = true;
    features.limit = 0;
    EXPECT_EQ(prune_cache(folder.path("cache"), features).removed, 9U);
    with.output = folder.path("again.mkv");
    EXPECT_EQ(make_film(shot, bake, with, {}, {}).rendered, 0);
    EXPECT_EQ(read_text(with.output), film);
    shot.output.denoise.strength = 0.5;
    EXPECT_GT(frame(1, options()).statistics.camera_rays, 0u) << "there is nothing to denoise";
}

TEST_F(DenoisedFilm, LimitOfTheCache_RemovesNoisyFramesFirst) {
    FilmJobOptions with = options();
    with.output = folder.path("film.mkv");
    with.cache_limit = 1;
    static_cast<void>(make_film(shot, bake, with, {}, {}));
    for (std::int64_t number = 0; number < 12; ++number) {
        EXPECT_TRUE(store().contains(key(number))) << number;
        EXPECT_EQ(store().noisy_size_bytes(noisy_key(number)), 0U) << number;
    }
}

TEST_F(DenoisedFilm, ChunksAndWorkers_MakeTheFilmOfASingleRun) {
    FilmJobOptions with = options();
    with.output = folder.path("film.mkv");
    static_cast<void>(make_film(shot, bake, with, {}, {}));
    const std::string film = read_text(with.output);
    FilmJobOptions chunk = options("chunks");
    for (const std::int64_t number : {1, 2}) {
        chunk.chunk = {number, 2};
        static_cast<void>(make_film(shot, bake, chunk, {}, {}));
    }
    FilmJobOptions mux = options("chunks");
    mux.output = folder.path("chunks.mkv");
    EXPECT_EQ(mux_film(shot, bake, mux, {}, {}).rendered, 0);
    EXPECT_EQ(read_text(mux.output), film);
    {
        std::vector<std::jthread> workers;
        for (std::size_t i = 0; i < 3; ++i) {
            workers.emplace_back([&, i] {
                const WorkerOptions worker{i, 3, std::chrono::seconds(60)};
                EXPECT_TRUE(
                    work_on_film(shot, bake, options("farm"), worker, {}, {}, {}).is_complete);
            });
        }
    }
    mux = options("farm");
    mux.output = folder.path("farm.mkv");
    static_cast<void>(mux_complete_film(shot, bake, mux, {}, {}));
    EXPECT_EQ(read_text(mux.output), film);
}

TEST_F(DenoisedFilm, StopBeforeDenoising_LosesNoSample) {
    const render::Film expected = frame(1, options());
    std::stop_source stop;
    FilmJobOptions with = options("other");
    with.renderer = [&, render = make_scene_renderer(shot, 1, nullptr)](const FrameInputs& inputs,
                                                                        const WorkContext& context,
                                                                        render::FrameSums* sums) {
        render::Film film = render(inputs, context, sums);
        stop.request_stop();
        return film;
    };
    EXPECT_THROW((void)make_frame(shot, bake, 1, with, {}, stop.get_token()), Stopped);
    EXPECT_GT(store("other").noisy_size_bytes(noisy_key(1)), 0U);
    EXPECT_FALSE(store("other").contains(key(1)));
    const render::Film again = frame(1, options("other"));
    EXPECT_EQ(again.statistics.camera_rays, 0u);
    EXPECT_EQ(again.rgba, expected.rgba);
}

}  // namespace
}  // namespace carom::pipeline
