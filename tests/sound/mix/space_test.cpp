// Both ears, the room and what rolls, in films.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "small_film.h"
#include "sound/level/decibels.h"
#include "sound/mix/film_sound.h"
#include "tests/sound/named_room.h"

namespace carom::sound {
namespace {

std::size_t first_above(const std::vector<double>& samples, double least) {
    return static_cast<std::size_t>(
        std::ranges::find_if(samples, [least](double x) { return std::abs(x) > least; }) -
        samples.begin());
}

double energy(const std::vector<double>& samples, std::size_t from = 0) {
    double sum = 0;
    for (std::size_t n = from; n < samples.size(); ++n) {
        sum += samples[n] * samples[n];
    }
    return sum;
}

TEST(Space, SoundFromTheLeft_IsEarlierAndLouderThere) {
    SmallFilm film;
    film.collide(0.25, 2);
    // Ahead is y, right is x: the balls are 30 degrees to the left.
    Clip& clip = film.show(0, 1, 0, 1, {0.5, -std::sqrt(0.75), 0});
    clip.settings.stereo = Stereo::sphere;
    clip.settings.width = Width::real;
    const Samples samples = samples_of(film.scene);
    const double threshold = 0.05 * highest(samples.left);
    const auto late = static_cast<double>(first_above(samples.right, threshold)) -
                      static_cast<double>(first_above(samples.left, threshold));
    EXPECT_NEAR(late / kSampleRate, 0.26e-3, 0.04e-3);
    EXPECT_GT(energy(samples.left), 1.5 * energy(samples.right));
}

/// A film with everything on the given side.
void fill(SmallFilm& film, double side) {
    for (int i = 0; i < 5; ++i) {
        film.collide(0.1 * i + 0.05, 1 + i);
        film.touch(0.1 * i + 0.08, "cushion", 0.2);
        sim::Event& event = film.timeline.events.back();
        event.place = {0.3, side * 0.4, 0.036};
        event.normal = {0, -side, 0};
    }
    film.shot().has_bed = true;
    Clip& clip = film.show(0, 1, 0, 1, {-1, side * 0.3, 0.5});
    clip.listener = [side](double) {
        Listener listener;
        listener.position = {-1, side * 0.3, 0.5};
        listener.ahead = {1, 0, 0};
        listener.right = {0, -1, 0};
        return listener;
    };
    clip.settings.stereo = Stereo::sphere;
    film.shot().room.kind = RoomSettings::Kind::outdoors;
}

TEST(Space, MirroredShot_HasItsChannelsExchanged) {
    SmallFilm film;
    fill(film, 1);
    SmallFilm mirrored;
    fill(mirrored, -1);
    const Samples a = samples_of(film.scene);
    const Samples b = samples_of(mirrored.scene);
    EXPECT_NE(a.left, a.right);
    EXPECT_EQ(a.left, b.right);
    EXPECT_EQ(a.right, b.left);
}

TEST(Space, Mono_HasBothChannelsAlikeInARoomToo) {
    SmallFilm film;
    film.collide(0.25);
    film.shot().room.kind = RoomSettings::Kind::box;
    film.show(0, 1, 0, 1);
    const Samples samples = samples_of(film.scene);
    EXPECT_GT(energy(samples.left, 15'000), 0);
    EXPECT_EQ(samples.left, samples.right);
}

TEST(Space, Pan_ToTheSide_IsInOneChannel) {
    SmallFilm film;
    film.collide(0.25);
    film.show(0, 1, 0, 1, {2, 0, 0}).settings.stereo = Stereo::pan;
    const Samples samples = samples_of(film.scene);
    EXPECT_GT(highest(samples.left), 0.1);
    EXPECT_LT(highest(samples.right), 1e-9);
}

TEST(Space, Ground_Outdoors_IsOneEcho) {
    SmallFilm film;
    film.touch(0.25, "cushion", 0.3);
    film.shot().room.kind = RoomSettings::Kind::outdoors;
    film.shot().room.floor_centre = {0, 0, -2};
    const Vec3 place(0, 0, 1);
    film.show(0, 1, 0, 1, place);
    const std::vector<double> with = samples_of(film.scene).left;
    film.shot().room.kind = RoomSettings::Kind::none;
    const std::vector<double> without = samples_of(film.scene).left;
    // The echo comes from the image 4 m below the source: 5 m instead of 1 m.
    const auto later = static_cast<std::size_t>(std::floor(4 / 343.0 * kSampleRate));
    const std::size_t first = first_above(without, 1e-6);
    for (std::size_t n = 0; n < first + later - 20; ++n) {
        ASSERT_EQ(with[n], without[n]);
    }
    EXPECT_GT(highest(with, first + later), 0.5 * 0.9 / 5 * highest(without));
}

TEST(Space, Room_AfterAnImpact_FallsBySixtyDecibelsInItsTime) {
    SmallFilm film;
    film.collide(0.1, 5);
    film.shot().room = room_named("club");
    film.show(0, 0.2, 0, 1);
    film.show(0.2, 3, 0.2, 0);
    film.scene.frames = 3LL * kSampleRate;
    const std::vector<double> samples = samples_of(film.scene).left;
    const double peak = highest(samples);
    const double early = highest(samples, 10'000, 14'000);
    const double late = highest(samples, 10'000 + 14'400, 14'000 + 14'400);  // half of T60
    EXPECT_GT(early, 1e-3 * peak);
    EXPECT_NEAR(decibels_of(late / early), -30, 8);
    // 1.5 T60 after the impact there is nothing above -90 dB.
    EXPECT_LT(highest(samples, 4800 + 43'200), 3.2e-5 * peak);
    EXPECT_LT(highest(samples, 130'000), 1e-12);
}

// The reverberation does not depend on where the listener is.
TEST(Space, Reverberation_IsAsLoudFarAway) {
    const auto reverberation = [](double distance) {
        SmallFilm film;
        film.touch(0.1, "cushion", 0.3);
        film.shot().room.size = {20, 20, 6};
        film.show(0, 1, 0, 1, {0, -distance, 0});
        film.shot().room.kind = RoomSettings::Kind::box;
        return energy(samples_of(film.scene).left, 12'000);
    };
    EXPECT_NEAR(decibels_of(std::sqrt(reverberation(8) / reverberation(1))), 0, 0.5);
}

class RollingFilm : public SmallFilm {
  public:
    explicit RollingFilm(double speed) {
        constexpr double kRadius = 0.028575;
        sim::Key start;
        start.position = {0, -speed, kRadius};
        start.velocity_in = start.velocity_out = {0, speed, 0};
        start.angular_velocity_in = start.angular_velocity_out = {-speed / kRadius, 0, 0};
        sim::Key end = start;
        end.time = 2;
        end.position = {0, speed, kRadius};
        timeline.tracks.emplace_back("two", std::vector{start, end});
        shot().bodies.push_back({"two", BallShape{kRadius}, 0.17, {}, {}});
        sim::Event rolling;
        rolling.kind = sim::EventKind::rolling;
        rolling.a = "two";
        timeline.events.push_back(rolling);
        scene.frames = 2LL * kSampleRate;
    }

    /// The root mean square of the left channel while the listener goes beside the ball, 1 m away.
    double level(double film_speed = 1) {
        shot().clips.clear();
        Clip& clip = show(0, 2, film_speed < 0 ? 2 : 0, film_speed);
        clip.listener = [this, film_speed](double t) {
            Listener listener;
            const double scene_time = (film_speed < 0 ? 2 : 0) + film_speed * t;
            listener.position = timeline.find("two")->sample(scene_time).position - Vec3(1, 0, 0);
            return listener;
        };
        const std::vector<double> samples = samples_of(scene).left;
        double sum = 0;
        for (std::size_t n = 24'000; n < 72'000; ++n) {
            sum += samples[n] * samples[n];
        }
        return level_of(std::sqrt(sum / 48'000));
    }
};

TEST(Space, RollingBall_AtOneMetrePerSecond_Has40Decibels) {
    EXPECT_NEAR(RollingFilm(1).level(), 40, 1.5);
    EXPECT_NEAR(RollingFilm(0.5).level(), 31, 2);
    EXPECT_NEAR(RollingFilm(1).level(-1), 40, 1.5);
}

TEST(Space, RollingBall_InAFrozenPicture_IsSilent) {
    EXPECT_EQ(RollingFilm(1).level(0), -std::numeric_limits<double>::infinity());
}

// A cut between two cameras at the same place is no change at all.
TEST(Space, RollingBall_AcrossACut_GoesOn) {
    RollingFilm film(1);
    film.show(0, 2, 0, 1, {-1, 0, 0.3});
    const std::vector<double> whole = samples_of(film.scene).left;
    film.shot().clips.clear();
    film.show(0, 1, 0, 1, {-1, 0, 0.3});
    film.show(1, 2, 1, 1, {-1, 0, 0.3});
    const std::vector<double> cut = samples_of(film.scene).left;
    const double peak = highest(whole);
    ASSERT_GT(peak, 0);
    for (std::size_t n = 1000; n < 95'000; ++n) {
        ASSERT_NEAR(cut[n], whole[n], 0.02 * peak) << n;
    }
}

// The way to the listener delays rolling, too. Both delays have the same fraction of a sample.
TEST(Space, RollingBall_IsHeardLateByTheWay) {
    RollingFilm film(1);
    const double head = 0.0875 / 343;  // s, the least delay
    const double distance = 0.0875 + 343 * 128.0 / kSampleRate;
    Clip& clip = film.show(0, 2, 0, 1);
    clip.listener = [&film, distance](double t) {
        Listener listener;
        listener.position = film.timeline.find("two")->sample(t).position - Vec3(distance, 0, 0);
        return listener;
    };
    const std::vector<double> late = samples_of(film.scene).left;
    clip.settings.has_delay = false;
    const std::vector<double> prompt = samples_of(film.scene).left;
    ASSERT_LT(head * kSampleRate, 13);
    const double peak = highest(late);
    for (std::size_t n = 24'000; n < 72'000; ++n) {
        ASSERT_NEAR(late[n], prompt[n - 128], 1e-6 * peak);
    }
}

TEST(Space, RollingBall_NearerToTheListener_IsLouder) {
    RollingFilm film(1);
    film.show(0, 2, 0, 1, {-0.2, 0, 0.028575});
    const std::vector<double> samples = samples_of(film.scene).left;
    EXPECT_GT(highest(samples, 46'000, 50'000), 2.5 * highest(samples, 4000, 8000));
}

}  // namespace
}  // namespace carom::sound
