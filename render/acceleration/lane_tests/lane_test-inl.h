// The common part of the intersection tests of all analytic shapes: rays in vector lanes, loads of
// a block of shapes, and the declaration of a test.
#if defined(CAROM_LANE_TEST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_LANE_TEST_INL_H
#undef CAROM_LANE_TEST_INL_H
#else
#define CAROM_LANE_TEST_INL_H
#endif

#include "render/acceleration/block_lists.h"
#include "render/geometry/ray.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class D>
using Int = hn::RebindToSigned<D>;

/// One ray in every lane.
template <class D>
struct RayLanes {
    hn::Vec<D> origin[3];
    hn::Vec<D> direction[3];
    hn::Vec<D> t_min;
    hn::Vec<D> time;
};

template <class D>
HWY_INLINE RayLanes<D> broadcast(D d, const Ray& ray) {
    return {{hn::Set(d, ray.origin.x), hn::Set(d, ray.origin.y), hn::Set(d, ray.origin.z)},
            {hn::Set(d, ray.direction.x), hn::Set(d, ray.direction.y), hn::Set(d, ray.direction.z)},
            hn::Set(d, ray.t_min),
            hn::Set(d, ray.time)};
}

/// A number of each shape of a block, from `lane` on, for one ray.
template <class D>
HWY_INLINE hn::Vec<D> load(D d, const Lanes& lanes, int lane) {
    return hn::LoadU(d, lanes.values + lane);
}

/// One shape of a block in all lanes, for a ray in every lane.
struct InAll {
    int lane;
};
template <class D>
HWY_INLINE hn::Vec<D> load(D d, const Lanes& lanes, InAll shape) {
    return hn::Set(d, lanes.values[shape.lane]);
}

template <class D>
HWY_INLINE hn::Vec<D> dot(const hn::Vec<D> (&a)[3], const hn::Vec<D> (&b)[3]) {
    return hn::MulAdd(a[0], b[0], hn::MulAdd(a[1], b[1], hn::Mul(a[2], b[2])));
}

/// The nearer of two distances (near <= far) that is greater than t_min.
template <class D>
HWY_INLINE hn::Vec<D> first_beyond(const RayLanes<D>& ray, hn::Vec<D> near, hn::Vec<D> far) {
    return hn::IfThenElse(hn::Gt(near, ray.t_min), near, far);
}

/// test(d, ray, block, lane, t) of a shape in the list: returns the lanes in which the ray hits the
/// shape beyond ray.t_min, and writes the distances. A shape without a test does not compile.
template <class Shape>
struct LaneTest;

/// 1 / x, with a huge finite number in place of infinity, so that its product with zero is zero.
template <class D>
HWY_INLINE hn::Vec<D> finite_reciprocals(D d, hn::Vec<D> x) {
    const hn::Vec<D> size = hn::Max(hn::Abs(x), hn::Set(d, 1e-30f));
    return hn::Div(hn::Set(d, 1.f), hn::CopySign(size, x));
}

/// The slab test of Kay and Kajiya 1986, from the distances to the near and far plane of each pair.
template <class D>
HWY_INLINE hn::Mask<D> hit_slabs(const RayLanes<D>& ray, const hn::Vec<D> (&near)[3],
                                 const hn::Vec<D> (&far)[3], hn::Vec<D>& t) {
    const hn::Vec<D> enter = hn::Max(hn::Max(near[0], near[1]), near[2]);
    const hn::Vec<D> leave = hn::Min(hn::Min(far[0], far[1]), far[2]);
    t = first_beyond<D>(ray, enter, leave);
    return hn::And(hn::Le(enter, leave), hn::Gt(t, ray.t_min));
}

template <class D, class At>
HWY_INLINE hn::Vec<D> mapped_coordinate(D d, const MappedBlock& block, At lane, int axis,
                                        const hn::Vec<D> (&p)[3], hn::Vec<D> last) {
    hn::Vec<D> sum = hn::MulAdd(p[0], load(d, block.map[0][axis], lane), last);
    sum = hn::MulAdd(p[1], load(d, block.map[1][axis], lane), sum);
    return hn::MulAdd(p[2], load(d, block.map[2][axis], lane), sum);
}

template <class D, class At>
HWY_INLINE hn::Vec<D> mapped_origin(D d, const RayLanes<D>& ray, const MappedBlock& block, At lane,
                                    int axis) {
    return mapped_coordinate(d, block, lane, axis, ray.origin, load(d, block.map[3][axis], lane));
}

template <class D, class At>
HWY_INLINE hn::Vec<D> mapped_direction(D d, const RayLanes<D>& ray, const MappedBlock& block,
                                       At lane, int axis) {
    return mapped_coordinate(d, block, lane, axis, ray.direction, hn::Zero(d));
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
