// The sound of a film has the same bytes whatever happens while it is made, and nothing that is
// stored depends on how a film sounds.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "tests/pipeline/cli/sound_fixture.h"
#include "tests/pipeline/video/decoded_sound.h"

namespace carom::cli {
namespace {

using carom::testing::carom_program;
using carom::testing::run_carom;
using carom::testing::RunningProgram;
using carom::testing::RunOptions;
using carom::testing::RunResult;
using carom::testing::SoundCommands;

namespace fs = std::filesystem;

class SoundBytes : public SoundCommands {
  protected:
    /// The bytes of the sound of the tiny shot, slowed to half a minute.
    static constexpr const char* kSpeed = "1/50";
    [[nodiscard]] std::vector<std::string> command(const std::string& name) const {
        return {"sound", "tiny.yaml", "-q", "--speed", kSpeed, "-o", name};
    }
    [[nodiscard]] std::string expected() {
        const RunResult result = run(command("expected.wav"));
        EXPECT_EQ(result.exit_code, 0) << result.err;
        const std::string bytes = text_of("expected.wav");
        EXPECT_EQ(bytes.size(), 44U + 6U * 30 * 48'000);
        EXPECT_TRUE(std::any_of(bytes.begin() + 44, bytes.end(), [](char x) { return x != 0; }));
        return bytes;
    }
};

TEST_F(SoundBytes, SeveralAtATime_AreAlike) {
    const std::string bytes = expected();
    std::vector<std::unique_ptr<RunningProgram>> running;
    for (const char* name : {"a.wav", "b.wav", "c.wav"}) {
        running.push_back(
            std::make_unique<RunningProgram>(carom_program(), command(name), options()));
    }
    for (const auto& program : running) {
        EXPECT_EQ(program->wait().exit_code, 0);
    }
    for (const char* name : {"a.wav", "b.wav", "c.wav"}) {
        EXPECT_TRUE(text_of(name) == bytes) << name;
    }
}

TEST_F(SoundBytes, KilledAndRepeated_LeavesNoHalfFile) {
    const std::string bytes = expected();
    {
        RunningProgram program(carom_program(), command("killed.wav"), options());
        // Until it has begun to write, to a file with a temporary name.
        const auto has_begun = [this] {
            return std::ranges::any_of(
                results(), [](const std::string& name) { return name.ends_with(".part"); });
        };
        while (!has_begun()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        program.send(SIGKILL);
        EXPECT_EQ(program.wait().exit_code, 128 + SIGKILL);
    }
    EXPECT_FALSE(exists("killed.wav"));
    EXPECT_EQ(run(command("killed.wav")).exit_code, 0);
    EXPECT_TRUE(text_of("killed.wav") == bytes);
}

TEST_F(SoundBytes, OtherRoutinesOfTheCLibrary_AreAlike) {
    const std::vector<std::string> break_sound{"sound", example("nine_ball_break"), "-q", "-o"};
    ASSERT_EQ(run(joined(break_sound, {"usual.wav"})).exit_code, 0);
    const RunOptions other{path(""),
                           {{"CAROM_CACHE", path("other")},
                            {"GLIBC_TUNABLES", "glibc.cpu.hwcaps=-AVX2,-FMA,-AVX,-FMA4"}}};
    ASSERT_EQ(run_carom(joined(break_sound, {"other.wav"}), other).exit_code, 0);
    EXPECT_GT(text_of("usual.wav").size(), 1'000'000U);
    EXPECT_TRUE(text_of("usual.wav") == text_of("other.wav"));
}

/// The codec that the film's sound has, "none" without a stream.
std::string sound_codec(const std::string& film) {
    const carom::testing::DecodedSound sound = carom::testing::decode_sound(film);
    return sound.has_sound ? sound.codec : "none";
}

TEST_F(SoundBytes, Films_AreTheSameInOneGoInChunksAndMuxed) {
    const auto render = [this](const std::vector<std::string>& words) {
        std::vector<std::string> command{"render", "tiny.yaml", "-q"};
        command.insert(command.end(), words.begin(), words.end());
        const RunResult result = run(command);
        EXPECT_EQ(result.exit_code, 0) << result.err;
    };
    render({"-o", "one.mp4", "--threads", "1"});
    const std::string bytes = text_of("one.mp4");
    EXPECT_EQ(sound_codec(path("one.mp4")), "aac");
    render({"-o", "more.mp4", "--threads", "16", "--cache", path("other")});
    EXPECT_TRUE(text_of("more.mp4") == bytes);
    for (const char* chunk : {"1/2", "2/2"}) {
        render({"--chunk", chunk, "--cache", path("third")});
    }
    const RunResult muxed =
        run({"mux", "tiny.yaml", "-q", "-o", "muxed.mp4", "--cache", path("third")});
    ASSERT_EQ(muxed.exit_code, 0) << muxed.err;
    EXPECT_TRUE(text_of("muxed.mp4") == bytes);
}

TEST_F(SoundBytes, SoundNone_IsAFilmWithoutASoundStream) {
    ASSERT_EQ(run({"render", "tiny.yaml", "-q", "-o", "a.mkv"}).exit_code, 0);
    EXPECT_EQ(sound_codec(path("a.mkv")), "flac");
    ASSERT_EQ(run({"render", "tiny.yaml", "-q", "-o", "b.mkv", "--set", "sound=none"}).exit_code,
              0);
    EXPECT_EQ(sound_codec(path("b.mkv")), "none");
    ASSERT_EQ(
        run({"render", "tiny.yaml", "-q", "-o", "c.mkv", "--set", "output.audio=none"}).exit_code,
        0);
    EXPECT_EQ(sound_codec(path("c.mkv")), "none");
    EXPECT_TRUE(text_of("b.mkv") == text_of("c.mkv"));
    const RunResult silent = run({"sound", "tiny.yaml", "-o", "x.wav", "--set", "sound=none"});
    EXPECT_EQ(silent.exit_code, 2);
    EXPECT_EQ(
        silent.err,
        "carom: error: 'tiny.yaml' says 'sound: none' and has no music, so its film is silent\n");
}

TEST_F(SoundBytes, StoredFramesAndBakes_HaveTheSameNamesWithAnySound) {
    const auto stored = [this] {
        std::vector<std::string> names;
        for (const auto& entry : fs::recursive_directory_iterator(path("cache"))) {
            const std::string extension = entry.path().extension().string();
            if (extension == ".exr" || extension == ".bake") {
                names.push_back(fs::relative(entry.path(), path("cache")).string());
            }
        }
        std::ranges::sort(names);
        return names;
    };
    const auto render = [this](const std::vector<std::string>& settings) {
        std::vector<std::string> words{"render", "tiny.yaml", "-o", "film.mp4"};
        for (const std::string& setting : settings) {
            words.insert(words.end(), {"--set", setting});
        }
        const RunResult result = run(words);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return result.err;
    };
    render({"sound=none"});
    const std::vector<std::string> names = stored();
    EXPECT_EQ(names.size(), 7U);  // six frames and a bake
    const std::vector<std::vector<std::string>> sounds{
        {},
        {"sound.room=hall", "sound.stereo=mono", "sound.gain.full_scale=2 Pa"},
        {"sound.loudness=-16 LUFS", "sound.mix.balls=-6 dB"},
        {"cameras[0].sound.pitch=keep", "sound.materials.ball.modulus=9 GPa"}};
    for (const std::vector<std::string>& sound : sounds) {
        EXPECT_THAT(render(sound), ::testing::HasSubstr("using the cached bake"));
        EXPECT_EQ(stored(), names);
    }
    render({"render.seed=1"});  // what changes pictures does make other names
    EXPECT_EQ(stored().size(), names.size() + 6);
}

}  // namespace
}  // namespace carom::cli
