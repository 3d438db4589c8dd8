// Counts and states of the path-traced view; no times.
#include "pipeline/studio/picture_view.h"

#include <limits>
#include <map>
#include <mutex>
#include <set>
#include <span>

#include <gtest/gtest.h>

#include "pipeline/job/film_plan.h"
#include "pipeline/job/film_status.h"
#include "pipeline/job/frame_graphics.h"
#include "pipeline/video/view_transform.h"
#include "tests/pipeline/job/tiny_shot.h"
#include "tests/scratch_folder.h"

namespace carom::studio {
namespace {

constexpr PageId kPage = 7;

class View : public ::testing::Test {
  protected:
    static std::shared_ptr<pipeline::Shot> make_shot() {
        auto shot = std::make_shared<pipeline::Shot>(testing::tiny_shot());
        shot->render.samples = 8;
        shot->output.glow.strength = 0.1;
        return shot;
    }

    void show(std::shared_ptr<const pipeline::Shot> shot, std::int64_t v) {
        view_.set_shot(std::move(shot), timeline_, v);
    }
    static See frame(std::int64_t q, std::int64_t number) {
        See see;
        see.q = q;
        see.frame = number;
        return see;
    }
    std::vector<Picture> pictures() {
        view_.wait_until_idle();
        const std::lock_guard lock(mutex_);
        return pictures_;
    }

    testing::ScratchFolder cache_;
    std::shared_ptr<const sim::Timeline> timeline_ =
        std::make_shared<const sim::Timeline>(testing::tiny_timeline());
    std::mutex mutex_;
    std::vector<Picture> pictures_;
    std::vector<PageId> pages_;  // of the pictures
    PictureView view_{[this](PageId page, Picture picture) {
                          const std::lock_guard lock(mutex_);
                          pages_.push_back(page);
                          pictures_.push_back(std::move(picture));
                      },
                      {cache_.path(), 2, std::chrono::milliseconds(0)}};
};

TEST_F(View, LastPicture_IsTheFilmsFrameAndIsInTheCache) {
    const auto shot = make_shot();
    show(shot, 3);
    view_.ask(kPage, frame(1, 4));
    const std::vector<Picture> seen = pictures();
    ASSERT_FALSE(seen.empty());
    const Picture& last = seen.back();
    EXPECT_EQ(last.problem, "");
    EXPECT_TRUE(last.head.complete);
    EXPECT_TRUE(last.head.stored);
    EXPECT_EQ(last.head.q, 1);
    EXPECT_EQ(last.head.v, 3);
    EXPECT_EQ(last.head.samples, 8);
    EXPECT_EQ(view_.counts().frames_stored, 1u);

    sim::Bake bake;
    bake.timeline = *timeline_;
    pipeline::FilmJobOptions options;
    options.cache_folder = cache_.path();
    EXPECT_EQ(pipeline::film_status(*shot, bake, options, {}).stored.front(), 4);
    pipeline::FilmJobOptions elsewhere;
    const testing::ScratchFolder other;
    elsewhere.cache_folder = other.path();
    const render::Film film = pipeline::make_frame(*shot, bake, 4, elsewhere, {}, {});
    const std::vector<std::uint8_t> rgb = pipeline::DisplayView(shot->output).to_8(film, 0);
    ASSERT_EQ(last.rgba.size(), rgb.size() / 3 * 4);
    for (std::size_t i = 0; i < rgb.size(); ++i) {
        ASSERT_EQ(last.rgba[i / 3 * 4 + i % 3], rgb[i]) << i;
    }
}

TEST_F(View, Annotations_AreOnFramesAndThoseInTheSceneInOtherViews) {
    const auto shot = make_shot();
    shot->annotations.resize(2);
    shot->annotations[0].kind =
        pipeline::PathAnnotation{.of = "cue", .part = pipeline::PathPart::whole};
    shot->annotations[1].kind = pipeline::TextAnnotation{"{frame}"};
    show(shot, 1);
    view_.ask(kPage, frame(1, 4));
    const std::vector<std::uint8_t> drawn = pictures().back().rgba;

    const pipeline::FilmSource source(*shot, *timeline_);
    sim::Bake bake;
    bake.timeline = *timeline_;
    const testing::ScratchFolder other_cache;
    pipeline::FilmJobOptions options;
    options.cache_folder = other_cache.path();
    const render::Film film = pipeline::make_frame(*shot, bake, 4, options, {}, {});
    std::vector<std::uint8_t> rgb = pipeline::DisplayView(shot->output).to_8(film, 0);
    const std::vector<std::uint8_t> plain = rgb;
    pipeline::FrameGraphics graphics(*shot, *timeline_, 1);
    graphics.draw(source.layers(4), std::span(rgb), film.width, film.height);
    EXPECT_NE(rgb, plain);
    ASSERT_EQ(drawn.size(), rgb.size() / 3 * 4);
    for (std::size_t i = 0; i < rgb.size(); ++i) {
        ASSERT_EQ(drawn[i / 3 * 4 + i % 3], rgb[i]) << i;
    }

    See other;
    other.q = 2;
    other.view = FreeView{};
    other.view->scene_time = 0.2;
    other.view->position = {0.2, -0.8, 0.5};
    other.view->target = {0.2, 0, 0};
    /// The view with the first `count` annotations.
    const auto view_with = [&](std::size_t count) {
        const auto changed = std::make_shared<pipeline::Shot>(*shot);
        changed->annotations.resize(count);
        show(changed, ++other.q);
        view_.ask(kPage, other);
        return pictures().back().rgba;
    };
    const std::vector<std::uint8_t> path = view_with(1);
    EXPECT_EQ(view_with(2), path) << "the text is only on the film";
    EXPECT_NE(view_with(0), path);
}

TEST_F(View, AdaptiveFrame_SaysHowManySamplesAPixelHas) {
    auto shot = make_shot();
    shot->render.samples = 4;
    shot->render.noise = 0.001;
    shot->render.max_samples = 64;
    show(shot, 1);
    view_.ask(kPage, frame(1, 4));
    const Picture traced = pictures().back();
    ASSERT_TRUE(traced.head.stored);
    const double rays = static_cast<double>(view_.counts().camera_rays);
    const int pixels = traced.head.width * traced.head.height;
    EXPECT_GT(traced.head.samples, 4);
    EXPECT_LE(traced.head.samples, static_cast<int>(rays / pixels));
    view_.ask(kPage, frame(2, 5));
    view_.ask(kPage, frame(3, 4));  // read from the cache
    EXPECT_EQ(pictures().back().head.samples, traced.head.samples);
}

TEST_F(View, OtherView_TakesNoNewSample) {
    auto shot = make_shot();
    show(shot, 1);
    See see = frame(1, 2);
    see.width = 64;  // not the film's own size: nothing comes from the cache
    see.height = 36;
    view_.ask(kPage, see);
    const std::vector<std::uint8_t> before = pictures().back().rgba;
    const PictureCounts counts = view_.counts();
    EXPECT_EQ(counts.camera_rays, 64u * 36u * 8u);
    EXPECT_EQ(counts.frames_stored, 0u);
    auto brighter = std::make_shared<pipeline::Shot>(*shot);
    brighter->output.exposure += 1;
    show(brighter, 2);
    const std::vector<Picture> seen = pictures();
    EXPECT_EQ(seen.back().head.v, 2);
    EXPECT_TRUE(seen.back().head.complete);
    EXPECT_NE(seen.back().rgba, before);
    EXPECT_EQ(view_.counts().camera_rays, counts.camera_rays);
    EXPECT_EQ(view_.counts().scenes, 1u);
}

/// A shot whose frames are denoised.
std::shared_ptr<pipeline::Shot> denoised(std::shared_ptr<pipeline::Shot> shot, double strength) {
    shot->render.for_denoiser = true;
    shot->output.denoise.strength = strength;
    return shot;
}

/// As 8-bit colours with alpha.
std::vector<std::uint8_t> rgba_of_film(const pipeline::Shot& shot, const sim::Timeline& timeline,
                                       std::int64_t frame) {
    sim::Bake bake;
    bake.timeline = timeline;
    pipeline::FilmJobOptions options;
    const testing::ScratchFolder folder;
    options.cache_folder = folder.path();
    const std::vector<std::uint8_t> rgb =
        pipeline::DisplayView(shot.output)
            .to_8(pipeline::make_frame(shot, bake, frame, options, {}, {}), 0);
    std::vector<std::uint8_t> rgba(rgb.size() / 3 * 4, 255);
    for (std::size_t i = 0; i < rgb.size(); ++i) {
        rgba[i / 3 * 4 + i % 3] = rgb[i];
    }
    return rgba;
}

TEST_F(View, LastPictureOfADenoisedFilm_IsTheFilmsFrame) {
    const auto shot = denoised(make_shot(), 1);
    show(shot, 1);
    view_.ask(kPage, frame(1, 4));
    const std::vector<Picture> seen = pictures();
    EXPECT_TRUE(seen.back().head.stored);
    EXPECT_EQ(seen.back().rgba, rgba_of_film(*shot, *timeline_, 4));
    const PictureCounts counts = view_.counts();
    const auto weaker = denoised(make_shot(), 0.5);
    show(weaker, 2);
    EXPECT_EQ(pictures().back().rgba, rgba_of_film(*weaker, *timeline_, 4));
    EXPECT_NE(pictures().back().rgba, seen.back().rgba);
    EXPECT_EQ(view_.counts().camera_rays, counts.camera_rays) << "from the noisy frame";
    EXPECT_EQ(view_.counts().frames_stored, 2u);
}

TEST_F(View, LastPictureAtAnotherSize_IsDenoised) {
    See see = frame(1, 2);
    see.width = 64;
    see.height = 36;
    const auto shot = denoised(make_shot(), 1);
    show(shot, 1);
    view_.ask(kPage, see);
    const Picture last = pictures().back();
    EXPECT_TRUE(last.head.complete);
    EXPECT_FALSE(last.head.stored);
    EXPECT_EQ(last.head.samples, 8);
    EXPECT_EQ(view_.counts().frames_stored, 0u);
    auto same = std::make_shared<pipeline::Shot>(*shot);
    same->render.width = 64;
    same->render.height = 36;
    EXPECT_EQ(last.rgba, rgba_of_film(*same, *timeline_, 2));
    const PictureCounts counts = view_.counts();
    see.q = 2;
    view_.ask(kPage, see);
    EXPECT_EQ(pictures().back().rgba, last.rgba);
    EXPECT_EQ(view_.counts().camera_rays, counts.camera_rays);
}

TEST_F(View, NewestQuestion_IsTheOneThatIsAnsweredLast) {
    show(make_shot(), 1);
    for (std::int64_t q = 1; q <= 20; ++q) {
        view_.ask(kPage, frame(q, q % 12));
    }
    const std::vector<Picture> seen = pictures();
    ASSERT_FALSE(seen.empty());
    EXPECT_EQ(seen.back().head.q, 20);
    EXPECT_TRUE(seen.back().head.complete);
    for (std::size_t i = 1; i < seen.size(); ++i) {
        EXPECT_GE(seen[i].head.q, seen[i - 1].head.q);
    }
}

TEST_F(View, CancelledOrHeld_LeavesNoPictureAfterwards) {
    auto shot = make_shot();
    shot->render.samples = 65536;
    show(shot, 1);
    view_.ask(kPage, frame(1, 3));
    view_.hold(Hold::dragging, true);
    const std::size_t held = pictures().size();
    EXPECT_EQ(pictures().size(), held);
    view_.hold(Hold::dragging, false);
    view_.cancel(kPage);
    const std::size_t count = pictures().size();
    EXPECT_EQ(pictures().size(), count);
}

TEST_F(View, HeldForTwoReasons_WaitsForTheEndOfBoth) {
    view_.hold(Hold::dragging, true);
    view_.hold(Hold::texts, true);
    show(make_shot(), 1);
    view_.ask(kPage, frame(1, 3));
    view_.hold(Hold::texts, false);
    EXPECT_TRUE(pictures().empty());
    view_.hold(Hold::dragging, false);
    EXPECT_FALSE(pictures().empty());
}

TEST_F(View, TwoPages_GetTheirOwnPictures) {
    auto shot = make_shot();
    shot->render.samples = 256;
    show(shot, 1);
    view_.ask(kPage, frame(5, 2));
    view_.ask(kPage + 1, frame(6, 3));  // stops the work for the first page, which goes on later
    const std::vector<Picture> seen = pictures();
    std::map<PageId, std::set<std::int64_t>> questions;
    std::set<PageId> complete;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        questions[pages_[i]].insert(seen[i].head.q);
        if (seen[i].head.complete) {
            complete.insert(pages_[i]);
        }
    }
    EXPECT_EQ(questions[kPage + 1], std::set<std::int64_t>{6});
    EXPECT_EQ(questions[kPage], std::set<std::int64_t>{5});
    EXPECT_EQ(complete, (std::set<PageId>{kPage, kPage + 1}));
}

TEST_F(View, PageThatCancels_LeavesTheOtherPagesItsPicture) {
    view_.hold(Hold::texts, true);
    show(make_shot(), 1);
    view_.ask(kPage, frame(1, 2));
    view_.ask(kPage + 1, frame(1, 3));
    view_.cancel(kPage + 1);
    view_.hold(Hold::texts, false);
    EXPECT_TRUE(pictures().back().head.complete);
    EXPECT_EQ(std::set<PageId>(pages_.begin(), pages_.end()), std::set<PageId>{kPage});
}

TEST_F(View, WithoutAShot_NothingIsShown) {
    show(make_shot(), 1);
    view_.set_shot(nullptr, nullptr, 0);  // the next one cannot be simulated
    view_.ask(kPage, frame(1, 2));
    EXPECT_TRUE(pictures().empty());
}

TEST_F(View, Channels_HaveLegendsAndAreNotStored) {
    show(make_shot(), 1);
    std::int64_t q = 0;
    for (const std::string name :
         {"depth", "normal", "albedo", "roughness", "object_id", "material_id", "noise"}) {
        See see = frame(++q, 4);
        see.channel = name;
        view_.ask(kPage, see);
        const Picture last = pictures().back();
        EXPECT_EQ(last.problem, "");
        EXPECT_EQ(last.head.channel, name);
        EXPECT_TRUE(last.head.complete) << name;
        EXPECT_FALSE(last.head.stored) << name;
        EXPECT_NE(last.head.legend, "") << name;
        EXPECT_EQ(last.head.samples, name == "depth" ? 1 : 8) << name << ", of what there is";
    }
    EXPECT_EQ(view_.counts().frames_stored, 0u);
    EXPECT_EQ(view_.counts().camera_rays, 32u * 18u * 8u) << "all share the same samples";
}

TEST_F(View, ChannelAfterTheStoredFrame_IsTracedAgain) {
    show(make_shot(), 1);
    view_.ask(kPage, frame(1, 4));
    ASSERT_TRUE(pictures().back().head.stored);
    See see = frame(2, 4);
    see.channel = "object_id";
    view_.ask(kPage, see);
    EXPECT_EQ(pictures().back().problem, "");
    EXPECT_EQ(pictures().back().head.q, 2);
}

TEST_F(View, UnknownChannel_IsAProblem) {
    show(make_shot(), 1);
    See see = frame(1, 4);
    see.channel = "smell";
    view_.ask(kPage, see);
    EXPECT_EQ(pictures().back().problem, "the view cannot show the channel 'smell'");
}

TEST_F(View, FreeViewOfManyPixels_IsMadeSmaller) {
    auto shot = make_shot();
    shot->render.samples = 1;
    show(shot, 1);
    See see;
    see.q = 1;
    see.view = FreeView{.scene_time = 0.1, .position = {0, -3, 2}, .target = {0, 0, 0}};
    see.width = 16384;
    see.height = 16384;
    view_.ask(kPage, see);
    const Picture last = pictures().back();
    EXPECT_EQ(last.problem, "");
    EXPECT_TRUE(last.head.complete);
    EXPECT_EQ(last.head.width, 2036);
    EXPECT_EQ(last.head.height, 2036);
    EXPECT_FALSE(last.head.stored);
    see.width = std::numeric_limits<int>::max();
    see.height = 1;
    see.q = 2;
    view_.ask(kPage, see);
    EXPECT_EQ(pictures().back().head.width, 16384);
    EXPECT_EQ(pictures().back().head.height, 1);
}

TEST_F(View, FrameBeyondTheFilm_IsAProblem) {
    show(make_shot(), 1);
    view_.ask(kPage, frame(1, 999));
    const std::vector<Picture> seen = pictures();
    ASSERT_EQ(seen.size(), 1u);
    EXPECT_EQ(seen[0].problem, "the film has no frame 999");
}

TEST_F(View, BesideAFilm_PicturesEndAtSixteenSamples) {
    auto shot = make_shot();
    shot->render.samples = 64;
    view_.set_film_running(true);
    show(shot, 1);
    view_.ask(kPage, frame(1, 3));
    EXPECT_EQ(pictures().back().head.samples, 16);
    EXPECT_TRUE(pictures().back().head.complete);
    view_.set_film_running(false);
    EXPECT_EQ(pictures().back().head.samples, 64);
    EXPECT_EQ(view_.counts().camera_rays, 32u * 18u * 64u) << "the first sixteen are kept";
}

}  // namespace
}  // namespace carom::studio
