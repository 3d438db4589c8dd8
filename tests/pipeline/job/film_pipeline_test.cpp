#include <algorithm>
#include <atomic>
#include <filesystem>
#include <numeric>
#include <thread>

#include <gmock/gmock.h>

#include "core/error.h"
#include "pipeline/job/film_job.h"
#include "pipeline/job/film_plan.h"
#include "pipeline/job/frame_queue.h"
#include "pipeline/job/frame_scheduler.h"
#include "pipeline/store/frame_store.h"
#include "tests/pipeline/job/tiny_shot.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::fake_picture;
using carom::testing::FakeRenderer;
using carom::testing::make_film_with;
using carom::testing::make_frame_with;
using carom::testing::read_text;
using carom::testing::ScratchFolder;
using carom::testing::write_text;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

namespace fs = std::filesystem;

constexpr int kFrames = 12;
constexpr int kPictures = 9;  // eight of the rolling ball, one of the resting

/// The tiny shot, with a folder for a cache and videos.
struct JobFixture {
    ScratchFolder folder;
    Shot shot = carom::testing::tiny_shot();
    sim::Timeline timeline = carom::testing::tiny_timeline();
    FakeRenderer renderer{shot};
    JobObserver observer;
    std::stop_source stop;

    [[nodiscard]] FilmJobOptions options(const std::string& name = "film.mkv") const {
        FilmJobOptions options;
        options.output = folder.path(name);
        options.cache_folder = folder.path("cache");
        return options;
    }

    [[nodiscard]] FrameStore store() const { return FrameStore(folder.path("cache/frames")); }

    [[nodiscard]] Hash128 key(std::int64_t frame) const {
        const FilmSource source(shot, timeline);
        return source.key(source.inputs(frame));
    }

    FilmJobResult film(const RenderFunction& render, const FilmJobOptions& options) {
        return make_film_with(render, shot, timeline, options, observer, stop.get_token());
    }

    FilmJobResult film(const std::string& name = "film.mkv") {
        return film(renderer.function(), options(name));
    }

    [[nodiscard]] std::string video(const std::string& name = "film.mkv") const {
        return read_text(folder.path(name));
    }
};

TEST(FilmPipeline, SecondRun_RendersNothingAndWritesTheSameBytes) {
    JobFixture job;
    const FilmJobResult first = job.film();
    EXPECT_EQ(first.frames, kFrames);
    EXPECT_EQ(first.rendered, kPictures);
    EXPECT_EQ(first.counts.camera_rays, 100u * kPictures);
    const std::string video = job.video();
    EXPECT_FALSE(video.empty());
    const FilmJobResult second = job.film("again.mkv");
    EXPECT_EQ(second.frames, kFrames);
    EXPECT_EQ(second.rendered, 0);
    EXPECT_EQ(second.counts.camera_rays, 0u);
    EXPECT_EQ(job.video("again.mkv"), video);
    EXPECT_EQ(job.renderer.rendered().size(), std::size_t{kPictures});
}

TEST(FilmPipeline, Pictures_AreRenderedInOrderAndOnceEach) {
    JobFixture job;
    (void)job.film();
    std::vector<double> rendered = job.renderer.rendered();
    ASSERT_EQ(rendered.size(), std::size_t{kPictures});
    EXPECT_EQ(rendered.back(), 0);  // at rest: no time of its own
    rendered.pop_back();
    EXPECT_TRUE(std::is_sorted(rendered.begin(), rendered.end()));
}

TEST(FilmPipeline, RunInPieces_GivesTheSameFilm) {
    JobFixture whole, pieces;
    (void)whole.film();
    FilmJobOptions options = pieces.options("piece.mkv");
    options.frames = parse_frame_range("7-11");
    EXPECT_EQ(pieces.film(pieces.renderer.function(), options).rendered, 2);
    options.frames = parse_frame_range("0-11x3");
    EXPECT_EQ(pieces.film(pieces.renderer.function(), options).rendered, 3);
    EXPECT_EQ(pieces.film().rendered, 4);
    EXPECT_EQ(pieces.video(), whole.video());
}

// Renders colours that half precision cannot represent, and channels, so slowly that the encoder
// has to wait.
RenderFunction slow_and_fine(const Shot& shot) {
    return [&shot](const FrameInputs& inputs, const WorkContext&, render::FrameSums*) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        render::Film film = fake_picture(shot, inputs);
        film.rgba[0] = 70000;
        film.rgba[1] = 1.0001f;
        film.aovs = {{"object_id.X", std::vector<float>(film.rgba.size() / 4, 2)},
                     {"N.X", std::vector<float>(film.rgba.size() / 4, 0.3f)},
                     {"Z", std::vector<float>(film.rgba.size() / 4, 1.00001f)}};
        film.notes = {{"cryptomatte/3ae39a5/name", "CryptoObject"}};
        return film;
    };
}

TEST(FilmPipeline, Film_IsTheSameFromMemoryAndFromTheStore) {
    for (const std::string name : {"film.mkv", "film.####.exr"}) {
        JobFixture uninterrupted, resumed;
        const std::string file = name == "film.mkv" ? name : "film.0005.exr";
        EXPECT_EQ(uninterrupted.film(slow_and_fine(uninterrupted.shot), uninterrupted.options(name))
                      .rendered,
                  kPictures);
        FilmJobOptions half = resumed.options(name);
        half.output.clear();
        half.frames = parse_frame_range("0-4");
        EXPECT_EQ(resumed.film(slow_and_fine(resumed.shot), half).rendered, 5);
        EXPECT_EQ(resumed.film(slow_and_fine(resumed.shot), resumed.options(name)).rendered,
                  kPictures - 5);
        EXPECT_EQ(resumed.video(file), uninterrupted.video(file)) << file;
        fs::remove(resumed.folder.path(file));
        EXPECT_EQ(resumed.film(slow_and_fine(resumed.shot), resumed.options(name)).rendered, 0);
        EXPECT_EQ(resumed.video(file), uninterrupted.video(file)) << file;
    }
}

TEST(FilmPipeline, ReversedFilm_SharesItsPictures) {
    JobFixture job;
    (void)job.film();
    std::swap(job.shot.cameras[0].time_map.scene_start, job.shot.cameras[0].time_map.scene_end);
    EXPECT_EQ(job.film("back.mkv").rendered, 0);
    EXPECT_NE(job.video("back.mkv"), job.video());
}

TEST(FilmPipeline, Observer_IsNotifiedOfEveryFrameAndOfOneStageAfterTheOther) {
    JobFixture job;
    std::vector<std::int64_t> rendered, found;
    std::vector<std::pair<std::string, double>> progress;
    job.observer.on_frame = [&](std::int64_t frame, bool from_store, double seconds,
                                std::uint64_t rays) {
        (from_store ? found : rendered).push_back(frame);
        EXPECT_EQ(rays, from_store ? 0u : 100u);
        EXPECT_EQ(seconds > 0, !from_store);
        EXPECT_TRUE(progress.empty() || progress.back().first == "render");
    };
    job.observer.on_progress = [&](std::string_view stage, double fraction) {
        if (!progress.empty() && progress.back().first == stage) {
            EXPECT_GT(fraction, progress.back().second);
        } else {
            EXPECT_TRUE(progress.empty() || progress.back().second == 1);
        }
        progress.emplace_back(stage, fraction);
    };
    (void)job.film();
    EXPECT_THAT(rendered, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8));
    EXPECT_THAT(found, ElementsAre(9, 10, 11));
    ASSERT_FALSE(progress.empty());
    EXPECT_EQ(progress.front().first, "render");
    EXPECT_EQ(progress.back(), std::make_pair(std::string("encode"), 1.0));
}

TEST(FilmPipeline, DamagedAndMissingFrames_AreRenderedAgain) {
    JobFixture job;
    (void)job.film();
    const std::string video = job.video();
    const FrameStore store = job.store();
    write_text(store.path_of(job.key(2)), "not a frame");
    fs::resize_file(store.path_of(job.key(5)), 100);
    fs::remove(store.path_of(job.key(10)));
    const FilmJobResult result = job.film("again.mkv");
    EXPECT_EQ(result.rendered, 3);
    EXPECT_EQ(job.video("again.mkv"), video);
}

TEST(FilmPipeline, DamagedFrames_AreReportedTheFirstFewByName) {
    JobFixture job;
    (void)job.film();
    const FrameStore store = job.store();
    const auto path = [&](std::int64_t frame) { return store.path_of(job.key(frame)); };
    std::string bytes = read_text(path(1));
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    const std::string another = read_text(path(2));
    write_text(path(0), "not a frame");
    write_text(path(1), bytes);
    write_text(path(3), another);
    fs::resize_file(path(4), 100);
    fs::resize_file(path(5), 100);
    std::vector<std::string> warnings;
    job.observer.on_warning = [&](const std::string& text) { warnings.push_back(text); };
    const std::string begin = "the stored frame '";
    const std::string again = "' is damaged and is rendered again: ";
    const auto expected = ElementsAre(
        begin + path(0) + again + "it has 11 bytes, too few for a frame",
        begin + path(1) + again + "its contents have changed since it was written",
        begin + path(3) + again + "it is another frame, or its checksum is overwritten",
        "2 more stored frames were damaged; 'carom cache verify' checks every file of the cache");
    FilmJobOptions options = job.options("again.mkv");
    EXPECT_EQ(job.film("again.mkv").rendered, 5);
    EXPECT_THAT(warnings, expected);
    warnings.clear();
    EXPECT_EQ(job.film("whole.mkv").rendered, 0);
    EXPECT_THAT(warnings, IsEmpty());
    // The same holds if nothing is encoded.
    fs::resize_file(path(4), 100);
    options.output.clear();
    EXPECT_EQ(job.film(job.renderer.function(), options).rendered, 1);
    EXPECT_THAT(warnings,
                ElementsAre(begin + path(4) + again + "its checksum is missing or overwritten"));
}

TEST(FilmPipeline, CacheThatIsRemovedMidway_IsFilledAgain) {
    JobFixture plain, job;
    (void)plain.film();
    int calls = 0;
    const RenderFunction render = [&](const FrameInputs& inputs, const WorkContext&,
                                      render::FrameSums*) {
        ++calls;
        if (calls == 5) {
            fs::remove_all(job.folder.path("cache"));
        }
        return fake_picture(job.shot, inputs);
    };
    (void)job.film(render, job.options());
    EXPECT_EQ(job.video(), plain.video());
}

TEST(FilmPipeline, UnusableSamples_AreReportedForTheFirstFrameThatHasSome) {
    for (const bool no_store : {false, true}) {
        JobFixture job;
        const RenderFunction render = [&](const FrameInputs& inputs, const WorkContext&,
                                          render::FrameSums*) {
            render::Film film = fake_picture(job.shot, inputs);
            film.statistics.add_unusable(3, {12, 7});
            return film;
        };
        std::vector<std::string> warnings;
        job.observer.on_warning = [&](const std::string& text) { warnings.push_back(text); };
        FilmJobOptions options = job.options();
        options.no_store = no_store;
        (void)job.film(render, options);
        EXPECT_THAT(warnings,
                    ElementsAre("frame 0: 3 of its samples, the first at pixel (12, 7), were "
                                "negative or not finite, which is a fault of carom; they count as "
                                "black"));
    }
}

TEST(FilmPipeline, FrameClaimedElsewhere_IsDeferredAndThenRead) {
    JobFixture plain, job;
    (void)plain.film();
    const FrameStore store = job.store();
    const Hash128 claimed_key = job.key(1);
    std::optional<Claim> claim = store.claim(claimed_key);
    ASSERT_TRUE(claim);
    const FilmSource source(job.shot, job.timeline);
    int calls = 0;
    const RenderFunction render = [&](const FrameInputs& inputs, const WorkContext&,
                                      render::FrameSums*) {
        ++calls;
        if (calls == kPictures - 1) {  // all others are finished
            store.write(claimed_key, fake_picture(job.shot, source.inputs(1)), {});
            claim.reset();
        }
        return fake_picture(job.shot, inputs);
    };
    EXPECT_EQ(job.film(render, job.options()).rendered, kPictures - 1);
    EXPECT_EQ(job.video(), plain.video());
}

TEST(FilmPipeline, ClaimThatIsReleased_LeavesTheFrameToThisJob) {
    JobFixture job;
    const FrameStore store = job.store();
    std::optional<Claim> claim = store.claim(job.key(0));
    const RenderFunction usual = job.renderer.function();
    int calls = 0;
    const RenderFunction render = [&](const FrameInputs& inputs, const WorkContext& context,
                                      render::FrameSums*) {
        ++calls;
        if (calls == kPictures - 1) {  // all others are finished
            claim.reset();
        }
        return usual(inputs, context, nullptr);
    };
    EXPECT_EQ(job.film(render, job.options()).rendered, kPictures);
    EXPECT_EQ(job.renderer.rendered().back(), Rational(-1, 96).to_double());
}

TEST(FilmPipeline, TwoConcurrentJobs_RenderEachPictureOnce) {
    JobFixture job;
    const auto slow = [&](const FrameInputs& inputs, const WorkContext& context,
                          render::FrameSums*) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        return job.renderer.function()(inputs, context, nullptr);
    };
    FilmJobResult other;
    std::thread second([&] {
        other = make_film_with(slow, job.shot, job.timeline, job.options("b.mkv"), {}, {});
    });
    const FilmJobResult result = job.film(slow, job.options("a.mkv"));
    second.join();
    EXPECT_EQ(result.rendered + other.rendered, kPictures);
    EXPECT_EQ(job.video("a.mkv"), job.video("b.mkv"));
}

TEST(FilmPipeline, Stopped_LeavesNoVideoAndResumesLater) {
    JobFixture plain, job;
    (void)plain.film();
    int calls = 0;
    const RenderFunction render = [&](const FrameInputs& inputs, const WorkContext& context,
                                      render::FrameSums*) {
        ++calls;
        if (calls == 4) {
            context.progress(1e-9);  // the rest would take hours
            job.stop.request_stop();
            EXPECT_TRUE(context.stop.stop_requested());
            throw Stopped();
        }
        return fake_picture(job.shot, inputs);
    };
    EXPECT_THROW((void)job.film(render, job.options()), Stopped);
    EXPECT_THAT(job.folder.names(), ElementsAre("cache"));
    job.stop = {};
    EXPECT_EQ(job.film().rendered, kPictures - 3);
    EXPECT_EQ(job.video(), plain.video());
}

TEST(FilmPipeline, StoppedShortlyBeforeTheEndOfAFrame_StoresTheFrame) {
    JobFixture job;
    const RenderFunction render = [&](const FrameInputs& inputs, const WorkContext& context,
                                      render::FrameSums*) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        context.progress(0.5);  // 10 ms more
        job.stop.request_stop();
        EXPECT_FALSE(context.stop.stop_requested());
        return fake_picture(job.shot, inputs);
    };
    EXPECT_THROW((void)job.film(render, job.options()), Stopped);
    EXPECT_TRUE(job.store().contains(job.key(0)));
    job.stop = {};
    EXPECT_EQ(job.film().rendered, kPictures - 1);
}

TEST(FilmPipeline, FrameThatExceedsItsGracePeriod_IsStopped) {
    JobFixture job;
    const auto begin = std::chrono::steady_clock::now();
    const RenderFunction render = [&](const FrameInputs&, const WorkContext& context,
                                      render::FrameSums*) -> render::Film {
        context.progress(0.999);  // almost finished, but then it hangs
        job.stop.request_stop();
        while (!context.stop.stop_requested() &&
               std::chrono::steady_clock::now() - begin < std::chrono::seconds(60)) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        throw Stopped();
    };
    EXPECT_THROW((void)job.film(render, job.options()), Stopped);
    EXPECT_FALSE(job.store().contains(job.key(0)));
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));
}

TEST(FilmPipeline, BitsFlippedInAHundredPlaces_NeverGiveAWrongFilm) {
    JobFixture job;
    (void)job.film();
    const std::string film = job.video();
    const FrameStore store = job.store();
    std::uint64_t random = 20240607;
    int flips = 0;
    for (int round = 0; flips < 100; ++round) {
        for (std::int64_t frame = 0; frame < kPictures; ++frame, ++flips) {
            const std::string path = store.path_of(job.key(frame));
            std::string bytes = read_text(path);
            random = random * 6364136223846793005U + 1442695040888963407U;
            char& byte = bytes[(random >> 20U) % bytes.size()];
            byte = static_cast<char>(byte ^ (1 << (random >> 60U) % 8));
            write_text(path, bytes);
        }
        EXPECT_EQ(job.film().rendered, kPictures) << "round " << round;
        ASSERT_EQ(job.video(), film) << "round " << round;
    }
}

TEST(FilmPipeline, EncoderThatNeverReads_DoesNotDelayTheRendering) {
    JobFixture job;
    const FilmSource source(job.shot, job.timeline);
    std::vector<std::int64_t> frames(kFrames);
    std::iota(frames.begin(), frames.end(), 0);
    const FilmPlan plan = plan_film(source, frames, {});
    const FrameStore store = job.store();
    ThreadSafeObserver safe_observer(job.observer);
    FrameQueue queue(plan.pictures.size());
    CachedRenderer renderer(source, store, job.renderer.function(), false);
    FrameScheduler scheduler(plan, renderer, queue, safe_observer);
    std::thread rendering([&] { scheduler.run({}); });
    for (std::size_t i = 0; i < plan.pictures.size(); ++i) {
        EXPECT_TRUE(queue.wait_until_ready(i, {})) << "all are ready before any was read";
    }
    queue.mark_reader_done();
    rendering.join();
    EXPECT_EQ(scheduler.rendered(), kPictures);
}

TEST(FilmPipeline, RendererThatFails_IsReportedAndLeavesNoVideo) {
    JobFixture job;
    write_text(job.folder.path("film.mkv"), "the old film");
    const RenderFunction render = [](const FrameInputs&, const WorkContext&,
                                     render::FrameSums*) -> render::Film {
        throw Error("the lamp is broken");
    };
    try {
        (void)job.film(render, job.options());
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "the lamp is broken");
    }
    EXPECT_EQ(job.video(), "the old film");
    EXPECT_EQ(job.folder.names().size(), 2u);
}

TEST(FilmPipeline, EncoderThatFails_StopsTheRendering) {
    JobFixture job;
    std::atomic<int> calls{0};
    const RenderFunction render = [&](const FrameInputs&, const WorkContext& context,
                                      render::FrameSums*) -> render::Film {
        ++calls;
        while (!context.stop.stop_requested()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        throw Stopped();
    };
    try {
        (void)job.film(render, job.options("no/such/folder/film.mkv"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("no/such/folder"));
    }
    EXPECT_LE(calls, 1);
}

TEST(FilmPipeline, PictureThatCannotBeStored_IsAnErrorNotALoop) {
    JobFixture job;
    const FrameStore store = job.store();
    const std::string path = store.path_of(job.key(0));
    // A folder with the frame's path can be neither read nor replaced.
    fs::create_directories(path);
    EXPECT_THROW((void)job.film(), Error);
}

TEST(FilmPipeline, NoSelectedFrame_IsAnError) {
    JobFixture job;
    FilmJobOptions options = job.options();
    options.frames = parse_frame_range("12-99");
    try {
        (void)job.film(job.renderer.function(), options);
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "none of the film's 12 frames is selected");
    }
}

TEST(FramePipeline, OneFrame_IsStoredAndSharedWithTheFilm) {
    JobFixture job;
    const auto frame = [&] {
        return make_frame_with(job.renderer.function(), job.shot, job.timeline, 3, job.options(),
                               job.observer, {});
    };
    const render::Film first = frame();
    EXPECT_EQ(first.width, 32);
    EXPECT_EQ(frame().rgba, first.rgba);
    EXPECT_EQ(job.renderer.rendered().size(), 1u);
    EXPECT_EQ(job.film().rendered, kPictures - 1);
    write_text(job.store().path_of(job.key(3)), "damaged");
    std::string warning;
    job.observer.on_warning = [&](const std::string& text) { warning = text; };
    EXPECT_EQ(frame().rgba, first.rgba);
    EXPECT_EQ(warning,
              "the stored frame '" + job.store().path_of(job.key(3)) +
                  "' is damaged and is rendered again: it has 7 bytes, too few for a frame");
}

}  // namespace
}  // namespace carom::pipeline
