// Films in slow motion, backwards and with changing speed.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "small_film.h"
#include "sound/mix/auralisation.h"
#include "sound/mix/film_sound.h"

namespace carom::sound {
namespace {

constexpr std::size_t kInstant = 12'000;  // samples: 0.25 s

/// A clack at 0.25 s of a film that runs at this speed, without the way to the listener.
std::vector<double> clack_at(double speed, const std::function<void(Clip&)>& change = {}) {
    SmallFilm film;
    // At a small scene time, so that the map rounds as little as the film time does.
    film.collide(0.125);
    Clip& clip = film.show(0, 1, 0.125 - 0.25 * speed, speed, {0.5, -0.8, 0});
    clip.settings.has_delay = false;
    if (change) {
        change(clip);
    }
    return samples_of(film.scene).left;
}

TEST(PlayingSpeed, SlowMotion_IsTheSameSoundStretched) {
    const std::vector<double> normal = clack_at(1);
    const std::vector<double> half = clack_at(0.5);
    const std::vector<double> eighth = clack_at(0.125);
    const double peak = highest(normal);
    ASSERT_GT(peak, 0.5);
    for (int i = -20; i < 200; ++i) {
        const double expected = normal[kInstant + i];
        EXPECT_NEAR(half[kInstant + 2 * i], expected, 1e-12 * peak);
        EXPECT_NEAR(eighth[kInstant + 8 * i], expected, 1e-12 * peak);
    }
}

TEST(PlayingSpeed, VerySlowMotion_SoundsAsAtAnEighth) {
    const std::vector<double> eighth = clack_at(0.125);
    const std::vector<double> fortieth = clack_at(0.025);
    for (std::size_t i = 0; i < eighth.size(); ++i) {
        ASSERT_NEAR(fortieth[i], eighth[i], 1e-9);
    }
}

TEST(PlayingSpeed, KeptPitch_DoesNotChangeTheSound) {
    const std::vector<double> normal = clack_at(1);
    const std::vector<double> kept = clack_at(0.125, [](Clip& p) { p.settings.pitch = 0; });
    for (std::size_t i = 0; i < normal.size(); ++i) {
        ASSERT_NEAR(kept[i], normal[i], 1e-9);
    }
}

TEST(PlayingSpeed, FastMotion_IsAtMostAnOctaveHigher) {
    const std::vector<double> twice = clack_at(2);
    const std::vector<double> tenfold = clack_at(10);
    for (std::size_t i = 0; i < twice.size(); ++i) {
        ASSERT_NEAR(tenfold[i], twice[i], 1e-9);
    }
}

TEST(PlayingSpeed, Lowest_IsTheSpeedBelowWhichThePitchStays) {
    SmallFilm film;
    film.collide(1);
    Clip& clip = film.show(0, 100, 0, 0.025);
    clip.settings.lowest = 0.25;
    clip.settings.pitch = 0.5;
    film.scene.frames = 100LL * kSampleRate;
    const std::vector<AudibleImpact> rows = audible_impacts(film.scene);
    ASSERT_EQ(rows.size(), 1);
    EXPECT_NEAR(rows[0].time_factor, 0.5, 1e-12);
}

TEST(PlayingSpeed, Backwards_IsTheMirrorImage) {
    for (const double speed : {1.0, 0.125}) {
        const std::vector<double> forward = clack_at(speed);
        const std::vector<double> backward = clack_at(-speed);
        const double peak = highest(forward);
        for (int i = -2000; i <= 2000; ++i) {
            ASSERT_NEAR(backward[kInstant - i], forward[kInstant + i], 1e-12 * peak) << i;
        }
    }
}

TEST(PlayingSpeed, BackwardsWithoutMirroring_IsAsForwards) {
    const std::vector<double> forward = clack_at(1);
    const std::vector<double> backward =
        clack_at(-1, [](Clip& p) { p.settings.mirrors_reverse = false; });
    for (std::size_t i = 0; i < forward.size(); ++i) {
        ASSERT_NEAR(backward[i], forward[i], 1e-9);
    }
}

// A ring that is played backwards begins long before its instant, in blocks that were mixed before
// the instant's own block.
TEST(PlayingSpeed, Backwards_ALongRingBeginsBeforeItsInstant) {
    SmallFilm film;
    film.touch(10, "cloth", 0.3);
    film.scene.frames = 3LL * kSampleRate;
    film.show(0, 3, 10 - 2 * 0.125, 0.125).settings.has_delay = false;
    const std::vector<double> forward = samples_of(film.scene).left;
    film.shot().clips.clear();
    film.show(0, 3, 10 + 2 * 0.125, -0.125).settings.has_delay = false;
    const std::vector<double> backward = samples_of(film.scene).left;
    const double peak = highest(forward);
    const std::size_t instant = 2UL * kSampleRate;
    EXPECT_GT(highest(backward, instant - 24'000, instant - 20'000), 1e-3 * peak);
    for (std::size_t i = 0; i < 47'000; ++i) {
        ASSERT_NEAR(backward[instant - i], forward[instant + i], 1e-11 * peak) << i;
    }
}

TEST(PlayingSpeed, Ramp_GivesEachImpactTheSpeedOfItsInstant) {
    SmallFilm film;
    film.collide(0.5 * 0.2 * 0.2);
    film.collide(0.5 * 0.8 * 0.8);
    Clip& clip = film.show(0, 1, 0, 1);
    clip.scene_time = [](double t) { return 0.5 * t * t; };
    clip.speed = [](double t) { return t; };
    const std::vector<AudibleImpact> rows = audible_impacts(film.scene);
    ASSERT_EQ(rows.size(), 2);
    EXPECT_NEAR(rows[0].film_time, 0.2, 1e-12);
    EXPECT_NEAR(rows[0].time_factor, 0.2, 1e-9);
    EXPECT_NEAR(rows[1].film_time, 0.8, 1e-12);
    EXPECT_NEAR(rows[1].time_factor, 0.8, 1e-9);
}

TEST(PlayingSpeed, FrozenPicture_AfterAnImpact_FallsSilent) {
    SmallFilm film;
    film.touch(0.1, "cushion", 0.3);
    film.touch(0.2, "cushion", 0.3);
    film.show(0, 0.15, 0, 1);
    film.show(0.15, 1, 0.15, 0);
    const std::vector<double> samples = samples_of(film.scene).left;
    EXPECT_GT(highest(samples, 4800, 7200), 0.01);
    EXPECT_EQ(highest(samples, 24'000), 0);
}

}  // namespace
}  // namespace carom::sound
