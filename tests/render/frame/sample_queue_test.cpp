// Camera rays are made in vectors, however many samples the integrator takes at a time.
#include "render/frame/sample_queue.h"

#include <array>
#include <limits>

#include <gtest/gtest.h>

#include "tests/render/scene_builder.h"

namespace carom::render {
namespace {

/// Adds nothing, but records the requests.
class CountingIntegrator final : public Integrator {
  public:
    void samples(const CameraRun& run, float /*spread*/, RadianceSample* /*results*/,
                 Workspace* /*workspace*/, RenderStatistics& /*count*/) const override {
        EXPECT_EQ(run.first, static_cast<int>(sizes.size()) % CameraBatch::kUsual * run.count);
        sizes.push_back(run.count);
        if (sizes.size() == stop_after) {
            stop.request_stop();
        }
    }

    mutable std::vector<int> sizes;
    mutable std::stop_source stop;
    std::size_t stop_after = 0;
};

/// The requests to the integrator for `samples` samples of one pixel, at most `at_once` at a time.
std::vector<int> asked_for(int samples, int at_once, CountingIntegrator& integrator,
                           TileSums& sums) {
    const CameraState state = test::camera(Vec3(0, -2, 1), Vec3(0, 0, 0), 0.6);
    const ThinLensCamera camera(state, state, 16, 16, 0, PixelFilter::box, 1);
    RenderStatistics count;
    WorkspacePool workspaces(integrator);
    SampleQueue queue({integrator, workspaces, camera, {}, 0.001f, at_once},
                      integrator.stop.get_token(), count);
    for (int i = 0; i < samples; ++i) {
        queue.add(SampleStream(1, 3, 4, static_cast<std::uint32_t>(i)), {3, 4, i}, sums, 0);
    }
    return integrator.sizes;
}

TEST(SampleQueue, RaysOfManySamples_AreMadeTogetherAndTracedAFewAtATime) {
    TileSums sums(1, {});
    CountingIntegrator waiting;
    EXPECT_TRUE(asked_for(CameraBatch::kUsual - 1, 1, waiting, sums).empty());
    CountingIntegrator one;
    EXPECT_EQ(asked_for(CameraBatch::kUsual, 1, one, sums),
              std::vector<int>(CameraBatch::kUsual, 1));
    CountingIntegrator all;
    EXPECT_EQ(asked_for(CameraBatch::kUsual, CameraBatch::kUsual, all, sums),
              std::vector<int>{CameraBatch::kUsual});
}

TEST(SampleQueue, StopBetweenSamples_LeavesTheOthersOut) {
    CountingIntegrator integrator;
    integrator.stop_after = 3;
    TileSums sums(1, {});
    EXPECT_EQ(asked_for(2 * CameraBatch::kUsual, 1, integrator, sums), std::vector<int>(3, 1));
    EXPECT_EQ(sums.samples(0), 3) << "what was traced before the stop is added";
}

/// Returns what no sample may be, once.
class FaultyIntegrator final : public Integrator {
  public:
    void samples(const CameraRun& run, float /*spread*/, RadianceSample* results,
                 Workspace* /*workspace*/, RenderStatistics& /*count*/) const override {
        for (int i = 0; i < run.count; ++i) {
            RadianceSample sample;
            sample.radiance = V3f(1, 2, 3);
            if (run.index(i).sample == 2) {
                sample.radiance.y =
                    run.index(i).x == 3 ? std::numeric_limits<float>::quiet_NaN() : -1;
                sample.coverage = 1;
            }
            results[i] = sample;
        }
    }
};

TEST(SampleQueue, UnusableSamples_AreCountedWithTheirFirstPixelAndBlack) {
    const CameraState state = test::camera(Vec3(0, -2, 1), Vec3(0, 0, 0), 0.6);
    const ThinLensCamera camera(state, state, 16, 16, 0, PixelFilter::box, 1);
    const FaultyIntegrator integrator;
    WorkspacePool workspaces(integrator);
    RenderStatistics count;
    TileSums sums(2, {});
    {
        SampleQueue queue({integrator, workspaces, camera, {}, 0.001f, 8}, {}, count);
        for (int i = 0; i < 4; ++i) {
            queue.add(SampleStream(1, 3, 4, static_cast<std::uint32_t>(i)), {3, 4, i}, sums, 0);
            queue.add(SampleStream(1, 9, 2, static_cast<std::uint32_t>(i)), {9, 2, i}, sums, 1);
        }
        queue.flush();
    }
    EXPECT_EQ(count.unusable_samples, 2u);
    EXPECT_EQ(count.unusable_pixel, (std::array{9, 2})) << "the first one in reading order";
    for (const std::size_t pixel : {0, 1}) {
        EXPECT_EQ(sums.samples(pixel), 4);
        EXPECT_EQ(sums.mean(pixel), V3f(0.75f, 1.5f, 2.25f));
        EXPECT_EQ(sums.coverage(pixel), 0);
    }
    RenderStatistics all;
    all += count;
    all.add_unusable(1, {15, 1});
    EXPECT_EQ(all.unusable_samples, 3u);
    EXPECT_EQ(all.unusable_pixel, (std::array{15, 1}));
}

}  // namespace
}  // namespace carom::render
