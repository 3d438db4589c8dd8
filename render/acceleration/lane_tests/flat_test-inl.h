// Planes, rectangles, triangles and disks: one ray against several of them, or several rays against
// one.
#if defined(CAROM_FLAT_TEST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_FLAT_TEST_INL_H
#undef CAROM_FLAT_TEST_INL_H
#else
#define CAROM_FLAT_TEST_INL_H
#endif

#include "render/acceleration/lane_tests/lane_test-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

template <>
struct LaneTest<UnitPlane> {
    template <class D, class At>
    HWY_INLINE hn::Mask<D> operator()(D d, const RayLanes<D>& ray, const MappedBlock& block,
                                      At lane, hn::Vec<D>& t) const {
        const hn::Vec<D> height = mapped_origin(d, ray, block, lane, 2);
        const hn::Vec<D> slope = mapped_direction(d, ray, block, lane, 2);
        t = hn::Neg(hn::Div(height, slope));
        // Infinite and NaN distances of rays within the plane are misses.
        return hn::And(hn::Gt(t, ray.t_min), hn::Lt(t, hn::Set(d, kInfinity)));
    }
};

/// Where the ray crosses the plane z = 0 of the unit shape in each lane.
template <class D>
struct PlanePoint {
    hn::Vec<D> x, y, slope;
};

template <class D, class At>
HWY_INLINE PlanePoint<D> intersect_plane(D d, const RayLanes<D>& ray, const MappedBlock& block,
                                         At lane, hn::Vec<D>& t) {
    PlanePoint<D> point;
    point.slope = mapped_direction(d, ray, block, lane, 2);
    t = hn::Neg(hn::Div(mapped_origin(d, ray, block, lane, 2), point.slope));
    point.x = hn::MulAdd(t, mapped_direction(d, ray, block, lane, 0),
                         mapped_origin(d, ray, block, lane, 0));
    point.y = hn::MulAdd(t, mapped_direction(d, ray, block, lane, 1),
                         mapped_origin(d, ray, block, lane, 1));
    return point;
}

template <>
struct LaneTest<UnitRectangle> {
    template <class D, class At>
    HWY_INLINE hn::Mask<D> operator()(D d, const RayLanes<D>& ray, const MappedBlock& block,
                                      At lane, hn::Vec<D>& t) const {
        const PlanePoint<D> at = intersect_plane(d, ray, block, lane, t);
        const hn::Vec<D> one = hn::Set(d, 1.f);
        const hn::Mask<D> inside = hn::And(hn::Le(hn::Abs(at.x), one), hn::Le(hn::Abs(at.y), one));
        // A one-sided rectangle is invisible from behind (slope > 0).
        const hn::Mask<D> is_visible = hn::Or(hn::Lt(at.slope, hn::Zero(d)),
                                              hn::Eq(load(d, block.one_sided, lane), hn::Zero(d)));
        return hn::And(hn::And(inside, is_visible), hn::Gt(t, ray.t_min));
    }
};

template <>
struct LaneTest<UnitTriangle> {
    template <class D, class At>
    HWY_INLINE hn::Mask<D> operator()(D d, const RayLanes<D>& ray, const MappedBlock& block,
                                      At lane, hn::Vec<D>& t) const {
        const PlanePoint<D> at = intersect_plane(d, ray, block, lane, t);
        const hn::Vec<D> low = hn::Set(d, -kTriangleMargin);
        const hn::Vec<D> high = hn::Set(d, 1 + kTriangleMargin);
        const hn::Mask<D> inside = hn::And(hn::And(hn::Ge(at.x, low), hn::Ge(at.y, low)),
                                           hn::Le(hn::Add(at.x, at.y), high));
        return hn::And(inside, hn::Gt(t, ray.t_min));
    }
};

template <>
struct LaneTest<UnitDisk> {
    template <class D, class At>
    HWY_INLINE hn::Mask<D> operator()(D d, const RayLanes<D>& ray, const MappedBlock& block,
                                      At lane, hn::Vec<D>& t) const {
        const PlanePoint<D> at = intersect_plane(d, ray, block, lane, t);
        const hn::Vec<D> radius2 = hn::MulAdd(at.x, at.x, hn::Mul(at.y, at.y));
        return hn::And(hn::Le(radius2, hn::Set(d, 1.f)), hn::Gt(t, ray.t_min));
    }
};

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
