// Checks and bakes every example and every rig of the library, and renders three frames of each.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/job/film_job.h"
#include "tests/folders.h"
#include "tests/pipeline/film_of_shots.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

namespace fs = std::filesystem;

const std::string kSource = CAROM_SOURCE_DIR;

/// Names without ".yaml" below a folder of the source tree, sorted.
std::vector<std::string> names_in(const std::string& folder) {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(kSource + "/" + folder)) {
        if (entry.path().extension() == ".yaml" &&
            !carom::testing::is_film_of_shots(entry.path())) {
            names.push_back(entry.path().stem().string());
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

/// Small and noisy, whatever the shot says.
std::vector<std::string> tiny() {
    return {"render.size=[48, 28]",
            "render.samples=2",
            "render.noise=0",
            "render.max_bounces=1",
            "render.distributed.pixel_samples=1",
            "render.distributed.blur_samples=1",
            "render.distributed.lens_samples=1",
            "output.codec=ffv1"};
}

std::string text_of(const std::vector<Problem>& problems) {
    std::string text;
    for (const Problem& problem : problems) {
        text += format(problem);
    }
    return text;
}

/// Checks that the first, middle and last frame are not black and have no NaN.
void expect_frames(const LoadResult& loaded, const std::string& cache) {
    ASSERT_EQ(text_of(loaded.problems), "");
    Shot shot = loaded.shot.value();
    FilmJobOptions options;
    options.cache_folder = cache;
    options.threads = 1;
    const sim::Bake bake = bake_or_reuse(shot, options.cache_folder, {}, {}).bake;
    std::shared_ptr<const ShotSource> source = loaded.source;
    ASSERT_EQ(text_of(resolve_moments(shot, source, bake.timeline)), "");
    const std::int64_t count = frame_count(shot.cameras, shot.timing);
    const std::vector<std::int64_t> frames{0, count / 2, count - 1};
    for (const std::int64_t frame : frames) {
        options.frames.parts.push_back({frame, frame, 1});
    }
    (void)make_film(shot, bake, options, {}, {});  // stores the frames, which are then read
    for (const std::int64_t frame : frames) {
        const render::Film film = make_frame(shot, bake, frame, options, {}, {});
        ASSERT_EQ(film.rgba.size(), 4U * 48 * 28);
        int lit = 0;
        for (std::size_t i = 0; i < film.rgba.size(); ++i) {
            ASSERT_TRUE(std::isfinite(film.rgba[i]));
            lit += i % 4 != 3 && film.rgba[i] > 0.004F ? 1 : 0;
        }
        EXPECT_GT(lit, 3 * 48 * 28 / 10) << "frame " << frame << " is almost black";
    }
}

/// The example that another one includes to film its bake: "domino_run" for "reverse"; empty for
/// most.
std::string included_example(const std::string& name) {
    std::ifstream file(kSource + "/examples/" + name + ".yaml");
    for (std::string line; std::getline(file, line);) {
        const std::string word = "include: ";
        const std::size_t end = line.find(".yaml");
        if (line.starts_with(word) && end != std::string::npos &&
            fs::exists(kSource + "/examples/" + line.substr(word.size(), end - word.size()) +
                       ".yaml")) {
            return line.substr(word.size(), end - word.size());
        }
    }
    return {};
}

std::vector<std::string> own_shots() {
    std::vector<std::string> names = names_in("examples");
    std::erase_if(names, [](const std::string& name) { return !included_example(name).empty(); });
    return names;
}

class Example : public ::testing::TestWithParam<std::string> {};

TEST_P(Example, IsCheckedBakedAndRendered) {
    const carom::testing::ScratchFolder folder;
    // Examples that film the same bake are tested together with it, so that it is simulated once.
    for (const std::string& name : names_in("examples")) {
        if (name == GetParam() || included_example(name) == GetParam()) {
            SCOPED_TRACE(name);
            expect_frames(load_shot(kSource + "/examples/" + name + ".yaml", {.overrides = tiny()}),
                          folder.path("cache"));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Library, Example, ::testing::ValuesIn(own_shots()),
                         [](const auto& test) { return test.param; });

TEST(Examples, All_AreInTheGallery) {
    EXPECT_GE(names_in("examples").size(), 10U);
    std::ifstream file(kSource + "/docs/gallery.md");
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    for (const std::string& name : names_in("examples")) {
        EXPECT_THAT(page, ::testing::HasSubstr("(images/gallery/example_" + name + ".jpg)"));
        EXPECT_THAT(page, ::testing::HasSubstr("`" + name + "`"));
        EXPECT_TRUE(fs::exists(kSource + "/docs/images/gallery/example_" + name + ".jpg")) << name;
    }
}

class Rig : public ::testing::TestWithParam<std::string> {
  protected:
    static LoadResult load(const std::string& include, const std::string& cameras) {
        return load_shot_text(
            "carom: 1\ninclude: [tables/pool_9ft.yaml, balls/pool.yaml, "
            "looks/studio.yaml" +
                include +
                "]\nballs: {cue: {at: [-0.6, 0]}, one: {at: [0.5, 0.02]}}\n"
                "simulation: {duration: 5 s}\n"
                "events: [{strike: {ball: cue, at: 0.2 s, toward: one, speed: 3}}]\n" +
                cameras,
            kSource + "/examples/shot.yaml", {.overrides = tiny()});
    }
};

TEST_P(Rig, Included_FilmsAShot) {
    const carom::testing::ScratchFolder folder;
    expect_frames(load(", rigs/" + GetParam() + ".yaml", ""), folder.path("cache"));
}

TEST_P(Rig, IncludedByACamera_MayBeOneOfSeveral) {
    const LoadResult loaded = load(
        "", "cameras:\n  - {include: rigs/" + GetParam() +
                ".yaml, video: [0 s, 1 s], scene: [0.2 s, 0.4 s]}\n"
                "  - {video: [1 s, 2 s], scene: 0 s, position: [0, -1, 1], target: [0, 0, 0]}\n");
    ASSERT_EQ(text_of(loaded.problems), "");
    EXPECT_EQ(loaded.shot->cameras.size(), 2U);
    EXPECT_EQ(loaded.shot->cameras[0].name, GetParam());
    EXPECT_EQ(loaded.shot->cameras[0].video_end, Rational(1));
}

INSTANTIATE_TEST_SUITE_P(Library, Rig, ::testing::ValuesIn(names_in("configs/rigs")),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace carom::pipeline
