// The same shot several times with small disturbances.
#include "pipeline/studio/outcome_fan.h"

#include <condition_variable>
#include <mutex>
#include <numbers>
#include <set>

#include <gmock/gmock.h>

#include "pipeline/config/load_shot.h"
#include "pipeline/studio/disturbance.h"
#include "pipeline/studio/fan_message.h"
#include "sim/bake.h"
#include "tests/folders.h"

namespace carom::studio {
namespace {

struct Baked {
    std::shared_ptr<const pipeline::Shot> shot;
    std::shared_ptr<const sim::Timeline> timeline;
};

Baked bake_example(const std::string& name) {
    pipeline::LoadResult loaded =
        pipeline::load_shot(CAROM_SOURCE_DIR "/examples/" + name + ".yaml");
    const auto shot = std::make_shared<const pipeline::Shot>(std::move(*loaded.shot));
    return {shot, std::make_shared<const sim::Timeline>(sim::bake(shot->world))};
}

TEST(OutcomeFan, Disturbances_FillTheirRangeAndDoNotRepeat) {
    for (const int runs : {1, 2, 3, 8, 15, 16}) {
        const Fan fan{1, runs, 1e-4, 1e-3};
        std::set<double> turns;
        Vec2 sum(0, 0);
        for (int i = 0; i < runs; ++i) {
            const Disturbance one = disturbance_of(i, fan);
            EXPECT_NEAR(one.displacement.length(), 1e-4, 1e-12);
            EXPECT_LE(std::abs(one.turn), 1e-3);
            sum += one.displacement;
            turns.insert(one.turn);
        }
        EXPECT_EQ(turns.size(), static_cast<std::size_t>(runs));
        EXPECT_NEAR(sum.length(), runs == 1 ? 1e-4 : 0, 1e-12);
    }
}

TEST(OutcomeFan, NoDisturbance_GivesTheSameMotion) {
    const Baked baked = bake_example("nine_ball_break");
    const sim::WorldDescription same = disturbed(baked.shot->world, *baked.timeline, {});
    const sim::Timeline again = sim::bake(same);
    ASSERT_EQ(again.events.size(), baked.timeline->events.size());
    for (std::size_t i = 0; i < 20; ++i) {  // the aim is rounded once more
        EXPECT_NEAR(again.events[i].time, baked.timeline->events[i].time, 1e-9);
    }
}

TEST(OutcomeFan, DisturbedWorld_TurnsTheStrikeAndDisplacesItsBall) {
    const Baked baked = bake_example("bank_shot");
    const sim::WorldDescription other =
        disturbed(baked.shot->world, *baked.timeline, {{1e-3, -2e-3}, 0.01});
    const sim::WorldDescription none = disturbed(baked.shot->world, *baked.timeline, {});
    for (std::size_t i = 0; i < other.bodies.size(); ++i) {
        const Vec3 moved = other.bodies[i].pose.position - none.bodies[i].pose.position;
        const bool is_cue = other.bodies[i].name == "cue";
        EXPECT_NEAR(moved.x, is_cue ? 1e-3 : 0, 1e-12);
        EXPECT_NEAR(moved.y, is_cue ? -2e-3 : 0, 1e-12);
    }
    const auto& strike = std::get<sim::Strike>(other.events.front().action);
    const auto& before = std::get<sim::Strike>(none.events.front().action);
    EXPECT_NEAR(*strike.direction - *before.direction, 0.01, 1e-12);
}

TEST(OutcomeFan, Message_HasThinnedPathsAndCounts) {
    const Baked baked = bake_example("bank_shot");
    const Numbers<FanHead> message = fan_message({*baked.timeline, *baked.timeline});
    EXPECT_EQ(message.head.finished, 2);
    ASSERT_EQ(message.head.tracks.size(), 4U);  // two balls that move, twice
    EXPECT_EQ(message.head.tracks[2].run, 1);
    std::int64_t next = 0;
    for (const FanTrack& track : message.head.tracks) {
        EXPECT_EQ(track.first, next);
        EXPECT_LT(track.points, 200);
        next += track.points * FanHead::kNumbersPerPoint;
        // Every point lies on the path.
        const sim::Track* path = baked.timeline->find(track.name);
        for (std::int64_t i = 0; i < track.points; ++i) {
            const double* point = &message.numbers[static_cast<std::size_t>(
                track.first + i * FanHead::kNumbersPerPoint)];
            const Vec3 there = path->sample(point[0]).position;
            EXPECT_LT((there - Vec3(point[1], point[2], point[3])).length(), 1e-9);
        }
    }
    EXPECT_EQ(next, static_cast<std::int64_t>(message.numbers.size()));
    EXPECT_THAT(message.head.outcomes,
                testing::Contains(testing::AllOf(testing::Field(&FanOutcome::kind, "potted"),
                                                 testing::Field(&FanOutcome::a, "nine"),
                                                 testing::Field(&FanOutcome::runs, 2))));
}

/// The worker and what it answered.
class OutcomeFanWork : public testing::Test {
  protected:
    OutcomeFanWork()
        : fan_(
              [this](const FanHead& head, const std::vector<double>&) {
                  const std::lock_guard lock(mutex_);
                  heads_.push_back(head);
                  wake_.notify_all();
              },
              [](const ServerMessage&) {}) {}

    void wait_for_finished(std::int64_t v, int finished) {
        std::unique_lock lock(mutex_);
        wake_.wait(lock, [&] {
            return !heads_.empty() && heads_.back().v == v && heads_.back().finished == finished;
        });
    }

    std::mutex mutex_;
    std::condition_variable wake_;
    std::vector<FanHead> heads_;
    OutcomeFan fan_;
};

TEST_F(OutcomeFanWork, Question_WaitsForItsShotAndIsAnsweredRunByRun) {
    const Baked baked = bake_example("bank_shot");
    fan_.ask({2, 3, 1e-4, 1e-3});
    fan_.set_shot(baked.shot, baked.timeline, 1);
    fan_.set_shot(baked.shot, baked.timeline, 2);
    wait_for_finished(2, 3);
    const std::lock_guard lock(mutex_);
    EXPECT_EQ(heads_.size(), 3U);
    EXPECT_EQ(heads_.front().finished, 1);
    EXPECT_EQ(heads_.front().runs, 3);
}

TEST_F(OutcomeFanWork, NewerQuestion_EndsTheOneBefore) {
    const Baked baked = bake_example("tower");
    fan_.set_shot(baked.shot, baked.timeline, 1);
    fan_.ask({1, 16, 1e-4, 1e-3});
    const Baked other = bake_example("bank_shot");
    fan_.cancel();
    fan_.set_shot(other.shot, other.timeline, 5);
    fan_.ask({5, 2, 1e-4, 1e-3});
    wait_for_finished(5, 2);
    const std::lock_guard lock(mutex_);
    EXPECT_LT(heads_.size(), 16U);
}

}  // namespace
}  // namespace carom::studio
