#include "render/camera/camera_batch.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace carom::render {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 360;

struct CameraCase {
    std::string name;
    std::function<void(CameraState&)> open, close;  // changes to the camera at both ends
    double switch_ratio = 0;
    PixelFilter filter = PixelFilter::box;
    CameraFixings fixings{};
};

std::vector<CameraCase> camera_cases() {
    const auto same = [](CameraState&) {};
    const auto lens = [](CameraState& state) { state.lens_radius = 0.02; };
    const auto moved = [](CameraState& state) {
        state.position += Vec3(0.1, 0.05, 0.02);
        state.target += Vec3(0, 0.1, 0);
        state.vertical_fov = 0.7;
        state.roll = 0.3;
        state.lens_radius = 0.03;
        state.focus_distance = 2;
    };
    const auto blades = [](CameraState& state) {
        state.lens_radius = 0.02;
        state.blades = 7;
        state.blade_rotation = 0.4;
    };
    const auto shaped = [blades](CameraState& state) {
        blades(state);
        state.lens = LensShape{1.1, 0.8, 0.6, -0.05};
    };
    const auto round = [shaped](CameraState& state) {
        shaped(state);
        state.blades = 0;
    };
    return {
        {"Pinhole", same, same},
        {"Shaped", shaped, shaped},
        {"RoundShaped", round, round},
        {"Lens", lens, lens, 0, PixelFilter::blackman_harris},
        {"Moving", lens, moved, 0.5, PixelFilter::gaussian},
        {"Blades", blades, blades},
        {"Shutter", same, same, 1},
        {"Fixed", lens, moved, 0.2, PixelFilter::gaussian, {true, true}},
    };
}

class CameraBatches : public testing::TestWithParam<CameraCase> {};

TEST_P(CameraBatches, Rays_AreThoseOfTheCamera) {
    const CameraCase& param = GetParam();
    CameraState open;
    open.position = Vec3(-1.5, -2, 1.2);
    open.target = Vec3(0.3, 0.1, 0.05);
    open.vertical_fov = 0.6;
    open.focus_distance = 2.2;
    CameraState close = open;
    param.open(open);
    param.close(close);
    const ThinLensCamera camera(open, close, kWidth, kHeight, param.switch_ratio, param.filter, 2);
    for (const int count : {1, 16, 255, 256}) {
        auto batch = std::make_unique<CameraBatch>();
        batch->count = count;
        std::vector<Ray> expected;
        std::vector<float> weights;
        for (int i = 0; i < count; ++i) {
            const int x = (37 * i) % kWidth;
            const int y = (91 * i) % kHeight;
            const SampleStream stream(5, static_cast<std::uint32_t>(x),
                                      static_cast<std::uint32_t>(y), static_cast<std::uint32_t>(i));
            batch->x[i] = x;
            batch->y[i] = y;
            batch->pixel_hash[i] = static_cast<std::int32_t>(stream.pixel_hash());
            batch->reversed_sample[i] = static_cast<std::int32_t>(stream.reversed_sample());
            CameraSample sample = stream.camera_sample();
            if (param.fixings.centred) {
                sample.pixel = V2f(0.5f, 0.5f);
            }
            if (param.fixings.instantaneous) {
                sample.time = 0.5f;
            }
            expected.push_back(camera.ray(x, y, sample));
            weights.push_back(camera.weight(x, y, sample));
        }
        make_rays(camera, param.fixings, *batch);
        for (int i = 0; i < count; ++i) {
            const Ray& ray = expected[static_cast<std::size_t>(i)];
            EXPECT_EQ(batch->ray(i).origin, ray.origin) << i;
            EXPECT_EQ(batch->ray(i).direction, ray.direction) << i;
            EXPECT_EQ(batch->time[i], ray.time) << i;
            EXPECT_EQ(batch->weight[i], weights[static_cast<std::size_t>(i)]) << i;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, CameraBatches, testing::ValuesIn(camera_cases()),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace carom::render
