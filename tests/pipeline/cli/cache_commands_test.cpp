// cache, mux, chunks and --dry-run, run as a user runs them.
#include "tests/pipeline/cli/end_to_end.h"

namespace carom::cli {
namespace {

using carom::testing::EndToEnd;
using carom::testing::RunResult;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class CacheCommands : public EndToEnd {
  protected:
    /// The largest frame that is stored.
    [[nodiscard]] std::string some_frame() const {
        for (const auto& entry :
             std::filesystem::recursive_directory_iterator(path("cache/frames"))) {
            if (entry.path().extension() == ".exr") {
                return entry.path().string();
            }
        }
        return {};
    }
};

TEST_F(CacheCommands, ChunksThenMux_GiveTheFilm) {
    ASSERT_EQ(run({"render", "tiny.yaml", "-o", "whole.mp4", "--cache", "cache2"}).exit_code, 0);
    const RunResult first = run({"render", "tiny.yaml", "--chunk", "1/2"});
    EXPECT_EQ(first.exit_code, 0) << first.err;
    EXPECT_EQ(first.out, "");
    EXPECT_THAT(results(), ElementsAre("whole.mp4"));
    EXPECT_EQ(run({"render", "tiny.yaml", "--dry-run"}).out,
              "there: 0-2\nto render: 3-5\n6 frames, 3 there, 3 to render\n");
    const RunResult early = run({"mux", "tiny.yaml", "-o", "film.mp4"});
    EXPECT_EQ(early.exit_code, 1);
    EXPECT_THAT(early.err, HasSubstr("3 of 6 frames are not in the cache: 3-5"));
    EXPECT_EQ(run({"render", "tiny.yaml", "--chunk", "2/2"}).exit_code, 0);
    const RunResult mux = run({"mux", "tiny.yaml", "-o", "film.mp4"});
    EXPECT_EQ(mux.exit_code, 0) << mux.err;
    EXPECT_EQ(mux.out, "film.mp4\n");
    EXPECT_EQ(text_of("film.mp4"), text_of("whole.mp4"));
}

TEST_F(CacheCommands, ChunkAsAFilm_IsRefused) {
    const RunResult result = run({"render", "tiny.yaml", "--chunk", "1/2", "-o", "film.mp4"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("a chunk is no film"));
    EXPECT_EQ(run({"render", "tiny.yaml", "--chunk", "3/2"}).exit_code, 2);
    EXPECT_EQ(stored_frames(), 0);
}

TEST_F(CacheCommands, ListVerifyPrune_SayAndDo) {
    EXPECT_THAT(run({"cache", "list"}).out, HasSubstr("0 frames, 0 B"));
    ASSERT_EQ(run({"render", "tiny.yaml", "-o", "film.mp4"}).exit_code, 0);
    EXPECT_THAT(run({"cache", "list"}).out, HasSubstr("\n6 frames, "));
    EXPECT_THAT(run({"cache", "list"}).out, HasSubstr("\n1 bake, "));
    EXPECT_THAT(run({"cache", "list", "--json"}).out, StartsWith("{\"kind\":\""));
    EXPECT_EQ(run({"cache", "verify"}).exit_code, 0);

    const std::string damaged = some_frame();
    std::filesystem::resize_file(damaged, 1000);
    const RunResult named = run({"cache", "verify", "--keep"});
    EXPECT_EQ(named.exit_code, 1);
    EXPECT_EQ(named.out, damaged + "\n");
    EXPECT_EQ(stored_frames(), 6);
    EXPECT_THAT(run({"cache", "verify"}).err, HasSubstr("1 damaged file of 7"));
    EXPECT_EQ(stored_frames(), 5);

    EXPECT_THAT(run({"cache", "prune", "--all", "--dry-run"}).err,
                HasSubstr("would remove 6 files"));
    EXPECT_EQ(stored_frames(), 5);
    EXPECT_EQ(run({"cache", "prune", "--unused-for", "1h"}).exit_code, 0);
    EXPECT_EQ(stored_frames(), 5);
    EXPECT_EQ(run({"cache", "prune", "--cache-size", "20 kB"}).exit_code, 0);
    EXPECT_EQ(stored_frames(), 2);
    EXPECT_EQ(run({"cache", "prune", "--all"}).exit_code, 0);
    EXPECT_EQ(stored_frames(), 0);
}

TEST_F(CacheCommands, RenderUnderALimit_KeepsTheCacheSmall) {
    ASSERT_EQ(run({"render", "tiny.yaml", "-o", "a.mp4"}).exit_code, 0);
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path("cache"))) {
        if (entry.is_regular_file()) {
            std::filesystem::last_write_time(
                entry.path(),
                std::filesystem::file_time_type::clock::now() - std::chrono::hours(1));
        }
    }
    const RunResult result = run({"render", "tiny.yaml", "-o", "b.mp4", "--set", "render.samples=5",
                                  "--frames", "0-1", "--cache-size", "60 kB"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(stored_frames(), 6);
    EXPECT_THAT(run({"render", "tiny.yaml", "--cache-size", "lots"}).err,
                HasSubstr("'lots' is not a size"));
}

TEST_F(CacheCommands, BadOptions_AreRefused) {
    EXPECT_EQ(run({"cache"}).exit_code, 2);
    EXPECT_EQ(run({"cache", "burn"}).exit_code, 2);
    EXPECT_THAT(run({"cache", "prune", "--unused-for", "3 moons"}).err,
                HasSubstr("'3 moons' is not a time"));
}

}  // namespace
}  // namespace carom::cli
