#include "render/integrator/wave/wave_kernels.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/integrator/wave/wave_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "render/integrator/wave/kernels-inl.h"
#include "render/lanes/packed_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

using Mask = Lanes::Mask;
using Vector = Vec3<Lanes::Value>;

/// Stores some lanes without gaps from `i` on; what follows them is undefined. (Some processors
/// take a hundred cycles for the instruction that stores just these.)
class PackedStore {
  public:
    HWY_INLINE PackedStore(Mask goes, int i) : goes_(goes), i_(i) {}

    HWY_INLINE void operator()(Lanes::Value value, const Floats& to) const {
        Lanes::store(goes_.pack(value), to.at + i_);
    }
    HWY_INLINE void operator()(Lanes::Int value, const Words& to) const {
        Lanes::store_int(goes_.pack(value), to.at + i_);
    }
    HWY_INLINE void operator()(const Vector& value, const Floats3& to) const {
        (*this)(value.x, to.x);
        (*this)(value.y, to.y);
        (*this)(value.z, to.z);
    }
    [[nodiscard]] HWY_INLINE int count() const { return goes_.count(); }

  private:
    PackedLanes goes_;
    int i_;
};

HWY_INLINE void store_ray(const PackedStore& store, const NextRayOf<Lanes>& ray,
                          const PathQueue& to) {
    store(ray.slot, to.slot);
    store(ray.branch, to.branch);
    store(ray.origin, to.origin);
    store(ray.direction, to.direction);
    store(ray.time, to.time);
    store(ray.throughput, to.throughput);
    store(ray.cone_width, to.cone_width);
    store(ray.cone_spread, to.cone_spread);
}

/// Appends to a list of paths.
struct AppendedPaths {
    PathQueue& to;
    bool transmits;  // in the scene

    [[nodiscard]] HWY_INLINE const AppendedPaths& at(int /*k*/) const { return *this; }
    HWY_INLINE void operator()(const NextPathOf<Lanes>& path, Mask goes) const {
        const PackedStore store(goes, to.count);
        store_ray(store, path, to);
        store(path.last_position, to.last_position);
        store(path.last_normal, to.last_normal);
        store(path.pdf, to.pdf);
        store(path.total_importance, to.total_importance);
        store(path.environment_samples, to.environment_samples);
        store(path.is_delta, to.is_delta);
        store(path.connects, to.connects);
        store(path.connected_sphere, to.connected_sphere);
        if (transmits) {
            store(path.entered_sphere, to.entered_sphere);
        }
        to.count += store.count();
    }
    HWY_INLINE void operator()(const NextRayOf<Lanes>& ray, Mask goes) const {
        const PackedStore store(goes, to.count);
        store_ray(store, ray, to);
        to.count += store.count();
    }
};

HWY_INLINE void append(Lanes::Int indices, Mask goes, IndexList& to) {
    const PackedStore store(goes, to.count);
    store(indices, to.at);
    to.count += store.count();
}

/// Counts the shadow rays of vertices.
HWY_INLINE void count_rays(int first, ShadowQueue& shadows) {
    for (int k = 0; k < shadows.rays; ++k) {
        shadows.count += Lanes::count_of(has_rays<Lanes>(shadows, k, first));
    }
}

inline HWY_ATTR void russian_roulette_in_lanes(const CameraSamples& samples, const PathQueue& paths,
                                               IndexList& reached) {
    const int count = reached.count;
    reached.count = 0;
    for (int first = 0; first < count; first += Lanes::count()) {
        // Lanes beyond the last path repeat it.
        const auto place = Lanes::smaller_int(Lanes::from(first), Lanes::all_int(count - 1));
        const auto path = gather<Lanes>(reached.at, place);
        const auto survives = survivors_of<Lanes>(samples, paths, path);
        // What is overwritten has been read.
        append(path, Lanes::both(survives, Lanes::first_lanes(count - first)), reached);
    }
}

inline HWY_ATTR void resolve_surfaces_in_lanes(const SurfaceTask& task, int first) {
    for (; first < task.last; first += Lanes::count()) {
        resolve_surfaces<Lanes>(task, first);
    }
}

/// What continues from the vertices from `first` on.
struct AppendedQueues {
    const AppendedPaths &coat, &base;
    IndexList& near_spheres;
    int first;

    HWY_INLINE void near_sphere(Mask asks) const { append(Lanes::from(first), asks, near_spheres); }
};

inline HWY_ATTR void shade_surfaces_in_lanes(const WaveStep& step, ShadowQueue& shadows,
                                             const ContinuingQueues& next) {
    const bool transmits = step.scene.materials.transmits;
    const AppendedPaths coat{next.reflected, transmits};
    const AppendedPaths base{next.scattered, transmits};
    for (int first = shadows.first; first < shadows.last; first += Lanes::count()) {
        shade_surfaces<Lanes>(step, first, AppendedQueues{coat, base, next.near_spheres, first});
        count_rays(first, shadows);
    }
}

inline HWY_ATTR void trace_coats_in_lanes(const WaveStep& step, PathQueue& reflected) {
    for (int first = 0; first < step.vertices.count; first += Lanes::count()) {
        trace_coats<Lanes>(step, first, AppendedPaths{reflected, step.scene.materials.transmits});
    }
}

inline HWY_ATTR void shade_background_in_lanes(const WaveScene& scene, const PathQueue& paths,
                                               const EscapedQueue& missed) {
    for (int first = 0; first < missed.paths.count; first += Lanes::count()) {
        shade_background<Lanes>(scene, paths, missed, first);
    }
}

inline HWY_ATTR void sum_light_in_lanes(const ShadowQueue& shadows) {
    for (int first = shadows.first; first < shadows.last; first += Lanes::count()) {
        sum_light<Lanes>(shadows, first);
    }
}

inline HWY_ATTR void shade_rays_in_lanes(const DistributedStep& step, ShadowQueue& shadows) {
    for (int first = shadows.first; first < shadows.last; first += Lanes::count()) {
        shade_rays<Lanes>(step, first);
        count_rays(first, shadows);
    }
}

inline HWY_ATTR void find_lobes_in_lanes(const DistributedStep& step, LobeWave& reflection,
                                         LobeWave& refraction) {
    reflection.samples = refraction.samples = 0;
    for (int first = 0; first < step.vertices.count; first += Lanes::count()) {
        const LobeRays rays = find_lobes<Lanes>(step, first);
        reflection.samples = std::max(reflection.samples, rays.reflection);
        refraction.samples = std::max(refraction.samples, rays.refraction);
    }
}

inline HWY_ATTR void send_rays_in_lanes(const DistributedStep& step, const LobeWave& lobe, int k,
                                        PathQueue& next) {
    for (int first = 0; first < step.vertices.count; first += Lanes::count()) {
        send_rays<Lanes>(step, lobe, k, first, AppendedPaths{next, false});
    }
}

inline const WaveKernels& wave_kernels_of_target() {
    static constexpr WaveKernels kKernels = {
        russian_roulette_in_lanes, resolve_surfaces_in_lanes, shade_surfaces_in_lanes,
        trace_coats_in_lanes,      shade_background_in_lanes, sum_light_in_lanes,
        shade_rays_in_lanes,       find_lobes_in_lanes,       send_rays_in_lanes};
    return kKernels;
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace carom::render {

HWY_EXPORT(wave_kernels_of_target);

const WaveKernels& best_wave_kernels() {
    return HWY_DYNAMIC_DISPATCH(wave_kernels_of_target)();
}

}  // namespace carom::render

#endif
