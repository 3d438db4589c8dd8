// A shot of two balls on a cloth, and a camera that sees them from the front, for tests of
// annotations.
#pragma once

#include "pipeline/picture/annotation_painter.h"
#include "tests/pipeline/picture/moving_balls.h"

namespace carom::testing {

inline constexpr int kWidth = 160;
inline constexpr int kHeight = 120;
inline constexpr double kFov = 0.3;  // of the height, rad

/// Balls "cue" and "one" of two_balls().
[[nodiscard]] inline pipeline::Shot drawn_shot() {
    pipeline::Shot shot;
    shot.scene.materials = {{"white", {}}};
    for (const char* name : {"cue", "one"}) {
        shot.scene.objects.push_back({name, render::SphereShape{kRadius}, {}, name, "white"});
        sim::Body body;
        body.name = name;
        body.shape = sim::Sphere{kRadius};
        shot.world.bodies.push_back(body);
    }
    return shot;
}

/// At (0, -1) and the balls' height, looking along +y.
[[nodiscard]] inline pipeline::PlannedFrame frame_at(double scene_time) {
    pipeline::PlannedFrame frame;
    frame.scene_time = frame.scene_open = frame.scene_close = scene_time;
    frame.video_time = 2;
    frame.camera_open.position = {0, -1, kRadius};
    frame.camera_open.target = {0, 0, kRadius};
    frame.camera_open.vertical_fov = kFov;
    frame.camera_close = frame.camera_open;
    return frame;
}

/// The opacity of a pixel of the picture, [0, 255].
[[nodiscard]] inline int alpha_at(const pipeline::DrawnPicture& picture, int x, int y) {
    return picture.pixels.empty()
               ? 0
               : static_cast<int>(picture.pixels[static_cast<std::size_t>(y * picture.width + x)] >>
                                  24);
}

/// The sum of all opacities, in pixels.
[[nodiscard]] inline double covered(const pipeline::DrawnPicture& picture) {
    double sum = 0;
    for (const std::uint32_t pixel : picture.pixels) {
        sum += (pixel >> 24) / 255.0;
    }
    return sum;
}

}  // namespace carom::testing
