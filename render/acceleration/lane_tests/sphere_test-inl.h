// Static and moving spheres: one ray against several shapes, or several rays against one.
#if defined(CAROM_SPHERE_TEST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_SPHERE_TEST_INL_H
#undef CAROM_SPHERE_TEST_INL_H
#else
#define CAROM_SPHERE_TEST_INL_H
#endif

#include "render/acceleration/lane_tests/lane_test-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

/// Spheres as seen from the origin of a ray.
template <class D>
struct SphereLanes {
    Vec3<hn::Vec<D>> to_centre;
    hn::Vec<D> radius2;

    [[nodiscard]] HWY_INLINE LaneHits<D> hit(const RayLanes<D>& ray) const {
        return hit_sphere<VectorLanes<D>>(to_centre, ray.line.direction, radius2, ray.t_min);
    }
};

template <class D, class At>
HWY_INLINE SphereLanes<D> spheres_from(D d, const RayLanes<D>& ray, const StaticSphereBlock& block,
                                       At lane) {
    return {load(d, block.centre, lane) - ray.line.origin, load(d, block.radius2, lane)};
}

/// Spheres that are not valid at the ray's time get a radius that no ray hits.
template <class D, class At>
HWY_INLINE SphereLanes<D> spheres_from(D d, const RayLanes<D>& ray, const MovingSphereBlock& block,
                                       At lane) {
    using L = VectorLanes<D>;
    const auto centre = point_on_path<L>(load(d, block.path[0], lane), load(d, block.path[1], lane),
                                         load(d, block.path[2], lane), load(d, block.path[3], lane),
                                         ray.time - load(d, block.path_start, lane));
    const auto is_valid = L::both(L::is_at_most(load(d, block.start, lane), ray.time),
                                  L::is_less(ray.time, load(d, block.end, lane)));
    return {centre - ray.line.origin,
            L::select(is_valid, load(d, block.radius2, lane), L::all(-1))};
}

struct SphereTest {
    template <class D, class Block, class At>
    HWY_INLINE LaneHits<D> operator()(D d, const RayLanes<D>& ray, const Block& block,
                                      At lane) const {
        return spheres_from(d, ray, block, lane).hit(ray);
    }
};
template <>
struct LaneTest<StaticSphere> : SphereTest {};
template <>
struct LaneTest<MovingSphere> : SphereTest {};

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
