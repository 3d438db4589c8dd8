#include "render/camera/camera_matrices.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "render/camera/thin_lens_camera.h"

namespace carom::render {
namespace {

CameraState some_state() {
    CameraState state;
    state.position = {1, -2, 1.5};
    state.target = {0.1, 0.2, 0};
    state.roll = 0.3;
    state.vertical_fov = 0.6;
    return state;
}

TEST(CameraMatrices, WorldToCamera_HasXRightYUpAndZAhead) {
    CameraState state;
    state.position = {0, -2, 1};
    state.target = {0, 0, 1};
    const Imath::M44f matrix = camera_matrices(state, state, 64, 36).world_to_camera;
    EXPECT_LT((V3f(0.5f, 1, 1.25f) * matrix - V3f(0.5f, 0.25f, 3)).length(), 1e-6f);
}

// The corners of the picture, computed independently of ray generation: y = z tan(fov / 2) is the
// top.
TEST(CameraMatrices, WorldToNdc_HasTheCornersOfThePicture) {
    CameraState state;
    state.position = {0, -2, 1};
    state.target = {0, 0, 1};
    state.vertical_fov = std::numbers::pi / 2;
    const Imath::M44f matrix = camera_matrices(state, state, 200, 100).world_to_ndc;
    for (const float distance : {0.5f, 3.f}) {
        const V3f top_left = V3f(-2 * distance, -2 + distance, 1 + distance) * matrix;
        EXPECT_NEAR(top_left.x, 0, 1e-6);
        EXPECT_NEAR(top_left.y, 0, 1e-6);
        const V3f bottom_right = V3f(2 * distance, -2 + distance, 1 - distance) * matrix;
        EXPECT_NEAR(bottom_right.x, 1, 1e-6);
        EXPECT_NEAR(bottom_right.y, 1, 1e-6);
        EXPECT_NEAR(bottom_right.z, 1 - 0.001f / distance, 1e-6);
    }
}

TEST(CameraMatrices, OfAMovingCamera_AreThoseOfTheMiddleOfTheShutter) {
    CameraState close = some_state();
    close.position.x += 0.4;
    close.target.y += 0.3;
    close.roll = 0.5;
    close.vertical_fov = 0.8;
    const ThinLensCamera camera(some_state(), close, 320, 180, 0, PixelFilter::box, 1);
    const CameraMatrices matrices = camera_matrices(some_state(), close, 320, 180);
    for (const V3f& point : {V3f(0, 0, 0), V3f(0.3f, 0.1f, 0.2f), V3f(-0.4f, 0.5f, 0.1f)}) {
        const auto place = camera.project(point, 0.5f);
        ASSERT_TRUE(place);
        const V3f ndc = point * matrices.world_to_ndc;
        EXPECT_NEAR(320 * ndc.x, place->x, 1e-3);
        EXPECT_NEAR(180 * ndc.y, place->y, 1e-3);
        // The inverse: a compositor computes the point from the pixel.
        EXPECT_LT((ndc * matrices.world_to_ndc.inverse() - point).length(), 2e-3f);
    }
}

}  // namespace
}  // namespace carom::render
