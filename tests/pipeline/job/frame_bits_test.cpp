// Checks that the pixels of the example films do not depend on how they are computed.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include <gtest/gtest.h>

#include "pipeline/job/far_light.h"
#include "render/frame/frame.h"
#include "render/frame/progressive_frame.h"
#include "tests/folders.h"
#include "tests/pipeline/job/example_frames.h"
#include "tests/render/every_target.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::ExampleFilm;
using carom::testing::ScratchFolder;

class ExampleBits : public ::testing::TestWithParam<std::string> {};

/// The frames that are tested: several of the break, where paths of all materials share SIMD
/// vectors in many combinations as the balls separate.
std::vector<std::int64_t> frames_of(const ExampleFilm& film, const std::string& path) {
    return path.ends_with("/nine_ball_break.yaml")
               ? std::vector<std::int64_t>{10, 80, 200}
               : std::vector<std::int64_t>{film.frame_count() / 2};
}

int differing_pixels(const std::vector<float>& a, const std::vector<float>& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.size(); i += 4) {
        count += std::equal(&a[i], &a[i] + 4, &b[i]) ? 0 : 1;
    }
    return count;
}

// The samples of a pixel do not depend on when they are traced and with which other samples.
void expect_same_bits_in_rounds(const ExampleFilm& film, std::int64_t frame) {
    const FrameInputs inputs = film.inputs(frame);
    render::RenderSettings settings = film.shot.render;
    settings.samples = 8;
    const render::PreparedScene scene(film.shot.scene, settings, {},
                                      known_far_light(film.shot.scene, nullptr));
    const render::Film at_once = render::render_frame(scene, inputs.tracks, inputs.frame, settings);
    render::ProgressiveFrame progressive(scene, inputs.tracks, inputs.frame, settings);
    for (int samples = 1; !progressive.finished(); samples *= 2) {
        progressive.refine(samples);
    }
    EXPECT_EQ(differing_pixels(progressive.film().rgba, at_once.rgba), 0)
        << "rounds of 1, 1, 2 and 4 samples, frame " << frame;
}

/// Everything that a frame stores: its pixels, and for the denoiser features and variances.
void expect_same(const render::Film& a, const render::Film& b, const std::string& what) {
    EXPECT_EQ(differing_pixels(a.rgba, b.rgba), 0) << what;
    ASSERT_EQ(a.aovs.size(), b.aovs.size()) << what;
    for (std::size_t i = 0; i < a.aovs.size(); ++i) {
        EXPECT_TRUE(a.aovs[i].values == b.aovs[i].values) << what << ", " << a.aovs[i].name;
    }
    ASSERT_EQ(a.half_aovs.size(), b.half_aovs.size()) << what;
    for (std::size_t i = 0; i < a.half_aovs.size(); ++i) {
        EXPECT_TRUE(a.half_aovs[i].bits == b.half_aovs[i].bits)
            << what << ", " << a.half_aovs[i].name;
    }
    EXPECT_EQ(a.statistics.camera_rays, b.statistics.camera_rays) << what;
    EXPECT_EQ(a.statistics.scattered_rays, b.statistics.scattered_rays) << what;
    EXPECT_EQ(a.statistics.shadow_rays, b.statistics.shadow_rays) << what;
}

class ExampleInstructions : public ::testing::TestWithParam<std::string> {};

// The key of a frame does not contain the instruction set, so the set must not matter.
TEST_P(ExampleInstructions, EverySet_GivesTheSameBits) {
    const ScratchFolder bakes;
    ExampleFilm film(GetParam(), bakes.path());
    film.shot.render.for_denoiser = film.shot.render.integrator == render::IntegratorKind::path;
    const std::int64_t frame = frames_of(film, GetParam()).front();
    const render::Film best = film.render(frame);
    EXPECT_NE(best.half_aovs.empty(), film.shot.render.for_denoiser);
    int tried = 0;
    test::for_each_instruction_set([&](const char* name) {
        expect_same(film.render(frame), best, name);
        ++tried;
    });
    EXPECT_GE(tried, 2);
}

TEST_P(ExampleBits, SamplesInRounds_GiveTheSameBits) {
    const ScratchFolder bakes;
    const ExampleFilm film(GetParam(), bakes.path());
    for (const std::int64_t frame : frames_of(film, GetParam())) {
        expect_same_bits_in_rounds(film, frame);
    }
}

std::string name_of(const ::testing::TestParamInfo<std::string>& tested) {
    const std::filesystem::path path(tested.param);
    return path.parent_path().filename().string() + "_" + path.stem().string();
}

/// Three examples; all of them if CAROM_ALL_EXAMPLES is set, since frames take several times longer
/// without vectors.
std::vector<std::string> examples_for_all_sets() {
    const std::string folder = CAROM_SOURCE_DIR "/examples/";
    return std::getenv("CAROM_ALL_EXAMPLES") != nullptr
               ? carom::testing::example_files()
               : std::vector<std::string>{folder + "nine_ball_break.yaml",
                                          folder + "distributed.yaml", folder + "park.yaml"};
}

INSTANTIATE_TEST_SUITE_P(All, ExampleBits, ::testing::ValuesIn(carom::testing::example_files()),
                         name_of);
INSTANTIATE_TEST_SUITE_P(All, ExampleInstructions, ::testing::ValuesIn(examples_for_all_sets()),
                         name_of);

}  // namespace
}  // namespace carom::pipeline
