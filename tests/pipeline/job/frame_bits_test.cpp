// Checks that the pixels of the example films do not depend on how they are computed.
#include <algorithm>
#include <filesystem>
#include <string_view>

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include "render/acceleration/vector_tier.h"
#include "render/frame/frame.h"
#include "render/frame/progressive_frame.h"
#include "tests/folders.h"
#include "tests/pipeline/job/example_frames.h"
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

/// While an object exists, SIMD vectors are no wider than those of AVX2.
class NarrowVectors {
  public:
    static constexpr std::int64_t kWider = HWY_AVX3 | HWY_AVX3_DL;
    NarrowVectors() { hwy::DisableTargets(kWider); }
    ~NarrowVectors() { hwy::DisableTargets(0); }
    NarrowVectors(const NarrowVectors&) = delete;
    NarrowVectors& operator=(const NarrowVectors&) = delete;
};

int differing_pixels(const std::vector<float>& a, const std::vector<float>& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.size(); i += 4) {
        count += std::equal(&a[i], &a[i] + 4, &b[i]) ? 0 : 1;
    }
    return count;
}

// The key of a frame does not contain the width of the vectors, so the width must not matter.
void expect_same_bits_in_wider_vectors(const ExampleFilm& film, std::int64_t frame) {
    if ((hwy::SupportedTargets() & NarrowVectors::kWider) == 0) {
        return;  // this processor has none
    }
    const render::Film wide = film.render(frame);
    const NarrowVectors narrow_vectors;
    const render::Film narrow = film.render(frame);
    EXPECT_EQ(differing_pixels(wide.rgba, narrow.rgba), 0) << "wider vectors, frame " << frame;
}

// The samples of a pixel do not depend on when they are traced and with which other samples.
void expect_same_bits_in_rounds(const ExampleFilm& film, std::int64_t frame) {
    const FrameInputs inputs = film.inputs(frame);
    render::RenderSettings settings = film.shot.render;
    settings.samples = 8;
    const render::PreparedScene scene(film.shot.scene, settings);
    const render::Film at_once = render::render_frame(scene, inputs.tracks, inputs.frame, settings);
    render::ProgressiveFrame progressive(scene, inputs.tracks, inputs.frame, settings);
    for (int samples = 1; !progressive.finished(); samples *= 2) {
        progressive.refine(samples);
    }
    EXPECT_EQ(differing_pixels(progressive.film().rgba, at_once.rgba), 0)
        << "rounds of 1, 1, 2 and 4 samples, frame " << frame;
}

TEST_P(ExampleBits, WiderVectorsAndSamplesInRounds_GiveTheSameBits) {
    const ScratchFolder bakes;
    const ExampleFilm film(GetParam(), bakes.path());
    for (const std::int64_t frame : frames_of(film, GetParam())) {
        expect_same_bits_in_wider_vectors(film, frame);
        expect_same_bits_in_rounds(film, frame);
    }
}

/// The middle frame with a tier; empty if the machine lacks it.
std::vector<float> pixels_with(const ExampleFilm& film, std::string_view option) {
    const std::string_view tier = render::tier_named(option);
    if (!render::machine_has_tier(tier)) {
        return {};
    }
    const render::TierLimit limit(tier);
    return film.render(film.frame_count() / 2).rgba;
}

// The tiers differ only in that AVX2 follows many paths of `path` in step.
TEST(FrameBits, TiersBelowAvx2_GiveTheSameBits) {
    const std::string examples = CAROM_SOURCE_DIR "/examples/";
    for (const char* name : {"jump_shot.yaml", "distributed.yaml"}) {
        const ScratchFolder bakes;
        ExampleFilm film(examples + name, bakes.path());
        film.shot.render.samples = 2;
        film.shot.render.distributed.pixel_samples = 1;
        film.shot.render.distributed.blur_samples = 1;
        film.shot.render.distributed.lens_samples = 1;
        const std::vector<float> expected = pixels_with(film, "scalar");
        for (const std::string_view option : {"ssse3", "sse4", "avx2"}) {
            const std::vector<float> pixels = pixels_with(film, option);
            const bool is_in_step = option == "avx2" && std::string(name) == "jump_shot.yaml";
            if (!pixels.empty() && !is_in_step) {
                EXPECT_EQ(differing_pixels(pixels, expected), 0) << name << ", " << option;
            }
        }
    }
}

std::string name_of(const ::testing::TestParamInfo<std::string>& tested) {
    const std::filesystem::path path(tested.param);
    return path.parent_path().filename().string() + "_" + path.stem().string();
}

INSTANTIATE_TEST_SUITE_P(All, ExampleBits, ::testing::ValuesIn(carom::testing::example_files()),
                         name_of);

}  // namespace
}  // namespace carom::pipeline
