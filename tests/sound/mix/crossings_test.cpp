// When a film shows the events of a shot.
#include "sound/mix/crossings.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "small_film.h"

namespace carom::sound {
namespace {

std::vector<Crossing> all(const SoundScene& scene, double until = 100) {
    Crossings crossings(scene);
    std::vector<Crossing> found;
    while (const auto crossing = crossings.next_before(until)) {
        found.push_back(*crossing);
    }
    return found;
}

TEST(Crossings, FilmTime_InARamp_IsExact) {
    Passage ramp;
    ramp.from = 2;
    ramp.to = 5;
    ramp.scene_time = [](double t) { return (t - 2) * (t - 2); };  // from 0 to 9
    for (const double scene_time : {0.1, 1.0, 4.0, 8.99}) {
        const auto found = film_time_of(ramp, scene_time);
        ASSERT_TRUE(found);
        EXPECT_NEAR(*found, 2 + std::sqrt(scene_time), 1e-12);
    }
    EXPECT_EQ(film_time_of(ramp, 0), 2);
    EXPECT_FALSE(film_time_of(ramp, 9));
    EXPECT_FALSE(film_time_of(ramp, -0.1));
}

TEST(Crossings, FilmTime_Backwards_IncludesTheFirstInstantAndNotTheLast) {
    Passage reverse;
    reverse.from = 1;
    reverse.to = 3;
    reverse.scene_time = [](double t) { return 7 - 2 * (t - 1); };  // from 7 to 3
    EXPECT_EQ(film_time_of(reverse, 7), 1);
    EXPECT_NEAR(*film_time_of(reverse, 4), 2.5, 1e-12);
    EXPECT_FALSE(film_time_of(reverse, 3));
}

TEST(Crossings, FilmTime_WhereTheMapRests_IsItsFirst) {
    Passage passage;
    passage.from = 0;
    passage.to = 10;
    passage.scene_time = [](double t) { return t < 3 ? t : std::max(3.0, t - 4); };
    EXPECT_NEAR(*film_time_of(passage, 3), 3, 1e-12);
    EXPECT_NEAR(*film_time_of(passage, 4), 8, 1e-12);
}

TEST(Crossings, StandingPicture_ShowsNothingNew) {
    SmallFilm film;
    film.collide(0.5);
    film.show(0, 1, 0.5, 0);
    EXPECT_TRUE(all(film.scene).empty());
}

// There and back, with the turn exactly on an event: it is shown once, not twice, and the others
// twice.
TEST(Crossings, Turn_OnAnEvent_ShowsItOnce) {
    SmallFilm film;
    film.collide(0.25);
    film.collide(0.5);
    film.show(0, 0.5, 0, 1);
    film.show(0.5, 1, 0.5, -1);
    const auto found = all(film.scene);
    ASSERT_EQ(found.size(), 3);
    EXPECT_NEAR(found[0].film_time, 0.25, 1e-12);
    EXPECT_EQ(found[0].event, 0);
    EXPECT_NEAR(found[1].film_time, 0.5, 1e-12);
    EXPECT_EQ(found[1].event, 1);
    EXPECT_NEAR(found[2].film_time, 0.75, 1e-12);
    EXPECT_EQ(found[2].event, 0);
}

TEST(Crossings, Cut_OnAnEvent_BelongsToTheSecondCamera) {
    SmallFilm film;
    film.collide(0.5);
    film.show(0, 0.5, 0, 1);
    film.show(0.5, 1, 0.5, 1);
    const auto found = all(film.scene);
    ASSERT_EQ(found.size(), 1);
    EXPECT_EQ(found[0].passage, 1);
}

TEST(Crossings, Replay_ShowsEventsAgain) {
    SmallFilm film;
    film.collide(0.5);
    film.show(0, 1, 0, 1);
    film.show(1, 5, 0.4, 0.125);
    const auto found = all(film.scene);
    ASSERT_EQ(found.size(), 2);
    EXPECT_NEAR(found[1].film_time, 1.8, 1e-12);
}

TEST(Crossings, EventsAtOneInstant_StayInTheOrderOfTheLog) {
    SmallFilm film;
    film.collide(0.2);
    film.collide(0.5);
    film.collide(0.5);
    film.collide(0.5);
    film.show(0, 1, 1, -1);
    const auto found = all(film.scene);
    ASSERT_EQ(found.size(), 4);
    EXPECT_EQ(found[0].event, 1);
    EXPECT_EQ(found[1].event, 2);
    EXPECT_EQ(found[2].event, 3);
    EXPECT_EQ(found[3].event, 0);
    EXPECT_EQ(found[0].film_time, found[2].film_time);
}

TEST(Crossings, Fade_ShowsAnEventInBothCameras) {
    SmallFilm film;
    film.collide(0.5);
    film.show(0, 0.6, 0, 1);
    film.show(0.4, 1, 0.4, 1);
    const auto found = all(film.scene);
    ASSERT_EQ(found.size(), 2);
    EXPECT_EQ(found[0].passage + found[1].passage, 1);
    EXPECT_NEAR(found[0].film_time, 0.5, 1e-12);
    EXPECT_NEAR(found[1].film_time, 0.5, 1e-12);
}

TEST(Crossings, AskedInSteps_GiveTheSameAsAtOnce) {
    SmallFilm film;
    for (int i = 0; i < 50; ++i) {
        film.collide(0.02 * i + 0.001);
    }
    film.show(0, 0.6, 0, 1.5);
    film.show(0.3, 0.9, 0.9, -1.5);
    const auto whole = all(film.scene);
    EXPECT_EQ(whole.size(), 90);
    Crossings crossings(film.scene);
    std::size_t at = 0;
    double last = 0;
    for (int step = 1; step <= 200; ++step) {
        while (const auto crossing = crossings.next_before(step * 0.005)) {
            ASSERT_LT(at, whole.size());
            EXPECT_EQ(crossing->film_time, whole[at].film_time);
            EXPECT_EQ(crossing->event, whole[at].event);
            EXPECT_LT(crossing->film_time, step * 0.005);
            EXPECT_GE(crossing->film_time, last);
            last = crossing->film_time;
            ++at;
        }
    }
    EXPECT_EQ(at, whole.size());
}

}  // namespace
}  // namespace carom::sound
