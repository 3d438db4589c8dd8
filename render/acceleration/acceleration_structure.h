// The interface of all acceleration structures.
#pragma once

#include "render/acceleration/ray_batch.h"
#include "render/geometry/ray.h"

namespace carom::render {

/// Built over a frame's shapes for one shutter interval; immutable and shared by all threads. Rays
/// need unit directions; implementations reject or clamp invalid rays (safe_ray.h) before they call
/// a library.
class AccelerationStructure {
  public:
    virtual ~AccelerationStructure() = default;

    /// The nearest hit in (ray.t_min, ray.t_max); without one, returns false and leaves `hit`
    /// untouched. Of two hits at the same distance the one with the lower (object, primitive) is
    /// returned.
    [[nodiscard]] virtual bool closest_hit(const Ray& ray, Hit& hit) const = 0;

    /// Whether anything is hit in (ray.t_min, ray.t_max).
    [[nodiscard]] virtual bool any_hit(const Ray& ray) const = 0;

    /// `closest_hit` of each ray without an upper bound; a ray without a hit gets the object
    /// kNoObject.
    virtual void closest_hits(const RayBatch& rays, Hit* hits) const {
        for (int i = 0; i < rays.count; ++i) {
            hits[i] = Hit{};
            static_cast<void>(closest_hit(rays.ray(i, kInfinity), hits[i]));
        }
    }

    /// Occlusion tests: sets t_max[i] to 0 if ray i hits anything in (0, t_max[i]). Rays whose
    /// t_max is 0 are skipped.
    virtual void test_occlusion(const RayBatch& rays, float* t_max) const {
        for (int i = 0; i < rays.count; ++i) {
            if (t_max[i] > 0 && any_hit(rays.ray(i, t_max[i]))) {
                t_max[i] = 0;
            }
        }
    }
};

}  // namespace carom::render
