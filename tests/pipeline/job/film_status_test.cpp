// Chunks, what is there already, films from stored frames, and the cache's limit.
#include "pipeline/job/film_status.h"

#include <filesystem>

#include <gmock/gmock.h>

#include "core/error.h"
#include "pipeline/job/film_job.h"
#include "pipeline/job/film_plan.h"
#include "pipeline/store/frame_store.h"
#include "tests/pipeline/job/tiny_shot.h"
#include "tests/pipeline/video/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::FakeRenderer;
using carom::testing::film_by;
using carom::testing::frame_by;
using carom::testing::read_text;
using carom::testing::ScratchFolder;
using carom::testing::write_text;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

namespace fs = std::filesystem;

/// The tiny shot: twelve frames, the last four of which show the same.
struct Farm {
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
        return film_by(renderer.function(), shot, bake.timeline, options, observer, {});
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

std::string mux_problem(Farm& farm) {
    try {
        (void)mux_film(farm.shot, farm.bake, farm.options("film.mkv"), {}, {});
        return "none";
    } catch (const Error& error) {
        return error.what();
    }
}

TEST(Chunks, Together_AreTheFilm) {
    Farm whole;
    (void)whole.render(whole.options("film.mkv"));
    Farm farm;
    EXPECT_EQ(farm.render_chunk(1, 3).frames, 4);
    EXPECT_THAT(farm.folder.names(), ElementsAre("cache")) << "a chunk writes no film";
    EXPECT_EQ(mux_problem(farm), "8 of 12 frames are not in the cache: 4-11");
    EXPECT_EQ(farm.render_chunk(3, 3).rendered, 1) << "four frames that show the same";
    EXPECT_EQ(mux_problem(farm), "4 of 12 frames are not in the cache: 4-7");
    EXPECT_EQ(farm.render_chunk(2, 3).rendered, 4);
    EXPECT_EQ(mux_problem(farm), "none");
    EXPECT_EQ(read_text(farm.folder.path("film.mkv")), read_text(whole.folder.path("film.mkv")));
}

TEST(FilmStatus, Frames_AreThereOrMissing) {
    Farm farm;
    EXPECT_EQ(farm.status().missing.size(), 12U);
    EXPECT_EQ(farm.status().pictures, 9);
    EXPECT_EQ(farm.stored(), 0) << "asking renders nothing";
    (void)farm.render_chunk(2, 4);  // 3 to 5
    fs::remove(farm.frame_path(4));
    EXPECT_THAT(farm.status().stored, ElementsAre(3, 5));
    EXPECT_EQ(farm.status().pictures, 7);
}

TEST(MuxFilm, DamagedFrame_IsNamedAndMadeAgainByItsChunk) {
    Farm farm;
    (void)farm.render(farm.options());
    std::string bytes = read_text(farm.frame_path(5));
    bytes[100] = static_cast<char>(bytes[100] ^ 1);
    write_text(farm.frame_path(5), bytes);
    EXPECT_THAT(farm.status().damaged, ElementsAre(5));
    EXPECT_EQ(mux_problem(farm), "1 of 12 frames are not in the cache: 5 (stored, but damaged: 5)");
    EXPECT_FALSE(fs::exists(farm.folder.path("film.mkv")));
    EXPECT_EQ(farm.render_chunk(1, 1).rendered, 1);
    EXPECT_EQ(mux_problem(farm), "none");
}

TEST(MuxFilm, OtherCodec_NeedsNoRenderer) {
    Farm farm;
    (void)farm.render(farm.options());
    const auto before = farm.renderer.rendered().size();
    const FilmJobResult result =
        mux_film(farm.shot, farm.bake, farm.options("film.####.png"), {}, {});
    EXPECT_EQ(result.frames, 12);
    EXPECT_EQ(result.rendered, 0);
    EXPECT_EQ(farm.renderer.rendered().size(), before);
}

TEST(CacheLimit, FramesOfOlderFilms_GoFirst) {
    Farm farm;
    (void)farm.render(farm.options());  // 9 pictures
    const std::uint64_t all = [&] {
        std::uint64_t bytes = 0;
        for (const CacheEntry& entry : list_cache(farm.folder.path("cache"))) {
            fs::last_write_time(entry.path,
                                fs::file_time_type::clock::now() - std::chrono::hours(5));
            bytes += entry.bytes;
        }
        return bytes;
    }();
    farm.shot.render.samples = 3;  // another film
    FilmJobOptions options = farm.options("film.mkv");
    options.frames = parse_frame_range("0-3");
    // Pictures are not all of one size, to a few bytes.
    options.cache_limit = all + all / 40;
    EXPECT_EQ(farm.render(options).rendered, 4);
    EXPECT_EQ(farm.stored(), 9) << "four of the other film went";
    EXPECT_EQ(farm.warning, "");
    farm.shot.render.samples = 2;
    EXPECT_EQ(farm.status().missing.size(), 4U);
}

TEST(CacheLimit, OtherPartsOfTheFilm_Stay) {
    Farm farm;
    const auto age_all = [&] {
        for (const CacheEntry& entry : list_cache(farm.folder.path("cache"))) {
            fs::last_write_time(entry.path,
                                fs::file_time_type::clock::now() - std::chrono::hours(5));
        }
    };
    FilmJobOptions options = farm.options();
    options.cache_limit = 1000;
    options.chunk = {1, 3};
    EXPECT_EQ(farm.render(options).rendered, 4);
    age_all();
    options.chunk = {2, 3};
    EXPECT_EQ(farm.render(options).rendered, 4);
    EXPECT_THAT(farm.status().missing, ElementsAre(8, 9, 10, 11));
    age_all();
    options.chunk = {};
    options.frames = parse_frame_range("0-1");
    EXPECT_EQ(farm.render(options).rendered, 0);
    EXPECT_THAT(farm.status().missing, ElementsAre(8, 9, 10, 11));
    age_all();
    (void)frame_by(farm.renderer.function(), farm.shot, farm.bake.timeline, 0, options, {}, {});
    EXPECT_THAT(farm.status().missing, ElementsAre(8, 9, 10, 11));
}

TEST(CacheLimit, FilmLargerThanIt_IsMadeAndSaysSo) {
    Farm farm;
    FilmJobOptions options = farm.options("film.mkv");
    options.cache_limit = 1000;
    EXPECT_EQ(farm.render(options).rendered, 9);
    EXPECT_EQ(farm.stored(), 9);
    EXPECT_THAT(farm.warning, HasSubstr("more than its limit of 1 kB"));
    EXPECT_EQ(farm.render(options).rendered, 0) << "what it is about to use is not pruned";
}

}  // namespace
}  // namespace carom::pipeline
