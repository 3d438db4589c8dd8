// When a want is met, and how far it is from that.
#include "pipeline/solve/wants.h"

#include <gtest/gtest.h>

namespace carom::pipeline::solve {
namespace {

using sim::Event;
using sim::EventKind;

Event event(EventKind kind, double time, const std::string& a, const std::string& b = "",
            const Vec3& place = {0, 0, 0}) {
    Event result;
    result.kind = kind;
    result.time = result.end_time = time;
    result.a = a;
    result.b = b;
    result.place = place;
    return result;
}

class WantsTest : public testing::Test {
  protected:
    WantsTest() {
        for (const std::string name : {"cue", "one", "eight"}) {
            sim::Body body;
            body.name = name;
            world_.bodies.push_back(body);
            names_.push_back(name);
        }
        outcome_.states.resize(3);
        outcome_.events = {event(EventKind::impact, 0.1, "one", "cushion"),  // before the strike
                           event(EventKind::strike, 1, "cue"),
                           event(EventKind::impact, 1.2, "cue", "cushion"),
                           event(EventKind::impact, 1.204, "cue", "cushion"),  // the same contact
                           event(EventKind::impact, 1.5, "cue", "cushion"),
                           event(EventKind::impact, 1.7, "cue", "one"),
                           event(EventKind::impact, 1.9, "cue", "cushion"),
                           event(EventKind::potted, 2.3, "one", "side_back")};
    }

    [[nodiscard]] double miss(const Want& want) const {
        return miss_of(want, {world_, names_, outcome_, 0});
    }
    static Happening happening(sim::Trigger::Kind kind, const std::string& a,
                               const std::string& b = "") {
        Happening want;
        want.trigger.kind = kind;
        want.trigger.a = a;
        want.trigger.b = b;
        return want;
    }

    sim::WorldDescription world_;
    std::vector<std::string> names_;
    sim::Outcome outcome_;
};

TEST_F(WantsTest, PotCountsInItsPocketOnly) {
    Happening want = happening(sim::Trigger::Kind::potted, "one");
    EXPECT_EQ(miss(want), 0);
    want.pocket = "side_back";
    EXPECT_EQ(miss(want), 0);
    want.pocket = "side_front";
    EXPECT_EQ(miss(want), 1);
    EXPECT_EQ(miss(happening(sim::Trigger::Kind::potted, "eight")), 1);
}

TEST_F(WantsTest, CushionsAreCountedSinceTheStrike_BeforeWhatEndsThem) {
    Happening want = happening(sim::Trigger::Kind::contact, "cue", "cushion");
    want.at_least = 3;
    EXPECT_EQ(miss(want), 0);
    want.before = happening(sim::Trigger::Kind::contact, "one", "cue").trigger;
    EXPECT_EQ(miss(want), 1);
    want.at_least = 2;
    EXPECT_EQ(miss(want), 0);
    want.before = happening(sim::Trigger::Kind::contact, "one", "eight").trigger;
    want.at_least = 3;
    EXPECT_EQ(miss(want), 1);  // it never ends
    EXPECT_EQ(miss(happening(sim::Trigger::Kind::contact, "one", "cushion")), 1);
    // The first contact is with a jaw.
    want = happening(sim::Trigger::Kind::contact, "cue", "cushion");
    want.at_least = 3;
    want.skips_jaws = true;
    for (Event& each : outcome_.events) {
        each.normal = Vec3(0, each.time < 1.3 ? 0.7 : -1, 0);
        each.normal.x = each.time < 1.3 ? 0.7 : 0;
    }
    EXPECT_EQ(miss(want), 1);
    want.at_least = 2;
    EXPECT_EQ(miss(want), 0);
}

TEST_F(WantsTest, WhatIsAvoidedMustNotHappen_InItsTime) {
    Happening want = happening(sim::Trigger::Kind::contact, "cue", "one");
    want.at_least = want.at_most = 0;
    EXPECT_EQ(miss(want), 1);
    want.by = 0.6;
    EXPECT_EQ(miss(want), 0);
    want.by = 0.8;
    EXPECT_EQ(miss(want), 1);
}

TEST_F(WantsTest, PlaceAtRest_IsMissedByTheDistanceBeyondItsCircle) {
    outcome_.states[0].position = Vec3(0.3, 0.4, 0.03);
    EXPECT_NEAR(miss(RestPlace{"cue", {0, 0}, 0.1}), 0.4, 1e-12);
    EXPECT_EQ(miss(RestPlace{"cue", {0, 0}, 0.6}), 0);
    outcome_.states[0].position.z = -0.4;  // in a pocket
    EXPECT_GT(miss(RestPlace{"cue", {0, 0}, 0.6}), 5);
}

TEST_F(WantsTest, FlightClears_WhatLiesUnderIt) {
    world_.bodies[2].pose.position = Vec3(0.5, 0.01, 0.03);
    outcome_.events = {event(EventKind::strike, 0, "cue"),
                       event(EventKind::airborne, 0, "cue", "", {0, 0, 0.03}),
                       event(EventKind::impact, 0.2, "cue", "cloth", {0.9, 0, 0})};
    EXPECT_EQ(miss(Clearing{"cue", "eight"}), 0);
    world_.bodies[2].pose.position = Vec3(1.2, 0, 0.03);
    EXPECT_NEAR(miss(Clearing{"cue", "eight"}), 0.3 - 0.5 * 0.028575, 1e-9);
    outcome_.events.insert(outcome_.events.begin() + 1,
                           event(EventKind::impact, 0, "eight", "cue"));
    EXPECT_EQ(miss(Clearing{"cue", "eight"}), 1);
}

TEST_F(WantsTest, Watch_TellsAtWhichEventAllIsDecided) {
    Happening pot = happening(sim::Trigger::Kind::potted, "one");
    Happening rail = happening(sim::Trigger::Kind::contact, "cue", "cushion");
    rail.at_least = 2;
    rail.before = happening(sim::Trigger::Kind::contact, "cue", "one").trigger;
    std::vector<Want> wants{pot, rail};
    Watch watch(wants, 0);
    std::vector<bool> met;
    for (const Event& each : outcome_.events) {
        watch.see(each);
        met.push_back(watch.is_met());
    }
    EXPECT_FALSE(watch.has_failed());
    EXPECT_EQ(met, (std::vector<bool>{false, false, false, false, false, false, false, true}));

    std::get<Happening>(wants[1]).at_least = 3;
    Watch failing(wants, 0);
    for (const Event& each : outcome_.events) {
        failing.see(each);
        EXPECT_EQ(failing.has_failed(), each.time >= 1.7);
    }
}

}  // namespace
}  // namespace carom::pipeline::solve
