// Appending what continues in some lanes to queues. Included once per instruction set.
#if defined(CAROM_PACKED_PATHS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_PACKED_PATHS_INL_H
#undef CAROM_PACKED_PATHS_INL_H
#else
#define CAROM_PACKED_PATHS_INL_H
#endif

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

/// What paths and rays have in every integrator.
template <class Path>
HWY_INLINE void store_ray(const PackedStore& store, const Path& path, const PathQueue& to) {
    store(path.slot, to.slot);
    store(path.branch, to.branch);
    store(path.origin, to.origin);
    store(path.direction, to.direction);
    store(path.time, to.time);
    store(path.throughput, to.throughput);
    store(path.cone_width, to.cone_width);
    store(path.cone_spread, to.cone_spread);
}

/// Appends to a list of paths.
struct AppendedPaths {
    PathQueue& to;
    bool transmits;  // in the scene

    [[nodiscard]] HWY_INLINE const AppendedPaths& at(int /*k*/) const {
        return *this;
    }
    HWY_INLINE void operator()(const ContinuingPathOf<Lanes>& path, Mask goes) const {
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
    HWY_INLINE void operator()(const SentRayOf<Lanes>& ray, Mask goes) const {
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

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
