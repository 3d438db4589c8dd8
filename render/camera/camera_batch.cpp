#include "render/camera/camera_batch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/camera/camera_batch.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "render/camera/kernels-inl.h"
#include "render/sampling/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

HWY_INLINE void store_rays(CameraBatch& batch, int first, const CameraRayOf<Lanes>& ray) {
    const FloatTag d;
    hn::StoreU(ray.origin.x, d, batch.origin[0] + first);
    hn::StoreU(ray.origin.y, d, batch.origin[1] + first);
    hn::StoreU(ray.origin.z, d, batch.origin[2] + first);
    hn::StoreU(ray.direction.x, d, batch.direction[0] + first);
    hn::StoreU(ray.direction.y, d, batch.direction[1] + first);
    hn::StoreU(ray.direction.z, d, batch.direction[2] + first);
    hn::StoreU(ray.time, d, batch.time + first);
}

HWY_INLINE F as_floats(const std::int32_t* words, int first) {
    return hn::ConvertTo(FloatTag(), hn::LoadU(IntTag(), words + first));
}

inline HWY_ATTR void make_rays_in_lanes(const CameraConstants& camera, const CameraFixings& fixings,
                                        CameraBatch& batch) {
    const IntTag di;
    for (int first = 0; first < batch.count; first += lane_count()) {
        const LaneSampler sampler(
            hn::BitCast(WordTag(), hn::LoadU(di, batch.pixel_hash + first)),
            hn::BitCast(WordTag(), hn::LoadU(di, batch.reversed_sample + first)));
        F u[5];
        sampler.get_camera_sample(u);
        CameraNumbersOf<Lanes> numbers{{u[0], u[1]}, {u[2], u[3]}, u[4]};
        if (fixings.centred) {
            numbers.pixel = {all(0.5f), all(0.5f)};
        }
        if (fixings.instantaneous) {
            numbers.time = all(0.5f);
        }
        const V2 pixel{as_floats(batch.x, first), as_floats(batch.y, first)};
        store_rays(batch, first, camera_ray<Lanes>(camera, pixel, numbers));
    }
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace carom::render {

HWY_EXPORT(make_rays_in_lanes);

void make_rays(const ThinLensCamera& camera, const CameraFixings& fixings, CameraBatch& batch) {
    HWY_DYNAMIC_DISPATCH(make_rays_in_lanes)(camera.constants(), fixings, batch);
}

}  // namespace carom::render

#endif
