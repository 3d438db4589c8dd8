// Static and moving spheres, and ellipsoids: one ray against several shapes, or several rays
// against one.
#if defined(CAROM_SPHERE_TEST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_SPHERE_TEST_INL_H
#undef CAROM_SPHERE_TEST_INL_H
#else
#define CAROM_SPHERE_TEST_INL_H
#endif

#include "render/acceleration/lane_tests/lane_test-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

/// A sphere with its centre at `offset` from the ray's origin; the direction has unit length. The
/// discriminant is computed from the distance between centre and line (Haines, Günther and
/// Akenine-Möller 2019, "Precision improvements for ray/sphere intersection", section 7.3).
template <class D>
HWY_INLINE hn::Mask<D> hit_sphere(D d, const RayLanes<D>& ray, const hn::Vec<D> (&offset)[3],
                                  hn::Vec<D> radius2, hn::Vec<D>& t) {
    const hn::Vec<D> along = dot<D>(offset, ray.direction);
    const hn::Vec<D> beside[3] = {hn::NegMulAdd(along, ray.direction[0], offset[0]),
                                  hn::NegMulAdd(along, ray.direction[1], offset[1]),
                                  hn::NegMulAdd(along, ray.direction[2], offset[2])};
    const hn::Vec<D> discriminant = hn::Sub(radius2, dot<D>(beside, beside));
    const hn::Mask<D> is_hit = hn::Ge(discriminant, hn::Zero(d));
    if (hn::AllFalse(d, is_hit)) {
        return is_hit;
    }
    const hn::Vec<D> half_chord = hn::Sqrt(hn::Max(discriminant, hn::Zero(d)));
    t = first_beyond<D>(ray, hn::Sub(along, half_chord), hn::Add(along, half_chord));
    return hn::And(is_hit, hn::Gt(t, ray.t_min));
}

template <>
struct LaneTest<StaticSphere> {
    /// The spheres' positions relative to the ray's origin; returns their squared radii.
    template <class D, class At>
    HWY_INLINE hn::Vec<D> sphere_offsets(D d, const RayLanes<D>& ray,
                                         const StaticSphereBlock& block, At lane,
                                         hn::Vec<D> (&offset)[3]) const {
        for (int axis = 0; axis < 3; ++axis) {
            offset[axis] = hn::Sub(load(d, block.centre[axis], lane), ray.origin[axis]);
        }
        return load(d, block.radius2, lane);
    }

    template <class D, class At>
    HWY_INLINE hn::Mask<D> operator()(D d, const RayLanes<D>& ray, const StaticSphereBlock& block,
                                      At lane, hn::Vec<D>& t) const {
        hn::Vec<D> offset[3];
        const hn::Vec<D> radius2 = sphere_offsets(d, ray, block, lane, offset);
        return hit_sphere(d, ray, offset, radius2, t);
    }
};

template <>
struct LaneTest<MovingSphere> {
    /// The same for moving spheres; those that are not valid at the ray's time get a radius that no
    /// ray hits.
    template <class D, class At>
    HWY_INLINE hn::Vec<D> sphere_offsets(D d, const RayLanes<D>& ray,
                                         const MovingSphereBlock& block, At lane,
                                         hn::Vec<D> (&offset)[3]) const {
        const hn::Vec<D> elapsed = hn::Sub(ray.time, load(d, block.path_start, lane));
        for (int axis = 0; axis < 3; ++axis) {
            hn::Vec<D> centre = load(d, block.path[3][axis], lane);
            centre = hn::MulAdd(centre, elapsed, load(d, block.path[2][axis], lane));
            centre = hn::MulAdd(centre, elapsed, load(d, block.path[1][axis], lane));
            centre = hn::MulAdd(centre, elapsed, load(d, block.path[0][axis], lane));
            offset[axis] = hn::Sub(centre, ray.origin[axis]);
        }
        const hn::Mask<D> is_valid = hn::And(hn::Ge(ray.time, load(d, block.start, lane)),
                                             hn::Lt(ray.time, load(d, block.end, lane)));
        return hn::IfThenElse(is_valid, load(d, block.radius2, lane), hn::Set(d, -1.f));
    }

    template <class D, class At>
    HWY_INLINE hn::Mask<D> operator()(D d, const RayLanes<D>& ray, const MovingSphereBlock& block,
                                      At lane, hn::Vec<D>& t) const {
        hn::Vec<D> offset[3];
        const hn::Vec<D> radius2 = sphere_offsets(d, ray, block, lane, offset);
        return hit_sphere(d, ray, offset, radius2, t);
    }
};

template <>
struct LaneTest<UnitBall> {
    template <class D, class At>
    HWY_INLINE hn::Mask<D> operator()(D d, const RayLanes<D>& ray, const MappedBlock& block,
                                      At lane, hn::Vec<D>& t) const {
        const hn::Vec<D> o[3] = {mapped_origin(d, ray, block, lane, 0),
                                 mapped_origin(d, ray, block, lane, 1),
                                 mapped_origin(d, ray, block, lane, 2)};
        const hn::Vec<D> v[3] = {mapped_direction(d, ray, block, lane, 0),
                                 mapped_direction(d, ray, block, lane, 1),
                                 mapped_direction(d, ray, block, lane, 2)};
        const hn::Vec<D> inverse_length2 = hn::Div(hn::Set(d, 1.f), dot<D>(v, v));
        const hn::Vec<D> along = hn::Neg(hn::Mul(dot<D>(o, v), inverse_length2));
        const hn::Vec<D> beside[3] = {hn::MulAdd(along, v[0], o[0]), hn::MulAdd(along, v[1], o[1]),
                                      hn::MulAdd(along, v[2], o[2])};
        const hn::Vec<D> discriminant = hn::Sub(hn::Set(d, 1.f), dot<D>(beside, beside));
        const hn::Mask<D> is_hit = hn::Ge(discriminant, hn::Zero(d));
        const hn::Vec<D> half_chord =
            hn::Sqrt(hn::Mul(hn::Max(discriminant, hn::Zero(d)), inverse_length2));
        t = first_beyond<D>(ray, hn::Sub(along, half_chord), hn::Add(along, half_chord));
        return hn::And(is_hit, hn::Gt(t, ray.t_min));
    }
};

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
