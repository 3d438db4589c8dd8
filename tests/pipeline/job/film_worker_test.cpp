#include "pipeline/job/film_worker.h"

#include <atomic>
#include <filesystem>
#include <set>
#include <thread>
#include <utility>

#include <gmock/gmock.h>

#include "core/error.h"
#include "pipeline/job/film_status.h"
#include "pipeline/job/job_frames.h"
#include "render/frame/frame_sums_data.h"
#include "tests/pipeline/job/tiny_shot.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::ScratchFolder;
using ::testing::ElementsAre;

TEST(BitReversedOrder, OrdersOfSmallFilms_AreAsWritten) {
    EXPECT_THAT(bit_reversed_order(8), ElementsAre(0, 4, 2, 6, 1, 5, 3, 7));
    EXPECT_THAT(bit_reversed_order(5), ElementsAre(0, 4, 2, 1, 3));
    EXPECT_THAT(bit_reversed_order(1), ElementsAre(0));
    EXPECT_TRUE(bit_reversed_order(0).empty());
}

TEST(BitReversedOrder, FirstFrames_AreSpreadOverTheFilm) {
    for (const std::size_t count : {100U, 255U, 1000U}) {
        const std::vector<std::size_t> order = bit_reversed_order(count);
        EXPECT_EQ(std::set<std::size_t>(order.begin(), order.end()).size(), count);
        const std::set<std::size_t> some(order.begin(), order.begin() + 25);
        std::size_t last = 0;
        for (const std::size_t frame : some) {
            EXPECT_LE(frame - last, count / 8) << count;
            last = frame;
        }
    }
}

/// Workers of the tiny film with a renderer that counts.
struct Farm {
    ScratchFolder folder;
    Shot shot = carom::testing::tiny_shot();
    sim::Bake bake{carom::testing::tiny_timeline(), {}, {}, {}};
    std::atomic<int> rendered = 0;

    FilmJobOptions options() {
        FilmJobOptions options;
        options.cache_folder = folder.path("cache");
        options.renderer = [this](const FrameInputs& inputs, const WorkContext&,
                                  render::FrameSums*) {
            ++rendered;
            return carom::testing::fake_picture(shot, inputs);
        };
        return options;
    }

    WorkerResult work(const WorkerOptions& worker) {
        return work_on_film(shot, bake, options(), worker, {}, {}, {});
    }
};

TEST(FilmWorker, ThreeAtOnce_RenderEachPictureOnce) {
    Farm farm;
    std::atomic<int> complete = 0;
    std::atomic<std::int64_t> twice = 0;
    {
        std::vector<std::jthread> workers;
        for (std::size_t i = 0; i < 3; ++i) {
            workers.emplace_back([&, i] {
                const WorkerResult result = farm.work({i, 3, std::chrono::seconds(60)});
                complete += result.is_complete ? 1 : 0;
                twice += result.state.twice;
            });
        }
    }
    EXPECT_EQ(complete, 3);
    EXPECT_EQ(twice, 0);
    const FilmStatus status = film_status(farm.shot, farm.bake, farm.options(), {});
    EXPECT_TRUE(status.missing.empty());
    EXPECT_EQ(farm.work({}).state.rendered, 0);
}

// While others are in the last pictures of a film, a worker goes on with the next one.
TEST(FilmWorker, SeveralFilms_AreRenderedWithoutWaiting) {
    Farm farm;
    Shot other = farm.shot;
    other.render.seed = 7;
    FilmJobOptions options = farm.options();
    const std::vector<WorkerFilm> films{{farm.shot, farm.bake, options, 100},
                                        {other, farm.bake, options, 200}};
    std::set<std::int64_t> told;
    bool is_reached = false;
    WorkerState elsewhere;
    FilmJobOptions slow = options;
    // In its first picture this worker waits until the other one has done all it can.
    slow.renderer = [&](const FrameInputs& inputs, const WorkContext&, render::FrameSums*) {
        if (!std::exchange(is_reached, true)) {
            std::stop_source stop;
            const auto on_state = [&](const WorkerState& state) {
                elsewhere = state;
                told.insert(state.frame);
                if (state.frame == -1) {  // it waits for the picture of this worker
                    stop.request_stop();
                }
            };
            EXPECT_THROW((void)work_on_films(films, {}, {}, on_state, stop.get_token()), Stopped);
        }
        return carom::testing::fake_picture(farm.shot, inputs);
    };
    const WorkerResult result = work_on_film(farm.shot, farm.bake, slow, {}, {}, {}, {});
    const std::int64_t pictures = result.state.pictures;
    EXPECT_TRUE(result.is_complete);
    EXPECT_EQ(result.state.rendered, 1);
    EXPECT_EQ(elsewhere.rendered, 2 * pictures - 1);
    EXPECT_EQ(elsewhere.pictures, 2 * pictures);
    EXPECT_TRUE(told.contains(200));
    EXPECT_TRUE(told.contains(101));
}

TEST(FilmWorker, StoppedPicture_IsGoneOnWithByTheNextWorker) {
    Farm farm;
    FilmJobOptions options = farm.options();
    options.keeps_sums = true;
    std::stop_source stop;
    int found = 0;
    options.renderer = [&](const FrameInputs& inputs, const WorkContext&,
                           render::FrameSums* sums) -> render::Film {
        render::FrameSums::Data& data = sums->data();
        if (farm.rendered++ == 3) {
            stop.request_stop();
            data.pixels = std::size_t{32} * 18;
            data.statistics.camera_rays = 5;
            throw Stopped();
        }
        if (data.pixels > 0) {
            ++found;
            EXPECT_EQ(sums->samples(), 5U);
        }
        return carom::testing::fake_picture(farm.shot, inputs);
    };
    EXPECT_THROW((void)work_on_film(farm.shot, farm.bake, options, {}, {}, {}, stop.get_token()),
                 Stopped);
    const WorkerResult result = work_on_film(farm.shot, farm.bake, options, {}, {}, {}, {});
    EXPECT_TRUE(result.is_complete);
    EXPECT_EQ(found, 1);
    EXPECT_EQ(result.state.continued, 1);
    EXPECT_EQ(result.state.twice, 0);
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(farm.folder.path("cache"))) {
        EXPECT_NE(entry.path().extension(), ".sums") << "sums of a finished frame stay";
    }
}

TEST(FilmWorker, Wishes_ArePreferredFirstAndSkippedNever) {
    Farm farm;
    WorkerOptions options;
    options.wishes = [] { return FrameWishes{1, {6}, {2, 3}}; };
    std::vector<std::int64_t> attempts;
    options.on_attempt = [&](const FrameAttempt& attempt) {
        EXPECT_EQ(attempt.end, FrameAttempt::End::rendered);
        attempts.push_back(attempt.frame);
    };
    const WorkerResult result = farm.work(options);
    EXPECT_TRUE(result.is_complete);
    EXPECT_THAT(attempts, ElementsAre(6, 0, 8, 4, 1, 5, 7));
    const FilmStatus status = film_status(farm.shot, farm.bake, farm.options(), {});
    EXPECT_THAT(status.missing, ElementsAre(2, 3));
}

// Somebody takes a picture out of the store that this worker has seen there, while it renders the
// last one that it knows of.
TEST(FilmWorker, ChangedWishes_LetItLookAtAllPicturesAgain) {
    Farm farm;
    EXPECT_TRUE(farm.work({}).is_complete);
    const int before = farm.rendered;
    const FilmSource source(farm.shot, farm.bake.timeline);
    const FilmPlan plan = plan_film(source, job_frames(farm.shot, farm.options()), {});
    const FrameStore store = open_store(farm.options());
    std::filesystem::remove(store.path_of(plan.pictures[3].key));
    FilmJobOptions slow = farm.options();
    std::int64_t revision = 0;
    slow.renderer = [&](const FrameInputs& inputs, const WorkContext&, render::FrameSums*) {
        if (++farm.rendered == before + 1) {
            std::filesystem::remove(store.path_of(plan.pictures[0].key));
            ++revision;
        }
        return carom::testing::fake_picture(farm.shot, inputs);
    };
    WorkerOptions options;
    options.wishes = [&] { return FrameWishes{revision, {}, {}}; };
    const WorkerResult result = work_on_film(farm.shot, farm.bake, slow, options, {}, {}, {});
    EXPECT_TRUE(result.is_complete);
    EXPECT_EQ(result.state.rendered, 2);
    EXPECT_EQ(result.state.finished, result.state.pictures);
}

TEST(FilmWorker, FailedPicture_IsToldWithItsProblem) {
    Farm farm;
    FilmJobOptions options = farm.options();
    options.renderer = [](const FrameInputs&, const WorkContext&,
                          render::FrameSums*) -> render::Film { throw Error("a lamp is broken"); };
    WorkerOptions worker;
    std::vector<std::string> told;
    worker.on_attempt = [&](const FrameAttempt& attempt) {
        EXPECT_EQ(attempt.end, FrameAttempt::End::failed);
        told.push_back(std::to_string(attempt.frame) + ": " + attempt.problem);
    };
    EXPECT_THROW((void)work_on_film(farm.shot, farm.bake, options, worker, {}, {}, {}), Error);
    EXPECT_THAT(told, ElementsAre("0: a lamp is broken"));
}

TEST(FilmWorker, BudgetThatIsOver_BeginsNothing) {
    Farm farm;
    const WorkerResult result = farm.work({0, 1, std::chrono::seconds(0)});
    EXPECT_FALSE(result.is_complete);
    EXPECT_EQ(farm.rendered, 0);
}

}  // namespace
}  // namespace carom::pipeline
