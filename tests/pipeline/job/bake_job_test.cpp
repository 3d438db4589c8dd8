#include <atomic>
#include <filesystem>
#include <thread>

#include <gmock/gmock.h>

#include "core/error.h"
#include "pipeline/job/film_job.h"
#include "sim/bake.h"
#include "tests/pipeline/job/tiny_shot.h"
#include "tests/scratch_folder.h"
#include "tests/sim/timeline/earlier_version.h"

namespace carom::pipeline {
namespace {

using carom::testing::read_text;
using carom::testing::ScratchFolder;
using carom::testing::write_text;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// One ball on the cloth that is struck too far off centre, so that the simulation gives a warning.
Shot make_shot() {
    Shot shot = carom::testing::tiny_shot();
    shot.resolved_text = "carom: 1";
    shot.world.duration = 0.2;
    sim::Body ball;
    ball.name = "cue";
    ball.pose.position = {0, 0, 0.028575};
    shot.world.table.emplace();
    shot.world.table->kind = sim::billiards::TableKind::cloth;
    shot.world.table->has_cushions = false;
    shot.world.bodies = {ball};
    sim::ForceEvent event;
    event.object = "cue";
    sim::Strike strike;
    strike.speed = 1;
    strike.direction = 0;
    strike.tip = {0.6, 0};
    event.action = strike;
    shot.world.events = {event};
    return shot;
}

struct Baking {
    sim::Bake bake;
    bool baked = false;
    BakeOrigin origin = BakeOrigin::cached;
    std::vector<std::string> warnings;
    double last_fraction = -1;
};

Baking run(const Shot& shot, const std::string& cache) {
    Baking result;
    JobObserver observer;
    observer.on_warning = [&](const std::string& text) { result.warnings.push_back(text); };
    observer.on_progress = [&](std::string_view stage, double fraction) {
        EXPECT_EQ(stage, "bake");
        result.last_fraction = fraction;
    };
    BakedShot baked = bake_or_reuse(shot, cache, observer, {});
    result.bake = std::move(baked.bake);
    result.origin = baked.origin;
    result.baked = result.origin != BakeOrigin::cached;
    return result;
}

std::string bake_path(const Shot& shot, const std::string& cache) {
    return cache + "/bakes/" + sim::physics_hash(shot.world).to_string() + ".bake";
}

TEST(BakeShot, Bake_IsTheSameAsTheCachedOne) {
    const ScratchFolder folder;
    Shot shot = make_shot();
    shot.keyed = {sim::Track("lamp", std::vector<sim::Key>(1))};
    double last_fraction = -1;
    const sim::Bake bake =
        bake_shot(shot, {[&](double fraction) { last_fraction = fraction; }, {}});
    EXPECT_EQ(last_fraction, 1);
    EXPECT_NE(bake.timeline.find("cue"), nullptr);
    EXPECT_NE(bake.timeline.find("lamp"), nullptr);
    EXPECT_EQ(bake, bake_or_reuse(shot, folder.path(), {}, {}).bake);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW((void)bake_shot(shot, {{}, stop.get_token()}), Stopped);
}

TEST(BakeJob, SecondRun_UsesTheCachedBakeAndWarnsAgain) {
    const ScratchFolder cache;
    const Shot shot = make_shot();
    const Baking first = run(shot, cache.path());
    EXPECT_EQ(first.origin, BakeOrigin::simulated);
    EXPECT_EQ(first.last_fraction, 1);
    EXPECT_EQ(first.bake.timeline.warnings.size(), 1u);
    EXPECT_EQ(first.bake.shot_text, "carom: 1");
    const Baking second = run(shot, cache.path());
    EXPECT_FALSE(second.baked);
    EXPECT_EQ(second.last_fraction, -1);
    EXPECT_EQ(second.bake, first.bake);
    EXPECT_EQ(second.bake.timeline.warnings, first.bake.timeline.warnings);
    using Files = std::filesystem::directory_iterator;
    EXPECT_EQ(std::distance(Files(cache.path("bakes")), Files()), 1) << "only the bake";
}

TEST(BakeJob, ChangeOfLook_ReusesTheBakeWithTheNewText) {
    const ScratchFolder cache;
    Shot shot = make_shot();
    const Baking first = run(shot, cache.path());
    shot.resolved_text = "carom: 1  # brighter";
    shot.render.samples = 99;
    const Baking second = run(shot, cache.path());
    EXPECT_FALSE(second.baked);
    EXPECT_EQ(second.bake.shot_text, shot.resolved_text);
    EXPECT_EQ(second.bake.timeline, first.bake.timeline);
}

TEST(BakeJob, ChangeOfPhysics_BakesAgain) {
    const ScratchFolder cache;
    Shot shot = make_shot();
    (void)run(shot, cache.path());
    shot.world.gravity = {0, 0, -1.62};
    EXPECT_TRUE(run(shot, cache.path()).baked);
}

TEST(BakeJob, DamagedBake_IsReplaced) {
    const ScratchFolder cache;
    const Shot shot = make_shot();
    const Baking first = run(shot, cache.path());
    const std::string path = bake_path(shot, cache.path());
    const std::string whole = read_text(path);
    std::string damaged = whole;
    damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 4);
    for (const std::string& text : {damaged, whole.substr(0, whole.size() / 3), std::string()}) {
        write_text(path, text);
        const Baking again = run(shot, cache.path());
        EXPECT_EQ(again.origin, BakeOrigin::replaced);
        EXPECT_EQ(again.bake, first.bake);
        EXPECT_THAT(again.warnings, ElementsAre(HasSubstr("the cached bake cannot be used, so the "
                                                          "shot is simulated again: ")));
        EXPECT_EQ(read_text(path), whole);
    }
}

TEST(BakeJob, BakeOfAnotherVersion_IsReplacedWithoutAWarning) {
    const ScratchFolder cache;
    const Shot shot = make_shot();
    const Baking first = run(shot, cache.path());
    const std::string path = bake_path(shot, cache.path());
    const std::string whole = read_text(path);
    const std::string old = sim::test::with_earlier_version(whole);
    ASSERT_FALSE(old.empty());
    write_text(path, old);
    EXPECT_EQ(bake_without_store(shot, cache.path(), {}, {}).origin, BakeOrigin::outdated);
    const Baking again = run(shot, cache.path());
    EXPECT_EQ(again.origin, BakeOrigin::outdated);
    EXPECT_EQ(again.bake, first.bake);
    EXPECT_THAT(again.warnings, IsEmpty());
    EXPECT_EQ(read_text(path), whole);
    EXPECT_EQ(run(shot, cache.path()).origin, BakeOrigin::cached);
}

TEST(BakeJob, BitsFlippedInAHundredPlaces_NeverGiveAWrongTimeline) {
    const ScratchFolder cache;
    const Shot shot = make_shot();
    const Baking first = run(shot, cache.path());
    const std::string path = bake_path(shot, cache.path());
    const std::string whole = read_text(path);
    std::uint64_t random = 20240607;
    for (int flip = 0; flip < 100; ++flip) {
        std::string damaged = whole;
        random = random * 6364136223846793005U + 1442695040888963407U;
        char& byte = damaged[(random >> 20U) % damaged.size()];
        byte = static_cast<char>(byte ^ (1 << (random >> 60U) % 8));
        write_text(path, damaged);
        const Baking again = run(shot, cache.path());
        ASSERT_TRUE(again.baked) << flip;
        ASSERT_EQ(again.bake, first.bake) << flip;
        ASSERT_EQ(read_text(path), whole) << flip;
    }
}

TEST(BakeJob, BakeOfAnotherShot_IsReplaced) {
    const ScratchFolder cache;
    Shot shot = make_shot(), other = make_shot();
    other.world.gravity = {0, 0, -1.62};
    (void)run(shot, cache.path());
    (void)run(other, cache.path());
    std::filesystem::copy_file(bake_path(other, cache.path()), bake_path(shot, cache.path()),
                               std::filesystem::copy_options::overwrite_existing);
    EXPECT_TRUE(run(shot, cache.path()).baked);
    EXPECT_FALSE(run(shot, cache.path()).baked);
}

TEST(BakeJob, CacheThatCannotBeWritten_StillGivesTheBake) {
    const ScratchFolder cache;
    write_text(cache.path("bakes"), "in the way");
    const Baking result = run(make_shot(), cache.path());
    EXPECT_TRUE(result.baked);
    EXPECT_THAT(result.warnings, ElementsAre(HasSubstr("the bake cannot be saved in the cache: ")));
}

TEST(BakeJob, AtTheSameTime_TheShotIsSimulatedOnce) {
    const ScratchFolder cache;
    const Shot shot = make_shot();
    std::atomic<int> simulated = 0;
    {
        std::vector<std::jthread> jobs;
        for (int i = 0; i < 4; ++i) {
            jobs.emplace_back([&] {
                simulated +=
                    bake_or_reuse(shot, cache.path(), {}, {}).origin == BakeOrigin::cached ? 0 : 1;
            });
        }
    }
    EXPECT_EQ(simulated, 1);
}

TEST(BakeJob, Stopped_LeavesNothing) {
    const ScratchFolder cache;
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW((void)bake_or_reuse(make_shot(), cache.path(), {}, stop.get_token()), Stopped);
    EXPECT_THAT(cache.names(), IsEmpty());
}

}  // namespace
}  // namespace carom::pipeline
