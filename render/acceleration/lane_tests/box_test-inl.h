// Boxes: one ray against several of them, or several rays against one.
#if defined(CAROM_BOX_TEST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_BOX_TEST_INL_H
#undef CAROM_BOX_TEST_INL_H
#else
#define CAROM_BOX_TEST_INL_H
#endif

#include <cmath>

#include "render/acceleration/lane_tests/lane_test-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

template <class D>
struct AlignedBoxTest {
    hn::Vec<D> inverse[3];
    hn::Vec<D> scaled_origin[3];  // origin / direction
    int near_side[3];             // which of the two planes the ray hits first

    HWY_INLINE AlignedBoxTest(D d, const RayLanes<D>& ray, const V3f& direction)
        : inverse{hn::Set(d, finite_reciprocal(direction.x)),
                  hn::Set(d, finite_reciprocal(direction.y)),
                  hn::Set(d, finite_reciprocal(direction.z))},
          scaled_origin{hn::Mul(ray.origin[0], inverse[0]), hn::Mul(ray.origin[1], inverse[1]),
                        hn::Mul(ray.origin[2], inverse[2])},
          near_side{std::signbit(direction.x) ? 1 : 0, std::signbit(direction.y) ? 1 : 0,
                    std::signbit(direction.z) ? 1 : 0} {}

    HWY_INLINE hn::Vec<D> distance(D d, const Lanes& plane, int lane, int axis) const {
        return hn::MulSub(load(d, plane, lane), inverse[axis], scaled_origin[axis]);
    }

    HWY_INLINE hn::Mask<D> operator()(D d, const RayLanes<D>& ray, const AlignedBoxBlock& block,
                                      int lane, hn::Vec<D>& t) const {
        const hn::Vec<D> near[3] = {distance(d, block.planes[0][near_side[0]], lane, 0),
                                    distance(d, block.planes[1][near_side[1]], lane, 1),
                                    distance(d, block.planes[2][near_side[2]], lane, 2)};
        const hn::Vec<D> far[3] = {distance(d, block.planes[0][1 - near_side[0]], lane, 0),
                                   distance(d, block.planes[1][1 - near_side[1]], lane, 1),
                                   distance(d, block.planes[2][1 - near_side[2]], lane, 2)};
        return hit_slabs(ray, near, far, t);
    }
};

/// The slab test for rays that differ from lane to lane.
template <class D>
struct AlignedBoxRays {
    hn::Vec<D> inverse[3];
    hn::Vec<D> scaled_origin[3];

    HWY_INLINE AlignedBoxRays(D d, const RayLanes<D>& ray)
        : inverse{finite_reciprocals(d, ray.direction[0]), finite_reciprocals(d, ray.direction[1]),
                  finite_reciprocals(d, ray.direction[2])},
          scaled_origin{hn::Mul(ray.origin[0], inverse[0]), hn::Mul(ray.origin[1], inverse[1]),
                        hn::Mul(ray.origin[2], inverse[2])} {}

    HWY_INLINE hn::Mask<D> operator()(D d, const RayLanes<D>& ray, const AlignedBoxBlock& block,
                                      InAll shape, hn::Vec<D>& t) const {
        hn::Vec<D> near[3];
        hn::Vec<D> far[3];
        for (int axis = 0; axis < 3; ++axis) {
            const hn::Vec<D> low = hn::MulSub(load(d, block.planes[axis][0], shape), inverse[axis],
                                              scaled_origin[axis]);
            const hn::Vec<D> high = hn::MulSub(load(d, block.planes[axis][1], shape), inverse[axis],
                                               scaled_origin[axis]);
            near[axis] = hn::Min(low, high);
            far[axis] = hn::Max(low, high);
        }
        return hit_slabs(ray, near, far, t);
    }
};

template <>
struct LaneTest<UnitBox> {
    template <class D, class At>
    HWY_INLINE hn::Mask<D> operator()(D d, const RayLanes<D>& ray, const MappedBlock& block,
                                      At lane, hn::Vec<D>& t) const {
        hn::Vec<D> near[3];
        hn::Vec<D> far[3];
        for (int axis = 0; axis < 3; ++axis) {
            const hn::Vec<D> origin = mapped_origin(d, ray, block, lane, axis);
            const hn::Vec<D> inverse =
                finite_reciprocals(d, mapped_direction(d, ray, block, lane, axis));
            const hn::Vec<D> to_low = hn::Mul(hn::Sub(hn::Set(d, -1.f), origin), inverse);
            const hn::Vec<D> to_high = hn::Mul(hn::Sub(hn::Set(d, 1.f), origin), inverse);
            near[axis] = hn::Min(to_low, to_high);
            far[axis] = hn::Max(to_low, to_high);
        }
        return hit_slabs(ray, near, far, t);
    }
};

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
