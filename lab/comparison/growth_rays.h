// Rays that every structure is asked.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "lab/comparison/laboratory_scene.h"
#include "render/acceleration/acceleration_structure.h"
#include "render/acceleration/ray_batch.h"

namespace carom::pipeline {

/// About `shapes` shapes within 1 m of the origin.
[[nodiscard]] LaboratoryScene sphere_cloud(std::size_t shapes);
[[nodiscard]] LaboratoryScene single_knot(std::size_t shapes);
/// As many balls. A moving one is two pieces of a path to a structure: n balls are 1.5 n shapes.
[[nodiscard]] LaboratoryScene ball_cloud(std::size_t balls);

/// By render::RayKind: about `count` from a camera, one onwards from where each of those ends, and
/// one from there to a light, at random times. `structure` tells where they end.
[[nodiscard]] std::array<std::vector<render::Ray>, 3> growth_rays(
    const render::AccelerationStructure& structure, std::size_t count);

/// How many rays a wavefront of paths asks at a time (render/integrator/wave).
inline constexpr int kBatchRays = 64;

/// Rays side by side.
class RayArrays {
  public:
    /// At most kBatchRays.
    explicit RayArrays(std::span<const render::Ray> rays);
    [[nodiscard]] render::RayBatch batch() const;

  private:
    static constexpr int kRoom = kBatchRays + 16;  // RayBatch
    int count_ = 0;
    std::array<std::array<float, kRoom>, 7> numbers_{};  // origin, direction, time
};

}  // namespace carom::pipeline
