#include "pipeline/export/timeline_csv.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"

namespace carom::pipeline {
namespace {

sim::Key key_at(double time, double x, double v_in, double v_out) {
    sim::Key key;
    key.time = time;
    key.position = {x, 0, 0.028575};
    key.velocity_in = {v_in, 0, 0};
    key.velocity_out = {v_out, 0, 0};
    return key;
}

/// A ball that moves 1 m in 1 s, immediately rebounds and returns at half the speed; and a ball at
/// rest.
sim::Timeline there_and_back() {
    sim::Timeline timeline;
    timeline.start_time = 0;
    timeline.end_time = 3;
    timeline.tracks.emplace_back(
        "cue",
        std::vector<sim::Key>{key_at(0, 0, 1, 1), key_at(1, 1, 1, -0.5), key_at(3, 0, -0.5, -0.5)});
    timeline.tracks.emplace_back("nine, the \"money\" ball",
                                 std::vector<sim::Key>{key_at(0, 2, 0, 0)});
    return timeline;
}

std::int64_t lines_of(const std::string& text) {
    return std::count(text.begin(), text.end(), '\n');
}

TEST(KeysToCsv, VelocityJump_GivesTwoRows) {
    EXPECT_EQ(keys_to_csv(there_and_back()),
              "object,time,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz\n"
              "cue,0,0,0,0.028575,1,0,0,0,1,0,0,0,0,0\n"
              "cue,1,1,0,0.028575,1,0,0,0,1,0,0,0,0,0\n"
              "cue,1,1,0,0.028575,1,0,0,0,-0.5,0,0,0,0,0\n"
              "cue,3,0,0,0.028575,1,0,0,0,-0.5,0,0,0,0,0\n"
              "\"nine, the \"\"money\"\" ball\",0,2,0,0.028575,1,0,0,0,0,0,0,0,0,0\n");
}

TEST(SamplesToCsv, EvenRate_IncludesBothEndsAndTheLeavingVelocity) {
    sim::Timeline timeline = there_and_back();
    timeline.tracks.pop_back();
    EXPECT_EQ(samples_to_csv(timeline, 1),
              "object,time,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz\n"
              "cue,0,0,0,0.028575,1,0,0,0,1,0,0,0,0,0\n"
              "cue,1,1,0,0.028575,1,0,0,0,-0.5,0,0,0,0,0\n"
              "cue,2,0.5,0,0.028575,1,0,0,0,-0.5,0,0,0,0,0\n"
              "cue,3,0,0,0.028575,1,0,0,0,-0.5,0,0,0,0,0\n");
}

TEST(SamplesToCsv, EndMissedByRounding_IsIncluded) {
    sim::Timeline timeline = there_and_back();
    timeline.end_time = 0.7;  // 0.7 * 10 is a little under 7 in doubles
    timeline.tracks.pop_back();
    EXPECT_EQ(lines_of(samples_to_csv(timeline, 10)), 1 + 8);
    timeline.end_time = 0.75;
    EXPECT_EQ(lines_of(samples_to_csv(timeline, 10)), 1 + 8);
}

TEST(SamplesToCsv, InvalidRates_AreErrors) {
    const sim::Timeline timeline = there_and_back();
    for (const double rate : {0.0, -1.0, std::nan(""), 2e6, HUGE_VAL}) {
        EXPECT_THROW(static_cast<void>(samples_to_csv(timeline, rate)), Error) << rate;
    }
    sim::Timeline hour = timeline;
    hour.end_time = 3600;
    EXPECT_THROW(static_cast<void>(samples_to_csv(hour, 1e5)), Error);
}

TEST(SamplesToCsv, EmptyTimeline_GivesOnlyTheHeader) {
    EXPECT_EQ(lines_of(samples_to_csv(sim::Timeline{}, 10)), 1);
    EXPECT_EQ(lines_of(keys_to_csv(sim::Timeline{})), 1);
    EXPECT_EQ(lines_of(events_to_csv(sim::Timeline{})), 1);
}

TEST(EventsToCsv, EachEvent_IsOneRow) {
    sim::Timeline timeline;
    sim::Event impact;
    impact.kind = sim::EventKind::impact;
    impact.time = 0.75;
    impact.a = "cue";
    impact.b = "one";
    impact.place = {0.5, -0.25, 0.028575};
    impact.normal = {-1, 0, 0};
    impact.normal_impulse = 1.5;
    impact.tangential_impulse = 0.0625;
    sim::Event potted;
    potted.kind = sim::EventKind::potted;
    potted.time = 2;
    potted.a = "one";
    potted.b = "corner, left";
    sim::Event strike;
    strike.kind = sim::EventKind::strike;
    strike.a = "cue";
    strike.normal_impulse = 0.5;
    strike.vector = {2, -1, 0.25};
    timeline.events = {strike, impact, potted};
    EXPECT_EQ(events_to_csv(timeline),
              "time,kind,a,b,x,y,z,nx,ny,nz,normal_impulse,tangential_impulse,vector_x,vector_y,"
              "vector_z\n"
              "0,strike,cue,,0,0,0,0,0,0,0.5,0,2,-1,0.25\n"
              "0.75,impact,cue,one,0.5,-0.25,0.028575,-1,0,0,1.5,0.0625,0,0,0\n"
              "2,potted,one,\"corner, left\",0,0,0,0,0,0,0,0,0,0,0\n");
}

TEST(ContactsToCsv, EachContact_IsOneRow) {
    sim::Timeline timeline;
    timeline.lasting_contacts = {{"tile, left", "floor", 0.25, 0.5, 1.75, 0.125},
                                 {"cue", "one", 0.375, 1, 2, 0}};
    EXPECT_EQ(contacts_to_csv(timeline),
              "from,to,a,b,normal_force,slip\n"
              "0.25,0.5,\"tile, left\",floor,1.75,0.125\n"
              "0.375,1,cue,one,2,0\n");
}

}  // namespace
}  // namespace carom::pipeline
