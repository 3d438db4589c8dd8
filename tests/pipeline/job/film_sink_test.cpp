// Tests of image sequences, posters, and conversions on export.
#include "pipeline/job/film_sink.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include <gmock/gmock.h>

#include "pipeline/job/film_job.h"
#include "pipeline/video/hdr_view.h"
#include "render/film/image_file.h"
#include "tests/pipeline/job/tiny_shot.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::fake_picture;
using carom::testing::make_film_with;
using carom::testing::ScratchFolder;
using carom::testing::tiny_timeline;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Not;

struct Export {
    ScratchFolder folder;
    Shot shot = carom::testing::tiny_shot();

    FilmJobResult film(const std::string& name, const std::string& frames = {}) {
        FilmJobOptions options;
        options.output = folder.path(name);
        options.cache_folder = folder.path("cache");
        if (!frames.empty()) {
            options.frames = parse_frame_range(frames);
        }
        const auto render = [this](const FrameInputs& inputs, const WorkContext&,
                                   render::FrameSums*) {
            render::Film film = fake_picture(shot, inputs);
            const std::size_t pixels = film.rgba.size() / 4;
            film.aovs = {{"motion.X", std::vector<float>(pixels, 3)},
                         {"motion.Y", std::vector<float>(pixels, 0)},
                         {"Z", std::vector<float>(pixels, 2)}};
            return film;
        };
        return make_film_with(render, shot, tiny_timeline(), options, {}, {});
    }
    [[nodiscard]] render::Film picture(const std::string& name) const {
        return render::read_exr(folder.path(name));
    }
};

TEST(ImageSequence, EveryFrame_IsWrittenToAFileWithItsNumber) {
    Export job;
    EXPECT_EQ(job.film("shot.####.exr", "2-10x4").frames, 3);
    std::vector<std::string> names = job.folder.names();
    std::sort(names.begin(), names.end());
    EXPECT_THAT(
        names, ElementsAre("cache", "shot.0002.exr", "shot.0006.exr", "shot.0010.exr", "shot.wav"));
    EXPECT_NE(job.picture("shot.0002.exr").rgba, job.picture("shot.0006.exr").rgba);
    // The file does not contain the current time, so the same frame always gives the same file.
    EXPECT_NE(carom::testing::read_text(job.folder.path("shot.0002.exr")).find("1970:01:01"),
              std::string::npos);
    EXPECT_EQ(job.film("view.#.png", "6").rendered, 0) << "the same pictures in another format";
    EXPECT_THAT(job.folder.names(), Contains("view.6.png"));
}

TEST(ImageSequence, FramesThatShowTheSame_AreAllWritten) {
    Export job;
    (void)job.film("shot.##.exr");
    EXPECT_EQ(job.folder.names().size(), 14U) << "the cache, the pictures and the sound";
    EXPECT_EQ(job.picture("shot.10.exr").rgba, job.picture("shot.11.exr").rgba);
}

TEST(ImageSequence, ReversedTime_NegatesTheMotion) {
    Export job;
    (void)job.film("on.##.exr", "4");
    std::swap(job.shot.cameras[0].time_map.scene_start, job.shot.cameras[0].time_map.scene_end);
    EXPECT_EQ(job.film("back.##.exr", "8").rendered, 0);  // it shows the same as frame 4
    const render::Film on = job.picture("on.04.exr"), back = job.picture("back.08.exr");
    EXPECT_EQ(on.rgba, back.rgba);
    const auto value = [](const render::Film& film, const std::string& name) {
        for (const render::Channel& channel : film.aovs) {
            if (channel.name == name) {
                return channel.values.front();
            }
        }
        return -1.0F;
    };
    EXPECT_EQ(value(on, "motion.X"), 3);
    EXPECT_EQ(value(back, "motion.X"), -3);
    EXPECT_EQ(value(back, "motion.Y"), 0);
    EXPECT_FALSE(std::signbit(value(back, "motion.Y")));
    EXPECT_EQ(value(back, "Z"), 2);
}

// The box `clli` of the container has two 16-bit numbers in big-endian order.
TEST(ImageSequence, LensOfTheView_IsInPicturesAndNotInFrames) {
    Export job;
    (void)job.film("clean.##.exr", "4");
    (void)job.film("clean.##.png", "4");
    for (CameraRig& rig : job.shot.cameras) {
        rig.lens.look = {1, 0.002};
    }
    EXPECT_EQ(job.film("lens.##.exr", "4").rendered, 0);
    EXPECT_EQ(job.picture("lens.04.exr").rgba, job.picture("clean.04.exr").rgba);
    EXPECT_EQ(job.film("lens.##.png", "4").rendered, 0);
    EXPECT_NE(carom::testing::read_text(job.folder.path("lens.04.png")),
              carom::testing::read_text(job.folder.path("clean.04.png")));
    job.shot.cameras[0].lens.shape.distortion = -0.02;
    EXPECT_EQ(job.film("bent.##.exr", "4").rendered, 1);
}

TEST(Hdr10, Film_ContainsTheLightLevelsOfItsBrightestFrames) {
    Export job;
    job.shot.output.codec = Codec::hevc;
    job.shot.output.hdr10 = Hdr10Settings{1000, 203};
    const std::string path = job.folder.path("film.mp4");
    FilmJobOptions options;
    options.output = path;
    options.cache_folder = job.folder.path("cache");
    std::atomic<int> rendered = 0;
    const auto render = [&](const FrameInputs& inputs, const WorkContext&, render::FrameSums*) {
        render::Film film = fake_picture(job.shot, inputs);
        std::fill(film.rgba.begin(), film.rgba.end(), 0.1F * static_cast<float>(++rendered));
        std::fill_n(film.rgba.begin(), 4, 1.0F);
        return film;
    };
    options.frames = parse_frame_range("2-10x4");
    ASSERT_EQ(make_film_with(render, job.shot, tiny_timeline(), options, {}, {}).rendered, 3);
    const std::string file = carom::testing::read_text(path);
    const std::size_t at = file.find("clli");
    ASSERT_NE(at, std::string::npos);
    const auto number = [&](std::size_t from) {
        return 256 * static_cast<unsigned char>(file[from]) +
               static_cast<unsigned char>(file[from + 1]);
    };
    const double pixels = job.shot.render.width * job.shot.render.height;
    EXPECT_EQ(number(at + 4), 203);
    EXPECT_NEAR(number(at + 6), 203 * (0.3 * (pixels - 1) + 1) / pixels, 0.6);
}

TEST(Poster, ContainerWithoutPosters_HasItInASeparateFile) {
    Export job;
    job.shot.output.poster = 0.25;
    (void)job.film("film.mkv");
    EXPECT_THAT(job.folder.names(), Contains("film-poster.jpg"));
    job.shot.output.codec = Codec::h264;
    (void)job.film("clip.mp4");
    EXPECT_THAT(job.folder.names(), Not(Contains("clip-poster.jpg")));
}

TEST(ReversedFilm, OfAMovingRig_RendersOnlyTheLastFrame) {
    Export job;
    CameraRig& rig = job.shot.cameras[0];
    rig.time_map = {0, {1, 4}};  // half speed: the ball moves throughout
    rig.position = BezierPath{
        {{{0.2, -0.8, 0.3}, "", 0}, {{0.1, -0.7, 0.4}, "", 0}, {{0.3, -0.9, 0.2}, "", 0}}, false};
    EXPECT_EQ(job.film("on.mkv").rendered, 12);
    std::swap(rig.time_map.scene_start, rig.time_map.scene_end);
    auto& points = std::get<BezierPath>(rig.position).points;
    std::reverse(points.begin(), points.end());
    EXPECT_EQ(job.film("back.mkv").rendered, 1);
}

}  // namespace
}  // namespace carom::pipeline
