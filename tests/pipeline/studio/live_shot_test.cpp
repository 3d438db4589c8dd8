// Which texts are answered, which simulations are stopped, and which are not needed at all.
#include "pipeline/studio/live_shot.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <sstream>
#include <thread>

#include <gtest/gtest.h>

#include "core/error.h"
#include "sim/bake.h"
#include "tests/folders.h"

namespace carom::studio {
namespace {

const std::string kShot = CAROM_SOURCE_DIR "/examples/bank_shot.yaml";

std::string read(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

/// A live shot whose clock and simulation belong to the test.
class LiveShotTest : public testing::Test {
  protected:
    LiveShotTest() {
        LiveOptions options;
        options.root = CAROM_SOURCE_DIR;
        options.clock = [this] {
            const std::lock_guard lock(mutex_);
            return now_;
        };
        options.bake = [this](std::uint64_t most, const sim::WorldDescription& world,
                              const WorkContext& context) { return bake(most, world, context); };
        LiveOutput output;
        output.text = [this](const ServerMessage& message) {
            const std::lock_guard lock(mutex_);
            if (const auto* problems = std::get_if<Problems>(&message)) {
                (problems->complete ? complete_ : seen_) = problems->v;
            } else if (const auto* deferred = std::get_if<Deferred>(&message)) {
                deferred_ = deferred->reason;
            } else if (const auto* work = std::get_if<Work>(&message)) {
                work_.push_back(work->what);
            } else if (const auto* state = std::get_if<ShotState>(&message)) {
                states_.push_back(*state);
            }
            wake_.notify_all();
        };
        output.binary = [this](const BinaryHead& head, const std::vector<double>&) {
            const std::lock_guard lock(mutex_);
            sent_cameras_ += std::holds_alternative<CamerasHead>(head) ? 1 : 0;
        };
        output.shown = [this](std::int64_t v, const pipeline::Shot&) {
            const std::lock_guard lock(mutex_);
            shown_ = v;
            wake_.notify_all();
        };
        output.files = [](std::int64_t, const std::vector<pipeline::ReadFile>&,
                          const std::vector<std::string>&) {};
        output.answer = [this](const LiveAnswer& answer) {
            const std::lock_guard lock(mutex_);
            answered_.push_back(answer.v);
            wake_.notify_all();
        };
        live_ = std::make_unique<LiveShot>(std::move(options), std::move(output));
    }

    std::optional<sim::Timeline> bake(std::uint64_t most, const sim::WorldDescription& world,
                                      const WorkContext& context) {
        const std::stop_callback stopping(context.stop, [this] {
            const std::lock_guard lock(mutex_);
            wake_.notify_all();
        });
        {
            std::unique_lock lock(mutex_);
            ++begun_;
            wake_.notify_all();
            while (holds_ && !context.stop.stop_requested()) {
                wake_.wait_for(lock, std::chrono::milliseconds(1));
                lock.unlock();
                context.progress(0.2);
                lock.lock();
            }
            if (context.stop.stop_requested()) {
                ++stopped_;
                wake_.notify_all();
                throw Stopped();
            }
            now_ += takes_;
        }
        if (context.progress) {
            context.progress(0.5);
        }
        if (context.stop.stop_requested()) {
            set([&] { ++stopped_; });
            throw Stopped();
        }
        if (fails_) {
            throw Error("a ball fell out of the world");
        }
        return is_limited_ ? std::optional<sim::Timeline>() : sim::bake_within(most, world);
    }

    /// The text with another position of the cue ball, which changes the physics.
    void offer(std::int64_t v, double x, int crf = 18) {
        auto texts = std::make_shared<pipeline::config::OpenTexts>();
        std::string& text = (*texts)[kShot] = read(kShot);
        text.replace(text.find("crf: 18"), 7, "crf: " + std::to_string(crf));
        text += "\nphysics: {gravity: [0, 0, " + std::to_string(-9.81 - x / 1000) + "]}\n";
        live_->offer({v, kShot, texts});
    }

    void wait(const std::function<bool()>& condition) {
        std::unique_lock lock(mutex_);
        wake_.wait(lock, condition);
    }

    std::size_t answers() {
        const std::lock_guard lock(mutex_);
        return answered_.size();
    }

    void set(const std::function<void()>& change) {
        const std::lock_guard lock(mutex_);
        change();
        wake_.notify_all();
    }

    std::mutex mutex_;
    std::condition_variable wake_;
    double now_ = 0;
    double takes_ = 0;
    bool holds_ = false;
    bool is_limited_ = false;
    int begun_ = 0;
    int stopped_ = 0;
    std::int64_t seen_ = 0;
    std::int64_t complete_ = 0;
    std::string deferred_;
    std::vector<std::int64_t> answered_;
    std::int64_t shown_ = 0;
    int sent_cameras_ = 0;
    std::vector<ShotState> states_;
    std::vector<std::string> work_;
    bool fails_ = false;  // the simulation, after it told its progress
    std::unique_ptr<LiveShot> live_;
};

TEST_F(LiveShotTest, LastOfManyTexts_IsAnswered) {
    for (int v = 1; v <= 200; ++v) {
        offer(v, v);
    }
    wait([&] { return complete_ == 200; });
    EXPECT_EQ(answered_.back(), 200);
    EXPECT_TRUE(std::ranges::is_sorted(answered_));
}

TEST_F(LiveShotTest, EditOfTheLook_IsNotSimulated) {
    offer(1, 0);
    wait([&] { return complete_ == 1; });
    offer(2, 0, 20);
    wait([&] { return complete_ == 2; });
    EXPECT_EQ(begun_, 1);
    EXPECT_EQ(answered_, (std::vector<std::int64_t>{1, 2}));
}

TEST_F(LiveShotTest, SimulationIsStoppedOnce_ThenTheNextOneEnds) {
    holds_ = true;
    offer(1, 1);
    wait([&] { return begun_ == 1; });
    offer(2, 2);  // the simulation has not run for 0.1 s
    offer(3, 3);
    EXPECT_EQ(stopped_, 0);
    set([&] { now_ += 0.2; });
    wait([&] { return stopped_ == 1 && begun_ == 2; });
    set([&] { now_ += 0.2; });
    offer(4, 4);
    offer(5, 5);
    set([&] { holds_ = false; });
    wait([&] { return complete_ == 5; });
    EXPECT_EQ(stopped_, 1);
    EXPECT_EQ(answered_, (std::vector<std::int64_t>{3, 5}));
}

TEST_F(LiveShotTest, SlowShot_IsShownBeforeItsMotionIsKnown) {
    holds_ = true;
    takes_ = 1;
    offer(1, 1);
    wait([&] { return begun_ == 1; });
    set([&] {
        EXPECT_EQ(shown_, 1);
        ASSERT_EQ(states_.size(), 1U);
        EXPECT_FALSE(states_.front().objects.empty());
        EXPECT_FALSE(states_.front().cameras.empty());
        holds_ = false;
    });
    wait([&] { return complete_ == 1; });
    // The same objects at the same places as with the motion. Only the stick, whose motion follows
    // from the strikes, is not seen yet.
    ASSERT_EQ(states_.size(), 2U);
    ASSERT_EQ(states_[0].objects.size(), states_[1].objects.size());
    for (std::size_t i = 0; i < states_[0].objects.size(); ++i) {
        EXPECT_EQ(states_[0].objects[i].moves, states_[1].objects[i].moves);
        if (states_[0].objects[i].name.starts_with("stick/")) {
            EXPECT_LT(states_[0].objects[i].position[2], -100);
        } else {
            EXPECT_EQ(states_[0].objects[i].position, states_[1].objects[i].position);
        }
    }
    offer(2, 2);  // known to be slow
    wait([&] { return complete_ == 2; });
    EXPECT_EQ(states_.size(), 4U);
}

TEST_F(LiveShotTest, QuickShot_IsShownOnceForEachText) {
    for (int v = 1; v <= 3; ++v) {
        offer(v, v);
        wait([&] { return complete_ == v; });
    }
    EXPECT_EQ(states_.size(), 4U);  // the first one before its motion, too
}

TEST_F(LiveShotTest, SameCameras_AreSentOnce) {
    offer(1, 1);
    wait([&] { return complete_ == 1; });
    offer(2, 1, 20);
    wait([&] { return complete_ == 2; });
    EXPECT_EQ(sent_cameras_, 1);
}

TEST_F(LiveShotTest, SlowShot_EndOfTheDragAnswersAtOnce) {
    takes_ = 1;
    offer(1, 1);
    wait([&] { return complete_ == 1; });
    live_->set_dragging(true);
    offer(2, 2);
    live_->set_dragging(false);
    wait([&] { return complete_ == 2; });
    EXPECT_EQ(begun_, 2);
}

// The last version of a drag that stands still, and of one that goes on, is answered.
TEST_F(LiveShotTest, SlowShot_IsAnsweredDuringTheDragAfterAPause) {
    takes_ = 1;
    offer(1, 1);
    wait([&] { return complete_ == 1; });
    live_->set_dragging(true);
    offer(2, 2);
    wait([&] { return complete_ == 2; });
    EXPECT_EQ(begun_, 2);
    for (int v = 3; answers() == 2; ++v) {
        offer(v, v);
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

// One simulation that the machine made slow leaves nothing behind.
TEST_F(LiveShotTest, ShotThatWasSlowOnce_FollowsEveryMoveAfterwards) {
    takes_ = 1;
    offer(1, 1);
    wait([&] { return complete_ == 1; });
    set([&] { takes_ = 0; });
    live_->set_dragging(true);
    offer(2, 2);
    wait([&] { return complete_ == 2; });
    set([&] { deferred_.clear(); });
    for (int v = 3; v <= 20; ++v) {
        offer(v, v);
        wait([&] { return complete_ == v; });
    }
    EXPECT_EQ(begun_, 20);
    EXPECT_EQ(deferred_, "");
}

TEST_F(LiveShotTest, TooLongShot_WaitsForTheButton) {
    is_limited_ = true;
    offer(1, 1);
    wait([&] { return complete_ == 1; });
    EXPECT_EQ(deferred_, "limit");
    offer(2, 1);
    wait([&] { return complete_ == 2; });
    EXPECT_EQ(begun_, 1);
    set([&] { is_limited_ = false; });
    live_->simulate();
    wait([&] { return !answered_.empty(); });
    EXPECT_EQ(answered_.front(), 2);
}

// A simulation of minutes must not end because somebody types a comment.
TEST_F(LiveShotTest, SimulationByTheButton_IsStoppedByAnotherWorldOnly) {
    is_limited_ = true;
    offer(1, 1);
    wait([&] { return complete_ == 1; });
    set([&] {
        is_limited_ = false;
        holds_ = true;
    });
    live_->simulate();
    wait([&] { return begun_ == 2; });
    set([&] { now_ += 10; });
    offer(2, 1, 20);  // the same world
    set([&] { holds_ = false; });
    wait([&] { return complete_ == 2; });
    EXPECT_EQ(stopped_, 0);
    EXPECT_EQ(begun_, 2);
    EXPECT_EQ(answered_, (std::vector<std::int64_t>{1, 2}));

    set([&] { is_limited_ = true; });
    offer(3, 3);
    wait([&] { return complete_ == 3; });
    set([&] {
        is_limited_ = false;
        holds_ = true;
    });
    live_->simulate();
    wait([&] { return begun_ == 4; });
    set([&] { now_ += 10; });
    offer(4, 4);  // another world
    set([&] { holds_ = false; });
    wait([&] { return complete_ == 4; });
    EXPECT_EQ(stopped_, 1);
    EXPECT_EQ(answered_.back(), 4);
}

TEST_F(LiveShotTest, FailedSimulation_LeavesNoProgressBehind) {
    takes_ = 1;
    fails_ = true;
    offer(1, 1);
    wait([&] { return complete_ == 1; });
    EXPECT_EQ(work_, (std::vector<std::string>{"bake", ""}));
}

TEST_F(LiveShotTest, SearchOfSolve_IsStoppedForNewerTexts) {
    const std::string run = CAROM_SOURCE_DIR "/examples/clearance.yaml";  // takes seconds
    auto texts = std::make_shared<pipeline::config::OpenTexts>();
    (*texts)[run] = read(run);
    live_->offer({1, run, texts});
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    offer(2, 0);
    wait([&] { return !answered_.empty(); });
    const std::lock_guard lock(mutex_);
    EXPECT_EQ(answered_, std::vector<std::int64_t>{2});
    EXPECT_TRUE(work_.empty() || work_.back().empty());
}

TEST_F(LiveShotTest, SolveIsAnswered_AlsoByTheFirstTexts) {
    const std::string shot = CAROM_SOURCE_DIR "/examples/solve_red_black.yaml";
    for (std::int64_t v = 1; v <= 5; ++v) {  // as a text that is opened, and typed in
        auto texts = std::make_shared<pipeline::config::OpenTexts>();
        (*texts)[shot] = read(shot) + "# " + std::to_string(v) + "\n";
        live_->offer({v, shot, texts});
        wait([&] { return std::ranges::count(answered_, v) == 1; });
    }
}

TEST_F(LiveShotTest, End_StopsTheSimulation) {
    holds_ = true;
    offer(1, 1);
    wait([&] { return begun_ == 1; });
    live_.reset();
    EXPECT_EQ(stopped_, 1);
    EXPECT_TRUE(answered_.empty());
}

}  // namespace
}  // namespace carom::studio
