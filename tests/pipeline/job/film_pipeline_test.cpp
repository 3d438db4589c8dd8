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
#include "tests/pipeline/video/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::fake_picture;
using carom::testing::FakeRenderer;
using carom::testing::film_by;
using carom::testing::frame_by;
using carom::testing::read_text;
using carom::testing::ScratchFolder;
using carom::testing::write_text;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

namespace fs = std::filesystem;

constexpr int kFrames = 12;
constexpr int kPictures = 9;  // eight of the rolling ball, one of the resting

/// A folder with a cache and videos, and the tiny shot.
struct Studio {
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
        return film_by(render, shot, timeline, options, observer, stop.get_token());
    }

    FilmJobResult film(const std::string& name = "film.mkv") {
        return film(renderer.function(), options(name));
    }

    [[nodiscard]] std::string video(const std::string& name = "film.mkv") const {
        return read_text(folder.path(name));
    }
};

TEST(FilmPipeline, SecondRun_RendersNothingAndWritesTheSameBytes) {
    Studio studio;
    const FilmJobResult first = studio.film();
    EXPECT_EQ(first.frames, kFrames);
    EXPECT_EQ(first.rendered, kPictures);
    EXPECT_EQ(first.counts.camera_rays, 100u * kPictures);
    const std::string video = studio.video();
    EXPECT_FALSE(video.empty());
    const FilmJobResult second = studio.film("again.mkv");
    EXPECT_EQ(second.frames, kFrames);
    EXPECT_EQ(second.rendered, 0);
    EXPECT_EQ(second.counts.camera_rays, 0u);
    EXPECT_EQ(studio.video("again.mkv"), video);
    EXPECT_EQ(studio.renderer.rendered().size(), std::size_t{kPictures});
}

TEST(FilmPipeline, Pictures_AreRenderedInOrderAndOnceEach) {
    Studio studio;
    (void)studio.film();
    std::vector<double> rendered = studio.renderer.rendered();
    ASSERT_EQ(rendered.size(), std::size_t{kPictures});
    EXPECT_EQ(rendered.back(), 0);  // at rest: no time of its own
    rendered.pop_back();
    EXPECT_TRUE(std::is_sorted(rendered.begin(), rendered.end()));
}

TEST(FilmPipeline, RunInPieces_GivesTheSameFilm) {
    Studio whole, pieces;
    (void)whole.film();
    FilmJobOptions options = pieces.options("piece.mkv");
    options.frames = parse_frame_range("7-11");
    EXPECT_EQ(pieces.film(pieces.renderer.function(), options).rendered, 2);
    options.frames = parse_frame_range("0-11x3");
    EXPECT_EQ(pieces.film(pieces.renderer.function(), options).rendered, 3);
    EXPECT_EQ(pieces.film().rendered, 4);
    EXPECT_EQ(pieces.video(), whole.video());
}

// Colours that a half cannot hold, channels, and pictures so slow that the encoder waits for them.
RenderFunction slow_and_fine(const Shot& shot) {
    return [&shot](const FrameInputs& inputs, const WorkContext&) {
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
        Studio at_once, resumed;
        const std::string file = name == "film.mkv" ? name : "film.0005.exr";
        EXPECT_EQ(at_once.film(slow_and_fine(at_once.shot), at_once.options(name)).rendered,
                  kPictures);
        FilmJobOptions half = resumed.options(name);
        half.output.clear();
        half.frames = parse_frame_range("0-4");
        EXPECT_EQ(resumed.film(slow_and_fine(resumed.shot), half).rendered, 5);
        EXPECT_EQ(resumed.film(slow_and_fine(resumed.shot), resumed.options(name)).rendered,
                  kPictures - 5);
        EXPECT_EQ(resumed.video(file), at_once.video(file)) << file;
        fs::remove(resumed.folder.path(file));
        EXPECT_EQ(resumed.film(slow_and_fine(resumed.shot), resumed.options(name)).rendered, 0);
        EXPECT_EQ(resumed.video(file), at_once.video(file)) << file;
    }
}

TEST(FrameQueue, PictureThatIsAwaited_IsHandedOver) {
    constexpr int kAttempts = 200;  // the reader has to wait already, which it may be slow to do
    FrameQueue queue(kAttempts);
    int handed_over = 0;
    for (std::size_t i = 0; i < kAttempts && handed_over == 0; ++i) {
        std::optional<render::Film> film;
        std::thread reader([&] { film = queue.receive(i, {}); });
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        queue.mark_ready(i, render::Film{7, 5, {}, {}, {}, {}});
        reader.join();
        handed_over += film && film->width == 7 ? 1 : 0;
    }
    EXPECT_EQ(handed_over, 1);
}

TEST(FrameQueue, PictureThatNobodyAwaits_IsNotKept) {
    FrameQueue queue(2);
    queue.mark_ready(0, render::Film{7, 5, {}, {}, {}, {}});
    EXPECT_FALSE(queue.receive(0, {}));
    queue.request_again(0);
    EXPECT_TRUE(queue.take_request());
    queue.mark_ready(0);
    EXPECT_FALSE(queue.receive(0, {}));
}

TEST(FrameQueue, Stopped_HandsNothingOver) {
    FrameQueue queue(1);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW((void)queue.receive(0, stop.get_token()), Stopped);
}

TEST(FilmPipeline, ReversedFilm_SharesItsPictures) {
    Studio studio;
    (void)studio.film();
    std::swap(studio.shot.cameras[0].time_map.scene_start,
              studio.shot.cameras[0].time_map.scene_end);
    EXPECT_EQ(studio.film("back.mkv").rendered, 0);
    EXPECT_NE(studio.video("back.mkv"), studio.video());
}

TEST(FilmPipeline, Observer_HearsOfEveryFrameAndOfOneStageAfterTheOther) {
    Studio studio;
    std::vector<std::int64_t> rendered, found;
    std::vector<std::pair<std::string, double>> progress;
    studio.observer.on_frame = [&](std::int64_t frame, bool from_store, double seconds,
                                   std::uint64_t rays) {
        (from_store ? found : rendered).push_back(frame);
        EXPECT_EQ(rays, from_store ? 0u : 100u);
        EXPECT_EQ(seconds > 0, !from_store);
        EXPECT_TRUE(progress.empty() || progress.back().first == "render");
    };
    studio.observer.on_progress = [&](std::string_view stage, double fraction) {
        if (!progress.empty() && progress.back().first == stage) {
            EXPECT_GT(fraction, progress.back().second);
        } else {
            EXPECT_TRUE(progress.empty() || progress.back().second == 1);
        }
        progress.emplace_back(stage, fraction);
    };
    (void)studio.film();
    EXPECT_THAT(rendered, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8));
    EXPECT_THAT(found, ElementsAre(9, 10, 11));
    ASSERT_FALSE(progress.empty());
    EXPECT_EQ(progress.front().first, "render");
    EXPECT_EQ(progress.back(), std::make_pair(std::string("encode"), 1.0));
}

TEST(FilmPipeline, DamagedAndVanishedFrames_AreMadeAgain) {
    Studio studio;
    (void)studio.film();
    const std::string video = studio.video();
    const FrameStore store = studio.store();
    write_text(store.path_of(studio.key(2)), "not a frame");
    fs::resize_file(store.path_of(studio.key(5)), 100);
    fs::remove(store.path_of(studio.key(10)));
    const FilmJobResult result = studio.film("again.mkv");
    EXPECT_EQ(result.rendered, 3);
    EXPECT_EQ(studio.video("again.mkv"), video);
}

TEST(FilmPipeline, DamagedFrames_AreToldOfTheFirstFewByName) {
    Studio studio;
    (void)studio.film();
    const FrameStore store = studio.store();
    const auto path = [&](std::int64_t frame) { return store.path_of(studio.key(frame)); };
    std::string bytes = read_text(path(1));
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    const std::string another = read_text(path(2));
    write_text(path(0), "not a frame");
    write_text(path(1), bytes);
    write_text(path(3), another);
    fs::resize_file(path(4), 100);
    fs::resize_file(path(5), 100);
    std::vector<std::string> warnings;
    studio.observer.on_warning = [&](const std::string& text) { warnings.push_back(text); };
    const std::string begin = "the stored frame '";
    const std::string again = "' is damaged and is rendered again: ";
    const auto expected = ElementsAre(
        begin + path(0) + again + "it has 11 bytes, too few for a frame",
        begin + path(1) + again + "its contents have changed since it was written",
        begin + path(3) + again + "it is another frame, or its end is overwritten",
        "2 more stored frames were damaged; 'carom cache verify' reads everything that is stored");
    FilmJobOptions options = studio.options("again.mkv");
    EXPECT_EQ(studio.film("again.mkv").rendered, 5);
    EXPECT_THAT(warnings, expected);
    warnings.clear();
    EXPECT_EQ(studio.film("whole.mkv").rendered, 0);
    EXPECT_THAT(warnings, IsEmpty());
    // The same when nothing is encoded.
    fs::resize_file(path(4), 100);
    options.output.clear();
    EXPECT_EQ(studio.film(studio.renderer.function(), options).rendered, 1);
    EXPECT_THAT(warnings,
                ElementsAre(begin + path(4) + again + "its end is missing or overwritten"));
}

TEST(FilmPipeline, CacheThatVanishesMidway_IsFilledAgain) {
    Studio plain, studio;
    (void)plain.film();
    int calls = 0;
    const RenderFunction render = [&](const FrameInputs& inputs, const WorkContext&) {
        ++calls;
        if (calls == 5) {
            fs::remove_all(studio.folder.path("cache"));
        }
        return fake_picture(studio.shot, inputs);
    };
    (void)studio.film(render, studio.options());
    EXPECT_EQ(studio.video(), plain.video());
}

TEST(FilmPipeline, FrameHeldByAnother_IsLeftForLaterAndThenRead) {
    Studio plain, studio;
    (void)plain.film();
    const FrameStore store = studio.store();
    const Hash128 held_key = studio.key(1);
    std::optional<FrameClaim> claim = store.claim(held_key);
    ASSERT_TRUE(claim);
    const FilmSource source(studio.shot, studio.timeline);
    int calls = 0;
    const RenderFunction render = [&](const FrameInputs& inputs, const WorkContext&) {
        ++calls;
        if (calls == kPictures - 1) {  // the last of the others
            store.write(held_key, fake_picture(studio.shot, source.inputs(1)), {});
            claim.reset();
        }
        return fake_picture(studio.shot, inputs);
    };
    EXPECT_EQ(studio.film(render, studio.options()).rendered, kPictures - 1);
    EXPECT_EQ(studio.video(), plain.video());
}

TEST(FilmPipeline, OwnerThatGivesUp_LeavesTheFrameToUs) {
    Studio studio;
    const FrameStore store = studio.store();
    std::optional<FrameClaim> claim = store.claim(studio.key(0));
    const RenderFunction usual = studio.renderer.function();
    int calls = 0;
    const RenderFunction render = [&](const FrameInputs& inputs, const WorkContext& context) {
        ++calls;
        if (calls == kPictures - 1) {  // the last of the others
            claim.reset();
        }
        return usual(inputs, context);
    };
    EXPECT_EQ(studio.film(render, studio.options()).rendered, kPictures);
    EXPECT_EQ(studio.renderer.rendered().back(), Rational(-1, 96).to_double());
}

TEST(FilmPipeline, TwoJobsAtOnce_RenderEachPictureOnce) {
    Studio studio;
    const auto slow = [&](const FrameInputs& inputs, const WorkContext& context) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        return studio.renderer.function()(inputs, context);
    };
    FilmJobResult other;
    std::thread second([&] {
        other = film_by(slow, studio.shot, studio.timeline, studio.options("b.mkv"), {}, {});
    });
    const FilmJobResult result = studio.film(slow, studio.options("a.mkv"));
    second.join();
    EXPECT_EQ(result.rendered + other.rendered, kPictures);
    EXPECT_EQ(studio.video("a.mkv"), studio.video("b.mkv"));
}

TEST(FilmPipeline, Stopped_LeavesNoVideoAndGoesOnLater) {
    Studio plain, studio;
    (void)plain.film();
    int calls = 0;
    const RenderFunction render = [&](const FrameInputs& inputs, const WorkContext& context) {
        ++calls;
        if (calls == 4) {
            context.progress(1e-9);  // it will take hours
            studio.stop.request_stop();
            EXPECT_TRUE(context.stop.stop_requested());
            throw Stopped();
        }
        return fake_picture(studio.shot, inputs);
    };
    EXPECT_THROW((void)studio.film(render, studio.options()), Stopped);
    EXPECT_THAT(studio.folder.names(), ElementsAre("cache"));
    studio.stop = {};
    EXPECT_EQ(studio.film().rendered, kPictures - 3);
    EXPECT_EQ(studio.video(), plain.video());
}

TEST(FilmPipeline, StoppedShortlyBeforeAFramesEnd_KeepsTheFrame) {
    Studio studio;
    const RenderFunction render = [&](const FrameInputs& inputs, const WorkContext& context) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        context.progress(0.5);  // 10 ms more
        studio.stop.request_stop();
        EXPECT_FALSE(context.stop.stop_requested());
        return fake_picture(studio.shot, inputs);
    };
    EXPECT_THROW((void)studio.film(render, studio.options()), Stopped);
    EXPECT_TRUE(studio.store().contains(studio.key(0)));
    studio.stop = {};
    EXPECT_EQ(studio.film().rendered, kPictures - 1);
}

TEST(FilmPipeline, FrameThatOutlivesItsGrace_IsStopped) {
    Studio studio;
    const auto begin = std::chrono::steady_clock::now();
    const RenderFunction render = [&](const FrameInputs&,
                                      const WorkContext& context) -> render::Film {
        context.progress(0.999);  // but then it hangs
        studio.stop.request_stop();
        while (!context.stop.stop_requested() &&
               std::chrono::steady_clock::now() - begin < std::chrono::seconds(60)) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        throw Stopped();
    };
    EXPECT_THROW((void)studio.film(render, studio.options()), Stopped);
    EXPECT_FALSE(studio.store().contains(studio.key(0)));
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));
}

TEST(FilmPipeline, BitsFlippedInAHundredPlaces_NeverGiveAWrongFilm) {
    Studio studio;
    (void)studio.film();
    const std::string film = studio.video();
    const FrameStore store = studio.store();
    std::uint64_t random = 20240607;
    int flips = 0;
    for (int round = 0; flips < 100; ++round) {
        for (std::int64_t frame = 0; frame < kPictures; ++frame, ++flips) {
            const std::string path = store.path_of(studio.key(frame));
            std::string bytes = read_text(path);
            random = random * 6364136223846793005U + 1442695040888963407U;
            char& byte = bytes[(random >> 20U) % bytes.size()];
            byte = static_cast<char>(byte ^ (1 << (random >> 60U) % 8));
            write_text(path, bytes);
        }
        EXPECT_EQ(studio.film().rendered, kPictures) << "round " << round;
        ASSERT_EQ(studio.video(), film) << "round " << round;
    }
}

TEST(FilmPipeline, EncoderThatNeverReads_DoesNotHoldTheRenderingUp) {
    Studio studio;
    const FilmSource source(studio.shot, studio.timeline);
    std::vector<std::int64_t> frames(kFrames);
    std::iota(frames.begin(), frames.end(), 0);
    const FilmPlan plan = plan_film(source, frames, {});
    const FrameStore store = studio.store();
    ThreadSafeObserver gate(studio.observer);
    FrameQueue queue(plan.pictures.size());
    CachedRenderer renderer(source, store, studio.renderer.function());
    FrameScheduler scheduler(plan, renderer, queue, gate);
    std::thread rendering([&] { scheduler.run({}); });
    for (std::size_t i = 0; i < plan.pictures.size(); ++i) {
        EXPECT_TRUE(queue.wait_until_ready(i, {})) << "the last ones, too, before any was read";
    }
    queue.reader_done();
    rendering.join();
    EXPECT_EQ(scheduler.rendered(), kPictures);
}

TEST(FilmPipeline, RendererThatFails_IsHeardAndLeavesNoVideo) {
    Studio studio;
    write_text(studio.folder.path("film.mkv"), "the old film");
    const RenderFunction render = [](const FrameInputs&, const WorkContext&) -> render::Film {
        throw Error("the lamp is broken");
    };
    try {
        (void)studio.film(render, studio.options());
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "the lamp is broken");
    }
    EXPECT_EQ(studio.video(), "the old film");
    EXPECT_EQ(studio.folder.names().size(), 2u);
}

TEST(FilmPipeline, EncoderThatFails_StopsTheRendering) {
    Studio studio;
    std::atomic<int> calls{0};
    const RenderFunction render = [&](const FrameInputs&,
                                      const WorkContext& context) -> render::Film {
        ++calls;
        while (!context.stop.stop_requested()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        throw Stopped();
    };
    try {
        (void)studio.film(render, studio.options("no/such/folder/film.mkv"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("no/such/folder"));
    }
    EXPECT_LE(calls, 1);
}

TEST(FilmPipeline, PictureThatCannotBeStored_IsAnErrorNotALoop) {
    Studio studio;
    const FrameStore store = studio.store();
    const std::string path = store.path_of(studio.key(0));
    // A folder in the frame's place can be neither read nor replaced.
    fs::create_directories(path);
    EXPECT_THROW((void)studio.film(), Error);
}

TEST(FilmPipeline, NoFrameAskedFor_IsAnError) {
    Studio studio;
    FilmJobOptions options = studio.options();
    options.frames = parse_frame_range("12-99");
    try {
        (void)studio.film(studio.renderer.function(), options);
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "none of the film's 12 frames is asked for");
    }
}

TEST(FramePipeline, OneFrame_IsStoredAndSharedWithTheFilm) {
    Studio studio;
    const auto frame = [&] {
        return frame_by(studio.renderer.function(), studio.shot, studio.timeline, 3,
                        studio.options(), studio.observer, {});
    };
    const render::Film first = frame();
    EXPECT_EQ(first.width, 32);
    EXPECT_EQ(frame().rgba, first.rgba);
    EXPECT_EQ(studio.renderer.rendered().size(), 1u);
    EXPECT_EQ(studio.film().rendered, kPictures - 1);
    write_text(studio.store().path_of(studio.key(3)), "damaged");
    std::string warning;
    studio.observer.on_warning = [&](const std::string& text) { warning = text; };
    EXPECT_EQ(frame().rgba, first.rgba);
    EXPECT_EQ(warning,
              "the stored frame '" + studio.store().path_of(studio.key(3)) +
                  "' is damaged and is rendered again: it has 7 bytes, too few for a frame");
}

}  // namespace
}  // namespace carom::pipeline
