// Tests of cross-fades, which mix two stored pictures into one frame of the film.
#include <algorithm>

#include <gmock/gmock.h>

#include "pipeline/job/film_job.h"
#include "pipeline/job/mixed_film.h"
#include "render/film/image_file.h"
#include "tests/pipeline/job/tiny_shot.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::make_film_with;
using carom::testing::make_frame_with;
using carom::testing::read_text;
using carom::testing::ScratchFolder;
using carom::testing::tiny_shot;
using carom::testing::tiny_timeline;
using ::testing::ElementsAre;

/// A camera at x = 1 films frames 0 to 7, and a camera at x = 3 films frames 4 to 11 and fades in
/// during four frames. The brightness of a picture and its depth are the x of its camera.
struct FadeJob {
    ScratchFolder folder;
    Shot shot = tiny_shot();
    std::vector<std::int64_t> reported;

    FadeJob() {
        CameraRig rig = shot.cameras[0];
        rig.video_end = {8, 24};
        rig.time_map = {{1, 2}, {1, 2}};
        rig.position = BezierPath{{{{1, -0.8, 0.3}, "", 0}}};
        shot.cameras = {rig, rig};
        shot.cameras[1].name = "second";
        shot.cameras[1].video_start = {4, 24};
        shot.cameras[1].video_end = {12, 24};
        shot.cameras[1].fade = {4, 24};
        shot.cameras[1].position = BezierPath{{{{3, -0.8, 0.3}, "", 0}}};
    }

    [[nodiscard]] FilmJobOptions options(const std::string& name) const {
        FilmJobOptions options;
        options.output = folder.path(name);
        options.cache_folder = folder.path("cache");
        return options;
    }
    [[nodiscard]] RenderFunction renderer() const {
        return [this](const FrameInputs& inputs, const WorkContext&, render::FrameSums*) {
            render::Film film;
            film.width = shot.render.width;
            film.height = shot.render.height;
            const auto x = static_cast<float>(inputs.frame.camera_open.position.x);
            const std::size_t pixels = static_cast<std::size_t>(film.width) * film.height;
            for (std::size_t i = 0; i < pixels; ++i) {
                film.rgba.insert(film.rgba.end(), {x, 2 * x, 0, 1});
            }
            film.aovs = {{"Z", std::vector<float>(pixels, x)}};
            return film;
        };
    }
    FilmJobResult film(const std::string& name) {
        JobObserver observer;
        observer.on_frame = [this](std::int64_t frame, bool, double, std::uint64_t) {
            reported.push_back(frame);
        };
        return make_film_with(renderer(), shot, tiny_timeline(), options(name), observer, {});
    }
};

TEST(FadeFilm, Frames_BlendFromOneCameraToTheOther) {
    FadeJob job;
    const FilmJobResult result = job.film("f.##.exr");
    EXPECT_EQ(result.frames, 12);
    EXPECT_EQ(result.rendered, 2);
    std::sort(job.reported.begin(), job.reported.end());
    EXPECT_THAT(job.reported, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11));  // each once
    const std::vector<float> light{1, 1, 1, 1, 1, 1.5, 2, 2.5, 3, 3, 3, 3};
    for (std::size_t i = 0; i < light.size(); ++i) {
        const std::string number = (i < 10 ? "0" : "") + std::to_string(i);
        const render::Film film = render::read_exr(job.folder.path("f." + number + ".exr"));
        EXPECT_EQ(film.rgba[0], light[i]) << i;
        EXPECT_EQ(film.rgba[1], 2 * light[i]) << i;
        EXPECT_EQ(film.rgba[3], 1) << i;
        EXPECT_EQ(film.aovs.at(0).values[0], light[i] < 2 ? 1 : 3) << i;  // larger weight
    }
}

/// The camera moves, so that all pictures differ.
TEST(FadeFilm, Pictures_AreCountedSeparatelyFromFrames) {
    FadeJob job;
    for (std::size_t i = 0; i < 2; ++i) {
        const double y = i == 0 ? -0.8 : -0.9;
        job.shot.cameras[i].position = BezierPath{{{{1, y, 0.3}, "", 0}, {{3, y, 0.3}, "", 0}}};
    }
    const FilmJobResult result = job.film("f.mkv");
    EXPECT_EQ(result.frames, 12);
    EXPECT_GT(result.pictures, 12);
    EXPECT_EQ(result.rendered, result.pictures);
    EXPECT_EQ(job.film("f.mkv").pictures, result.pictures);
}

TEST(FadeFilm, SingleFrame_IsTheSameAsInTheFilm) {
    FadeJob job;
    const render::Film film =
        make_frame_with(job.renderer(), job.shot, tiny_timeline(), 7, job.options(""), {}, {});
    EXPECT_EQ(film.rgba[0], 2.5F);
}

TEST(FadeFilm, Video_IsTheSameFromTheStore) {
    FadeJob job;
    EXPECT_EQ(job.film("a.mkv").rendered, 2);
    EXPECT_EQ(job.film("b.mkv").rendered, 0);
    EXPECT_EQ(read_text(job.folder.path("a.mkv")), read_text(job.folder.path("b.mkv")));
    FadeJob pieces;  // only frames inside the fade, then all
    FilmJobOptions options = pieces.options("c.mkv");
    options.frames = parse_frame_range("5-6");
    EXPECT_EQ(
        make_film_with(pieces.renderer(), pieces.shot, tiny_timeline(), options, {}, {}).rendered,
        2);
    EXPECT_EQ(pieces.film("d.mkv").rendered, 0);
    EXPECT_EQ(read_text(job.folder.path("a.mkv")), read_text(pieces.folder.path("d.mkv")));
}

}  // namespace
}  // namespace carom::pipeline
