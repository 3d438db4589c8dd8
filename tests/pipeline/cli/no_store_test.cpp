// End-to-end tests of --no-store: rendering without a cache that can be written to.
#include <filesystem>
#include <map>

#include "tests/pipeline/cli/end_to_end.h"

namespace carom::cli {
namespace {

using carom::testing::EndToEnd;
using carom::testing::RunResult;
using carom::testing::write_text;
using ::testing::HasSubstr;
using ::testing::Not;

namespace fs = std::filesystem;

constexpr const char* kWarning =
    "carom: warning: nothing is stored (--no-store): if this is interrupted, it starts anew\n";

class NoStore : public EndToEnd {
  protected:
    /// All files of a folder with their times.
    [[nodiscard]] std::map<std::string, fs::file_time_type> files(const std::string& name) const {
        std::map<std::string, fs::file_time_type> found;
        for (const auto& entry : fs::recursive_directory_iterator(path(name))) {
            found[entry.path().string()] = entry.last_write_time();
        }
        return found;
    }
};

TEST_F(NoStore, Films_HaveTheSameBytesAndNoCacheIsMade) {
    const std::vector<std::vector<std::string>> films{
        {"render", "tiny.yaml"},
        {"render", "tiny.yaml", "--frames", "1-4"},
        {"retime", "tiny.yaml", "--speed", "1/2", "--reverse"},
        {"render", "tiny.yaml", "--set", "output.hdr10={}", "--set", "output.codec=hevc"},
        {"render", "fade.yaml"}};
    std::string fading = text_of("tiny.yaml");
    fading.insert(fading.find("render: {"),
                  "  - name: other\n    fade: 0.3 s\n    video: [0.3 s, 0.6 s]\n"
                  "    scene: [0.3 s, 0.3 s]\n    position: [1, -1, 0.8]\n"
                  "    target: [0, 0, 0]\n    fov: 40 deg\n");
    write_text(path("fade.yaml"), fading);
    for (std::vector<std::string> film : films) {
        film.insert(film.end(), {"-o", "stored.mp4"});
        const RunResult stored = run(film);
        ASSERT_EQ(stored.exit_code, 0) << stored.err;
        film.back() = "unstored.mp4";
        film.insert(film.end(), {"--no-store", "--cache", path("nowhere")});
        const RunResult unstored = run(film);
        EXPECT_EQ(unstored.exit_code, 0) << unstored.err;
        EXPECT_THAT(unstored.err, HasSubstr(kWarning));
        EXPECT_EQ(text_of("unstored.mp4"), text_of("stored.mp4")) << film[1] << " " << film[0];
    }
    EXPECT_FALSE(exists("nowhere"));
}

TEST_F(NoStore, Pictures_AreTheSame) {
    for (const std::string command : {"frame", "contact-sheet"}) {
        EXPECT_EQ(run({command, "tiny.yaml", "-o", "stored.png"}).exit_code, 0);
        const RunResult unstored = run(
            {command, "tiny.yaml", "-o", "unstored.png", "--no-store", "--cache", path("nowhere")});
        EXPECT_EQ(unstored.exit_code, 0) << unstored.err;
        EXPECT_EQ(text_of("unstored.png"), text_of("stored.png"));
    }
    EXPECT_FALSE(exists("nowhere"));
    const RunResult chunk = run({"render", "tiny.yaml", "--chunk", "2/3", "-o", "tiny.#.exr",
                                 "--no-store", "--cache", path("nowhere")});
    EXPECT_EQ(chunk.exit_code, 0) << chunk.err;
    EXPECT_TRUE(exists("tiny.2.exr") && exists("tiny.3.exr") && !exists("tiny.1.exr"));
}

TEST_F(NoStore, ExistingCache_IsReadAndStaysAsItIs) {
    ASSERT_EQ(run({"render", "tiny.yaml", "--chunk", "1/2"}).exit_code, 0);
    const auto before = files("cache");
    const RunResult result = run({"render", "tiny.yaml", "-o", "film.mp4", "--no-store"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("using the cached bake"));
    EXPECT_THAT(result.err, HasSubstr("6 frames, 3 of them rendered now"));
    EXPECT_EQ(files("cache"), before);
    EXPECT_EQ(run({"render", "tiny.yaml", "--no-store", "--dry-run", "--quiet"}).out,
              "stored: 0-2\nto render: 3-5\n6 frames, 3 stored, 3 to render\n");
    EXPECT_EQ(files("cache"), before);
    ASSERT_EQ(run({"render", "tiny.yaml", "-o", "whole.mp4"}).exit_code, 0);
    EXPECT_EQ(text_of("film.mp4"), text_of("whole.mp4"));
}

TEST_F(NoStore, DamagedFrame_IsRenderedAndItsFileStays) {
    ASSERT_EQ(run({"render", "tiny.yaml", "-o", "whole.mp4"}).exit_code, 0);
    for (const auto& entry : fs::recursive_directory_iterator(path("cache/frames"))) {
        if (entry.path().extension() == ".exr") {
            fs::resize_file(entry.path(), 2000);
        }
    }
    const auto before = files("cache");
    const RunResult result = run({"render", "tiny.yaml", "-o", "film.mp4", "--no-store"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("is damaged and is rendered again"));
    EXPECT_EQ(files("cache"), before);
    EXPECT_EQ(text_of("film.mp4"), text_of("whole.mp4"));
}

// Links to themselves: root, who may run this test, can read everything else.
TEST_F(NoStore, CacheThatCannotBeRead_IsAsIfItWereEmpty) {
    ASSERT_EQ(run({"render", "tiny.yaml", "-o", "whole.mp4"}).exit_code, 0);
    std::vector<fs::path> all;
    for (const auto& entry : fs::recursive_directory_iterator(path("cache"))) {
        if (entry.is_regular_file()) {
            all.push_back(entry.path());
        }
    }
    for (const fs::path& file : all) {
        fs::remove(file);
        fs::create_symlink(file, file);
    }
    const RunResult result = run({"render", "tiny.yaml", "-o", "film.mp4", "--no-store"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("6 frames, 6 of them rendered now"));
    EXPECT_EQ(text_of("film.mp4"), text_of("whole.mp4"));
    const RunResult frame = run({"frame", "tiny.yaml", "--no-store"});
    EXPECT_EQ(frame.exit_code, 0) << frame.err;
}

TEST_F(NoStore, ChunkWithoutOutput_IsRejected) {
    const RunResult result = run({"render", "tiny.yaml", "--no-store", "--chunk", "1/2"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("with --no-store the frames of a chunk would be lost"));
    EXPECT_FALSE(exists("cache"));
}

TEST_F(NoStore, CacheThatCannotBeMade_SuggestsIt) {
    write_text(path("file"), "not a folder");
    const RunResult result = run({"render", "tiny.yaml", "-o", "a.mp4", "--cache", path("file/c")});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr("; --no-store renders without a cache\n"));
    EXPECT_THAT(result.err, Not(HasSubstr("simulated"))) << "it fails before that";
    const RunResult other = run({"mux", "tiny.yaml", "-o", "a.mp4", "--cache", path("file/c")});
    EXPECT_EQ(other.exit_code, 1);
    EXPECT_THAT(other.err, Not(HasSubstr("--no-store"))) << "mux has no such option";
    EXPECT_EQ(run({"render", "tiny.yaml", "-o", "a.mp4", "--cache", path("file/c"), "--no-store"})
                  .exit_code,
              0);
}

}  // namespace
}  // namespace carom::cli
