// Checks that a frame's noise depends on what the frame shows and when, but not on how it is
// computed.
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "lab/structures/make_structure.h"
#include "render/frame/frame.h"
#include "tests/folders.h"
#include "tests/pipeline/job/example_frames.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::ExampleFilm;

class FrameNoise : public ::testing::Test {
  protected:
    static constexpr std::int64_t kFrame = 80;

    FrameNoise()
        : film_(std::string(CAROM_SOURCE_DIR) + "/examples/nine_ball_break.yaml", folder_.path()) {
        film_.shot.render.width = 96;
        film_.shot.render.height = 54;
    }

    [[nodiscard]] std::vector<float> picture() const { return film_.render(kFrame).rgba; }

    /// The fraction of the pixels that differ by more than `bound` times their value.
    static double changed(const std::vector<float>& a, const std::vector<float>& b, float bound) {
        int count = 0;
        for (std::size_t i = 0; i < a.size(); i += 4) {
            bool differs = false;
            for (std::size_t channel = i; channel < i + 3; ++channel) {
                differs |= std::abs(a[channel] - b[channel]) > bound * (a[channel] + b[channel]);
            }
            count += differs ? 1 : 0;
        }
        return 4.0 * count / static_cast<double>(a.size());
    }

    static double mean(const std::vector<float>& rgba) {
        double sum = 0;
        for (std::size_t i = 0; i < rgba.size(); i += 4) {
            sum += static_cast<double>(rgba[i + 1]);
        }
        return 4 * sum / static_cast<double>(rgba.size());
    }

    carom::testing::ScratchFolder folder_;
    ExampleFilm film_;
};

TEST_F(FrameNoise, OtherAccelerationStructures_HaveTheSameNoise) {
    const std::vector<float> usual = picture();
    for (const auto kind : {render::AccelerationKind::embree, render::AccelerationKind::bvh}) {
        const FrameInputs inputs = film_.inputs(kFrame);
        const render::PreparedScene scene(film_.shot.scene, film_.shot.render,
                                          render::structure_maker(kind));
        const std::vector<float> other =
            render::render_frame(scene, inputs.tracks, inputs.frame, film_.shot.render).rgba;
        // At edges, rounding sends a few paths to another surface.
        EXPECT_LT(changed(usual, other, 1e-3F), 0.02) << name_of(kind);
    }
}

TEST_F(FrameNoise, AnotherNumberOnOneBall_ChangesThatBallAlone) {
    const std::vector<float> usual = picture();
    int painted = 0;
    for (render::MaterialDescription& material : film_.shot.scene.materials) {
        auto* ball = std::get_if<render::BallTexture>(&material.surface.base);
        if (ball != nullptr && ball->number == 1) {
            ball->number = 7;
            ++painted;
        }
    }
    ASSERT_EQ(painted, 1);
    const double fraction = changed(usual, picture(), 0);
    EXPECT_GT(fraction, 0);
    EXPECT_LT(fraction, 0.05);
}

TEST_F(FrameNoise, BrighterLights_GiveTheSameNoise) {
    const std::vector<float> usual = picture();
    for (render::LightDescription& light : film_.shot.scene.lights) {
        std::visit(
            [](auto& one) {
                if constexpr (requires { one.radiance; }) {
                    one.radiance *= 2;
                }
            },
            light.light);
    }
    std::vector<float> brighter = picture();
    for (float& value : brighter) {
        value /= 2;
    }
    EXPECT_LT(changed(usual, brighter, 1e-4F), 0.001);
}

TEST_F(FrameNoise, AnotherSeed_GivesOtherNoiseWithTheSameMean) {
    const std::vector<float> usual = picture();
    film_.shot.render.seed = 1;
    const std::vector<float> other = picture();
    EXPECT_GT(changed(usual, other, 1e-3F), 0.5);
    EXPECT_NEAR(mean(other), mean(usual), 0.02 * mean(usual));
    film_.shot.render.seed = 0;
    EXPECT_EQ(picture(), usual);
}

}  // namespace
}  // namespace carom::pipeline
