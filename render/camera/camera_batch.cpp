#include "render/camera/camera_batch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/camera/camera_batch.cpp"
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4)  // these make rays one by one
#include <hwy/foreach_target.h>                      // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR
#include "render/sampling/lane_sampler-inl.h"
#include "render/sampling/one_minus_epsilon.h"
#endif

#ifndef CAROM_MAKE_RAYS
#define CAROM_MAKE_RAYS
namespace carom::render {
using MakeRays = void(const ThinLensCamera& camera, const CameraFixings& fixings,
                      CameraBatch& batch);
}  // namespace carom::render
#endif

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

inline MakeRays* make_rays_of_target() {
    return nullptr;
}

#else

HWY_INLINE F3 mix(const V3f& from, const V3f& to, F weight) {
    return all(from) + (all(to) - all(from)) * weight;
}
HWY_INLINE F mix(float from, float to, F weight) {
    return all(from) + weight * (all(to) - all(from));
}
HWY_INLINE F3 cross(const F3& a, const F3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// CameraFrame in every lane.
struct FrameLanes {
    F3 position, forward, right, up;
    F pixel_size, focus_distance, lens_radius, blade_turns;
};

HWY_INLINE FrameLanes static_frame(const CameraFrame& frame) {
    return {all(frame.position),    all(frame.forward),    all(frame.right),
            all(frame.up),          all(frame.pixel_size), all(frame.focus_distance),
            all(frame.lens_radius), all(frame.blade_turns)};
}

/// ThinLensCamera::frame_at.
HWY_INLINE FrameLanes frame_at(const ThinLensCamera& camera, F time) {
    const ThinLensCamera::Moving& a = camera.open();
    const ThinLensCamera::Moving& b = camera.close();
    FrameLanes frame;
    frame.position = mix(a.frame.position, b.frame.position, time);
    frame.forward = unit(mix(a.axis, b.axis, time));
    frame.right = unit(cross(frame.forward, mix(a.up, b.up, time)));
    frame.up = cross(frame.right, frame.forward);
    if (a.roll != 0 || b.roll != 0) {
        const SinCosOf<Lanes> turn =
            sin_cos_turn<Lanes>(mix(a.roll, b.roll, time) * all(0.5f * kInversePi));
        const F3 level = frame.right;
        frame.right = level * turn.cosine + frame.up * turn.sine;
        frame.up = frame.up * turn.cosine - level * turn.sine;
    }
    frame.pixel_size = mix(a.frame.pixel_size, b.frame.pixel_size, time);
    frame.focus_distance = mix(a.frame.focus_distance, b.frame.focus_distance, time);
    frame.lens_radius = mix(a.frame.lens_radius, b.frame.lens_radius, time);
    frame.blade_turns = mix(a.blade_rotation, b.blade_rotation, time) / all(2 * kPi);
    return frame;
}

HWY_INLINE F sample_trapezoid(F u, float switch_ratio) {
    const float ramp = 0.5f * switch_ratio;
    if (ramp <= 0) {
        return u;
    }
    const float height = 1 / (1 - ramp);
    const float ramp_probability = 0.5f * ramp * height;
    const F opening = hn::Sqrt(all(2.f) * u * all(ramp) / all(height));
    const F closing =
        hn::Min(all(1.f) - hn::Sqrt(all(2.f) * (all(1.f) - u) * all(ramp) / all(height)),
                all(kOneMinusEpsilon));
    const F open = all(ramp) + (u - all(ramp_probability)) / all(height);
    return select(hn::Lt(u, all(ramp_probability)), opening,
                  select(hn::Gt(u, all(1 - ramp_probability)), closing, open));
}

HWY_INLINE V2 sample_polygon(const V2& u, int blades, F rotation_turns) {
    const auto count = static_cast<float>(blades);
    const F scaled = u.x * all(count);
    const F blade = hn::Min(hn::Floor(scaled), all(count - 1));
    const F fraction = hn::Min(scaled - blade, all(kOneMinusEpsilon));
    const F r = hn::Sqrt(fraction);
    const SinCosOf<Lanes> a = sin_cos_turn<Lanes>(blade / all(count) + rotation_turns);
    const SinCosOf<Lanes> b = sin_cos_turn<Lanes>((blade + all(1.f)) / all(count) + rotation_turns);
    const F first = all(1.f) - u.y;
    return {r * (first * a.cosine + u.y * b.cosine), r * (first * a.sine + u.y * b.sine)};
}

/// PixelFilterSampler::offset.
HWY_INLINE F filter_offset(const PixelFilterSampler& filter, F u) {
    const std::vector<PixelFilterSampler::Cell>& cells = filter.cells();
    if (cells.empty()) {
        return (u - all(0.5f)) * all(static_cast<float>(filter.width()));
    }
    static_assert(sizeof(PixelFilterSampler::Cell) == 3 * sizeof(float));
    const float* numbers = &cells[0].cdf;
    const IntTag di;
    const FloatTag d;
    const auto guides = static_cast<float>(filter.guide().size());
    I at = hn::GatherIndex(di, filter.guide().data(), hn::ConvertTo(di, u * all(guides)));
    const auto number = [&](int which)
                            HWY_ATTR { return hn::GatherIndex(d, numbers + which, at + at + at); };
    for (;;) {
        const M goes_on = hn::Le(number(3), u);  // the next cell's cdf
        if (hn::AllFalse(d, goes_on)) {
            break;
        }
        at = at + hn::IfThenElseZero(hn::RebindMask(di, goes_on), hn::Set(di, 1));
    }
    return number(1) + number(2) * (u - number(0));
}

HWY_INLINE void store_ray(CameraBatch& batch, int first, const F3& origin, const F3& direction,
                          F time) {
    const FloatTag d;
    hn::StoreU(origin.x, d, batch.origin[0] + first);
    hn::StoreU(origin.y, d, batch.origin[1] + first);
    hn::StoreU(origin.z, d, batch.origin[2] + first);
    hn::StoreU(direction.x, d, batch.direction[0] + first);
    hn::StoreU(direction.y, d, batch.direction[1] + first);
    hn::StoreU(direction.z, d, batch.direction[2] + first);
    hn::StoreU(time, d, batch.time + first);
}

HWY_INLINE F as_floats(const std::int32_t* words, int first) {
    return hn::ConvertTo(FloatTag(), hn::LoadU(IntTag(), words + first));
}

inline HWY_ATTR void make_rays_in_lanes(const ThinLensCamera& camera, const CameraFixings& fixings,
                                        CameraBatch& batch) {
    const IntTag di;
    const V2f centre = camera.centre();
    for (int first = 0; first < batch.count; first += lane_count()) {
        const LaneSampler sampler(
            hn::BitCast(WordTag(), hn::LoadU(di, batch.pixel_hash + first)),
            hn::BitCast(WordTag(), hn::LoadU(di, batch.reversed_sample + first)));
        F u[5];
        sampler.get_camera_sample(u);
        const F pixel_u = fixings.centred ? all(0.5f) : u[0];
        const F pixel_v = fixings.centred ? all(0.5f) : u[1];
        const F instant = fixings.instantaneous ? all(0.5f) : u[4];
        const F time = sample_trapezoid(instant, camera.switch_ratio());
        const FrameLanes frame =
            camera.moves() ? frame_at(camera, time) : static_frame(camera.open().frame);
        const F x = (as_floats(batch.x, first) + all(0.5f) - all(centre.x) +
                     filter_offset(camera.filter(), pixel_u)) *
                    frame.pixel_size;
        const F y = (all(centre.y - 0.5f) - as_floats(batch.y, first) -
                     filter_offset(camera.filter(), pixel_v)) *
                    frame.pixel_size;
        const F3 picture = frame.forward + frame.right * x + frame.up * y;
        if (!camera.has_lens()) {
            store_ray(batch, first, frame.position, unit(picture), time);
            continue;
        }
        const V2 lens = camera.blades() == 0
                            ? sample_disk<Lanes>({u[2], u[3]})
                            : sample_polygon({u[2], u[3]}, camera.blades(), frame.blade_turns);
        const F3 arm =
            frame.right * (frame.lens_radius * lens.x) + frame.up * (frame.lens_radius * lens.y);
        store_ray(batch, first, frame.position + arm, unit(picture * frame.focus_distance - arm),
                  time);
    }
}

inline MakeRays* make_rays_of_target() {
    return make_rays_in_lanes;
}

#endif

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace carom::render {

HWY_EXPORT(make_rays_of_target);

namespace {

void make_rays_one_by_one(const ThinLensCamera& camera, const CameraFixings& fixings,
                          CameraBatch& batch) {
    for (int i = 0; i < batch.count; ++i) {
        CameraSample sample = camera_sample(static_cast<std::uint32_t>(batch.pixel_hash[i]),
                                            static_cast<std::uint32_t>(batch.reversed_sample[i]));
        if (fixings.centred) {
            sample.pixel = V2f(0.5f, 0.5f);
        }
        if (fixings.instantaneous) {
            sample.time = 0.5f;
        }
        const Ray ray = camera.ray(batch.x[i], batch.y[i], sample);
        for (int axis = 0; axis < 3; ++axis) {
            batch.origin[axis][i] = ray.origin[axis];
            batch.direction[axis][i] = ray.direction[axis];
        }
        batch.time[i] = ray.time;
    }
}

}  // namespace

void make_rays(const ThinLensCamera& camera, const CameraFixings& fixings, CameraBatch& batch) {
    MakeRays* const in_lanes = HWY_DYNAMIC_DISPATCH(make_rays_of_target)();
    (in_lanes != nullptr ? in_lanes : make_rays_one_by_one)(camera, fixings, batch);
}

}  // namespace carom::render

#endif
