#include "pipeline/store/frame_seed.h"

#include <functional>
#include <set>

#include <gmock/gmock.h>

namespace carom::pipeline {
namespace {

using Change = std::function<void(render::FrameInput&)>;

/// A camera that moves past something that moves.
render::FrameInput sample_frame() {
    render::FrameInput frame;
    frame.scene_open = 0.4;
    frame.scene_close = 0.42;
    frame.camera_close.position.x = 0.01;
    return frame;
}

TEST(FrameSeed, WhatTheFrameShowsWhen_ChangesIt) {
    const std::vector<std::pair<const char*, Change>> changes{
        {"scene_open", [](auto& f) { f.scene_open = 0.39; }},
        {"scene_close", [](auto& f) { f.scene_close = 0.43; }},
        {"camera_open.position", [](auto& f) { f.camera_open.position.x = 1; }},
        {"camera_close.position", [](auto& f) { f.camera_close.position.x = 1; }},
        {"target", [](auto& f) { f.camera_open.target.x = 1; }},
        {"up",
         [](auto& f) {
             f.camera_open.up = {0, 1, 1};
         }},
        {"roll", [](auto& f) { f.camera_open.roll = 1; }},
        {"vertical_fov", [](auto& f) { f.camera_open.vertical_fov = 1; }},
        {"focus_distance", [](auto& f) { f.camera_open.focus_distance = 1; }},
        {"lens_radius", [](auto& f) { f.camera_open.lens_radius = 0.01; }},
        {"blades", [](auto& f) { f.camera_open.blades = 5; }},
        {"blade_rotation", [](auto& f) { f.camera_open.blade_rotation = 1; }},
    };
    std::set<std::uint64_t> seen{frame_seed(0, sample_frame()), frame_seed(1, sample_frame())};
    EXPECT_EQ(seen.size(), 2U) << "render.seed";
    for (const auto& [name, change] : changes) {
        render::FrameInput frame = sample_frame();
        change(frame);
        EXPECT_TRUE(seen.insert(frame_seed(0, frame)).second) << name;
    }
}

TEST(FrameSeed, HowItIsComputed_DoesNotEnter) {
    render::FrameInput frame = sample_frame();
    frame.switch_ratio = 0.7;
    frame.seed = 99;
    EXPECT_EQ(frame_seed(5, frame), frame_seed(5, sample_frame()));
}

}  // namespace
}  // namespace carom::pipeline
