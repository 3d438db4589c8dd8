#include "pipeline/job/viewed_frame.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace carom::pipeline {
namespace {

PlannedFrame layer(double weight, const LensLook& look, double fov) {
    PlannedFrame frame;
    frame.number = 12;
    frame.weight = weight;
    frame.look = look;
    frame.camera_open.vertical_fov = frame.camera_close.vertical_fov = fov;
    return frame;
}

TEST(ViewedFrame, OfOneCamera_HasItsLens) {
    const std::vector<PlannedFrame> layers{layer(1, {0.5, 0.002}, 0.8)};
    const ViewedFrame viewed = viewed_frame(layers);
    EXPECT_EQ(viewed.number, 12);
    EXPECT_EQ(viewed.lens.look, (LensLook{0.5, 0.002}));
    EXPECT_NEAR(viewed.lens.half_height, std::tan(0.4), 1e-15);
}

TEST(ViewedFrame, InACrossFade_HasTheMeanByWeight) {
    const std::vector<PlannedFrame> layers{layer(0.75, {1, 0}, 0.8), layer(0.25, {0, 0.004}, 0.4)};
    const LensView lens = viewed_frame(layers).lens;
    EXPECT_NEAR(lens.look.falloff, 0.75, 1e-15);
    EXPECT_NEAR(lens.look.lateral_colour, 0.001, 1e-15);
    EXPECT_NEAR(lens.half_height, 0.75 * std::tan(0.4) + 0.25 * std::tan(0.2), 1e-15);
}

}  // namespace
}  // namespace carom::pipeline
