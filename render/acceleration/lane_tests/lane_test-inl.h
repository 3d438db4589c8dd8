// The common part of the intersection tests of all analytic shapes: rays in vector lanes, loads of
// a block of shapes, and the test of unit shapes under affine maps. The formulas themselves are in
// render/geometry/kernels/.
#if defined(CAROM_LANE_TEST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_LANE_TEST_INL_H
#undef CAROM_LANE_TEST_INL_H
#else
#define CAROM_LANE_TEST_INL_H
#endif

#include "render/acceleration/block_lists.h"
#include "render/acceleration/kernels-inl.h"
#include "render/geometry/ray.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class D>
using Int = hn::RebindToSigned<D>;

/// One ray in every lane.
template <class D>
struct RayLanes {
    RayOf<VectorLanes<D>> line;
    hn::Vec<D> t_min;
    hn::Vec<D> time;
};

template <class D>
HWY_INLINE RayLanes<D> broadcast(D /*d*/, const Ray& ray) {
    using L = VectorLanes<D>;
    return {{all_of<L>(ray.origin), all_of<L>(ray.direction)}, L::all(ray.t_min), L::all(ray.time)};
}

/// Where a ray hits each shape of a block from `lane` on, or one shape for a ray in every lane.
template <class D>
using LaneHits = DistanceOf<VectorLanes<D>>;

/// A number of each shape of a block, from `lane` on, for one ray.
template <class D>
HWY_INLINE hn::Vec<D> load(D d, const FloatLanes& lanes, int lane) {
    return hn::LoadU(d, lanes.values + lane);
}

/// One shape of a block in all lanes, for a ray in every lane.
struct InAll {
    int lane;
};
template <class D>
HWY_INLINE hn::Vec<D> load(D d, const FloatLanes& lanes, InAll shape) {
    return hn::Set(d, lanes.values[shape.lane]);
}

template <class D, class At>
HWY_INLINE Vec3<hn::Vec<D>> load(D d, const FloatLanes (&lanes)[3], At at) {
    return {load(d, lanes[0], at), load(d, lanes[1], at), load(d, lanes[2], at)};
}

template <class D, class At>
HWY_INLINE Vec3<hn::Vec<D>> load_parameters(D d, const MappedBlock& /*block*/, At /*at*/) {
    return {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
}
template <class D, class At>
HWY_INLINE Vec3<hn::Vec<D>> load_parameters(D d, const ParameterBlock& block, At at) {
    return load(d, block.parameters, at);
}

/// test(d, ray, block, lane) of a shape in the list returns the first hits beyond ray.t_min.
template <class Shape>
struct LaneTest {
    template <class D, class At>
    HWY_INLINE LaneHits<D> operator()(D d, const RayLanes<D>& ray,
                                      const typename Shape::Block& block, At lane) const {
        using L = VectorLanes<D>;
        const AffineOf<L> unit_from_world{
            {load(d, block.map[0], lane), load(d, block.map[1], lane), load(d, block.map[2], lane)},
            load(d, block.map[3], lane)};
        return hit_unit_shape<Shape::kKind, L>(
            unit_from_world.ray(ray.line), ray.t_min,
            {load_parameters(d, block, lane), load(d, block.one_sided, lane)});
    }
};

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
