// Which spheres and modes an event of the log becomes.
#include "sound/source/impact_sound.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "sound/source/contact.h"
#include "sound/source/defaults.h"
#include "sound/source/direct_sound.h"
#include "sound/source/mode_sound.h"

namespace carom::sound {
namespace {

constexpr double kRadius = 0.028575;
constexpr double kMass = 0.170097;

class ImpactSoundTest : public testing::Test {
  protected:
    ImpactSoundTest() {
        shot_.timeline = &timeline_;
        shot_.resonators = default_resonators(kMass);
        shot_.has_bed = true;
        shot_.bed_reflection = 0.5;
        shot_.bodies = {{"cue", BallShape{kRadius}, kMass, default_material("ball"), {}},
                        {"one", BallShape{kRadius}, kMass, default_material("ball"), {}},
                        {"tile_1",
                         BoxShape{{0.01, 0.032, 0.06}},
                         0.0346,
                         default_material("tile"),
                         {0, 0, 0.03}},
                        {"tile_2",
                         BoxShape{{0.01, 0.032, 0.06}},
                         0.0346,
                         default_material("tile"),
                         {0.02, 0, 0.03}},
                        {"wall",
                         BoxShape{{1, 1, 1}},
                         std::numeric_limits<double>::infinity(),
                         default_material("wood"),
                         {}}};
    }

    [[nodiscard]] std::optional<ImpactSound> sound_of(const sim::Event& event) const {
        return ImpactSounds(shot_).sound_of(event);
    }

    static sim::Event impact(const std::string& a, const std::string& b, const Vec3& place,
                             const Vec3& normal, double impulse) {
        sim::Event event;
        event.a = a;
        event.b = b;
        event.place = place;
        event.normal = normal;
        event.normal_impulse = impulse;
        return event;
    }

    sim::Timeline timeline_;
    SoundShot shot_;
};

TEST_F(ImpactSoundTest, TwoBalls_OnTheBed_AreTwoSpheresAndTheirImages) {
    const auto sound = sound_of(impact("cue", "one", {0, 0, kRadius}, {-1, 0, 0}, 0.2));
    ASSERT_TRUE(sound);
    EXPECT_EQ(sound->group, Group::balls);
    ASSERT_EQ(sound->spheres.size(), 4);
    EXPECT_EQ(sound->spheres[0].centre, Vec3(-kRadius, 0, kRadius));
    EXPECT_NEAR(sound->spheres[0].velocity_step.x, -0.2 / kMass, 1e-12);
    EXPECT_EQ(sound->spheres[1].centre, Vec3(-kRadius, 0, -kRadius));
    EXPECT_EQ(sound->spheres[1].factor, 0.5);
    EXPECT_EQ(sound->spheres[2].centre, Vec3(kRadius, 0, kRadius));
    EXPECT_NEAR(sound->spheres[2].velocity_step.x, 0.2 / kMass, 1e-12);
    EXPECT_TRUE(sound->modes.empty());
}

TEST_F(ImpactSoundTest, Ball_OnTheCloth_HasAnImageThatMovesTheOtherWay) {
    const auto sound = sound_of(impact("cue", "cloth", {0, 0, 0}, {0, 0, 1}, 0.3));
    ASSERT_TRUE(sound);
    EXPECT_EQ(sound->group, Group::cloth);
    ASSERT_EQ(sound->spheres.size(), 2);
    EXPECT_NEAR(sound->spheres[0].velocity_step.z, 0.3 / kMass, 1e-12);
    EXPECT_NEAR(sound->spheres[1].velocity_step.z, -0.3 / kMass, 1e-12);
    EXPECT_EQ(sound->modes, shot_.resonators.bed.modes);
}

TEST_F(ImpactSoundTest, Surfaces_HaveTheirContactTimesModesAndGroups) {
    const auto heard = [&](const char* surface) {
        return *sound_of(impact("cue", surface, {0, 0, 0.03}, {1, 0, 0}, 0.3));
    };
    EXPECT_EQ(heard("cushion").group, Group::cushions);
    EXPECT_EQ(heard("cushion").contact_time, shot_.resonators.cushion.contact);
    EXPECT_EQ(heard("cushion").modes, shot_.resonators.cushion.modes);
    EXPECT_EQ(heard("pocket").group, Group::pockets);
    EXPECT_EQ(heard("pocket").contact_time, 3.5e-3);
    EXPECT_EQ(heard("rail").group, Group::cushions);
    EXPECT_EQ(heard("rail").contact_time, 0.8e-3);
    EXPECT_EQ(heard("floor").group, Group::objects);
    EXPECT_EQ(heard("floor").modes, shot_.resonators.wood.modes);
}

TEST_F(ImpactSoundTest, Strike_OfABall_HasTheImpulseOfTheVelocityThatItGave) {
    sim::Event strike;
    strike.kind = sim::EventKind::strike;
    strike.a = "cue";
    strike.place = {0, 0, kRadius};
    strike.vector = {0, 3, 0};
    const auto sound = sound_of(strike);
    ASSERT_TRUE(sound);
    EXPECT_EQ(sound->group, Group::stick);
    EXPECT_NEAR(sound->impulse, 3 * kMass, 1e-15);
    EXPECT_NEAR(sound->contact_time, 1.3e-3, 1e-15);
    EXPECT_NEAR((sound->place - Vec3(0, -kRadius, kRadius)).length(), 0, 1e-15);
    EXPECT_EQ(sound->modes, shot_.resonators.stick.modes);
}

TEST_F(ImpactSoundTest, TwoBoxes_TouchWithAnEdgeThatMovesLikeAThirdOfEach) {
    const auto sound = sound_of(impact("tile_1", "tile_2", {0.01, 0, 0.05}, {-1, 0, 0}, 1e-3));
    ASSERT_TRUE(sound);
    EXPECT_EQ(sound->group, Group::objects);
    const Material plastic = default_material("tile");
    const ContactPair pair{0.0346 / 6, 0.004, reduced_modulus(plastic, plastic),
                           plastic.restitution};
    EXPECT_NEAR(sound->contact_time, hertz_contact_time(pair, 1e-3), 1e-12);
    EXPECT_NEAR(sound->contact_time, 224e-6, 1e-6);
    // Each is the sphere of its volume at its own centre, and bends along its thickness.
    ASSERT_EQ(sound->spheres.size(), 4);
    EXPECT_EQ(sound->spheres[0].centre, Vec3(0, 0, 0.03));
    EXPECT_EQ(sound->spheres[2].centre, Vec3(0.02, 0, 0.03));
    EXPECT_NEAR(std::pow(sound->spheres[0].radius, 3) * 4 * M_PI / 3, 0.01 * 0.032 * 0.06, 1e-12);
    EXPECT_EQ(sound->modes.size(), 4);
}

TEST_F(ImpactSoundTest, Box_ThatHasTurned_IsHitInItsOwnAxes) {
    sim::Key key;
    key.orientation.setAxisAngle({0, 1, 0}, M_PI / 2);  // its x now points down
    key.position = {0, 0, 0.01};
    timeline_.tracks.emplace_back("tile_1", std::vector{key});
    const auto sound = sound_of(impact("tile_1", "cloth", {0, 0, 0}, {0, 0, 1}, 1e-3));
    ASSERT_TRUE(sound);
    EXPECT_EQ(sound->contact_time, 0.9e-3);
    ASSERT_EQ(sound->modes.size(), 2 + shot_.resonators.box_on_cloth.modes.size());
    EXPECT_NEAR(sound->modes[0].frequency, 5830, 20);
    EXPECT_NEAR(sound->modes[0].gain, 1, 1e-9);  // half of a free tile's
}

TEST_F(ImpactSoundTest, Ball_OnAWallThatDoesNotMove_IsOneSphereWithItsOwnMass) {
    const auto sound = sound_of(impact("cue", "wall", {0, 0, 1}, {1, 0, 0}, 0.3));
    ASSERT_TRUE(sound);
    EXPECT_EQ(sound->group, Group::objects);
    EXPECT_EQ(sound->spheres.size(), 2);
    EXPECT_TRUE(sound->modes.empty());
}

TEST_F(ImpactSoundTest, Events_ThatAreNoImpacts_AreSilent) {
    sim::Event event = impact("cue", "one", {0, 0, kRadius}, {1, 0, 0}, 0);
    EXPECT_FALSE(sound_of(event));  // no impulse
    event.normal_impulse = 0.1;
    event.a = "unknown";
    EXPECT_FALSE(sound_of(event));
    event.a = "cue";
    for (const auto kind : {sim::EventKind::sliding, sim::EventKind::potted,
                            sim::EventKind::resting, sim::EventKind::impulse}) {
        event.kind = kind;
        EXPECT_FALSE(sound_of(event));
    }
}

// The levels that the gains of the resonators were set by.
TEST_F(ImpactSoundTest, Structures_AtOneMetre_HaveTheirLevels) {
    shot_.has_bed = false;
    const auto level = [&](const sim::Event& event) {
        const double pressure =
            find_peak(direct_sound_at(event.place + Vec3(0, 1, 0), *sound_of(event))).pressure;
        return 20 * std::log10(pressure / 20e-6);
    };
    EXPECT_NEAR(level(impact("cue", "cushion", {0, 0, 0.036}, {1, 0, 0}, 1.85 * kMass)), 68, 1);
    // A landing: the bed without the ball, which is silent at right angles to its step.
    EXPECT_NEAR(level(impact("cue", "cloth", {0, 0, 0}, {0, 0, 1}, 1.5 * kMass)), 85, 6);
}

}  // namespace
}  // namespace carom::sound
