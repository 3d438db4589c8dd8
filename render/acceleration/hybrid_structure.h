// Analytic shapes in the lanes of vectors, meshes in Embree.
#pragma once

#include <vector>

#include "render/acceleration/acceleration_structure.h"
#include "render/acceleration/analytic_kernels.h"
#include "render/acceleration/shapes.h"

namespace carom::render {

/// The default. The handful of balls and boxes of a billiard shot is tested by brute force, eight
/// at a time, which no hierarchy beats; time grows in proportion to their number. Only then are
/// triangles asked, within the distance found.
class HybridStructure final : public AccelerationStructure {
  public:
    explicit HybridStructure(const ShapeSet& shapes);

    [[nodiscard]] bool closest_hit(const Ray& ray, Hit& hit) const override;
    [[nodiscard]] bool any_hit(const Ray& ray) const override;
    [[nodiscard]] FanMask any_hits(const RayFan& fan) const override;

  private:
    const AnalyticKernels& kernels_;
    AnalyticBlocks blocks_;
    std::vector<MovingShape> moving_;  // in order of object
    std::shared_ptr<const TriangleScene> meshes_;
};

}  // namespace carom::render
