// Films whose pictures are denoised: what is stored, and that a frame has the same bytes wherever
// it is made.
#include <filesystem>

#include <gtest/gtest.h>

#include "pipeline/job/film_job.h"
#include "pipeline/job/film_plan.h"
#include "pipeline/store/frame_store.h"
#include "render/film/image_file.h"
#include "tests/pipeline/job/tiny_shot.h"
#include "tests/pipeline/video/scratch_folder.h"

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
    EXPECT_TRUE(film.aovs.empty());
    ASSERT_NE(key(1), noisy_key(1));
    const auto before = store().read(noisy_key(1));
    const auto after = store().read(key(1));
    ASSERT_TRUE(before && after);
    EXPECT_FALSE(before->aovs.empty());
    EXPECT_EQ(after->rgba, film.rgba);
    EXPECT_NE(before->rgba, film.rgba);
    const render::Film plain = make_frame(noisy, bake, 1, options(), {}, {});
    EXPECT_EQ(plain.rgba, before->rgba) << "the noisy picture is the frame's without denoising";
    EXPECT_EQ(plain.statistics.camera_rays, 0u);
}

TEST_F(DenoisedFilm, OtherStrength_RendersNothing) {
    const render::Film full = frame(1, options());
    const auto before = store().read(noisy_key(1));
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
    std::filesystem::resize_file(store().path_of(noisy_key(1)), 100);
    const render::Film again = frame(1, options());
    EXPECT_EQ(again.rgba, expected.rgba);
    EXPECT_GT(again.statistics.camera_rays, 0u);
}

}  // namespace
}  // namespace carom::pipeline
