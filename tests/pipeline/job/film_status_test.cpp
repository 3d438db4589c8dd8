// Tests of chunks, the status of a film, films from stored frames, and the limit of the cache.
#include "pipeline/job/film_status.h"

#include <filesystem>

#include <gmock/gmock.h>

#include "core/error.h"
#include "pipeline/job/film_job.h"
#include "pipeline/job/film_plan.h"
#include "pipeline/store/frame_store.h"
#include "tests/pipeline/job/tiny_shot.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::FakeRenderer;
using carom::testing::make_film_with;
using carom::testing::make_frame_with;
using carom::testing::read_text;
using carom::testing::ScratchFolder;
using carom::testing::write_text;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

namespace fs = std::filesystem;

/// The tiny shot: twelve frames, the last four of which show the same.
struct ChunkFixture {
    ScratchFolder folder;
    Shot shot = carom::testing::tiny_shot();
    sim::Bake bake{carom::testing::tiny_timeline(), {}, {}, {}};
    FakeRenderer renderer{shot};
    std::string warning;

    [[nodiscard]] FilmJobOptions options(const std::string& output = {}) const {
        FilmJobOptions options;
        options.output = output.empty() ? "" : folder.path(output);
        options.cache_folder = folder.path("cache");
        return options;
    }
    FilmJobResult render(const FilmJobOptions& options) {
        JobObserver observer;
        observer.on_warning = [this](const std::string& text) { warning = text; };
        return make_film_with(renderer.function(), shot, bake.timeline, options, observer, {});
    }
    FilmJobResult render_chunk(std::int64_t number, std::int64_t of) {
        FilmJobOptions chunk = options();
        chunk.chunk = {number, of};
        return render(chunk);
    }
    [[nodiscard]] FilmStatus status() const { return film_status(shot, bake, options(), {}); }
    [[nodiscard]] std::string frame_path(std::int64_t frame) const {
        const FilmSource source(shot, bake.timeline);
        return FrameStore(folder.path("cache/frames")).path_of(source.key(source.inputs(frame)));
    }
    [[nodiscard]] int stored() const {
        int count = 0;
        for (const auto& entry : fs::recursive_directory_iterator(folder.path("cache"))) {
            count += entry.path().extension() == ".exr" ? 1 : 0;
        }
        return count;
    }
};

std::string mux_problem(ChunkFixture& job) {
    try {
        (void)mux_film(job.shot, job.bake, job.options("film.mkv"), {}, {});
        return "none";
    } catch (const Error& error) {
        return error.what();
    }
}

TEST(Chunks, Together_AreTheFilm) {
    ChunkFixture whole;
    (void)whole.render(whole.options("film.mkv"));
    ChunkFixture job;
    EXPECT_EQ(job.render_chunk(1, 3).frames, 4);
    EXPECT_THAT(job.folder.names(), ElementsAre("cache")) << "a chunk writes no film";
    EXPECT_EQ(mux_problem(job),
              "8 of 12 frames are not in the cache: 4-11; 'carom render' renders them");
    EXPECT_EQ(job.render_chunk(3, 3).rendered, 1) << "four frames that show the same";
    EXPECT_EQ(mux_problem(job),
              "4 of 12 frames are not in the cache: 4-7; 'carom render' renders them");
    EXPECT_EQ(job.render_chunk(2, 3).rendered, 4);
    EXPECT_EQ(mux_problem(job), "none");
    EXPECT_EQ(read_text(job.folder.path("film.mkv")), read_text(whole.folder.path("film.mkv")));
}

TEST(FilmStatus, Frames_AreStoredOrMissing) {
    ChunkFixture job;
    EXPECT_EQ(job.status().missing.size(), 12U);
    EXPECT_EQ(job.status().pictures, 9);
    EXPECT_EQ(job.stored(), 0) << "film_status renders nothing";
    (void)job.render_chunk(2, 4);  // 3 to 5
    fs::remove(job.frame_path(4));
    EXPECT_THAT(job.status().stored, ElementsAre(3, 5));
    EXPECT_EQ(job.status().pictures, 7);
}

TEST(MuxFilm, DamagedFrame_IsNamedAndRenderedAgainByItsChunk) {
    ChunkFixture job;
    (void)job.render(job.options());
    std::string bytes = read_text(job.frame_path(5));
    bytes[100] = static_cast<char>(bytes[100] ^ 1);
    write_text(job.frame_path(5), bytes);
    EXPECT_THAT(job.status().damaged, ElementsAre(5));
    EXPECT_EQ(mux_problem(job),
              "1 of 12 frames is not in the cache: 5 (stored, but damaged: 5); 'carom render' "
              "renders it");
    EXPECT_FALSE(fs::exists(job.folder.path("film.mkv")));
    EXPECT_EQ(job.render_chunk(1, 1).rendered, 1);
    EXPECT_EQ(mux_problem(job), "none");
}

TEST(FilmStatus, DamagedFrames_AreRemovedIfWanted) {
    ChunkFixture job;
    (void)job.render(job.options());
    const std::string path = job.frame_path(5);
    std::string bytes = read_text(path);
    bytes[100] = static_cast<char>(bytes[100] ^ 1);
    write_text(path, bytes);
    EXPECT_THAT(job.status().missing, ElementsAre(5));
    EXPECT_TRUE(fs::exists(path));
    const FilmStatus status =
        film_status(job.shot, job.bake, job.options(), {}, DamagedFrames::remove);
    EXPECT_THAT(status.missing, ElementsAre(5));
    EXPECT_FALSE(fs::exists(path));
    EXPECT_TRUE(fs::exists(job.frame_path(4)));
}

TEST(MuxCompleteFilm, Film_HasTheBytesOfMuxFilmAndAFrameThatIsMissingIsAnError) {
    ChunkFixture job;
    (void)job.render(job.options());
    (void)mux_film(job.shot, job.bake, job.options("one.mkv"), {}, {});
    (void)mux_complete_film(job.shot, job.bake, job.options("other.mkv"), {}, {});
    EXPECT_EQ(read_text(job.folder.path("one.mkv")), read_text(job.folder.path("other.mkv")));
    fs::remove(job.frame_path(5));
    EXPECT_THROW((void)mux_complete_film(job.shot, job.bake, job.options("third.mkv"), {}, {}),
                 Error);
    EXPECT_FALSE(fs::exists(job.folder.path("third.mkv")));
}

TEST(MuxFilm, AnotherFormat_NeedsNoRenderer) {
    ChunkFixture job;
    (void)job.render(job.options());
    const auto before = job.renderer.rendered().size();
    const FilmJobResult result = mux_film(job.shot, job.bake, job.options("film.####.png"), {}, {});
    EXPECT_EQ(result.frames, 12);
    EXPECT_EQ(result.rendered, 0);
    EXPECT_EQ(job.renderer.rendered().size(), before);
}

TEST(CacheLimit, FramesOfOlderFilms_AreRemovedFirst) {
    ChunkFixture job;
    (void)job.render(job.options());  // 9 pictures
    const std::uint64_t all = [&] {
        std::uint64_t bytes = 0;
        for (const CacheEntry& entry : list_cache(job.folder.path("cache"))) {
            fs::last_write_time(entry.path,
                                fs::file_time_type::clock::now() - std::chrono::hours(5));
            bytes += entry.bytes;
        }
        return bytes;
    }();
    job.shot.render.samples = 3;  // another film
    FilmJobOptions options = job.options("film.mkv");
    options.frames = parse_frame_range("0-3");
    // Pictures are not all of one size, to a few bytes.
    options.cache_limit = all + all / 40;
    EXPECT_EQ(job.render(options).rendered, 4);
    EXPECT_EQ(job.stored(), 9) << "four frames of the other film were removed";
    EXPECT_EQ(job.warning, "");
    job.shot.render.samples = 2;
    EXPECT_EQ(job.status().missing.size(), 4U);
}

TEST(CacheLimit, OtherPartsOfTheFilm_AreKept) {
    ChunkFixture job;
    const auto age_all = [&] {
        for (const CacheEntry& entry : list_cache(job.folder.path("cache"))) {
            fs::last_write_time(entry.path,
                                fs::file_time_type::clock::now() - std::chrono::hours(5));
        }
    };
    FilmJobOptions options = job.options();
    options.cache_limit = 1000;
    options.chunk = {1, 3};
    EXPECT_EQ(job.render(options).rendered, 4);
    age_all();
    options.chunk = {2, 3};
    EXPECT_EQ(job.render(options).rendered, 4);
    EXPECT_THAT(job.status().missing, ElementsAre(8, 9, 10, 11));
    age_all();
    options.chunk = {};
    options.frames = parse_frame_range("0-1");
    EXPECT_EQ(job.render(options).rendered, 0);
    EXPECT_THAT(job.status().missing, ElementsAre(8, 9, 10, 11));
    age_all();
    (void)make_frame_with(job.renderer.function(), job.shot, job.bake.timeline, 0, options, {}, {});
    EXPECT_THAT(job.status().missing, ElementsAre(8, 9, 10, 11));
}

TEST(CacheLimit, FilmLargerThanTheLimit_IsFinishedWithAWarning) {
    ChunkFixture job;
    FilmJobOptions options = job.options("film.mkv");
    options.cache_limit = 1000;
    EXPECT_EQ(job.render(options).rendered, 9);
    EXPECT_EQ(job.stored(), 9);
    EXPECT_THAT(job.warning, HasSubstr("more than its limit of 1 kB"));
    EXPECT_EQ(job.render(options).rendered, 0) << "frames that the job needs are not pruned";
}

}  // namespace
}  // namespace carom::pipeline
