// Checks that the pixels of the example films do not depend on how they are computed.
#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include "render/frame/frame.h"
#include "render/frame/prepared_scene.h"
#include "render/frame/tile_renderer.h"
#include "tests/pipeline/job/example_frames.h"
#include "tests/pipeline/video/scratch_folder.h"

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

/// The pixels of a frame that is rendered in two parts: `first` samples, then the others up to
/// `all`.
std::vector<float> rendered_in_two(const ExampleFilm& film, std::int64_t frame, int first,
                                   int all) {
    const FrameInputs inputs = film.inputs(frame);
    render::RenderSettings settings = film.shot.render;
    settings.samples = first;
    const render::PreparedScene prepared(film.shot.scene, settings);
    const render::PreparedScene::Data& data = prepared.data();
    const render::FrameScene scene(data.geometry, inputs.tracks, inputs.frame.scene_open,
                                   inputs.frame.scene_close, {});
    const render::TransportScene transport{scene, data.materials, data.lights, data.object_count};
    render::Film result;
    result.width = settings.width;
    result.height = settings.height;
    const std::size_t pixels =
        static_cast<std::size_t>(settings.width) * static_cast<std::size_t>(settings.height);
    result.rgba.resize(4 * pixels);
    render::AovPlanes aovs(settings, inputs.frame, scene, data.names);
    render::TileRenderer renderer(settings, inputs.frame, transport, result, aovs);
    std::vector<render::PixelSums> sums(pixels);
    const std::vector<int> plan(pixels, all);
    for (int tile = 0; tile < renderer.tile_count(); ++tile) {
        (void)renderer.begin(tile, sums, {});
        (void)renderer.finish(tile, sums, plan, {});
    }
    return result.rgba;
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
void expect_same_bits_in_two_parts(const ExampleFilm& film, std::int64_t frame) {
    if (film.shot.render.integrator != render::IntegratorKind::path) {
        return;  // only the path integrator renders in two parts
    }
    EXPECT_EQ(
        differing_pixels(rendered_in_two(film, frame, 4, 8), rendered_in_two(film, frame, 8, 8)), 0)
        << "four samples and four more, frame " << frame;
}

TEST_P(ExampleBits, WiderVectorsAndSamplesInTwoParts_GiveTheSameBits) {
    const ScratchFolder bakes;
    const ExampleFilm film(GetParam(), bakes.path());
    for (const std::int64_t frame : frames_of(film, GetParam())) {
        expect_same_bits_in_wider_vectors(film, frame);
        expect_same_bits_in_two_parts(film, frame);
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
