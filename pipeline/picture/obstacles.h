// What hides annotations in the scene.
#pragma once

#include "core/vectors.h"
#include "render/frame_scene/frame_scene.h"
#include "render/frame_scene/static_geometry.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// The surfaces of the scene at one instant. Any number of threads may ask; each must be in the
/// mode of render/acceleration/flush_denormals.h.
class Obstacles {
  public:
    /// Refers to `geometry`. Throws Error if the timeline lacks a track of the scene.
    Obstacles(const render::StaticGeometry& geometry, const sim::Timeline& timeline,
              double scene_time);

    /// Whether a surface is nearer to `eye` than the point `eye` + `depth` * `direction`.
    [[nodiscard]] bool hides(const Vec3& eye, const Vec3& direction, double depth) const;

  private:
    render::FrameScene scene_;
};

/// The geometry of a scene for Obstacles. Reads its meshes. Throws Error.
[[nodiscard]] render::StaticGeometry obstacle_geometry(const render::SceneDescription& scene,
                                                       render::RenderSettings settings);

}  // namespace carom::pipeline
