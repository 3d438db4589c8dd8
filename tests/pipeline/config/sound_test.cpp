// Tests of the section sound, of a shot and of its cameras.
#include <cmath>

#include <gmock/gmock.h>

#include "pipeline/config/explain.h"
#include "sim/bake.h"
#include "sound/space/room.h"
#include "tests/pipeline/config/load.h"
#include "tests/pipeline/config/shot_text.h"

namespace carom::pipeline {
namespace {

using sound::Group;
using ::testing::ContainsRegex;
using ::testing::Not;

SoundSettings read_sound(const std::string& keys) {
    return load_sections("balls: {cue: {at: [0, 0]}}\nsound: " + keys + "\n").sound;
}

CameraSound read_camera_sound(const std::string& keys) {
    const Shot shot = load_sections(
        "cameras: [{video: [0 s, 1 s], scene: 0 s, position: [0, -2, 1], target: [0, 0, 0], "
        "sound: " +
        keys + "}]\n");
    return shot.cameras.empty() ? CameraSound{} : shot.cameras[0].sound;
}

std::optional<double> level(const CameraSound& sound, Group group) {
    return sound.mix.at(static_cast<std::size_t>(group));
}

TEST(Sound, WithoutTheSection_EverythingIsUsual) {
    const Shot shot = load_sections("");
    EXPECT_FALSE(shot.sound.is_silent);
    EXPECT_EQ(shot.sound.room, sound::RoomSettings{});
    EXPECT_EQ(shot.sound.bed_reflection, 0.85);
    EXPECT_FALSE(shot.sound.full_scale);
    EXPECT_FALSE(shot.sound.loudness);
    EXPECT_FALSE(shot.sound.cameras.pitch);
    EXPECT_FALSE(shot.cameras.at(0).sound.gain);
}

TEST(Sound, Keys_FillTheirFields) {
    const SoundSettings sound = read_sound(R"(
  room: {size: [12 m, 9 m, 350 cm], reverberation: [0.9 s, 500 ms]}
  bed: 0.5
  listener: {at: [0, -1.2, 60 cm], facing: [0, 2, 0]}
  stereo: pan
  width: real
  pitch: 0.25
  lowest: 1/40
  reverse: forward
  delay: false
  dynamics: 3
  gain: {full_scale: 20 Pa}
  mix: {balls: 1 dB, cushions: 2 dB, cloth: 3 dB, stick: 4 dB, pockets: 5 dB, objects: 6 dB,
        rolling: -7 dB}
  materials:
    ball: {modulus: 9 GPa, poisson: 0.3, loss: 0.03}
    cushion: {contact: 5 ms, modes: [{frequency: 140 Hz, q: 5, gain: 0.3}]}
    tip: {modes: []})");
    EXPECT_EQ(sound.room.kind, sound::RoomSettings::Kind::box);
    EXPECT_EQ(sound.room.size, Vec3(12, 9, 3.5));
    EXPECT_EQ(sound.room.reverberation_low, 0.9);
    EXPECT_EQ(sound.room.reverberation_high, 0.5);
    EXPECT_EQ(sound.bed_reflection, 0.5);
    EXPECT_EQ(sound.full_scale, 20);
    const CameraSound& all = sound.cameras;
    ASSERT_TRUE(all.listener);
    EXPECT_FALSE(all.listener->is_camera);
    EXPECT_EQ(all.listener->at, Vec3(0, -1.2, 0.6));
    EXPECT_EQ(all.listener->facing, Vec3(0, 2, 0));
    EXPECT_EQ(all.stereo, sound::Stereo::pan);
    EXPECT_EQ(all.width, sound::Width::real);
    EXPECT_EQ(all.pitch, 0.25);
    EXPECT_EQ(all.lowest, 1.0 / 40);
    EXPECT_EQ(all.mirrors_reverse, false);
    EXPECT_EQ(all.has_delay, false);
    EXPECT_EQ(all.ratio, 3);
    EXPECT_EQ(level(all, Group::balls), 1);
    EXPECT_EQ(level(all, Group::cushions), 2);
    EXPECT_EQ(level(all, Group::cloth), 3);
    EXPECT_EQ(level(all, Group::stick), 4);
    EXPECT_EQ(level(all, Group::pockets), 5);
    EXPECT_EQ(level(all, Group::objects), 6);
    EXPECT_EQ(level(all, Group::rolling), -7);
    ASSERT_EQ(sound.materials.size(), 3U);
    EXPECT_EQ(sound.materials[0].name, "ball");
    EXPECT_EQ(sound.materials[0].modulus, 9e9);
    EXPECT_EQ(sound.materials[0].poisson, 0.3);
    EXPECT_EQ(sound.materials[0].loss, 0.03);
    EXPECT_FALSE(sound.materials[0].contact);
    EXPECT_EQ(sound.materials[1].contact, 0.005);
    EXPECT_EQ(sound.materials[1].modes, std::vector{(sound::Mode{140, 5, 0.3})});
    EXPECT_FALSE(sound.materials[1].modulus);
    ASSERT_TRUE(sound.materials[2].modes);
    EXPECT_TRUE(sound.materials[2].modes->empty());
}

TEST(Sound, Words_StandForNumbers) {
    const SoundSettings usual = read_sound(
        "{listener: camera, stereo: sphere, width: frame, pitch: follow, reverse: mirrored, "
        "dynamics: film, gain: auto}");
    EXPECT_TRUE(usual.cameras.listener.value().is_camera);
    EXPECT_EQ(usual.cameras.stereo, sound::Stereo::sphere);
    EXPECT_EQ(usual.cameras.width, sound::Width::frame);
    EXPECT_EQ(usual.cameras.pitch, 1);
    EXPECT_EQ(usual.cameras.mirrors_reverse, true);
    EXPECT_EQ(usual.cameras.ratio, 2);
    EXPECT_FALSE(usual.full_scale);
    const SoundSettings other =
        read_sound("{stereo: mono, pitch: keep, dynamics: natural, loudness: -16 LUFS}");
    EXPECT_EQ(other.cameras.stereo, sound::Stereo::mono);
    EXPECT_EQ(other.cameras.pitch, 0);
    EXPECT_EQ(other.cameras.ratio, 1);
    EXPECT_EQ(other.loudness, -16);
}

TEST(Sound, RoomNames_AreThoseOfTheLibrary) {
    for (const sound::NamedRoom& one : sound::rooms()) {
        EXPECT_EQ(read_sound("{room: " + std::string(one.name) + "}").room, one.room) << one.name;
    }
    EXPECT_EQ(read_sound("{room: {size: [8, 6, 2.8]}}").room, sound::RoomSettings{});
}

TEST(Sound, None_IsSilent) {
    EXPECT_TRUE(read_sound("none").is_silent);
    const double gain = read_camera_sound("none").gain.value();
    EXPECT_TRUE(std::isinf(gain) && gain < 0);
}

TEST(Sound, CameraKeys_LeaveTheRestToTheFilm) {
    const CameraSound sound = read_camera_sound(
        "{gain: -6 dB, pitch: keep, listener: {at: [1, 2, 3]}, mix: {stick: 3 dB}}");
    EXPECT_EQ(sound.gain, -6);
    EXPECT_EQ(sound.pitch, 0);
    EXPECT_EQ(sound.listener.value().at, Vec3(1, 2, 3));
    EXPECT_EQ(level(sound, Group::stick), 3);
    EXPECT_FALSE(level(sound, Group::balls));
    EXPECT_FALSE(sound.lowest);
    EXPECT_FALSE(sound.stereo);
    EXPECT_FALSE(sound.ratio);
}

TEST(Sound, Overrides_ReachEveryDepth) {
    const Shot shot = load("carom: 1\n" + kCamera + "sound: {room: hall, gain: auto}\n",
                           {"sound.room=none", "sound.gain.full_scale=20Pa", "sound.bed=0",
                            "sound.mix.rolling=-3 dB"});
    EXPECT_EQ(shot.sound.room.kind, sound::RoomSettings::Kind::none);
    EXPECT_EQ(shot.sound.full_scale, 20);
    EXPECT_EQ(shot.sound.bed_reflection, 0);
    EXPECT_EQ(level(shot.sound.cameras, Group::rolling), -3);
}

TEST(Sound, ZeroLevels_NeedTheirUnit) {
    EXPECT_EQ(first_problem("carom: 1\nsound: {mix: {balls: 0}}\n" + kCamera),
              "'balls' is a level and needs a unit; write '0 dB'");
    EXPECT_EQ(level(read_sound("{mix: {balls: 0 dB}}").cameras, Group::balls), 0);
}

TEST(Sound, ResolvedText_GivesTheSameShotAgain) {
    const Shot shot = load_sections(R"(
balls: {cue: {at: [0, 0]}}
cameras:
  - {video: [0 s, 1 s], scene: 0 s, position: [0, -2, 1], target: [0, 0, 0], sound: {gain: -6 dB}}
  - {video: [1 s, 2 s], scene: 0 s, position: [0, -2, 1], target: [0, 0, 0], sound: none}
sound:
  room: {size: [9, 8, 3], reverberation: [1 s, 1/3 s]}
  listener: {at: [1, 1, 1]}
  dynamics: 1.5
  materials: {ball: {modulus: 6.1 GPa}, pocket: {contact: 2 ms}}
)");
    EXPECT_NE(shot.resolved_text.find("6.1 GPa"), std::string::npos);
    EXPECT_EQ(shot_text(load(shot.resolved_text)), shot_text(shot));
}

std::string explained(const std::string& sections) {
    const LoadResult loaded = load_shot_text("carom: 1\n" + kCamera + sections, "s.yaml");
    return loaded.source ? explained_yaml(*loaded.source, *loaded.shot) : all_problems(loaded);
}

TEST(Sound, ExplainedShot_HasItsDefaults) {
    const std::string text = explained("");
    for (const char* line :
         {"room: club", "bed: 0.85", "listener: camera", "stereo: sphere", "width: frame",
          "pitch: follow", "lowest: 0.125", "reverse: mirrored", "delay: true", "dynamics: film",
          "gain: auto", "mix:\n    balls: 0 dB"}) {
        EXPECT_THAT(text,
                    ContainsRegex("\nsound:\n(  .*\n)*  " + std::string(line) + " +# default"));
    }
    const std::string given = explained("sound: {room: {size: [5, 5, 3]}, pitch: keep}\n");
    EXPECT_THAT(given, ContainsRegex("\n  pitch: keep +# s.yaml:3\n"));
    EXPECT_THAT(given, ContainsRegex("\n    reverberation: \\[0.6 s, 0.35 s\\] +# default\n"));
    EXPECT_THAT(explained("sound: none\n"), Not(ContainsRegex("room:")));
}

TEST(Sound, PhysicsHash_DoesNotDependOnIt) {
    const std::string balls = "balls: {cue: {at: [0, 0], velocity: [1, 0]}}\n";
    const Shot shot = load_sections(balls);
    for (const char* sound : {"none", "{room: none, bed: 0, gain: {full_scale: 1 Pa}}",
                              "{materials: {ball: {modulus: 1 GPa}}}"}) {
        const Shot other = load_sections(balls + "sound: " + sound + "\n");
        EXPECT_EQ(sim::physics_hash(other.world), sim::physics_hash(shot.world)) << sound;
    }
}

}  // namespace
}  // namespace carom::pipeline
