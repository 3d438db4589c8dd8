#include "pipeline/sound/loudness_note.h"

#include <limits>

#include <gtest/gtest.h>

namespace carom::pipeline {
namespace {

TEST(QuietFilmNote, FilmFarBelowPlatforms_IsToldWhatToAskFor) {
    sound::FilmGain gain;
    gain.gentle = -21.3;
    EXPECT_EQ(quiet_film_note(gain, {-30.66, -1, 0}),
              "the film has -30.7 LUFS, and platforms play films at -14 to -16 LUFS; "
              "'sound: {loudness: -22 LUFS}' makes it louder");
    gain.gentle = -12;
    EXPECT_EQ(quiet_film_note(gain, {-23.01, -1, 0}),
              "the film has -23 LUFS, and platforms play films at -14 to -16 LUFS; "
              "'sound: {loudness: -16 LUFS}' makes it louder");
}

TEST(QuietFilmNote, FilmWithALoneCrack_IsToldWhy) {
    sound::FilmGain gain;
    gain.gentle = -31.2;
    EXPECT_EQ(quiet_film_note(gain, {-33.1, -1, 0}),
              "the film has -33.1 LUFS, and platforms play films at -14 to -16 LUFS; its loudest "
              "sounds are short and far above the rest: a higher 'dynamics', up to 4, brings them "
              "nearer to it, and then 'loudness' can make the film louder");
}

TEST(QuietFilmNote, OtherFilms_HaveNone) {
    sound::FilmGain gain;
    constexpr double kSilence = -std::numeric_limits<double>::infinity();
    EXPECT_EQ(quiet_film_note(gain, {-40, -1, 0}), "") << "its gain is not automatic";
    gain.gentle = -16;
    EXPECT_EQ(quiet_film_note(gain, {-22.9, -1, 0}), "");
    gain.gentle.reset();
    EXPECT_EQ(quiet_film_note(gain, {kSilence, kSilence, 0}), "");
}

}  // namespace
}  // namespace carom::pipeline
