// Intersection tests of analytic shapes in vector lanes: one ray against several shapes, or several
// rays against one shape. Included once per instruction set.
#include <cmath>

#include "render/acceleration/block_lists.h"
#include "render/geometry/intersect.h"
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
    const hn::Mask<D> meets = hn::Ge(discriminant, hn::Zero(d));
    if (hn::AllFalse(d, meets)) {
        return meets;
    }
    const hn::Vec<D> half_chord = hn::Sqrt(hn::Max(discriminant, hn::Zero(d)));
    t = first_beyond<D>(ray, hn::Sub(along, half_chord), hn::Add(along, half_chord));
    return hn::And(meets, hn::Gt(t, ray.t_min));
}

/// test(d, ray, block, lane, t) of a shape in the list: returns the lanes in which the ray hits the
/// shape beyond ray.t_min, and writes the distances. A shape without a test does not compile.
template <class Shape>
struct LaneTest;

template <>
struct LaneTest<StillSphere> {
    /// The spheres' positions relative to the ray's origin; returns their squared radii.
    template <class D, class At>
    HWY_INLINE hn::Vec<D> place(D d, const RayLanes<D>& ray, const StillSphereBlock& block, At lane,
                                hn::Vec<D> (&offset)[3]) const {
        for (int axis = 0; axis < 3; ++axis) {
            offset[axis] = hn::Sub(load(d, block.centre[axis], lane), ray.origin[axis]);
        }
        return load(d, block.radius2, lane);
    }

    template <class D, class At>
    HWY_INLINE hn::Mask<D> operator()(D d, const RayLanes<D>& ray, const StillSphereBlock& block,
                                      At lane, hn::Vec<D>& t) const {
        hn::Vec<D> offset[3];
        const hn::Vec<D> radius2 = place(d, ray, block, lane, offset);
        return hit_sphere(d, ray, offset, radius2, t);
    }
};

template <>
struct LaneTest<MovingSphere> {
    /// The same for moving spheres; those that are not valid at the ray's time get a radius that no
    /// ray hits.
    template <class D, class At>
    HWY_INLINE hn::Vec<D> place(D d, const RayLanes<D>& ray, const MovingSphereBlock& block,
                                At lane, hn::Vec<D> (&offset)[3]) const {
        const hn::Vec<D> elapsed = hn::Sub(ray.time, load(d, block.path_start, lane));
        for (int axis = 0; axis < 3; ++axis) {
            hn::Vec<D> centre = load(d, block.path[3][axis], lane);
            centre = hn::MulAdd(centre, elapsed, load(d, block.path[2][axis], lane));
            centre = hn::MulAdd(centre, elapsed, load(d, block.path[1][axis], lane));
            centre = hn::MulAdd(centre, elapsed, load(d, block.path[0][axis], lane));
            offset[axis] = hn::Sub(centre, ray.origin[axis]);
        }
        const hn::Mask<D> in_force = hn::And(hn::Ge(ray.time, load(d, block.start, lane)),
                                             hn::Lt(ray.time, load(d, block.end, lane)));
        return hn::IfThenElse(in_force, load(d, block.radius2, lane), hn::Set(d, -1.f));
    }

    template <class D, class At>
    HWY_INLINE hn::Mask<D> operator()(D d, const RayLanes<D>& ray, const MovingSphereBlock& block,
                                      At lane, hn::Vec<D>& t) const {
        hn::Vec<D> offset[3];
        const hn::Vec<D> radius2 = place(d, ray, block, lane, offset);
        return hit_sphere(d, ray, offset, radius2, t);
    }
};

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
        const hn::Mask<D> meets = hn::Ge(discriminant, hn::Zero(d));
        const hn::Vec<D> half_chord =
            hn::Sqrt(hn::Mul(hn::Max(discriminant, hn::Zero(d)), inverse_length2));
        t = first_beyond<D>(ray, hn::Sub(along, half_chord), hn::Add(along, half_chord));
        return hn::And(meets, hn::Gt(t, ray.t_min));
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
        const hn::Mask<D> seen = hn::Or(hn::Lt(at.slope, hn::Zero(d)),
                                        hn::Eq(load(d, block.one_sided, lane), hn::Zero(d)));
        return hn::And(hn::And(inside, seen), hn::Gt(t, ray.t_min));
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

/// See cross_frustum in intersect.h.
template <>
struct LaneTest<UnitFrustum> {
    template <class D, class At>
    HWY_INLINE hn::Mask<D> operator()(D d, const RayLanes<D>& ray, const ProfiledBlock& block,
                                      At lane, hn::Vec<D>& t) const {
        const hn::Vec<D> v[3] = {mapped_direction(d, ray, block, lane, 0),
                                 mapped_direction(d, ray, block, lane, 1),
                                 mapped_direction(d, ray, block, lane, 2)};
        hn::Vec<D> p[3] = {mapped_origin(d, ray, block, lane, 0),
                           mapped_origin(d, ray, block, lane, 1),
                           mapped_origin(d, ray, block, lane, 2)};
        const hn::Vec<D> shift = hn::Neg(hn::Div(dot<D>(p, v), dot<D>(v, v)));
        for (int axis = 0; axis < 3; ++axis) {
            p[axis] = hn::MulAdd(shift, v[axis], p[axis]);
        }
        const hn::Vec<D> zero = hn::Zero(d);
        const hn::Vec<D> one = hn::Set(d, 1.f);
        const hn::Vec<D> middle = load(d, block.profile[0], lane);
        const hn::Vec<D> slope = load(d, block.profile[1], lane);
        const hn::Vec<D> radius = hn::MulAdd(slope, p[2], middle);
        const hn::Vec<D> narrowing = hn::Mul(slope, v[2]);
        const hn::Vec<D> a =
            hn::NegMulAdd(narrowing, narrowing, hn::MulAdd(v[0], v[0], hn::Mul(v[1], v[1])));
        const hn::Vec<D> b =
            hn::NegMulAdd(narrowing, radius, hn::MulAdd(p[0], v[0], hn::Mul(p[1], v[1])));
        const hn::Vec<D> c =
            hn::NegMulAdd(radius, radius, hn::MulAdd(p[0], p[0], hn::Mul(p[1], p[1])));
        const hn::Vec<D> discriminant = hn::NegMulAdd(a, c, hn::Mul(b, b));
        const hn::Vec<D> root = hn::Sqrt(hn::Max(discriminant, zero));
        const hn::Vec<D> q = hn::Neg(hn::Add(b, hn::CopySign(root, b)));
        const hn::Mask<D> meets = hn::Ge(discriminant, zero);
        const hn::Vec<D> margin = hn::Set(d, kFrustumMargin);
        t = hn::Set(d, kInfinity);
        const auto offer = [&](hn::Vec<D> u, hn::Mask<D> valid) HWY_ATTR {
            const hn::Vec<D> at = hn::Add(shift, u);
            const hn::Mask<D> take = hn::And(valid, hn::And(hn::Gt(at, ray.t_min), hn::Lt(at, t)));
            t = hn::IfThenElse(take, at, t);
        };
        const auto offer_side = [&](hn::Vec<D> u) HWY_ATTR {
            const hn::Vec<D> z = hn::Abs(hn::MulAdd(u, v[2], p[2]));
            offer(u, hn::And(meets, hn::Le(z, hn::Add(one, margin))));
        };
        const auto offer_cap = [&](hn::Vec<D> end, hn::Vec<D> cap_radius) HWY_ATTR {
            const hn::Vec<D> u = hn::Div(hn::Sub(end, p[2]), v[2]);
            const hn::Vec<D> x = hn::MulAdd(u, v[0], p[0]);
            const hn::Vec<D> y = hn::MulAdd(u, v[1], p[1]);
            const hn::Vec<D> widened_radius = hn::Add(cap_radius, margin);
            offer(u,
                  hn::Le(hn::MulAdd(x, x, hn::Mul(y, y)), hn::Mul(widened_radius, widened_radius)));
        };
        offer_side(hn::Div(q, a));
        offer_side(hn::Div(c, q));
        offer_cap(hn::Neg(one), hn::Sub(middle, slope));
        offer_cap(one, hn::Add(middle, slope));
        return hn::Lt(t, hn::Set(d, kInfinity));
    }
};

/// See intersect_unit_capsule in capsule.h.
template <>
struct LaneTest<UnitCapsule> {
    template <class D, class At>
    HWY_INLINE hn::Mask<D> operator()(D d, const RayLanes<D>& ray, const ProfiledBlock& block,
                                      At lane, hn::Vec<D>& t) const {
        const hn::Vec<D> v[3] = {mapped_direction(d, ray, block, lane, 0),
                                 mapped_direction(d, ray, block, lane, 1),
                                 mapped_direction(d, ray, block, lane, 2)};
        hn::Vec<D> p[3] = {mapped_origin(d, ray, block, lane, 0),
                           mapped_origin(d, ray, block, lane, 1),
                           mapped_origin(d, ray, block, lane, 2)};
        const hn::Vec<D> length2 = dot<D>(v, v);
        const hn::Vec<D> shift = hn::Neg(hn::Div(dot<D>(p, v), length2));
        for (int axis = 0; axis < 3; ++axis) {
            p[axis] = hn::MulAdd(shift, v[axis], p[axis]);
        }
        const hn::Vec<D> zero = hn::Zero(d);
        const hn::Vec<D> half_length = load(d, block.profile[0], lane);
        const hn::Vec<D> a = hn::Max(hn::MulAdd(v[0], v[0], hn::Mul(v[1], v[1])),
                                     hn::Mul(hn::Set(d, kLeastLean), length2));
        const hn::Vec<D> b = hn::MulAdd(p[0], v[0], hn::Mul(p[1], v[1]));
        const hn::Vec<D> moment = hn::MulSub(p[0], v[1], hn::Mul(p[1], v[0]));
        const hn::Vec<D> discriminant = hn::NegMulAdd(moment, moment, a);
        const hn::Mask<D> meets = hn::Ge(discriminant, zero);
        if (hn::AllFalse(d, meets)) {
            return meets;
        }
        const hn::Vec<D> root = hn::Sqrt(hn::Max(discriminant, zero));
        // The distance at which the line enters or leaves the surface; infinite if the line misses
        // it.
        const auto crossing = [&](hn::Vec<D> signed_root) HWY_ATTR {
            const hn::Vec<D> on_side = hn::Div(hn::Sub(signed_root, b), a);
            const hn::Vec<D> z = hn::MulAdd(on_side, v[2], p[2]);
            const hn::Vec<D> from_end[3] = {p[0], p[1],
                                            hn::Sub(p[2], hn::CopySign(half_length, z))};
            const hn::Vec<D> along = hn::Neg(hn::Div(dot<D>(from_end, v), length2));
            const hn::Vec<D> beside[3] = {hn::MulAdd(along, v[0], from_end[0]),
                                          hn::MulAdd(along, v[1], from_end[1]),
                                          hn::MulAdd(along, v[2], from_end[2])};
            const hn::Vec<D> in_ball = hn::Sub(hn::Set(d, 1.f), dot<D>(beside, beside));
            const hn::Vec<D> half_chord = hn::Sqrt(hn::Div(hn::Max(in_ball, zero), length2));
            const hn::Vec<D> on_ball = hn::Add(along, hn::CopySign(half_chord, signed_root));
            const hn::Vec<D> on_end =
                hn::IfThenElse(hn::Ge(in_ball, zero), on_ball, hn::Set(d, kInfinity));
            return hn::Add(shift, hn::IfThenElse(hn::Le(hn::Abs(z), half_length), on_side, on_end));
        };
        t = first_beyond<D>(ray, crossing(hn::Neg(root)), crossing(root));
        return hn::And(meets, hn::And(hn::Gt(t, ray.t_min), hn::Lt(t, hn::Set(d, kInfinity))));
    }
};

/// See RoundedBoxCrossing in rounded_box.h.
template <>
struct LaneTest<UnitRoundedBox> {
    /// The line in the axes of the unit shape, and its crossings with the planes of the core's
    /// faces.
    template <class D>
    struct Line {
        hn::Vec<D> p[3], v[3], core[3];
        hn::Vec<D> near[3], far[3];
    };

    /// Narrows the intervals in which the line enters and leaves: `before` is behind every crossing
    /// at which the line approaches the core, `behind` before every crossing at which it recedes.
    template <class D>
    HWY_INLINE static void pass(D d, const Line<D>& line, hn::Vec<D> t, hn::Vec<D>& before,
                                hn::Vec<D>& behind) {
        const hn::Vec<D> zero = hn::Zero(d);
        hn::Vec<D> distance2 = zero;
        hn::Vec<D> slope = zero;
        for (int axis = 0; axis < 3; ++axis) {
            const hn::Vec<D> x = hn::MulAdd(t, line.v[axis], line.p[axis]);
            const hn::Vec<D> on_core =
                hn::Min(hn::Max(x, hn::Neg(line.core[axis])), line.core[axis]);
            const hn::Vec<D> out = hn::Sub(x, on_core);
            distance2 = hn::MulAdd(out, out, distance2);
            slope = hn::MulAdd(out, line.v[axis], slope);
        }
        const hn::Mask<D> is_outside = hn::Gt(distance2, hn::Set(d, 1.f));
        before =
            hn::IfThenElse(hn::And(is_outside, hn::Lt(slope, zero)), hn::Max(before, t), before);
        behind =
            hn::IfThenElse(hn::And(is_outside, hn::Gt(slope, zero)), hn::Min(behind, t), behind);
    }

    /// The distance to the sphere, cylinder or plane for the axes that count, before or behind the
    /// core; infinite if the line misses it. `side`: -1 where the line enters, 1 where it leaves.
    template <class D>
    HWY_INLINE static hn::Vec<D> cross(D d, const Line<D>& line, const hn::Mask<D> (&is_before)[3],
                                       const hn::Mask<D> (&is_behind)[3], hn::Vec<D> side) {
        hn::Vec<D> from[3];
        hn::Vec<D> along[3];
        for (int axis = 0; axis < 3; ++axis) {
            const hn::Mask<D> counts = hn::Or(is_before[axis], is_behind[axis]);
            const hn::Vec<D> far_face = hn::CopySign(line.core[axis], line.v[axis]);
            const hn::Vec<D> face = hn::IfThenElse(is_before[axis], hn::Neg(far_face), far_face);
            from[axis] = hn::IfThenElseZero(counts, hn::Sub(line.p[axis], face));
            along[axis] = hn::IfThenElseZero(counts, line.v[axis]);
        }
        const hn::Vec<D> length2 = dot<D>(along, along);
        const hn::Vec<D> middle = hn::Neg(hn::Div(dot<D>(from, along), length2));
        const hn::Vec<D> beside[3] = {hn::MulAdd(middle, along[0], from[0]),
                                      hn::MulAdd(middle, along[1], from[1]),
                                      hn::MulAdd(middle, along[2], from[2])};
        const hn::Vec<D> in_ball = hn::Sub(hn::Set(d, 1.f), dot<D>(beside, beside));
        const hn::Vec<D> half_chord = hn::Sqrt(hn::Div(hn::Max(in_ball, hn::Zero(d)), length2));
        return hn::IfThenElse(hn::Ge(in_ball, hn::Zero(d)), hn::MulAdd(side, half_chord, middle),
                              hn::Set(d, kInfinity));
    }

    template <class D, class At>
    HWY_INLINE hn::Mask<D> operator()(D d, const RayLanes<D>& ray, const ProfiledBlock& block,
                                      At lane, hn::Vec<D>& t) const {
        Line<D> line;
        for (int axis = 0; axis < 3; ++axis) {
            line.v[axis] = mapped_direction(d, ray, block, lane, axis);
            line.p[axis] = mapped_origin(d, ray, block, lane, axis);
            line.core[axis] = load(d, block.profile[axis], lane);
        }
        const hn::Vec<D> shift = hn::Neg(hn::Div(dot<D>(line.p, line.v), dot<D>(line.v, line.v)));
        for (int axis = 0; axis < 3; ++axis) {
            line.p[axis] = hn::MulAdd(shift, line.v[axis], line.p[axis]);
            const hn::Vec<D> inverse = finite_reciprocals(d, line.v[axis]);
            const hn::Vec<D> to_low =
                hn::Mul(hn::Sub(hn::Neg(line.core[axis]), line.p[axis]), inverse);
            const hn::Vec<D> to_high = hn::Mul(hn::Sub(line.core[axis], line.p[axis]), inverse);
            line.near[axis] = hn::Min(to_low, to_high);
            line.far[axis] = hn::Max(to_low, to_high);
        }
        const hn::Vec<D> highest = hn::Set(d, hwy::HighestValue<float>());
        hn::Vec<D> before = hn::Neg(highest);
        hn::Vec<D> behind = highest;
        for (int axis = 0; axis < 3; ++axis) {
            pass(d, line, line.near[axis], before, behind);
            pass(d, line, line.far[axis], before, behind);
        }
        const hn::Mask<D> comes[3] = {hn::Gt(line.near[0], before), hn::Gt(line.near[1], before),
                                      hn::Gt(line.near[2], before)};
        const hn::Mask<D> came[3] = {hn::Le(line.far[0], before), hn::Le(line.far[1], before),
                                     hn::Le(line.far[2], before)};
        const hn::Mask<D> goes[3] = {hn::Ge(line.near[0], behind), hn::Ge(line.near[1], behind),
                                     hn::Ge(line.near[2], behind)};
        const hn::Mask<D> went[3] = {hn::Lt(line.far[0], behind), hn::Lt(line.far[1], behind),
                                     hn::Lt(line.far[2], behind)};
        const hn::Vec<D> one = hn::Set(d, 1.f);
        const hn::Vec<D> enter = cross(d, line, comes, came, hn::Neg(one));
        const hn::Vec<D> leave = cross(d, line, goes, went, one);
        t = first_beyond<D>(ray, hn::Add(shift, enter), hn::Add(shift, leave));
        return hn::And(hn::Gt(t, ray.t_min), hn::Lt(t, hn::Set(d, kInfinity)));
    }
};

/// The test of a shape for one ray in all lanes; `direction` is the ray's.
template <class Shape, class D>
HWY_INLINE LaneTest<Shape> test_for_ray(Shape /*shape*/, D /*d*/, const RayLanes<D>& /*ray*/,
                                        const V3f& /*direction*/) {
    return {};
}
template <class D>
HWY_INLINE AlignedBoxTest<D> test_for_ray(AlignedBox /*shape*/, D d, const RayLanes<D>& ray,
                                          const V3f& direction) {
    return AlignedBoxTest<D>(d, ray, direction);
}

/// The test of a shape for rays that differ from lane to lane.
template <class Shape, class D>
HWY_INLINE LaneTest<Shape> test_for_rays(Shape /*shape*/, D /*d*/, const RayLanes<D>& /*rays*/) {
    return {};
}
template <class D>
HWY_INLINE AlignedBoxRays<D> test_for_rays(AlignedBox /*shape*/, D d, const RayLanes<D>& rays) {
    return AlignedBoxRays<D>(d, rays);
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
