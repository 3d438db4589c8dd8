// The rays with which structures are compared.
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
/// About `balls` balls. A moving one has two segments in a structure: n balls are 1.5 n shapes.
[[nodiscard]] LaboratoryScene ball_cloud(std::size_t balls);

/// `balls` balls, of which every other one moves for a second at up to 2 m/s, with an impact about
/// every 0.1 s.
[[nodiscard]] LaboratoryScene restless_balls(std::size_t balls);

/// By render::RayKind.
using RaysByKind = std::array<std::vector<render::Ray>, 3>;

/// About `count` rays from a camera, one onwards from each of their hits, and one from there to a
/// light, at random times. `structure` finds the hits.
[[nodiscard]] RaysByKind growth_rays(const render::AccelerationStructure& structure,
                                     std::size_t count);

/// Every `every`th ray.
[[nodiscard]] RaysByKind thinned(const RaysByKind& rays, std::size_t every);

/// The size of a batch of rays in a wavefront (render/integrator/wave).
inline constexpr int kBatchRays = 64;

/// Rays as a structure of arrays.
class RayArrays {
  public:
    static constexpr int kRoom = kBatchRays + 16;  // RayBatch
    using Numbers = std::array<float, kRoom>;

    /// At most kBatchRays rays.
    explicit RayArrays(std::span<const render::Ray> rays);
    [[nodiscard]] render::RayBatch batch() const;
    [[nodiscard]] const Numbers& t_max() const { return numbers_[7]; }

  private:
    int count_ = 0;
    std::array<Numbers, 8> numbers_{};  // origin, direction, time, t_max
};

}  // namespace carom::pipeline
