#include "pipeline/job/overlay.h"

#include <algorithm>

#include <gmock/gmock.h>

#include "pipeline/job/film_job.h"
#include "pipeline/video/overlay_extent.h"
#include "render/film/image_file.h"
#include "tests/pipeline/job/tiny_shot.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::FakeRenderer;
using carom::testing::make_film_with;
using carom::testing::read_text;
using carom::testing::ScratchFolder;
using carom::testing::tiny_shot;
using carom::testing::tiny_timeline;
using ::testing::ElementsAre;

TEST(Overlay, Lines_GiveFrameSceneTimeAndSpeed) {
    OverlaySettings settings;
    settings.show = {OverlayItem::playback_speed, OverlayItem::frame, OverlayItem::scene_time};
    settings.corner = Corner::top_right;
    PlannedFrame frame;
    frame.number = 42;
    frame.scene_time = 1.2375;
    frame.speed = -0.125;
    const render::PictureText text = overlay_text(settings, frame);
    EXPECT_THAT(text.lines, ElementsAre("playback  -0.1250x", "frame     42", "scene   1.2375 s"));
    EXPECT_TRUE(text.at_top);
    EXPECT_TRUE(text.at_right);
    frame.speed = -0.0;
    EXPECT_EQ(overlay_text(settings, frame).lines[0], "playback   0.0000x");
}

struct Extent {
    int left = 1000, right = -1, top = 1000, bottom = -1;
    int white = 0;
};

/// The part of a grey picture of 200 x 100 pixels in which three letters are drawn.
Extent drawn_extent(bool at_top, bool at_right) {
    constexpr int width = 200;
    constexpr int height = 100;
    constexpr std::uint16_t grey = 20000;
    std::vector<std::uint16_t> rgb(std::size_t{width} * height * 3, grey);
    render::draw_text({{"HHH"}, at_top, at_right, 0.2}, rgb, width, height, 60000);
    Extent extent;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::uint16_t* pixel = &rgb[(std::size_t{width} * y + x) * 3];
            EXPECT_TRUE(pixel[0] == pixel[1] && pixel[1] == pixel[2]);
            extent.white += pixel[0] == 60000 ? 1 : 0;
            if (pixel[0] != grey) {
                extent.left = std::min(extent.left, x);
                extent.right = std::max(extent.right, x);
                extent.top = std::min(extent.top, y);
                extent.bottom = std::max(extent.bottom, y);
            }
        }
    }
    return extent;
}

TEST(PictureText, Corners_AreWhereTheNamesSay) {
    const Extent low = drawn_extent(false, false);
    EXPECT_GT(low.white, 30);
    EXPECT_GT(low.left, 5);
    EXPECT_LT(low.right, 60);
    EXPECT_GT(low.top, 60);
    EXPECT_LT(low.bottom, 95);
    const Extent high = drawn_extent(true, true);
    EXPECT_EQ(high.white, low.white);
    EXPECT_GT(high.left, 140);
    EXPECT_LT(high.right, 195);
    EXPECT_GT(high.top, 5);
    EXPECT_LT(high.bottom, 40);
}

TEST(OverlayExtent, Width_EndsWithTheLastLetter) {
    constexpr int kWidth = 1200;
    constexpr int kHeight = 600;
    for (const OverlayItem item :
         {OverlayItem::frame, OverlayItem::scene_time, OverlayItem::playback_speed}) {
        OverlaySettings settings;
        settings.show = {item};
        settings.size = 0.1;
        std::vector<std::uint8_t> rgb(std::size_t{kWidth} * kHeight * 3, 0);
        PlannedFrame frame;
        frame.number = 123456;
        frame.scene_time = frame.speed = 123.4567;
        render::draw_text(overlay_text(settings, frame), rgb, kWidth, kHeight);
        int right = 0;
        for (std::size_t i = 0; i < rgb.size(); i += 3) {
            right = std::max(right, rgb[i] > 128 ? static_cast<int>(i / 3 % kWidth) + 1 : 0);
        }
        const double end = overlay_extent(settings).width * kHeight;
        EXPECT_LE(right, end);
        EXPECT_GT(right, end - 0.3 * settings.size * kHeight) << "within half a letter";
    }
}

TEST(PictureText, TextThatDoesNotFit_IsCutOff) {
    std::vector<std::uint8_t> rgb(std::size_t{8} * 6 * 3, 10);
    render::draw_text({{"a very long line", "and another", "and one more"}, false, true, 0.5}, rgb,
                      8, 6);
    render::draw_text({{}, false, false, 0.5}, rgb, 8, 6);
    SUCCEED();
}

struct OverlayJob {
    ScratchFolder folder;
    Shot shot = tiny_shot();
    FakeRenderer renderer{shot};

    OverlayJob() {
        shot.render.width = 128;
        shot.render.height = 72;
    }
    FilmJobResult film(const std::string& name) {
        FilmJobOptions options;
        options.output = folder.path(name);
        options.cache_folder = folder.path("cache");
        return make_film_with(renderer.function(), shot, tiny_timeline(), options, {}, {});
    }
    [[nodiscard]] std::string bytes(const std::string& name) const {
        return read_text(folder.path(name));
    }
};

TEST(Overlay, InTheFilm_RendersNothingAgain) {
    OverlayJob job;
    EXPECT_GT(job.film("plain.mkv").rendered, 0);
    job.shot.output.overlay.show = {OverlayItem::frame};
    EXPECT_EQ(job.film("numbered.mkv").rendered, 0);
    EXPECT_NE(job.bytes("plain.mkv"), job.bytes("numbered.mkv"));
    job.shot.output.overlay.show.clear();
    job.film("again.mkv");
    EXPECT_EQ(job.bytes("plain.mkv"), job.bytes("again.mkv"));
}

Annotation path_of_ball() {
    Annotation path;
    path.kind = PathAnnotation{.of = "cue", .part = PathPart::whole};
    return path;
}

TEST(Annotations, InTheFilm_RenderNothingAgain) {
    OverlayJob job;
    EXPECT_GT(job.film("plain.mkv").rendered, 0);
    job.shot.annotations = {path_of_ball()};
    EXPECT_EQ(job.film("drawn.mkv").rendered, 0);
    EXPECT_NE(job.bytes("plain.mkv"), job.bytes("drawn.mkv"));
    EXPECT_EQ(job.film("again.mkv").rendered, 0);
    EXPECT_EQ(job.bytes("drawn.mkv"), job.bytes("again.mkv"));
    job.shot.annotations.clear();
    job.film("without.mkv");
    EXPECT_EQ(job.bytes("plain.mkv"), job.bytes("without.mkv"));
}

TEST(Annotations, InHdr10_AreInTheFilm) {
    OverlayJob job;
    job.shot.output.hdr10 = Hdr10Settings{};
    job.shot.output.codec = Codec::hevc;
    job.film("plain.mkv");
    job.shot.annotations = {path_of_ball()};
    EXPECT_EQ(job.film("drawn.mkv").rendered, 0);
    EXPECT_NE(job.bytes("plain.mkv"), job.bytes("drawn.mkv"));
}

TEST(Annotations, InImageSequences_AreOnlyInDisplayFormats) {
    OverlayJob job;
    job.film("a.##.bmp");
    job.film("a.##.exr");
    job.shot.annotations = {path_of_ball()};
    job.film("b.##.bmp");
    job.film("b.##.exr");
    EXPECT_NE(job.bytes("b.10.bmp"), job.bytes("a.10.bmp"));
    EXPECT_EQ(render::read_exr(job.folder.path("b.10.exr")).rgba,
              render::read_exr(job.folder.path("a.10.exr")).rgba);
}

TEST(Annotations, InThePoster_AreDrawn) {
    OverlayJob job;
    job.shot.output.poster = 0.25;
    job.film("plain.mkv");
    job.shot.annotations = {path_of_ball()};
    job.film("drawn.mkv");
    EXPECT_NE(job.bytes("plain-poster.jpg"), job.bytes("drawn-poster.jpg"));
}

TEST(Overlay, InImageSequences_IsOnlyInDisplayFormats) {
    OverlayJob job;
    job.film("a.##.png");
    job.film("a.##.exr");
    job.shot.output.overlay.show = {OverlayItem::frame};
    job.film("b.##.png");
    job.film("b.##.exr");
    // The files contain the current time, which always has the same number of digits.
    EXPECT_GT(job.bytes("b.10.png").size(), job.bytes("a.10.png").size() + 50);
    EXPECT_EQ(render::read_exr(job.folder.path("b.10.exr")).rgba,
              render::read_exr(job.folder.path("a.10.exr")).rgba);
}

}  // namespace
}  // namespace carom::pipeline
