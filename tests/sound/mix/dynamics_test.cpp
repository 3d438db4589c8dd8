// Levels: dynamics, gains of cameras and groups, fades.
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "small_film.h"
#include "sound/level/decibels.h"
#include "sound/mix/auralisation.h"
#include "sound/mix/film_sound.h"
#include "sound/source/direct_sound.h"
#include "tests/sound/named_room.h"

namespace carom::sound {
namespace {

double level_of_peak(const SmallFilm& film) {
    return 20 * std::log10(highest(samples_of(film.scene).left) / 20e-6);
}

double level_with_ratio(double speed, double ratio) {
    SmallFilm film;
    film.collide(0.25, speed);
    film.show(0, 1, 0, 1, {0.9, -0.4, 0}).settings.ratio = ratio;
    return level_of_peak(film);
}

TEST(Dynamics, EachImpact_KeepsAPartOfItsDistanceFrom80Decibels) {
    for (const double speed : {0.05, 0.5, 5.0}) {
        SmallFilm film;
        film.collide(0.25, speed);
        film.show(0, 1, 0, 1, {0.9, -0.4, 0});
        const ImpactSound sound = *ImpactSounds(film.shot()).sound_of(film.timeline.events[0]);
        const double pressure = find_peak(direct_sound_at(average_place(sound), sound)).pressure;
        const double peak = level_of(pressure);
        const double natural = level_with_ratio(speed, 1);
        for (const double ratio : {2.0, 3.0, 4.0}) {
            const double gain = decibels_of(compressor_gain(pressure, ratio, kQuietImpact));
            EXPECT_NEAR(level_with_ratio(speed, ratio) - natural, gain, 1e-9);
            if (speed > 0.1) {
                EXPECT_NEAR(gain, (peak - 80) * (1 / ratio - 1), 1e-9);
            }
        }
    }
}

/// The energy of a clack in a club, from the film time `from` (s) on, dB.
double energy_in_club(double ratio, const Vec3& place, double from) {
    SmallFilm film;
    film.collide(0.1, 2);
    film.shot().room = room_named("club");
    film.shot().has_bed = true;
    film.show(0, 1, 0, 1, place).settings.ratio = ratio;
    const std::vector<double> samples = samples_of(film.scene).left;
    double sum = 0;
    for (auto n = static_cast<std::size_t>(from * kSampleRate); n < samples.size(); ++n) {
        sum += samples[n] * samples[n];
    }
    return decibels_of(std::sqrt(sum));
}

// Along their line two balls are 27 dB louder than across it, but the room hears both sides.
TEST(Dynamics, Room_IsAsLoudFromEverySide) {
    const auto reverberation = [](double ratio, double degrees) {
        const double angle = degrees * std::numbers::pi / 180;
        const Vec3 place(1.5 * std::cos(angle), 1.5 * std::sin(angle), 0.4);
        return energy_in_club(ratio, place, 0.2);
    };
    const double natural = reverberation(1, 0);
    const double film = reverberation(2, 0);
    EXPECT_GT(std::abs(film - natural), 3);
    for (const double degrees : {30.0, 60.0, 90.0, 180.0, 270.0}) {
        EXPECT_NEAR(reverberation(1, degrees) - natural, 0, 0.05) << degrees;
        EXPECT_NEAR(reverberation(2, degrees) - film, 0, 0.05) << degrees;
    }
}

TEST(Dynamics, CameraFartherAway_IsNeverLouder) {
    for (const double ratio : {1.0, 2.0, 4.0}) {
        for (const Vec3& towards : {Vec3(1, 0, 0.2), Vec3(0.5, 0.8, 0.2), Vec3(0, 1, 0.2)}) {
            double last = std::numeric_limits<double>::infinity();
            for (const double distance : {1.0, 2.0, 4.0, 8.0, 16.0}) {
                const double now = energy_in_club(ratio, towards.normalized() * distance, 0);
                EXPECT_LT(now, last) << ratio << ", " << distance << " m";
                last = now;
            }
        }
    }
}

TEST(Dynamics, OneImpact_DoesNotChangeAnother) {
    SmallFilm film;
    film.collide(0.25, 0.3);
    film.show(0, 1, 0, 1).settings.ratio = 2;
    const std::vector<double> alone = samples_of(film.scene).left;
    film.collide(0.26, 8);
    const std::vector<double> both = samples_of(film.scene).left;
    for (std::size_t n = 0; n < 12'400; ++n) {
        ASSERT_EQ(both[n], alone[n]);
    }
}

TEST(Dynamics, GainsOfCameraAndGroup_AreDecibels) {
    SmallFilm film;
    film.collide(0.25);
    Clip& clip = film.show(0, 1, 0, 1);
    const double before = level_of_peak(film);
    clip.settings.gain = -6;
    clip.settings.mix[static_cast<std::size_t>(Group::balls)] = 2.5;
    clip.settings.mix[static_cast<std::size_t>(Group::cloth)] = 40;
    EXPECT_NEAR(level_of_peak(film) - before, -3.5, 1e-9);
}

// Both cameras hear the impact in the middle of the fade, each with the root of 1/2.
TEST(Dynamics, Fade_WeighsTheSoundsOfBothCameras) {
    SmallFilm film;
    film.collide(0.5);
    film.show(0, 1, 0, 1);
    const std::vector<double> single = samples_of(film.scene).left;
    film.shot().clips.clear();
    film.show(0, 0.6, 0, 1).weight = [](double) { return std::sqrt(0.5); };
    film.show(0.4, 1, 0.4, 1).weight = [](double) { return std::sqrt(0.5); };
    const std::vector<double> faded = samples_of(film.scene).left;
    for (std::size_t n = 0; n < single.size(); ++n) {
        ASSERT_NEAR(faded[n], std::sqrt(2) * single[n], 1e-9);
    }
    film.shot().clips[1].weight = [](double) { return 0.0; };
    EXPECT_EQ(audible_impacts(film.scene).size(), 1);
}

// A ring that began before the cut goes on, as the first camera heard it.
TEST(Dynamics, Cut_LetsARingGoOn) {
    SmallFilm film;
    film.touch(0.48, "cushion", 0.3);
    film.show(0, 1, 0, 1);
    const std::vector<double> single = samples_of(film.scene).left;
    film.shot().clips.clear();
    film.show(0, 0.5, 0, 1);
    film.show(0.5, 1, 0.5, 1, {30, 0, 0});
    EXPECT_EQ(samples_of(film.scene).left, single);
}

// The listener passes by fast: what is heard is what a listener at rest hears who is there when the
// balls collide.
TEST(Dynamics, MovingListener_HearsNoDoppler) {
    SmallFilm film;
    film.collide(0.25);
    film.show(0, 1, 0, 1, {0.3, -1, 0});
    const std::vector<double> at_rest = samples_of(film.scene).left;
    film.shot().clips[0].listener = [](double t) {
        Listener listener;
        listener.position = Vec3(0.3 + 80 * (t - 0.25), -1, 0);
        return listener;
    };
    const std::vector<double> moving = samples_of(film.scene).left;
    for (std::size_t n = 0; n < at_rest.size(); ++n) {
        ASSERT_NEAR(moving[n], at_rest[n], 1e-9);
    }
}

TEST(Dynamics, Delay_IsTheWayToTheListener) {
    SmallFilm film;
    film.collide(0.25);
    film.show(0, 1, 0, 1, {0, -3.43, 0});
    const std::vector<double> late = samples_of(film.scene).left;
    film.shot().clips[0].settings.has_delay = false;
    const std::vector<double> prompt = samples_of(film.scene).left;
    for (std::size_t n = 480; n < late.size(); ++n) {
        ASSERT_NEAR(late[n], prompt[n - 480], 1e-9);
    }
}

}  // namespace
}  // namespace carom::sound
