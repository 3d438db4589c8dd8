// The samples of films against closed forms.
#include "sound/mix/film_sound.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <random>
#include <span>
#include <stop_token>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.h"
#include "small_film.h"
#include "sound/mix/auralisation.h"
#include "sound/source/direct_sound.h"
#include "sound/source/impact_sound.h"
#include "tests/sound/closed_forms.h"

namespace carom::sound {
namespace {

TEST(FilmSound, Clack_AtAnyFractionOfASample_IsTheClosedForm) {
    for (int sixteenth = 0; sixteenth < 16; ++sixteenth) {
        SmallFilm film;
        const double instant = (12'000 + sixteenth / 16.0) / kSampleRate;
        film.collide(instant);
        const Vec3 place(0.5, -0.8, 0.3);
        film.show(0, 1, 0, 1, place);
        const Samples samples = samples_of(film.scene);
        const DirectSound direct =
            direct_sound_at(place, *ImpactSounds(film.shot()).sound_of(film.timeline.events[0]));
        const double delay = place.length() / 343;
        const double peak = find_peak(direct).pressure;
        for (std::size_t n = 11'900; n < 12'400; ++n) {
            const double time = static_cast<double>(n) / kSampleRate - instant - delay;
            // Each ball ends at -60 dB.
            ASSERT_NEAR(samples.left[n], pressure_at(direct, time), 2.1e-3 * peak) << n;
            if (time < 300e-6) {
                ASSERT_NEAR(samples.left[n], pressure_at(direct, time), 1e-11 * peak) << n;
            }
            ASSERT_EQ(samples.left[n], samples.right[n]);
        }
        EXPECT_EQ(highest(samples.left, 0, 11'990), 0);
        EXPECT_EQ(highest(samples.left, 12'600), 0);
    }
}

TEST(FilmSound, Length_IsThatOfTheScene) {
    SmallFilm film;
    film.show(0, 1, 0, 1);
    for (const std::int64_t frames : {0LL, 1LL, 239LL, 240LL, 2002LL * 24}) {
        film.scene.frames = frames;
        EXPECT_EQ(samples_of(film.scene).left.size(), static_cast<std::size_t>(frames));
    }
}

TEST(FilmSound, NothingHappens_AllSamplesAreZero) {
    SmallFilm film;
    film.shot().room.kind = RoomSettings::Kind::box;
    film.show(0, 1, 0, 1).settings.stereo = Stereo::sphere;
    film.scene.full_scale.reset();
    FilmSound sound(film.scene);
    EXPECT_EQ(sound.gain().full_scale, 0.2);
    const Samples samples = samples_of(film.scene);
    EXPECT_EQ(highest(samples.left), 0);
    EXPECT_EQ(highest(samples.right), 0);
}

/// A film with everything: a room, both ears, cuts, slow motion, reverse, a moving ball.
void fill(SmallFilm& film) {
    sim::Key start;
    start.position = {-0.5, 0.1, 0.028575};
    start.velocity_in = start.velocity_out = {1, 0.2, 0};
    start.angular_velocity_in = start.angular_velocity_out = {-7, 35, 0};
    sim::Key end = start;
    end.time = 1;
    end.position = {0.5, 0.3, 0.028575};
    film.timeline.tracks.emplace_back("two", std::vector{start, end});
    film.shot().bodies.push_back({"two", BallShape{0.028575}, 0.1701, {}, {}});
    sim::Event rolling;
    rolling.kind = sim::EventKind::rolling;
    rolling.a = "two";
    film.timeline.events.push_back(rolling);
    for (int i = 0; i < 12; ++i) {
        film.collide(0.05 + 0.037 * i, 0.3 + 0.4 * i);
        film.touch(0.06 + 0.041 * i, i % 2 == 0 ? "cushion" : "cloth", 0.05 * i + 0.01);
    }
    std::ranges::stable_sort(film.timeline.events, {}, &sim::Event::time);
    film.shot().has_bed = true;
    film.shot().room.kind = RoomSettings::Kind::box;
    film.show(0, 0.3, 0, 1, {0.2, -1, 0.5});
    film.show(0.3, 0.7, 0.3, 0.3, {-1, -0.4, 1});
    film.show(0.7, 1, 0.42, -1, {1, 1, 1});
    for (Clip& clip : film.shot().clips) {
        clip.settings.stereo = Stereo::sphere;
        clip.settings.ratio = 2;
    }
}

TEST(FilmSound, BlocksOfAnySize_HaveTheSameBits) {
    SmallFilm film;
    fill(film);
    const Samples whole = samples_of(film.scene, {}, 4096);
    EXPECT_GT(highest(whole.left), 0.1);
    EXPECT_NE(whole.left, whole.right);
    for (const std::size_t block : {1, 64, 1000, 1024}) {
        const Samples blocks = samples_of(film.scene, {}, block);
        EXPECT_EQ(blocks.left, whole.left);
        EXPECT_EQ(blocks.right, whole.right);
    }
}

TEST(FilmSound, ReadRest_HandsOverAllThatIsLeft) {
    SmallFilm film;
    fill(film);
    const Samples whole = samples_of(film.scene);
    FilmSound sound(film.scene, {.gain = FilmGain{.full_scale = *film.scene.full_scale}});
    std::vector<double> left(1000);
    std::vector<double> right(1000);
    ASSERT_EQ(sound.read(left, right), left.size());
    double done = 0;
    const auto on_progress = [&done](double part) {
        EXPECT_GT(part, done);
        done = part;
    };
    sound.read_rest({on_progress, {}},
                    [&](std::span<const double> more_left, std::span<const double> more_right) {
                        left.insert(left.end(), more_left.begin(), more_left.end());
                        right.insert(right.end(), more_right.begin(), more_right.end());
                    });
    EXPECT_EQ(left, whole.left);
    EXPECT_EQ(right, whole.right);
    EXPECT_EQ(done, 1);
}

TEST(FilmSound, ReadRest_WhenStopped_Throws) {
    SmallFilm film;
    FilmSound sound(film.scene);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(sound.read_rest({{}, stop.get_token()}), Stopped);
}

TEST(FilmSound, Groups_AsFilesOfTheirOwn_AddUpToTheFilm) {
    SmallFilm film;
    fill(film);
    const Samples whole = samples_of(film.scene);
    std::vector<double> sum(whole.left.size());
    int heard_groups = 0;
    for (std::size_t group = 0; group < kGroupCount; ++group) {
        const Samples stem = samples_of(film.scene, {.only = static_cast<Group>(group)});
        heard_groups += highest(stem.left) > 0 ? 1 : 0;
        for (std::size_t n = 0; n < sum.size(); ++n) {
            sum[n] += stem.left[n];
        }
    }
    EXPECT_EQ(heard_groups, 4);  // balls, cushions, cloth, rolling
    for (std::size_t n = 0; n < sum.size(); ++n) {
        ASSERT_NEAR(sum[n], whole.left[n], 1e-12);
    }
}

TEST(FilmSound, AutomaticGain_PutsTheTruePeakAtMinusOne) {
    SmallFilm film;
    fill(film);
    film.scene.full_scale.reset();
    FilmSound sound(film.scene);
    std::vector<double> left(48'000);
    std::vector<double> right(48'000);
    ASSERT_EQ(sound.read(left, right), left.size());
    EXPECT_LE(sound.levels().true_peak, -1.0);
    EXPECT_GT(sound.levels().true_peak, -1.02);
    EXPECT_EQ(sound.levels().limited, 0);
    // In whole hundredths of a decibel.
    const double level = 20 * std::log10(sound.gain().full_scale / 20e-6) * 100;
    EXPECT_NEAR(level, std::round(level), 1e-6);
}

TEST(FilmSound, AutomaticGain_OfAQuietFilm_StopsAt80Decibels) {
    SmallFilm film;
    film.collide(0.5, 0.05);
    film.show(0, 1, 0, 1);
    film.scene.full_scale.reset();
    EXPECT_EQ(FilmSound(film.scene).gain().full_scale, 0.2);
}

/// The levels of a film that was read to its end, which are as loud as its gain says.
SoundLevels levels_of(const SoundScene& scene, const AddedSound& added = {}) {
    FilmSound sound(scene, {.added = added});
    sound.read_rest();
    EXPECT_EQ(sound.position(), scene.frames);
    const FilmGain gain = sound.gain();
    EXPECT_EQ(gain.found.has_value(), scene.loudness.has_value());
    if (gain.found) {
        EXPECT_EQ(gain.found->loudness, sound.levels().loudness);
        EXPECT_EQ(gain.found->limited, sound.levels().limited);
        EXPECT_EQ(gain.found->gentle.has_value(), sound.levels().limited > kGentlyLimited);
    }
    EXPECT_LE(sound.levels().true_peak, kHighestTruePeak);
    return sound.levels();
}

/// A sine of this amplitude, of so many samples.
AddedSound sine(double amplitude, double frequency, std::int64_t samples) {
    return [=] {
        return [=, at = std::int64_t{0}](std::span<double> left, std::span<double> right) mutable {
            const std::size_t count = std::min(left.size(), static_cast<std::size_t>(samples - at));
            for (std::size_t i = 0; i < count; ++i, ++at) {
                left[i] = right[i] = amplitude * std::sin(2 * std::numbers::pi * frequency *
                                                          static_cast<double>(at) / kSampleRate);
            }
            return count;
        };
    };
}

TEST(FilmSound, Loudness_AskedFor_IsReachedBelowTheTruePeak) {
    SmallFilm film;
    fill(film);
    film.scene.frames = 3LL * kSampleRate;
    for (const double loudness : {-14.0, -17.0, -23.0, -40.0}) {
        film.scene.loudness = loudness;
        const SoundLevels levels = levels_of(film.scene);
        EXPECT_NEAR(levels.loudness, loudness, 0.1);
        EXPECT_EQ(levels.limited > 0, loudness > -20) << loudness;
    }
}

TEST(FilmSound, LoudnessOfASingleClack_IsMissedAndToldAsItIs) {
    SmallFilm film;
    film.collide(0.5);
    film.show(0, 1, 0, 1);
    film.scene.loudness = -14;
    const SoundLevels levels = levels_of(film.scene);
    EXPECT_LT(levels.loudness, -14.2);
    EXPECT_LT(levels.limited, kMaxLimited + 0.2);
    film.scene.loudness = levels.loudness - 1;
    EXPECT_NEAR(levels_of(film.scene).loudness, *film.scene.loudness, 0.1);
}

/// What a film could have with some limiting, after it was read.
std::optional<double> gentle_loudness_of(const SoundScene& scene, const AddedSound& added = {}) {
    FilmSound sound(scene, {.added = added});
    sound.read_rest();
    return sound.gentle_loudness();
}

TEST(FilmSound, QuietFilm_KnowsHowLoudItCouldBe) {
    SmallFilm film;
    film.collide(0.5, 5);
    film.touch(1, "cushion", 0.3);
    film.show(0, 3, 0, 1);
    film.scene.frames = 3LL * kSampleRate;
    film.scene.full_scale.reset();
    EXPECT_LT(levels_of(film.scene).loudness, kQuietFilm);
    const std::optional<double> gentle = gentle_loudness_of(film.scene);
    ASSERT_TRUE(gentle);
    const AddedSound music = sine(1, 997, film.scene.frames);
    EXPECT_FALSE(gentle_loudness_of(film.scene, music)) << "with it, it is not quiet";
    film.scene.full_scale =
        FilmSound(film.scene).gain().full_scale * std::pow(10, -kGentlyLimited / 20);
    const SoundLevels limited = levels_of(film.scene);
    EXPECT_NEAR(limited.limited, kGentlyLimited, 0.2);
    EXPECT_NEAR(limited.loudness, *gentle, 0.05);
    EXPECT_FALSE(gentle_loudness_of(film.scene)) << "it has the gain that was asked for";
    film.scene.loudness = -30;
    EXPECT_FALSE(gentle_loudness_of(film.scene));
    SoundScene music_alone;
    music_alone.frames = kSampleRate;
    EXPECT_FALSE(gentle_loudness_of(music_alone, sine(0.01, 997, kSampleRate)));
}

TEST(FilmSound, Loudness_OfSilenceAndOfVeryShortFilms_IsNone) {
    SmallFilm film;
    film.show(0, 1, 0, 1);
    film.scene.loudness = -14;
    EXPECT_FALSE(std::isfinite(levels_of(film.scene).loudness));
    film.collide(0.1);
    film.scene.frames = 19'000;  // of 19 200 for a block of the measurement
    const SoundLevels levels = levels_of(film.scene);
    EXPECT_FALSE(std::isfinite(levels.loudness));
    EXPECT_EQ(levels.limited, 0);
    film.scene.loudness.reset();
    film.scene.full_scale.reset();
    EXPECT_EQ(levels.true_peak, levels_of(film.scene).true_peak) << "as without a loudness";
}

TEST(FilmSound, LoudnessOfAVeryQuietFilm_IsReached) {
    SmallFilm film;
    film.collide(0.5, 0.01);
    film.show(0, 1, 0, 1);
    film.scene.loudness = -50;
    EXPECT_NEAR(levels_of(film.scene).loudness, -50, 0.1);
}

TEST(FilmSound, Music_IsPartOfTheLoudnessAndOfThePeak) {
    SmallFilm film;
    fill(film);
    film.scene.frames = 3LL * kSampleRate;
    for (const double amplitude : {0.1, 1.0, 10.0}) {
        for (const std::int64_t samples : {kSampleRate, 10 * kSampleRate}) {
            const AddedSound music = sine(amplitude, 997, samples);
            film.scene.loudness = -14;
            EXPECT_NEAR(levels_of(film.scene, music).loudness, -14, 0.1) << amplitude;
            film.scene.loudness = -30;
            EXPECT_NEAR(levels_of(film.scene, music).loudness, -30, 0.1) << amplitude;
            film.scene.loudness.reset();
            film.scene.full_scale.reset();
            EXPECT_EQ(levels_of(film.scene, music).limited, 0);
            film.scene.full_scale = 20;
            EXPECT_EQ(levels_of(film.scene, music).limited > 0, amplitude >= 1);
        }
    }
}

TEST(FilmSound, MusicAlone_KeepsItsLevelUnlessItsPeakIsTooHigh) {
    SoundScene silent;
    silent.frames = 48'000;
    const FilmSoundOptions quiet{.added = sine(0.5, 997, 24'000)};
    const Samples samples = samples_of(silent, quiet);
    EXPECT_NEAR(highest(samples.left, 0, 24'000), 0.5, 1e-3);
    EXPECT_EQ(highest(samples.left, 24'000), 0);
    EXPECT_NEAR(levels_of(silent, sine(1, 997, 24'000)).true_peak, -1, 0.02);
}

TEST(FilmSound, GroupsAndMusic_OfALimitedFilm_AddUpToTheFilm) {
    SmallFilm film;
    fill(film);
    film.scene.frames = 2LL * kSampleRate;
    film.scene.loudness = -14;
    const AddedSound music = sine(0.02, 300, 60'000);
    FilmSound whole(film.scene, {.added = music});
    std::vector<double> left(static_cast<std::size_t>(film.scene.frames));
    std::vector<double> right = left;
    ASSERT_EQ(whole.read(left, right), left.size());
    ASSERT_GT(whole.levels().limited, 0);
    FilmSoundOptions part{.added = music, .gain = whole.gain()};
    std::vector<double> sum = [&] {
        part.only_added = true;
        return samples_of(film.scene, part).left;
    }();
    part.only_added = false;
    for (std::size_t group = 0; group < kGroupCount; ++group) {
        part.only = static_cast<Group>(group);
        const Samples stem = samples_of(film.scene, part);
        std::ranges::transform(sum, stem.left, sum.begin(), std::plus<>());
    }
    for (std::size_t n = 0; n < sum.size(); ++n) {
        ASSERT_NEAR(sum[n], left[n], 1e-12);
    }
}

TEST(FilmSound, Limiter_DoesNotMakeTheSoundLate) {
    SmallFilm film;
    film.collide(0.5);
    film.show(0, 1, 0, 1);
    const Samples plain = samples_of(film.scene);
    film.scene.loudness = -60;
    const Samples limited = samples_of(film.scene);
    const auto peak_of = [](const std::vector<double>& samples) {
        return std::ranges::max_element(samples, {}, [](double x) { return std::abs(x); }) -
               samples.begin();
    };
    EXPECT_EQ(peak_of(limited.left), peak_of(plain.left));
}

TEST(FilmSound, End_FadesWithinFiveMilliseconds) {
    SmallFilm film;
    film.touch(0.45, "cushion", 0.3);
    film.show(0, 1, 0, 1);
    const Samples whole = samples_of(film.scene);
    film.scene.frames = 24'000;
    const Samples cut = samples_of(film.scene);
    EXPECT_EQ(cut.left.back(), 0);
    EXPECT_NEAR(cut.left[24'000 - 121], 0.5 * whole.left[24'000 - 121], 1e-12);
    EXPECT_EQ(cut.left[24'000 - 241], whole.left[24'000 - 241]);
}

TEST(FilmSound, StopRequest_WhileTheGainIsFound_Throws) {
    SmallFilm film;
    film.show(0, 1, 0, 1);
    film.scene.full_scale.reset();
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(FilmSound(film.scene, {}, {{}, stop.get_token()}), Stopped);
}

TEST(FilmSound, Progress_RisesToOne) {
    SmallFilm film;
    film.show(0, 1, 0, 1);
    film.scene.full_scale.reset();
    double last = 0;
    const FilmSound sound(film.scene, {},
                          {[&last](double part) {
                               EXPECT_GE(part, last);
                               last = part;
                           },
                           {}});
    EXPECT_EQ(last, 1);
}

// Blows of any strength, order and place, shown by any map: what is heard is finite.
TEST(FilmSound, RandomFilms_AreFinite) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int run = 0; run < 30; ++run) {
        SmallFilm film;
        const char* surfaces[] = {"cushion", "cloth", "pocket", "rail", "floor"};
        for (int i = 0; i < 60; ++i) {
            if (unit(random) < 0.5) {
                film.collide(unit(random), std::pow(10, 4 * unit(random) - 3));
            } else {
                film.touch(unit(random), surfaces[i % 5], std::pow(10, 4 * unit(random) - 4));
            }
        }
        std::ranges::stable_sort(film.timeline.events, {}, &sim::Event::time);
        film.shot().has_bed = true;
        film.shot().room.kind = RoomSettings::Kind::box;
        for (int i = 0; i < 4; ++i) {
            const Vec3 place(unit(random) - 0.5, unit(random) - 0.5, unit(random) - 0.2);
            Clip& clip =
                film.show(0.25 * i, 0.25 * (i + 1), unit(random), 6 * unit(random) - 3, place);
            clip.settings.stereo = static_cast<Stereo>(run % 3);
            clip.settings.ratio = 1 + 3 * unit(random);
            clip.settings.pitch = unit(random);
            clip.settings.has_delay = run % 2 == 0;
        }
        const Samples samples = samples_of(film.scene);
        for (std::size_t n = 0; n < samples.left.size(); ++n) {
            ASSERT_TRUE(std::abs(samples.left[n]) < 1e4 && std::abs(samples.right[n]) < 1e4)
                << run << " " << n;
        }
    }
}

}  // namespace
}  // namespace carom::sound
