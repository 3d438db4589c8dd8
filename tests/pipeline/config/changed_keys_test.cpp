#include "pipeline/config/changed_keys.h"

#include <gmock/gmock.h>

namespace carom::pipeline {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const std::string kShot =
    "carom: 1\n"
    "simulation: {duration: 2 s}\n"
    "balls: {cue: {at: [0, 0], look: {number: 1}}, one: {at: [1, 0]}}\n"
    "objects: {tile: {box: [1, 1, 1], material: brass, physics: {density: 700 kg/m^3}}}\n"
    "events: [{strike: {ball: cue, speed: 3}}, {impulse: {object: one}}]\n"
    "cameras: [{fov: 3}]\n";

std::vector<std::string> changes(const std::string& from, const std::string& to) {
    std::string changed = kShot;
    changed.replace(changed.find(from), from.size(), to);
    return changed_physics_keys(kShot, changed);
}

TEST(ChangedKeys, SameText_HasNoChangedKeys) {
    EXPECT_THAT(changed_physics_keys(kShot, kShot), IsEmpty());
    EXPECT_THAT(changed_physics_keys(kShot, "# remark\n" + kShot), IsEmpty());
}

TEST(ChangedKeys, Value_IsNamedByItsPath) {
    EXPECT_THAT(changes("speed: 3", "speed: 4"), ElementsAre("events[0].strike.speed"));
    EXPECT_THAT(changes("[1, 0]", "[1, 2]"), ElementsAre("balls.one.at[1]"));
    EXPECT_THAT(changes("[1, 0]", "[1, 0, 2]"), ElementsAre("balls.one.at"));
}

TEST(ChangedKeys, AddedOrRemovedKey_IsNamedAsAWhole) {
    EXPECT_THAT(changes("balls: {", "balls: {two: {at: [2, 2]}, "), ElementsAre("balls.two"));
    EXPECT_THAT(changes("simulation: {duration: 2 s}\n", ""), ElementsAre("simulation"));
    EXPECT_THAT(changes(", {impulse: {object: one}}", ""), ElementsAre("events"));
}

TEST(ChangedKeys, Look_IsIgnored) {
    EXPECT_THAT(changes("fov: 3", "fov: 4"), IsEmpty());
    EXPECT_THAT(changes("number: 1", "number: 2"), IsEmpty());
    EXPECT_THAT(changes("material: brass", "material: wood"), IsEmpty());
}

TEST(ChangedKeys, MotionByKeys_IsComparedWhereItTakesPartInThePhysics) {
    const auto door = [](const std::string& angle, const std::string& physics) {
        return "objects: {door: {box: [1, 1, 1], motion: {keys: [{turn: " + angle + "}]}" +
               physics + "}}\n";
    };
    const std::string physics = ", physics: true";
    EXPECT_THAT(changed_physics_keys(door("1 rad", ""), door("2 rad", "")), IsEmpty());
    EXPECT_THAT(changed_physics_keys(door("1 rad", physics), door("2 rad", physics)),
                ElementsAre("objects.door.motion.keys[0].turn"));
}

TEST(ChangedKeys, TextThatCannotBeRead_HasNoKeys) {
    EXPECT_THAT(changed_physics_keys("a: [", "a: ["), IsEmpty());
    EXPECT_THAT(changed_physics_keys("", "rack: {set: nine_ball}"), ElementsAre("rack"));
}

}  // namespace
}  // namespace carom::pipeline
