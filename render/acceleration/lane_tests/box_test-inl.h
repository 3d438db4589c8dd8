// Boxes along the axes of the world: one ray against several of them, or several rays against one.
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

/// For the same ray in all lanes. Which planes it crosses first is known beforehand.
template <class D>
struct AlignedBoxTest {
    using L = VectorLanes<D>;

    Three<hn::Vec<D>> inverse;
    int first[3];  // which of the two planes the ray hits first

    HWY_INLINE AlignedBoxTest(D /*d*/, const V3f& direction)
        : inverse(finite_reciprocals<L>(all_of<L>(direction))),
          first{std::signbit(direction.x) ? 1 : 0, std::signbit(direction.y) ? 1 : 0,
                std::signbit(direction.z) ? 1 : 0} {}

    HWY_INLINE LaneHits<D> operator()(D d, const RayLanes<D>& ray, const AlignedBoxBlock& block,
                                      int lane) const {
        const auto slab = [&](hn::Vec<D> origin, hn::Vec<D> inverse_direction, int axis) HWY_ATTR {
            return cross_sorted_slab<L>(origin, inverse_direction,
                                        load(d, block.planes[axis][first[axis]], lane),
                                        load(d, block.planes[axis][1 - first[axis]], lane));
        };
        const Three<hn::Vec<D>>& o = ray.line.origin;
        return cross_slabs<L>(slab(o.x, inverse.x, 0), slab(o.y, inverse.y, 1),
                              slab(o.z, inverse.z, 2))
            .first_hit(ray.t_min);
    }
};

/// For rays that differ from lane to lane.
template <class D>
struct AlignedBoxRays {
    using L = VectorLanes<D>;

    Three<hn::Vec<D>> inverse;

    HWY_INLINE LaneHits<D> operator()(D d, const RayLanes<D>& ray, const AlignedBoxBlock& block,
                                      InAll shape) const {
        const auto corner = [&](int side) HWY_ATTR {
            return Three<hn::Vec<D>>{load(d, block.planes[0][side], shape),
                                     load(d, block.planes[1][side], shape),
                                     load(d, block.planes[2][side], shape)};
        };
        return cross_box<L>(ray.line.origin, inverse, corner(0), corner(1)).first_hit(ray.t_min);
    }
};

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
