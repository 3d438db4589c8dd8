// What every acceleration structure answers.
#pragma once

#include "render/acceleration/ray_batch.h"
#include "render/geometry/ray.h"

namespace carom::render {

/// Built over a frame's shapes for one shutter interval; immutable and shared by all threads. Rays
/// must be finite with unit directions; implementations make every ray safe before handing it to a
/// library.
class AccelerationStructure {
  public:
    virtual ~AccelerationStructure() = default;

    /// The nearest hit in (ray.t_min, ray.t_max); false and an untouched `hit` if there is none.
    /// Of two hits at the same distance the lower (object, primitive) is reported.
    [[nodiscard]] virtual bool closest_hit(const Ray& ray, Hit& hit) const = 0;

    /// Whether anything is hit in (ray.t_min, ray.t_max).
    [[nodiscard]] virtual bool any_hit(const Ray& ray) const = 0;

    /// The rays of a fan that `any_hit` is true of.
    [[nodiscard]] virtual FanMask any_hits(const RayFan& fan) const {
        FanMask hits = 0;
        for (int i = 0; i < fan.count; ++i) {
            hits |= any_hit(fan.ray(i)) ? FanMask{1} << i : 0;
        }
        return hits;
    }

    /// `closest_hit` of each ray, without bound; without a hit the object is kNoObject.
    virtual void closest_hits(const RayBatch& rays, Hit* hits) const {
        for (int i = 0; i < rays.count; ++i) {
            hits[i] = Hit{};
            static_cast<void>(closest_hit(rays.ray(i, kInfinity), hits[i]));
        }
    }

    /// Sets reach[i] to 0 where ray i meets anything before it; 0 asks for nothing.
    virtual void drop_blocked(const RayBatch& rays, float* reach) const {
        for (int i = 0; i < rays.count; ++i) {
            if (reach[i] > 0 && any_hit(rays.ray(i, reach[i]))) {
                reach[i] = 0;
            }
        }
    }
};

}  // namespace carom::render
