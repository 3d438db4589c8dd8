// Rays that every structure is asked.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "lab/comparison/laboratory_scene.h"
#include "render/acceleration/acceleration_structure.h"

namespace carom::pipeline {

/// About `shapes` shapes within 1 m of the origin.
[[nodiscard]] LaboratoryScene sphere_cloud(std::size_t shapes);
[[nodiscard]] LaboratoryScene single_knot(std::size_t shapes);

/// By render::RayKind: about `count` from a camera, one onwards from where each of those ends, and
/// one from there to a light. `structure` tells where they end.
[[nodiscard]] std::array<std::vector<render::Ray>, 3> growth_rays(
    const render::AccelerationStructure& structure, std::size_t count);

}  // namespace carom::pipeline
