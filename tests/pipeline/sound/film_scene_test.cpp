#include "pipeline/sound/film_scene.h"

#include <cmath>

#include <gmock/gmock.h>

#include "pipeline/sound/film_levels.h"
#include "pipeline/video/sound_length.h"
#include "sound/mix/auralisation.h"
#include "sound/source/defaults.h"
#include "tests/pipeline/camera/rig_fixture.h"

namespace carom::pipeline {
namespace {

TEST(SoundLength, IsTheNearestNumberOfSamples) {
    EXPECT_EQ(first_sample(240, 24), 480000);
    EXPECT_EQ(first_sample(1, {24000, 1001}), 2002);
    EXPECT_EQ(first_sample(1, {30000, 1001}), 1602);  // 1601.6
    EXPECT_EQ(first_sample(5, {30000, 1001}), 8008);
    EXPECT_EQ(first_sample(0, 24), 0);
    EXPECT_EQ(first_sample(3600LL * 60, 60), 172800000);
}

/// A ball on a table, a tile, and one camera for two seconds.
Shot small_shot() {
    Shot shot;
    shot.world.table = sim::billiards::TableMeasures{};
    shot.world.floor_height = -0.75;
    sim::Body ball;
    ball.name = "cue";
    ball.shape = sim::Sphere{0.03};
    ball.mass = 0.2;
    ball.pose.position = {0, 0, 0.03};
    shot.world.bodies.push_back(ball);
    sim::Body tile;
    tile.name = "tile";
    tile.shape = sim::Box{{0.01, 0.03, 0.06}};
    tile.material = "tile";
    tile.mass = 0.02;
    shot.world.bodies.push_back(tile);
    sim::Body ramp;
    ramp.name = "ramp";
    ramp.shape = sim::Cylinder{0.1, 0.5};
    ramp.material = "steel";
    ramp.kind = sim::BodyKind::fixed;
    shot.world.bodies.push_back(ramp);
    CameraRig rig = fixture_rig();
    rig.video_start = 0;
    rig.video_end = 2;
    rig.time_map = {0, 2};
    shot.cameras = {rig};
    shot.timing.fps = 25;
    return shot;
}

TEST(FilmScene, Bodies_HaveTheirShapesMassesAndMaterials) {
    Shot shot = small_shot();
    shot.sound.materials = {{"tile", 8e9, std::nullopt, 0.05, {}, {}},
                            {"cushion", {}, {}, {}, 0.004, std::vector<sound::Mode>{{100, 5, 1}}}};
    const sim::Timeline timeline;
    const sound::SoundScene scene = film_scene(shot, timeline, 0, 50);
    EXPECT_EQ(scene.frames, 96000);
    ASSERT_EQ(scene.shots.size(), 1U);
    const sound::SoundShot& found = scene.shots[0];
    EXPECT_EQ(found.timeline, &timeline);
    EXPECT_TRUE(found.has_bed);
    EXPECT_EQ(found.room.floor_centre.z, -0.75);
    ASSERT_EQ(found.bodies.size(), 3U);
    EXPECT_EQ(std::get<sound::BallShape>(found.bodies[0].shape).radius, 0.03);
    EXPECT_EQ(found.bodies[0].mass, 0.2);
    EXPECT_EQ(found.bodies[0].position, Vec3(0, 0, 0.03));
    EXPECT_EQ(std::get<sound::BoxShape>(found.bodies[1].shape).size, Vec3(0.01, 0.03, 0.06));
    EXPECT_EQ(found.bodies[1].material.modulus, 8e9);
    EXPECT_EQ(found.bodies[1].material.poisson, sound::default_material("tile").poisson);
    EXPECT_EQ(found.bodies[1].material.loss, 0.05);
    EXPECT_EQ(found.bodies[2].material, sound::default_material("steel"));
    EXPECT_TRUE(std::isinf(found.bodies[2].mass));
    EXPECT_NEAR(std::get<sound::OtherShape>(found.bodies[2].shape).volume, 0.0157, 1e-4);
    EXPECT_EQ(found.resonators.cushion.contact, 0.004);
    EXPECT_EQ(found.resonators.cushion.modes.size(), 1U);
    EXPECT_EQ(found.resonators.bed, sound::default_resonators(0.2).bed);
    // Without the value of the shot, a cushion touches this ball for pi sqrt(m / k).
    shot.sound.materials.clear();
    EXPECT_NEAR(sound_shot(shot, timeline, {}).resonators.cushion.contact,
                M_PI * std::sqrt(0.2 / 55e3), 1e-12);
}

TEST(FilmScene, AnImpact_IsHeardWhenTheFilmShowsIt) {
    const Shot shot = small_shot();
    sim::Timeline timeline;
    timeline.end_time = 2;
    sim::Event impact;
    impact.time = 1.5;
    impact.a = "cue";
    impact.b = "cushion";
    impact.normal = {-1, 0, 0};
    impact.place = {0.03, 0, 0.03};
    impact.normal_impulse = 0.1;
    timeline.events.push_back(impact);
    const auto all = sound::audible_impacts(film_scene(shot, timeline, 0, 50));
    ASSERT_EQ(all.size(), 1U);
    EXPECT_NEAR(all[0].film_time, 1.5, 1e-12);
    // In a film of its frames from 1 s on it comes half a second after the start.
    const auto part = sound::audible_impacts(film_scene(shot, timeline, 25, 25));
    ASSERT_EQ(part.size(), 1U);
    EXPECT_NEAR(part[0].film_time, 0.5, 1e-12);
    EXPECT_TRUE(sound::audible_impacts(film_scene(shot, timeline, 0, 37)).empty());
}

TEST(FilmLevels, AnImpact_IsLoudWhereTheFilmShowsIt) {
    Shot shot = small_shot();
    shot.sound.room.kind = sound::RoomSettings::Kind::none;
    sim::Timeline timeline;
    timeline.end_time = 2;
    sim::Event impact;
    impact.time = 1.52;
    impact.a = "cue";
    impact.b = "cushion";
    impact.normal = {-1, 0, 0};
    impact.place = {0.03, 0, 0.03};
    impact.normal_impulse = 1;
    timeline.events.push_back(impact);
    const FilmLevels levels = film_levels(shot, timeline);
    EXPECT_EQ(levels.length, 2);
    ASSERT_EQ(levels.decibels.size(), 40U);
    EXPECT_TRUE(std::isinf(levels.decibels[29]));
    EXPECT_GT(levels.decibels[30], -30);
    EXPECT_LT(levels.decibels[30], 0);
    EXPECT_LT(levels.decibels[31], levels.decibels[30]);
    shot.sound.is_silent = true;
    EXPECT_TRUE(film_levels(shot, timeline).decibels.empty());
}

TEST(FilmScene, SilentShot_HasNoClips) {
    Shot shot = small_shot();
    shot.sound.is_silent = true;
    const sim::Timeline timeline;
    EXPECT_TRUE(film_scene(shot, timeline, 0, 50).shots[0].clips.empty());
}

}  // namespace
}  // namespace carom::pipeline
