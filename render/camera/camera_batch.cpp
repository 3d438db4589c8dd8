#include "render/camera/camera_batch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/camera/camera_batch.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "render/camera/kernels-inl.h"
#include "render/sampling/kernels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

/// Makes the rays of the samples from `first` on.
HWY_INLINE void make_rays_at(const CameraConstants& camera, const CameraFixings& fixings, int first,
                             CameraBatch& batch) {
    using L = Lanes;
    const auto word = [&](const std::int32_t* words)
                          HWY_ATTR { return L::to_word(L::load_int(words + first)); };
    const auto number = [&](const std::int32_t* words)
                            HWY_ATTR { return L::to_value(L::load_int(words + first)); };
    const SamplerOf<L> sampler(word(batch.pixel_hash), word(batch.reversed_sample));
    L::Value u[5];
    sampler.get_camera_sample(u);
    CameraNumbersOf<L> numbers{{u[0], u[1]}, {u[2], u[3]}, u[4]};
    if (fixings.centred) {
        numbers.pixel = {L::all(0.5F), L::all(0.5F)};
    }
    if (fixings.instantaneous) {
        numbers.time = L::all(0.5F);
    }
    const CameraRayOf<L> ray = camera_ray<L>(camera, {number(batch.x), number(batch.y)}, numbers);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        L::store(ray.origin[axis], batch.origin[axis] + first);
        L::store(ray.direction[axis], batch.direction[axis] + first);
    }
    L::store(ray.time, batch.time + first);
    L::store(ray.weight, batch.weight + first);
}

inline HWY_ATTR void make_rays_in_lanes(const CameraConstants& camera, const CameraFixings& fixings,
                                        CameraBatch& batch) {
    for (int first = 0; first < batch.count; first += Lanes::count()) {
        make_rays_at(camera, fixings, first, batch);
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
