// Scenes of any size: a cloud of balls, half of them moving with an impact inside the shutter, or a
// bumpy ball of triangles, in the same room under the same lamp.
#pragma once

#include <cstdint>
#include <vector>

#include "render/frame/frame.h"
#include "render/geometry/ray.h"
#include "tests/render/scene_builder.h"

namespace carom::bench {

struct GrowthScene {
    test::SceneBuilder builder;
    std::vector<sim::Track> tracks;
    render::FrameInput frame;
};

/// `count` balls that fill the same room whatever their number.
[[nodiscard]] GrowthScene make_ball_cloud(int count);

/// A mesh of at least `count` triangles around the origin.
[[nodiscard]] render::MeshShape bumpy_ball(int count, double radius);

/// The same of at least `count` triangles, with a ball beside it.
[[nodiscard]] GrowthScene make_mesh(int count);

/// Camera rays, every other one followed by one in a random direction from a random place: coherent
/// and not, at random times.
[[nodiscard]] std::vector<render::Ray> make_rays(int count);

}  // namespace carom::bench
