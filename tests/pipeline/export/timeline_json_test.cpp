#include "pipeline/export/timeline_json.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "sim/timeline/event_fields.h"
#include "sim/timeline/track_fields.h"
#include "tests/pipeline/export/sample_scene.h"

namespace carom::pipeline {
namespace {

using Json = nlohmann::json;

const carom::testing::SampleScene& sample() {
    static const carom::testing::SampleScene scene = carom::testing::sample_scene();
    return scene;
}

Json json(std::optional<double> rate = std::nullopt) {
    return Json::parse(timeline_json(sample().shot, sample().timeline, sample().scene, rate));
}

Vec3 vector(const Json& list) {
    return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

TEST(TimelineJson, Tracks_EqualTheTimelinesBitByBit) {
    const Json document = json();
    ASSERT_EQ(document["tracks"].size(), sample().timeline.tracks.size());
    for (std::size_t i = 0; i < document["tracks"].size(); ++i) {
        const sim::Track& track = sample().timeline.tracks[i];
        const Json& keys = document["tracks"][i]["keys"];
        ASSERT_EQ(keys.size(), track.keys().size());
        for (std::size_t k = 0; k < keys.size(); ++k) {
            const sim::Key& key = track.keys()[k];
            EXPECT_EQ(keys[k]["time"].get<double>(), key.time);
            EXPECT_EQ(vector(keys[k]["position"]), key.position);
            EXPECT_EQ(vector(keys[k]["velocity"]), key.velocity_out);
            EXPECT_EQ(keys[k]["orientation"][0].get<double>(), key.orientation.r);
            EXPECT_EQ(keys[k].contains("velocity_before"), key.is_break());
            if (key.is_break()) {
                EXPECT_EQ(vector(keys[k]["velocity_before"]), key.velocity_in);
            }
        }
    }
}

TEST(TimelineJson, PutBacks_AreListed) {
    const Json document = json();
    ASSERT_EQ(document["put_backs"].size(), 1U);
    EXPECT_EQ(document["put_backs"][0]["ball"], "two");
    EXPECT_EQ(document["put_backs"][0]["time"], 0.33);
    EXPECT_EQ(vector(document["put_backs"][0]["to"]), Vec3(0.4, -0.2, 0.028575));
    const auto is_placed = [](const Json& event) { return event["kind"] == "placed"; };
    EXPECT_EQ(std::ranges::count_if(document["events"], is_placed), 1);
    sim::Timeline without = sample().timeline;
    without.put_backs.clear();
    EXPECT_FALSE(Json::parse(timeline_json(sample().shot, without, sample().scene, std::nullopt))
                     .contains("put_backs"));
}

TEST(TimelineJson, LastingContacts_AreListed) {
    sim::Timeline timeline = sample().timeline;
    timeline.lasting_contacts.clear();
    const Json without =
        Json::parse(timeline_json(sample().shot, timeline, sample().scene, std::nullopt));
    EXPECT_FALSE(without.contains("lasting_contacts"));
    timeline.lasting_contacts = {{"tile", "floor", 0.25, 0.5, 1.75, 0.125}};
    const Json document =
        Json::parse(timeline_json(sample().shot, timeline, sample().scene, std::nullopt));
    EXPECT_EQ(document["lasting_contacts"], Json::array({{{"a", "tile"},
                                                          {"b", "floor"},
                                                          {"from", 0.25},
                                                          {"to", 0.5},
                                                          {"normal_force", 1.75},
                                                          {"slip", 0.125}}}));
}

TEST(TimelineJson, Rate_GivesEvenSamples) {
    const Json document = json(10);
    EXPECT_EQ(document["tracks"][0]["keys"].size(), 7U);
    EXPECT_FALSE(document["tracks"][0]["keys"][3].contains("velocity_before"));
    EXPECT_THROW((void)json(-1), Error);
}

template <class T>
void expect_fields(const Json& json, const T& described) {
    for_each_field(described, [&](const auto& field, const auto& /*value*/) {
        EXPECT_TRUE(json.contains(field.name)) << field.name;
    });
}

TEST(TimelineJson, EveryDescribedField_IsPresent) {
    const Json document = json();
    expect_fields(document["events"][0], sim::Event{});
    expect_fields(document["energy"][0], sim::EnergySample{});
    expect_fields(document["tracks"][0]["keys"][0], MotionState{});
}

TEST(TimelineJson, OtherMembers_ArePresent) {
    const Json document = json();
    EXPECT_EQ(document["carom_export"], 1);
    EXPECT_EQ(document["name"], "sample");
    EXPECT_EQ(document["events"].size(), sample().timeline.events.size());
    EXPECT_EQ(document["energy"].size(), sample().timeline.energy.size());
    EXPECT_EQ(document["objects"].size(), sample().shot.scene.objects.size());
    EXPECT_EQ(document["cameras"][0]["keys"].size(), 6U);
    EXPECT_EQ(document["cameras"][0]["keys"][0]["scene_time"], 0.6);
    for (const Json& object : document["objects"]) {
        if (object["name"] == "tile") {
            EXPECT_EQ(object["shape"], Json({{"kind", "box"}, {"size", {0.01, 0.03, 0.06}}}));
            EXPECT_EQ(object["track"], "tile");
        }
    }
}

}  // namespace
}  // namespace carom::pipeline
