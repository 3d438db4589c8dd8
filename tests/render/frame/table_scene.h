// A small scene with some of everything that a frame may contain.
#pragma once

#include <vector>

#include "tests/render/scene_builder.h"

namespace carom::test {

/// Some of everything: moving coated balls, cloth, lamp, bulb, sky.
inline SceneBuilder table() {
    SceneBuilder builder;
    render::StandardMaterial cloth;
    cloth.base = render::ClothTexture{.thread = 0.0008};
    cloth.sheen = 0.3;
    render::StandardMaterial ball;
    ball.base = render::BallTexture{.colour = Vec3(0.8, 0.1, 0.1),
                                    .striped = true,
                                    .number = 11,
                                    .disc_radius = 0.48,
                                    .band_width = 0.56};
    ball.coat.weight = 1;
    builder.material("cloth", cloth).material("ball", ball);
    builder.object("bed", render::PlaneShape{}, Vec3(0, 0, 0), "cloth");
    builder.sphere("a", 0.03, Vec3(0, 0, 0), "ball", "a")
        .sphere("b", 0.03, Vec3(0, 0, 0), "ball", "b");
    builder.lamp(Vec3(0, 0, 1), 0.4, 0.2, 20).bulb(Vec3(0.5, 0.5, 0.6), 0.05, 30).environment(0.1);
    return builder;
}

inline std::vector<sim::Track> table_tracks() {
    return {straight_track("a", Vec3(-0.05, 0, 0.03), Vec3(0.02, 0, 0.03), 0, 0.02),
            resting_track("b", Vec3(0.06, 0.05, 0.03))};
}

inline render::FrameInput table_frame() {
    render::CameraState state = camera(Vec3(-0.1, -0.4, 0.2), Vec3(0, 0, 0.02), 0.6);
    state.lens_radius = 0.004;
    render::FrameInput frame = static_frame(state);
    frame.scene_close = 0.02;
    frame.switch_ratio = 0.2;
    return frame;
}

}  // namespace carom::test
