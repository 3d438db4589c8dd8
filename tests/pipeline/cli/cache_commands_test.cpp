// End-to-end tests of cache, mux, chunks and --dry-run.
#include "tests/pipeline/cli/end_to_end.h"

namespace carom::cli {
namespace {

using carom::testing::EndToEnd;
using carom::testing::RunResult;
using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

class CacheCommands : public EndToEnd {
  protected:
    /// The path of one stored frame.
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

TEST_F(CacheCommands, ChunksAndMux_GiveTheFilm) {
    ASSERT_EQ(run({"render", "tiny.yaml", "-o", "whole.mp4", "--cache", "cache2"}).exit_code, 0);
    const RunResult first = run({"render", "tiny.yaml", "--chunk", "1/2"});
    EXPECT_EQ(first.exit_code, 0) << first.err;
    EXPECT_EQ(first.out, "");
    EXPECT_THAT(results(), ElementsAre("whole.mp4"));
    EXPECT_EQ(run({"render", "tiny.yaml", "--dry-run"}).out,
              "stored: 0-2\nto render: 3-5\n6 frames, 3 stored, 3 to render\n");
    const RunResult early = run({"mux", "tiny.yaml", "-o", "film.mp4"});
    EXPECT_EQ(early.exit_code, 1);
    EXPECT_THAT(early.err,
                HasSubstr("3 of 6 frames are not in the cache: 3-5; 'carom render' renders them"));
    EXPECT_EQ(run({"render", "tiny.yaml", "--chunk", "2/2"}).exit_code, 0);
    const RunResult mux = run({"mux", "tiny.yaml", "-o", "film.mp4"});
    EXPECT_EQ(mux.exit_code, 0) << mux.err;
    EXPECT_EQ(mux.out, "film.mp4\n");
    EXPECT_EQ(text_of("film.mp4"), text_of("whole.mp4"));
}

TEST_F(CacheCommands, DryRun_ForecastsWhatIsMissing) {
    const RunResult film = run({"render", "tiny.yaml", "-o", "film.mp4", "--dry-run"});
    EXPECT_EQ(film.exit_code, 0) << film.err;
    EXPECT_EQ(film.out, "to render: 0-5\n6 frames, 0 stored, 6 to render\n");
    EXPECT_THAT(film.err, ContainsRegex("carom: about [0-9]+ s of processor time "
                                        "\\(give or take [0-9]+ %\\), [0-9]+ s on [0-9]+ "
                                        "processors?; [0-9]+ MB of memory, [0-9.]+ [kM]?B in the "
                                        "cache, a film of [0-9.]+ [kM]?B\n"));
    EXPECT_EQ(stored_frames(), 0);
    const RunResult chunk =
        run({"render", "tiny.yaml", "--chunk", "1/2", "--dry-run", "--log", "json"});
    EXPECT_THAT(chunk.err, HasSubstr("\"event\":\"forecast\",\"frames\":3,\"pictures\":3,"
                                     "\"cpu_seconds\":"));
    EXPECT_THAT(chunk.err, HasSubstr("\"film_bytes\":0,")) << "a chunk writes no film";
    EXPECT_THAT(run({"render", "tiny.yaml", "--dry-run", "--quiet"}).err, IsEmpty());
    ASSERT_EQ(run({"render", "tiny.yaml", "-o", "film.mp4"}).exit_code, 0);
    EXPECT_THAT(run({"render", "tiny.yaml", "--dry-run"}).err, Not(HasSubstr("of processor time")))
        << "nothing is missing";
}

TEST_F(CacheCommands, ChunkAsAFilm_IsRejected) {
    const RunResult result = run({"render", "tiny.yaml", "--chunk", "1/2", "-o", "film.mp4"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("cannot write the film 'film.mp4' from one chunk; omit -o"));
    EXPECT_EQ(run({"render", "tiny.yaml", "--chunk", "3/2"}).exit_code, 2);
    EXPECT_EQ(stored_frames(), 0);
}

TEST_F(CacheCommands, ListVerifyAndPrune_ReportAndRemoveFiles) {
    EXPECT_THAT(run({"cache", "list"}).out, HasSubstr("0 frames, 0 B"));
    ASSERT_EQ(run({"render", "tiny.yaml", "-o", "film.mp4"}).exit_code, 0);
    EXPECT_THAT(run({"cache", "list"}).out, HasSubstr("\n6 frames, "));
    EXPECT_THAT(run({"cache", "list"}).out, HasSubstr("\n1 bake, "));
    EXPECT_THAT(run({"cache", "list", "--json"}).out, StartsWith("{\"kind\":\""));
    const RunResult intact = run({"cache", "verify"});
    EXPECT_EQ(intact.exit_code, 0);
    EXPECT_THAT(intact.err, HasSubstr("carom: checked 7 files in '"));
    EXPECT_THAT(intact.err, HasSubstr("': none is damaged\n"));

    const std::string damaged = some_frame();
    std::filesystem::resize_file(damaged, 1000);
    const RunResult kept = run({"cache", "verify", "--keep"});
    EXPECT_EQ(kept.exit_code, 1);
    EXPECT_EQ(kept.out, damaged + "\n");
    EXPECT_THAT(kept.err, HasSubstr("' is damaged\n"));
    EXPECT_EQ(stored_frames(), 6);
    const RunResult removed = run({"cache", "verify"});
    EXPECT_THAT(removed.err, HasSubstr("carom: error: 1 of 7 files in '"));
    EXPECT_THAT(removed.err,
                HasSubstr("' is damaged and was removed; it is made again when it is needed\n"));
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

TEST_F(CacheCommands, NoisyFrames_AreListedAndRemovedApart) {
    const std::vector<std::string> render{
        "render", "tiny.yaml", "--set", "output.denoise=true", "--set", "render.samples=8"};
    const auto with_output = [&](const std::string& name) {
        std::vector<std::string> arguments = render;
        arguments.insert(arguments.end(), {"-o", name});
        return run(arguments);
    };
    ASSERT_EQ(with_output("film.mp4").exit_code, 0);
    EXPECT_THAT(run({"cache", "list"}).out,
                ContainsRegex("\n6 frames, [0-9.]+ kB, used between .*\n1 bake, .*\n"
                              "6 noisy frames, [0-9.]+ kB, used between .*\nreserved "));
    EXPECT_THAT(run({"cache", "list", "--json"}).out, HasSubstr("{\"kind\":\"noisy frame\","));
    EXPECT_THAT(run({"cache", "prune", "--features", "--dry-run"}).err,
                ContainsRegex("^carom: would remove 6 files \\([0-9.]+ kB\\); 7 files "
                              "\\([0-9.]+ kB\\) stay in '.*'\n$"));
    EXPECT_THAT(run({"cache", "prune", "--features", "--unused-for", "1h"}).err,
                StartsWith("carom: removed 0 files (0 B); 13 files ("));
    EXPECT_THAT(run({"cache", "prune", "--features"}).err,
                ContainsRegex("^carom: removed 6 files \\([0-9.]+ kB\\); 7 files "
                              "\\([0-9.]+ kB\\) stay in '.*'\n$"));
    EXPECT_EQ(stored_frames(), 6);
    EXPECT_THAT(run({"cache", "list"}).out, Not(HasSubstr("noisy")));
    EXPECT_EQ(with_output("again.mp4").exit_code, 0);
    EXPECT_EQ(text_of("again.mp4"), text_of("film.mp4"));
    EXPECT_THAT(run({"cache", "list"}).out, Not(HasSubstr("noisy"))) << "nothing was rendered";
    EXPECT_EQ(run({"cache", "prune", "--features", "--all"}).exit_code, 2);
}

TEST_F(CacheCommands, RenderWithALimit_KeepsTheCacheSmall) {
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

TEST_F(CacheCommands, InvalidOptions_AreRejected) {
    EXPECT_EQ(run({"cache"}).exit_code, 2);
    EXPECT_EQ(run({"cache", "burn"}).exit_code, 2);
    EXPECT_THAT(run({"cache", "prune", "--unused-for", "3 moons"}).err,
                HasSubstr("'3 moons' is not a time"));
}

}  // namespace
}  // namespace carom::cli
