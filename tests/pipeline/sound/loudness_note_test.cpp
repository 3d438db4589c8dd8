#include "pipeline/sound/loudness_note.h"

#include <optional>

#include <gtest/gtest.h>

namespace carom::pipeline {
namespace {

TEST(QuietFilmNote, FilmFarBelowPlatforms_IsToldWhatToAskFor) {
    EXPECT_EQ(quiet_film_note(-30.66, -21.3),
              "the film has -30.7 LUFS, and platforms play films at -14 to -16 LUFS; "
              "'sound: {loudness: -22 LUFS}' makes it louder");
    EXPECT_EQ(quiet_film_note(-23.01, -12),
              "the film has -23 LUFS, and platforms play films at -14 to -16 LUFS; "
              "'sound: {loudness: -16 LUFS}' makes it louder");
}

TEST(QuietFilmNote, FilmWithALoneCrack_IsToldWhy) {
    EXPECT_EQ(quiet_film_note(-33.1, -31.2),
              "the film has -33.1 LUFS, and platforms play films at -14 to -16 LUFS; its loudest "
              "sounds are short and far above the rest: a higher 'dynamics', up to 4, brings them "
              "nearer to it, and then 'loudness' can make the film louder");
}

TEST(QuietFilmNote, FilmThatIsLoudEnough_HasNone) {
    EXPECT_EQ(quiet_film_note(-22.9, std::nullopt), "");
}

}  // namespace
}  // namespace carom::pipeline
