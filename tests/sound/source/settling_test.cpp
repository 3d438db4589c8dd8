#include "sound/source/settling.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace carom::sound {
namespace {

constexpr double kGravity = 9.81;

/// Boxes that are described a little above each other, and the log of what becomes of them.
struct Shot {
    sim::Timeline timeline;
    SoundShot shot;

    Shot() {
        timeline.end_time = 10;
        shot.timeline = &timeline;
    }
    Shot(const Shot&) = delete;
    Shot& operator=(const Shot&) = delete;
    Shot(Shot&&) = delete;
    Shot& operator=(Shot&&) = delete;
    ~Shot() = default;

    void add(const std::string& name, const std::vector<sim::Key>& keys, double mass = 1) {
        SoundBody body;
        body.name = name;
        body.shape = BoxShape{{0.1, 0.1, 0.1}};
        body.mass = mass;
        shot.bodies.push_back(body);
        if (!keys.empty()) {
            timeline.tracks.emplace_back(name, keys);
        }
    }

    /// Falls from rest by `depth` (m) and lies there.
    void add_falling(const std::string& name, double depth) {
        const double time = std::sqrt(2 * depth / kGravity);
        sim::Key start;
        start.position = {0, 0, depth};
        sim::Key end;
        end.time = time;
        end.velocity_in = {0, 0, -kGravity * time};
        add(name, {start, end});
    }

    void log(const std::string& a, const std::string& b, double time,
             sim::EventKind kind = sim::EventKind::impact) {
        sim::Event event;
        event.kind = kind;
        event.time = time;
        event.a = a;
        event.b = b;
        event.normal_impulse = 0.01;
        timeline.events.push_back(event);
    }

    [[nodiscard]] std::vector<bool> settling() const { return settling_contacts(shot); }
};

TEST(Settling, FallThatNobodySees_IsSilentAndAVisibleOneIsNot) {
    for (const double depth : {1e-6, 25e-6, 1e-3, 3e-3}) {
        Shot shot;
        shot.add_falling("box", depth);
        shot.log("box", "cloth", std::sqrt(2 * depth / kGravity));
        shot.log("box", "cloth", 1);
        const bool is_small = depth < kSettlingWay;
        EXPECT_EQ(shot.settling(), (std::vector<bool>{is_small, is_small})) << depth;
    }
}

TEST(Settling, BodiesThatSettleOnEachOther_AreSilentUntilSomethingHappens) {
    Shot shot;
    shot.add_falling("low", 1e-4);
    shot.add_falling("high", 2e-4);
    shot.add("table", {});
    shot.log("low", "table", 0.006);
    shot.log("low", "high", 0.007);
    shot.log("high", "", 1, sim::EventKind::impulse);
    shot.log("low", "high", 1.001);
    shot.log("low", "table", 1.002);
    EXPECT_EQ(shot.settling(), (std::vector<bool>{true, true, false, false, false}));
}

// The ball moves from the beginning, the tower has not moved visibly when it is hit, and passes the
// blow on.
TEST(Settling, BlowFromOutside_IsHeardThroughTheWholeTower) {
    Shot shot;
    sim::Key start;
    start.velocity_in = start.velocity_out = {1, 0, 0};
    sim::Key end = start;
    end.time = 1;
    end.position = {1, 0, 0};
    shot.add("ball", {start, end});
    shot.add_falling("near", 1e-4);
    shot.add_falling("middle", 1e-4);
    shot.add_falling("far", 1e-4);
    shot.log("near", "cloth", 0.01);
    shot.log("near", "middle", 0.02);
    shot.log("ball", "near", 1);
    shot.log("near", "middle", 1);
    shot.log("middle", "far", 1);
    EXPECT_EQ(shot.settling(), (std::vector<bool>{true, true, false, false, false}));
}

TEST(Settling, WhatKeysMove_DoesNotSettle) {
    constexpr double kFixed = std::numeric_limits<double>::infinity();
    Shot shot;
    sim::Key start;
    sim::Key moved = start;
    moved.time = 2;
    moved.position = {1e-3, 0, 0};
    shot.add("plank", {start, moved}, kFixed);
    shot.add_falling("ball", 25e-6);
    shot.log("ball", "plank", 0.0);
    shot.log("ball", "plank", 1);
    EXPECT_EQ(shot.settling(), (std::vector<bool>{false, false}));
    Shot still;
    still.add("plank", {start}, kFixed);
    still.add_falling("ball", 25e-6);
    still.log("ball", "plank", 0.0023);
    EXPECT_EQ(still.settling(), std::vector<bool>{true});
}

TEST(Settling, TurnOfABody_IsSeenAtItsEdge) {
    for (const double angle : {0.01, 0.05}) {  // 0.9 mm and 4.3 mm
        Shot shot;
        sim::Key start;
        sim::Key turned = start;
        turned.time = 0.1;
        turned.orientation = Quat(std::cos(angle / 2), 0, std::sin(angle / 2), 0);
        shot.add("box", {start, turned});
        shot.log("box", "cloth", 0.1);
        EXPECT_EQ(shot.settling(), std::vector<bool>{angle < 0.02});
    }
}

// Nothing has moved at all: whoever wrote such a log wants the blow to be heard.
TEST(Settling, BlowsWithoutAnyMotion_AreNoSettling) {
    Shot shot;
    shot.add("one", {sim::Key{}});
    shot.add("two", {sim::Key{}});
    shot.log("one", "two", 1);
    EXPECT_EQ(shot.settling(), std::vector<bool>{false});
}

}  // namespace
}  // namespace carom::sound
