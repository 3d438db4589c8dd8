// The list of what is heard, against the samples.
#include "sound/mix/auralisation.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "small_film.h"

namespace carom::sound {
namespace {

TEST(AudibleImpacts, Row_OfAClack_SaysWhatItIs) {
    SmallFilm film;
    film.collide(3.5);
    film.show(0, 1, 3.4, 0.5, {0, -2, 0});
    const std::vector<AudibleImpact> rows = audible_impacts(film.scene);
    ASSERT_EQ(rows.size(), 1);
    const AudibleImpact& row = rows[0];
    EXPECT_NEAR(row.film_time, 0.2, 1e-12);
    EXPECT_EQ(row.scene_time, 3.5);
    EXPECT_EQ(row.group, Group::balls);
    EXPECT_EQ(row.a, "cue");
    EXPECT_EQ(row.b, "one");
    EXPECT_EQ(row.camera, "camera");
    EXPECT_EQ(row.speed, 0.5);
    EXPECT_EQ(row.time_factor, 0.5);
    EXPECT_NEAR(row.distance, 2, 1e-12);
    EXPECT_NEAR(row.delay, 2 / 343.0, 1e-12);
    EXPECT_NEAR(row.contact_time, 390e-6, 1e-6);
    EXPECT_NEAR(row.gain, 0, 1e-12);
}

TEST(AudibleImpacts, PeakTimes_AreWhereTheSamplesArePeaks) {
    SmallFilm film;
    for (int i = 0; i < 9; ++i) {
        film.collide(0.05 + 0.1003 * i, 0.2 * (i + 1));
    }
    film.show(0, 0.5, 0, 1, {0.7, -0.7, 0.4});
    film.show(0.5, 1, 0.5, 1, {-0.2, 1.4, 0.1});
    const std::vector<double> samples = samples_of(film.scene).left;
    const std::vector<AudibleImpact> rows = audible_impacts(film.scene);
    ASSERT_EQ(rows.size(), 9);
    for (const AudibleImpact& row : rows) {
        const auto from = static_cast<std::ptrdiff_t>(row.film_time * kSampleRate);
        const auto peak =
            std::max_element(samples.begin() + from, samples.begin() + from + 2400,
                             [](double a, double b) { return std::abs(a) < std::abs(b); });
        const double time = static_cast<double>(peak - samples.begin()) / kSampleRate;
        EXPECT_NEAR(time, row.peak_time, 0.6 / kSampleRate);
        EXPECT_LE(std::abs(*peak), row.peak * 1.001);
        EXPECT_GT(std::abs(*peak), row.peak * 0.97);
    }
}

TEST(AudibleImpacts, PeakTime_OfAMirroredSound_IsBeforeItsInstant) {
    SmallFilm film;
    film.collide(0.5);
    film.show(0, 1, 0, 1).settings.has_delay = false;
    const AudibleImpact forwards = audible_impacts(film.scene).at(0);
    film.shot().clips.clear();
    film.show(0, 1, 1, -1).settings.has_delay = false;
    const AudibleImpact backwards = audible_impacts(film.scene).at(0);
    EXPECT_GT(forwards.peak_time, 0.5);
    EXPECT_NEAR(backwards.peak_time, 1 - forwards.peak_time, 1e-9);
}

// Two steel balls of 4 mm touch for 14 us; their sound would reach far above half of the sample
// rate.
TEST(AudibleImpacts, ContactTime_IsAtLeastThreeSamplesOfTheFilm) {
    SmallFilm film;
    for (SoundBody& body : film.shot().bodies) {
        body.shape = BallShape{0.002};
        body.mass = 2.6e-4;
        body.material = {206e9, 0.29, 0.001, 0.9};
    }
    film.collide(0.5, 0.003);
    film.show(0, 1, 0, 1, {0.05, -0.1, 0});
    EXPECT_NEAR(audible_impacts(film.scene).at(0).contact_time, 3.0 / 48000, 1e-12);
    film.shot().clips.clear();
    film.show(0, 4, 0, 0.25, {0.05, -0.1, 0});
    film.scene.frames = 4LL * kSampleRate;
    EXPECT_NEAR(audible_impacts(film.scene).at(0).contact_time, 0.25 * 3.0 / 48000, 1e-12);
}

TEST(AudibleImpacts, ImpactsBelowZeroDecibels_AreLeftOut) {
    SmallFilm film;
    film.collide(0.3, 1e-4);
    film.collide(0.6, 1);
    film.show(0, 1, 0, 1);
    EXPECT_EQ(audible_impacts(film.scene).size(), 1);
}

TEST(AudibleImpacts, ImpactsAfterTheFilmsEnd_AreLeftOut) {
    SmallFilm film;
    film.collide(0.3);
    film.collide(0.6);
    film.show(0, 1, 0, 1);
    film.scene.frames = kSampleRate / 2;
    EXPECT_EQ(audible_impacts(film.scene).size(), 1);
}

}  // namespace
}  // namespace carom::sound
