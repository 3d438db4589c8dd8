// Checks that the example shots do what the comments in their first lines promise.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/camera/path_fit.h"
#include "pipeline/config/load_shot.h"
#include "sim/bake.h"
#include "sim/timeline/energy.h"
#include "tests/folders.h"

namespace carom::pipeline {
namespace {

using sim::Event;
using sim::EventKind;

Shot example(const std::string& name) {
    const LoadResult loaded =
        load_shot(std::string(CAROM_SOURCE_DIR) + "/examples/" + name + ".yaml");
    EXPECT_TRUE(loaded.problems.empty()) << name;
    return loaded.shot.value();
}

const Event* find(const sim::Timeline& timeline, EventKind kind, const std::string& a,
                  const std::string& b = {}) {
    for (const Event& event : timeline.events) {
        const bool is_pair = event.a == a && (b.empty() || event.b == b);
        if (event.kind == kind && (is_pair || (event.a == b && event.b == a))) {
            return &event;
        }
    }
    return nullptr;
}

struct Nearest {
    double gap = 1e9;  // between the balls' surfaces
    Vec3 a, b;         // centres
};

Nearest nearest(const sim::Timeline& timeline, const std::string& a, const std::string& b) {
    Nearest best;
    for (double time = 0; time <= timeline.end_time; time += 1e-3) {
        const Vec3 p = timeline.find(a)->sample(time).position;
        const Vec3 q = timeline.find(b)->sample(time).position;
        const double gap = (p - q).length() - 2 * 0.028575;
        if (gap < best.gap) {
            best = {gap, p, q};
        }
    }
    return best;
}

/// Checks that every frame of the example's film can be planned with the bake of `baked`.
void expect_filmable(const std::string& name, const Shot& baked, const sim::Timeline& timeline) {
    const Shot shot = example(name);
    EXPECT_EQ(sim::physics_hash(shot.world), sim::physics_hash(baked.world)) << name;
    const std::vector<CameraRig> rigs = with_fitted_paths(shot.cameras, timeline);
    const std::int64_t frames = frame_count(rigs, shot.timing);
    EXPECT_GT(frames, 0);
    for (std::int64_t n = 0; n < frames; ++n) {
        EXPECT_NO_THROW((void)plan_mixed_frame(n, rigs, shot.timing, timeline)) << name << " " << n;
    }
}

TEST(NineBallBreak, IsFilmedAgainInSlowMotion) {
    const Shot shot = example("nine_ball_break");
    const sim::Timeline timeline = sim::bake(shot.world);
    expect_filmable("nine_ball_break", shot, timeline);
    expect_filmable("slow_motion", shot, timeline);
}

TEST(JumpShot, ClearsTheEightAndPotsTheNine) {
    const Shot shot = example("jump_shot");
    const sim::Timeline result = sim::bake(shot.world);
    EXPECT_TRUE(result.warnings.empty());
    const sim::Timeline& timeline = result;
    expect_filmable("jump_shot", shot, timeline);
    expect_filmable("bullet_time", shot, timeline);
    EXPECT_EQ(find(timeline, EventKind::impact, "cue", "eight"), nullptr);
    const Nearest over = nearest(timeline, "cue", "eight");
    EXPECT_GT(over.gap, 0.005);
    EXPECT_LT(over.gap, 0.1);
    EXPECT_GT(over.a.z, over.b.z + 0.05);  // above it, not beside it
    const Event* hit = find(timeline, EventKind::impact, "cue", "nine");
    const Event* potted = find(timeline, EventKind::potted, "nine");
    ASSERT_TRUE(hit != nullptr && potted != nullptr);
    EXPECT_LT(hit->time, potted->time);
    EXPECT_EQ(find(timeline, EventKind::potted, "cue"), nullptr);
    EXPECT_LT(sim::largest_energy_rise(timeline), 1e-9);
}

TEST(Masse, CurvesAroundTheEightAndPotsTheThree) {
    const sim::Timeline result = sim::bake(example("masse").world);
    EXPECT_TRUE(result.warnings.empty());
    const sim::Timeline& timeline = result;
    EXPECT_EQ(find(timeline, EventKind::impact, "cue", "eight"), nullptr);
    const Nearest beside = nearest(timeline, "cue", "eight");
    EXPECT_GT(beside.gap, 0.005);
    const Event* hit = find(timeline, EventKind::impact, "cue", "three");
    ASSERT_NE(hit, nullptr);
    EXPECT_NE(find(timeline, EventKind::potted, "three"), nullptr);
    EXPECT_EQ(find(timeline, EventKind::potted, "cue"), nullptr);
    // The straight path is blocked: the eight is less than a ball's diameter off the line.
    const sim::Track& cue = *timeline.find("cue");
    const Vec3 start = cue.sample(0).position;
    const Vec3 direction = (cue.sample(hit->time).position - start).normalized();
    const Vec3 eight = timeline.find("eight")->sample(0).position - start;
    EXPECT_LT(direction.cross(eight).length(), 2 * 0.028575);
    // The path starts to the left of this line and returns: it turns by more than thirty degrees.
    const Vec3 first = cue.sample(0.51).velocity.normalized();
    const Vec3 last = cue.sample(hit->time - 0.01).velocity.normalized();
    EXPECT_GT(direction.cross(first).z, 0.15);
    EXPECT_LT(direction.cross(last).z, -0.15);
    EXPECT_LT(first.dot(last), 0.87);
}

TEST(Park, SetsTheCueBallInMotionAgain) {
    const sim::Timeline timeline = sim::bake(example("park").world);
    EXPECT_TRUE(timeline.warnings.empty());
    const Event* again = find(timeline, EventKind::velocity, "cue");
    ASSERT_NE(again, nullptr);
    EXPECT_GT(again->time, 5);
}

TEST(DominoRun, FallsToItsEndAndPotsTheNine) {
    const Shot shot = example("domino_run");
    const sim::Timeline result = sim::bake(shot.world);
    EXPECT_TRUE(result.warnings.empty());
    const sim::Timeline& timeline = result;
    expect_filmable("domino_run", shot, timeline);
    expect_filmable("reverse", shot, timeline);
    constexpr int kTiles = 32;
    const auto tile = [](int i) { return "tile_" + std::to_string(i); };
    const Event* before = find(timeline, EventKind::impact, "cue", tile(1));
    ASSERT_NE(before, nullptr);
    for (int i = 1; i < kTiles; ++i) {
        const Event* impact = find(timeline, EventKind::impact, tile(i), tile(i + 1));
        ASSERT_NE(impact, nullptr) << i;
        EXPECT_GT(impact->time, before->time) << i;
        before = impact;
    }
    for (int i = 1; i <= kTiles; ++i) {
        const MotionState end = timeline.find(tile(i))->sample(timeline.end_time);
        EXPECT_LT(end.position.z, 0.02) << i;  // it stood with its centre at 30 mm
        EXPECT_EQ(end.velocity, Vec3(0, 0, 0)) << i;
        // The wave ends at 2.4 s. Tiles that lean on others and are held by friction must be put to
        // sleep soon after, too, since every moving body costs time in every frame.
        const MotionState soon = timeline.find(tile(i))->sample(3.2);
        EXPECT_EQ(soon.velocity, Vec3(0, 0, 0)) << i;
    }
    const Event* push = find(timeline, EventKind::impact, "nine", tile(kTiles));
    const Event* potted = find(timeline, EventKind::potted, "nine");
    ASSERT_TRUE(push != nullptr && potted != nullptr);
    EXPECT_LT(push->time, potted->time);
    EXPECT_LT(potted->time, 3.3);  // the film ends at 3.475 s
    EXPECT_LT(sim::largest_energy_rise(timeline), 1e-9);
}

/// The partners of all impacts of `ball` in order of time, except the cloth.
std::vector<std::string> impact_partners(const sim::Timeline& timeline, const std::string& ball) {
    std::vector<std::string> partners;
    for (const Event& event : timeline.events) {
        if (event.kind == EventKind::impact && (event.a == ball || event.b == ball)) {
            const std::string& other = event.a == ball ? event.b : event.a;
            if (other != "cloth") {
                partners.push_back(other);
            }
        }
    }
    return partners;
}

TEST(BankShot, PotsTheNineOffTheCushion) {
    const sim::Timeline timeline = sim::bake(example("bank_shot").world);
    const Event* bank = find(timeline, EventKind::impact, "nine", "cushion");
    const Event* potted = find(timeline, EventKind::potted, "nine");
    ASSERT_TRUE(bank != nullptr && potted != nullptr);
    EXPECT_LT(bank->time, potted->time);
    EXPECT_EQ(find(timeline, EventKind::potted, "cue"), nullptr);
}

TEST(SnookerBreakOff, BringsTheCueBallBackToBaulk) {
    const sim::Timeline timeline = sim::bake(example("snooker_break_off").world);
    EXPECT_THAT(impact_partners(timeline, "cue"),
                ::testing::ElementsAre("red_15", "cushion", "cushion", "brown"));
    EXPECT_LT(timeline.find("cue")->sample(timeline.end_time).position.x, -1);
}

TEST(ThreeCushion, Scores) {
    const std::vector<std::string> partners =
        impact_partners(sim::bake(example("three_cushion").world), "white");
    ASSERT_GE(partners.size(), 5U);
    EXPECT_EQ(partners[0], "yellow");
    EXPECT_EQ(partners[4], "red");
    EXPECT_EQ(std::count(partners.begin() + 1, partners.begin() + 4, "cushion"), 3);
}

TEST(CueStroke, TheTipIsAtTheBallWhenItIsStruck) {
    const Shot shot = example("cue_stroke");
    const auto tip = std::ranges::find(shot.keyed, "stick_tip", &sim::Track::name);
    ASSERT_NE(tip, shot.keyed.end());
    const MotionState state = tip->sample(0.8);
    const Vec3 ball(0.30, -0.30, 0.028575);
    EXPECT_NEAR((state.position - ball).length(), 0.028575, 2e-4);
    EXPECT_NEAR(state.velocity.length(), 2.2, 0.01);
    // It moves along its own axis, which is the direction of the strike.
    const Vec3 back = (tip->sample(0.55).position - state.position).normalized();
    EXPECT_GT(back.dot(-state.velocity.normalized()), 0.99999);
}

TEST(Tower, FallsAndEveryEventHappens) {
    const sim::Timeline result = sim::bake(example("tower").world);
    EXPECT_THAT(result.warnings, ::testing::IsEmpty());
    EXPECT_NE(find(result, EventKind::impact, "barrel", "cloth"), nullptr);
    EXPECT_LT(result.find("c2")->sample(result.end_time).position.z, 0.06);
}

TEST(ThirtyDegrees, RollingCueBallLeavesByAboutThirtyDegrees) {
    const sim::Timeline result = sim::bake(example("thirty_degrees").world);
    EXPECT_THAT(result.warnings, ::testing::IsEmpty());
    const Event* hit = find(result, EventKind::impact, "cue", "one");
    ASSERT_TRUE(hit != nullptr);
    const sim::Track& cue = *result.find("cue");
    const Vec3 before = cue.sample(hit->time - 1e-6).velocity.normalized();
    const Vec3 after = cue.sample(hit->time + 0.5).velocity.normalized();
    const double degrees = std::acos(before.dot(after)) * 180 / std::numbers::pi;
    EXPECT_NEAR(degrees, 32, 3);
}

TEST(Turnstile, PlankAndBarsPushTheBalls) {
    const sim::Timeline result = sim::bake(example("turnstile").world);
    EXPECT_THAT(result.warnings, ::testing::IsEmpty());
    for (const char* ball : {"cue", "one", "three", "five", "six", "eight", "twelve"}) {
        EXPECT_TRUE(find(result, EventKind::impact, ball, "bar_x") != nullptr ||
                    find(result, EventKind::impact, ball, "bar_y") != nullptr)
            << ball;
    }
    const auto speed = [&](double time) {
        return result.find("cue")->sample(time).velocity.length();
    };
    EXPECT_EQ(speed(0.5), 0) << "it rests on the plank";
    EXPECT_GT(speed(2), 0.5) << "rolled down";
}

std::vector<std::string> potted_in(const sim::Timeline& timeline) {
    std::vector<std::string> balls;
    for (const Event& event : timeline.events) {
        if (event.kind == EventKind::potted) {
            balls.push_back(event.a);
        }
    }
    return balls;
}

TEST(Examples, SolveRedBlack_PotsTheRedAndLeavesTheCueBallForTheBlack) {
    const sim::Timeline timeline = sim::bake(example("solve_red_black").world);
    EXPECT_EQ(potted_in(timeline), std::vector<std::string>{"red"});
    const Vec3 cue = timeline.find("cue")->keys().back().position;
    EXPECT_LT(std::hypot(cue.x - 1.0, cue.y + 0.3), 0.25);
}

TEST(Examples, Clearance_PotsAllThree) {
    const sim::Timeline timeline = sim::bake(example("clearance").world);
    EXPECT_EQ(potted_in(timeline), (std::vector<std::string>{"one", "two", "three"}));
}

}  // namespace
}  // namespace carom::pipeline
