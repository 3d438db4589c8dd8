// When a film shows the events of a shot.
#include "sound/mix/onsets.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "small_film.h"

namespace carom::sound {
namespace {

/// The film times at which a clip shows things that happen at these scene times.
std::vector<double> film_times(const Clip& clip, const std::vector<double>& scene_times) {
    SmallFilm film;
    for (const double time : scene_times) {
        film.collide(time);
    }
    film.shot().clips.push_back(clip);
    std::vector<double> times;
    for (const Onset& onset : onsets_of(film.scene)) {
        times.push_back(onset.film_time);
    }
    return times;
}

TEST(Onsets, FilmTime_InARamp_IsExact) {
    Clip ramp;
    ramp.from = 2;
    ramp.to = 5;
    ramp.scene_time = [](double t) { return (t - 2) * (t - 2); };  // from 0 to 9
    for (const double scene_time : {0.1, 1.0, 4.0, 8.99}) {
        const std::vector<double> found = film_times(ramp, {scene_time});
        ASSERT_EQ(found.size(), 1);
        EXPECT_NEAR(found[0], 2 + std::sqrt(scene_time), 1e-12);
    }
    EXPECT_EQ(film_times(ramp, {0}), std::vector<double>{2});
    EXPECT_TRUE(film_times(ramp, {-0.1, 9}).empty());
}

TEST(Onsets, FilmTime_Backwards_IncludesTheFirstInstantAndNotTheLast) {
    Clip reverse;
    reverse.from = 1;
    reverse.to = 3;
    reverse.scene_time = [](double t) { return 7 - 2 * (t - 1); };  // from 7 to 3
    const std::vector<double> found = film_times(reverse, {3, 4, 7});
    ASSERT_EQ(found.size(), 2);
    EXPECT_EQ(found[0], 1);
    EXPECT_NEAR(found[1], 2.5, 1e-12);
}

TEST(Onsets, FilmTime_WhereTheMapRests_IsItsFirst) {
    Clip clip;
    clip.from = 0;
    clip.to = 10;
    clip.scene_time = [](double t) { return t < 3 ? t : std::max(3.0, t - 4); };
    const std::vector<double> found = film_times(clip, {3, 4});
    ASSERT_EQ(found.size(), 2);
    EXPECT_NEAR(found[0], 3, 1e-12);
    EXPECT_NEAR(found[1], 8, 1e-12);
}

TEST(Onsets, StandingPicture_ShowsNothingNew) {
    SmallFilm film;
    film.collide(0.5);
    film.show(0, 1, 0.5, 0);
    EXPECT_TRUE(onsets_of(film.scene).empty());
}

// There and back, with the turn exactly on an event: it is shown once, not twice, and the others
// twice.
TEST(Onsets, Turn_OnAnEvent_ShowsItOnce) {
    SmallFilm film;
    film.collide(0.25);
    film.collide(0.5);
    film.show(0, 0.5, 0, 1);
    film.show(0.5, 1, 0.5, -1);
    const auto found = onsets_of(film.scene);
    ASSERT_EQ(found.size(), 3);
    EXPECT_NEAR(found[0].film_time, 0.25, 1e-12);
    EXPECT_EQ(found[0].event, 0);
    EXPECT_NEAR(found[1].film_time, 0.5, 1e-12);
    EXPECT_EQ(found[1].event, 1);
    EXPECT_NEAR(found[2].film_time, 0.75, 1e-12);
    EXPECT_EQ(found[2].event, 0);
}

TEST(Onsets, Cut_OnAnEvent_BelongsToTheSecondCamera) {
    SmallFilm film;
    film.collide(0.5);
    film.show(0, 0.5, 0, 1);
    film.show(0.5, 1, 0.5, 1);
    const auto found = onsets_of(film.scene);
    ASSERT_EQ(found.size(), 1);
    EXPECT_EQ(found[0].clip, 1);
}

TEST(Onsets, Replay_ShowsEventsAgain) {
    SmallFilm film;
    film.collide(0.5);
    film.show(0, 1, 0, 1);
    film.show(1, 5, 0.4, 0.125);
    const auto found = onsets_of(film.scene);
    ASSERT_EQ(found.size(), 2);
    EXPECT_NEAR(found[1].film_time, 1.8, 1e-12);
}

TEST(Onsets, EventsAtOneInstant_StayInTheOrderOfTheLog) {
    SmallFilm film;
    film.collide(0.2);
    film.collide(0.5);
    film.collide(0.5);
    film.collide(0.5);
    film.show(0, 1, 1, -1);
    const auto found = onsets_of(film.scene);
    ASSERT_EQ(found.size(), 4);
    EXPECT_EQ(found[0].event, 1);
    EXPECT_EQ(found[1].event, 2);
    EXPECT_EQ(found[2].event, 3);
    EXPECT_EQ(found[3].event, 0);
    EXPECT_EQ(found[0].film_time, found[2].film_time);
}

TEST(Onsets, Fade_ShowsAnEventInBothCameras) {
    SmallFilm film;
    film.collide(0.5);
    film.show(0, 0.6, 0, 1);
    film.show(0.4, 1, 0.4, 1);
    const auto found = onsets_of(film.scene);
    ASSERT_EQ(found.size(), 2);
    EXPECT_EQ(found[0].clip + found[1].clip, 1);
    EXPECT_NEAR(found[0].film_time, 0.5, 1e-12);
    EXPECT_NEAR(found[1].film_time, 0.5, 1e-12);
}

TEST(Onsets, OfOverlappingClips_AreInOrderOfFilmTime) {
    SmallFilm film;
    for (int i = 0; i < 50; ++i) {
        film.collide(0.02 * i + 0.001);
    }
    film.show(0, 0.6, 0, 1.5);
    film.show(0.3, 0.9, 0.9, -1.5);
    const std::vector<Onset> found = onsets_of(film.scene);
    EXPECT_EQ(found.size(), 90);
    EXPECT_TRUE(std::ranges::is_sorted(found, {}, &Onset::film_time));
}

}  // namespace
}  // namespace carom::sound
