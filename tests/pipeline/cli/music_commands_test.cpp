// End-to-end tests of films with music.
#include <algorithm>
#include <vector>

#include "tests/pipeline/cli/end_to_end.h"
#include "tests/pipeline/video/decoded_sound.h"

namespace carom::cli {
namespace {

using carom::testing::decode_sound;
using carom::testing::DecodedSound;
using carom::testing::EndToEnd;
using carom::testing::RunResult;
using carom::testing::write_text;
using ::testing::HasSubstr;

class MusicCommands : public EndToEnd {
  protected:
    /// A WAV file of one channel at 48 kHz: 0.1 s of 8-bit samples of 0.5.
    void write_music() const {
        const std::string header = std::string(
            "RIFF\xe4\x12\0\0WAVEfmt \x10\0\0\0\1\0\1\0\x80\xbb\0\0"
            "\x80\xbb\0\0\1\0\x08\0data\xc0\x12\0\0",
            44);
        write_text(path("music.wav"), header + std::string(4800, '\xc0'));
    }
};

TEST_F(MusicCommands, FilmOfAFilm_HasItsMusic) {
    write_music();
    const RunResult made = run({"render", "tiny.yaml", "-o", "a.mkv", "--set", "sound=none",
                                "--set", "output.music={file: music.wav, gain: -20 dB}"});
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const DecodedSound found = decode_sound(path("a.mkv"));
    EXPECT_EQ(found.codec, "flac");
    const std::vector<double> left = found.channel(false);
    ASSERT_EQ(left.size(), 28800U) << "six frames of a tenth of a second";
    EXPECT_NEAR(left[1000], 0.05, 1e-6);
    EXPECT_EQ(left[4800], 0);
    // The film itself can be the music of another container.
    const RunResult again = run({"render", "tiny.yaml", "-o", "b.mov", "--set", "sound=none",
                                 "--set", "output={music: a.mkv, codec: prores}"});
    ASSERT_EQ(again.exit_code, 0) << again.err;
    EXPECT_TRUE(decode_sound(path("b.mov")).channel(false) == left);
}

// The loudness and the limit hold for the whole mix, whichever command makes it.
TEST_F(MusicCommands, SoundOfAFilm_IncludesItsMusicInEveryCommand) {
    write_music();
    const auto with = [](std::vector<std::string> words, const std::string& loudness) {
        words.insert(words.end(), {"--set", "output.music={file: music.wav, gain: 10 dB}", "--set",
                                   "sound.loudness=" + loudness});
        return words;
    };
    ASSERT_EQ(run(with({"render", "tiny.yaml", "-q", "-o", "a.mkv"}, "-16 LUFS")).exit_code, 0);
    const RunResult sound = run(with(
        {"sound", "tiny.yaml", "-q", "-o", "a.wav", "--report", "--stems", "stems"}, "-16 LUFS"));
    ASSERT_EQ(sound.exit_code, 0) << sound.err;
    EXPECT_THAT(sound.out, HasSubstr("loudness    -16."));
    EXPECT_THAT(sound.out, HasSubstr(" LUFS (asked for: -16)\n"));
    EXPECT_THAT(sound.out, HasSubstr("music       is included\n"));
    EXPECT_TRUE(exists("stems/music.wav"));
    const std::vector<double> heard = decode_sound(path("a.wav")).channel(false);
    EXPECT_TRUE(heard == decode_sound(path("a.mkv")).channel(false));
    EXPECT_LE(*std::ranges::max_element(heard), 0.8913);
    EXPECT_EQ(run(with({"check", "tiny.yaml"}, "-24 LUFS")).err,
              "carom: 'tiny.yaml' has no errors\n");
    const std::string missed =
        "warning: the film has -[0-9.]+ LUFS instead of -5 LUFS, [0-9.]+ LU less";
    EXPECT_THAT(run(with({"check", "tiny.yaml"}, "-5 LUFS")).err, ::testing::ContainsRegex(missed));
    EXPECT_THAT(run(with({"sound", "tiny.yaml", "-o", "b.wav"}, "-5 LUFS")).err,
                ::testing::ContainsRegex(missed));
    const RunResult rendered = run(with({"render", "tiny.yaml", "-o", "b.mkv"}, "-5 LUFS"));
    EXPECT_EQ(rendered.exit_code, 0);
    EXPECT_THAT(rendered.err, ::testing::ContainsRegex(missed));
}

TEST_F(MusicCommands, SoundOfASilentShotWithMusic_IsTheMusic) {
    write_music();
    const RunResult result = run({"sound", "tiny.yaml", "-q", "-o", "a.wav", "--set", "sound=none",
                                  "--set", "output.music=music.wav"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NEAR(decode_sound(path("a.wav")).channel(false).at(1000), 0.5, 1e-6);
}

TEST_F(MusicCommands, MusicThatCannotBePlayed_IsAnErrorWithItsPlace) {
    write_text(path("music.mp3"), "this is no music at all");
    for (const auto& [command, file] : {std::pair{"render", "a.mkv"}, {"sound", "a.wav"}}) {
        const RunResult result =
            run({command, "tiny.yaml", "-o", file, "--set", "output.music=music.mp3"});
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_THAT(result.err, HasSubstr(": error: cannot read the sound of '"));
        EXPECT_THAT(result.err, HasSubstr("    1 | output.music=music.mp3\n"));
        EXPECT_THAT(result.err, HasSubstr("carom: error: "));
    }
    EXPECT_EQ(stored_frames(), 0);
    EXPECT_FALSE(exists("a.mkv"));
}

TEST_F(MusicCommands, SoundThatTheFileCannotHold_IsAnErrorBeforeAnythingIsRendered) {
    const RunResult result =
        run({"render", "tiny.yaml", "-o", "a.mp4", "--set", "output.audio=flac"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr(".mp4 files cannot hold flac sound; the codecs of sound and "
                                      "their file extensions are "));
    EXPECT_EQ(stored_frames(), 0);
}

TEST_F(MusicCommands, SoundInFilesThatNeedAnEncoder_IsThatOfTheWavFile) {
    ASSERT_EQ(run({"sound", "tiny.yaml", "-o", "a.wav"}).exit_code, 0);
    const DecodedSound wav = decode_sound(path("a.wav"));
    for (const auto& [name, codec] :
         {std::pair{"a.flac", "flac"}, {"a.m4a", "aac"}, {"a.opus", "opus"}}) {
        const RunResult result = run({"sound", "tiny.yaml", "-o", name});
        ASSERT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(result.out, std::string(name) + "\n");
        const DecodedSound found = decode_sound(path(name));
        EXPECT_EQ(found.codec, codec);
        EXPECT_GE(found.samples(), wav.samples());
        if (found.codec == "flac") {
            EXPECT_TRUE(found.channel(false) == wav.channel(false));
        }
    }
    const RunResult unknown = run({"sound", "tiny.yaml", "-o", "a.mp3"});
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_THAT(unknown.err, HasSubstr("'a.mp3' is not a known type of sound file; the file "
                                       "extensions are .flac, .m4a, .opus, .mka, and .wav"));
}

}  // namespace
}  // namespace carom::cli
