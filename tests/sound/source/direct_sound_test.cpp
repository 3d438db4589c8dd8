// Two balls that collide, at places around them.
#include "sound/source/direct_sound.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sound/source/contact.h"
#include "sound/source/defaults.h"
#include "tests/sound/closed_forms.h"

namespace carom::sound {
namespace {

constexpr double kRadius = 0.028575;
constexpr double kMass = 0.1701;

/// Two pool balls that meet at the origin with a closing speed, along x.
ImpactSound clack(double speed) {
    const Material phenolic = default_material("ball");
    ImpactSound sound;
    sound.impulse = kMass / 2 * 1.95 * speed;
    sound.contact_time = hertz_contact_time(
        {kMass / 2, kRadius / 2, reduced_modulus(phenolic, phenolic), 0.95}, sound.impulse);
    const Vec3 step(sound.impulse / kMass, 0, 0);
    sound.spheres = {{{kRadius, 0, 0}, kRadius, step, 1}, {{-kRadius, 0, 0}, kRadius, -step, 1}};
    return sound;
}

Vec3 place_at(double degrees, double distance = 1) {
    const double angle = degrees * M_PI / 180;
    return {distance * std::cos(angle), distance * std::sin(angle), 0};
}

double peak(double speed, double degrees) {
    return find_peak(direct_sound_at(place_at(degrees), clack(speed))).pressure;
}

TEST(DirectSound, Clack_AtOneMetreAndSixtyDegrees_HasItsPressure) {
    EXPECT_GE(peak(1, 60), 0.624);
    EXPECT_LE(peak(1, 60), 0.628);
    EXPECT_GE(peak(5, 60), 5.95);
    EXPECT_LE(peak(5, 60), 5.98);
}

TEST(DirectSound, Clack_AtOtherAnglesAndSpeeds_FollowsTheTable) {
    EXPECT_NEAR(peak(0.1, 0), 0.073, 0.001);
    EXPECT_NEAR(peak(0.1, 45), 0.038, 0.001);
    EXPECT_NEAR(peak(0.1, 90), 0.003, 0.0005);
    EXPECT_NEAR(peak(1, 0), 2.09, 0.015);
    EXPECT_NEAR(peak(1, 45), 1.18, 0.01);
    EXPECT_NEAR(peak(1, 90), 0.065, 0.002);
    EXPECT_NEAR(peak(5, 0), 16.5, 0.15);
    EXPECT_NEAR(peak(5, 45), 10.6, 0.1);
    EXPECT_NEAR(peak(5, 90), 0.51, 0.01);
}

/// d log(pressure) / d log(impulse).
double slope(double from, double to, double degrees) {
    return std::log(peak(to, degrees) / peak(from, degrees)) / std::log(to / from);
}

TEST(DirectSound, Level_OverTheImpulse_HasTheSlopesOfShorterContacts) {
    EXPECT_NEAR(slope(0.1, 0.3, 60), 1.53, 0.01);
    EXPECT_NEAR(slope(0.3, 1, 60), 1.48, 0.015);
    EXPECT_NEAR(slope(1, 3, 60), 1.42, 0.015);
    EXPECT_NEAR(slope(3, 10, 60), 1.35, 0.015);
    EXPECT_NEAR(slope(0.1, 0.3, 0), 1.49, 0.015);
    EXPECT_NEAR(slope(3, 10, 0), 1.20, 0.025);
}

TEST(DirectSound, Peak_OnAFineGrid_IsTheHighestPressure) {
    const DirectSound direct = direct_sound_at(place_at(60), clack(2));
    const Peak found = find_peak(direct);
    double highest = 0;
    double time = 0;
    for (int i = -20000; i < 60000; ++i) {
        const double pressure = std::abs(pressure_at(direct, i * 1e-8));
        time = pressure > highest ? i * 1e-8 : time;
        highest = std::max(highest, pressure);
    }
    EXPECT_NEAR(found.pressure, highest, 1e-3 * highest);
    EXPECT_NEAR(found.time, time, 1e-6);
}

// Both balls alone, each with its own distance, angle and delay.
TEST(DirectSound, Pair_AtAPlace_IsTheSumOfBothSpheres) {
    const ImpactSound sound = clack(1);
    const Vec3 place(0.4, 0.7, 0.3);
    const DirectSound direct = direct_sound_at(place, sound);
    const double contact_distance = place.length();
    for (const double time : {-50e-6, 100e-6, 300e-6, 600e-6}) {
        double sum = 0;
        for (const double side : {1.0, -1.0}) {
            const Vec3 path = place - Vec3(side * kRadius, 0, 0);
            const double r = path.length();
            const SpherePole wave = sphere_pole(kRadius, r, side * path.x / r);
            const double begins = (r - kRadius - contact_distance) / kSpeedOfSound;
            const Complex response = pole_response_at(wave.pole, sound.contact_time, time - begins);
            sum += 2 * sound.impulse / kMass * (wave.residue * response).re;
        }
        EXPECT_NEAR(pressure_at(direct, time), sum, 1e-12);
    }
}

// A listener on the cloth hears a sphere and its image alike, with the vertical part cancelled.
TEST(DirectSound, Image_ForAListenerOnTheBed_DoublesTheHorizontalPart) {
    ImpactSound alone;
    alone.place = {0, 0, kRadius};
    alone.contact_time = 390e-6;
    alone.spheres = {{{0, 0, kRadius}, kRadius, {0.4, 0, 0.3}, 1}};
    ImpactSound both = alone;
    both.spheres.push_back({{0, 0, -kRadius}, kRadius, {0.4, 0, -0.3}, 1});
    ImpactSound flat = alone;
    flat.spheres[0].velocity_step.z = 0;
    const Vec3 place(0.8, 0.2, 0);
    const double t = 200e-6;
    const double with_image = pressure_at(direct_sound_at(place, both), t);
    // The vertical step, seen from the height of the bed, adds -0.3 R / r of the same shape for the
    // sphere, and cancels with a reflection of 1 only if the image's step is turned, too.
    ImpactSound mirrored = alone;
    mirrored.spheres = {both.spheres[1]};
    EXPECT_NEAR(with_image, 2 * pressure_at(direct_sound_at(place, alone), t), 1e-12);
    EXPECT_NEAR(pressure_at(direct_sound_at(place, mirrored), t),
                pressure_at(direct_sound_at(place, alone), t), 1e-12);
    EXPECT_GT(pressure_at(direct_sound_at(place, flat), t),
              pressure_at(direct_sound_at(place, alone), t));
}

TEST(DirectSound, Modes_FallWithTheDistance) {
    ImpactSound sound;
    sound.impulse = 0.3;
    sound.contact_time = 1e-5;
    sound.modes = {{500, 10, 0.4}};
    const double near = find_peak(direct_sound_at({0, 0.5, 0}, sound)).pressure;
    const double far = find_peak(direct_sound_at({0, 0, 2}, sound)).pressure;
    EXPECT_NEAR(near, 4 * far, 1e-9);
    EXPECT_NEAR(near, 0.3 * 0.4 / 0.5, 0.02 * 0.24);
    // Nothing is heard from nearer than 10 cm.
    EXPECT_NEAR(find_peak(direct_sound_at({0, 0.01, 0}, sound)).pressure, 5 * near, 1e-9);
}

}  // namespace
}  // namespace carom::sound
