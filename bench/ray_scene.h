// The scenes and the rays of ray_bench: a table of boxes with sixteen balls, half of them moving
// with an impact during the shutter, and optionally a knot of 100 000 triangles between lamp and
// table.
#pragma once

#include <string>
#include <vector>

#include "render/frame_scene/frame_scene.h"
#include "render/frame_scene/static_geometry.h"
#include "render/geometry/ray.h"
#include "render/scene/scene_description.h"
#include "sim/timeline/track.h"

namespace carom::bench {

struct TableShot {
    render::SceneDescription scene;
    std::vector<sim::Track> tracks;
    double scene_open = 0;
    double scene_close = 1.0 / 48;
};

[[nodiscard]] TableShot make_table_shot(bool with_knot);

/// Two hundred equal bumpy balls of 20 000 triangles in rows on a floor, at rest or each moving by
/// itself.
[[nodiscard]] TableShot make_equal_meshes(bool move);

/// Rays of one kind, in the order in which a renderer traces them.
struct RaySets {
    std::vector<render::Ray> primary;    // through a thin lens, 4 x 4 pixels at a time
    std::vector<render::Ray> secondary;  // cosine-distributed from the hits of the primary rays
    std::vector<render::Ray> shuffled;   // the secondary rays in random order
    std::vector<render::Ray> shadow;     // from the same points to the lamp
};

[[nodiscard]] RaySets make_ray_sets(const render::FrameScene& frame);

}  // namespace carom::bench
