// Frustums (cylinders and cones), capsules and rounded boxes: one ray against several of them, or
// several rays against one.
#if defined(CAROM_ROUND_TEST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_ROUND_TEST_INL_H
#undef CAROM_ROUND_TEST_INL_H
#else
#define CAROM_ROUND_TEST_INL_H
#endif

#include "render/acceleration/lane_tests/lane_test-inl.h"
#include "render/geometry/intersect.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

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
        const hn::Mask<D> is_hit = hn::Ge(discriminant, zero);
        const hn::Vec<D> margin = hn::Set(d, kFrustumMargin);
        t = hn::Set(d, kInfinity);
        const auto offer = [&](hn::Vec<D> u, hn::Mask<D> valid) HWY_ATTR {
            const hn::Vec<D> at = hn::Add(shift, u);
            const hn::Mask<D> take = hn::And(valid, hn::And(hn::Gt(at, ray.t_min), hn::Lt(at, t)));
            t = hn::IfThenElse(take, at, t);
        };
        const auto offer_side = [&](hn::Vec<D> u) HWY_ATTR {
            const hn::Vec<D> z = hn::Abs(hn::MulAdd(u, v[2], p[2]));
            offer(u, hn::And(is_hit, hn::Le(z, hn::Add(one, margin))));
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
                                     hn::Mul(hn::Set(d, kMinSquaredSine), length2));
        const hn::Vec<D> b = hn::MulAdd(p[0], v[0], hn::Mul(p[1], v[1]));
        const hn::Vec<D> moment = hn::MulSub(p[0], v[1], hn::Mul(p[1], v[0]));
        const hn::Vec<D> discriminant = hn::NegMulAdd(moment, moment, a);
        const hn::Mask<D> is_hit = hn::Ge(discriminant, zero);
        if (hn::AllFalse(d, is_hit)) {
            return is_hit;
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
        return hn::And(is_hit, hn::And(hn::Gt(t, ray.t_min), hn::Lt(t, hn::Set(d, kInfinity))));
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
        const hn::Mask<D> enter_is_before[3] = {hn::Gt(line.near[0], before),
                                                hn::Gt(line.near[1], before),
                                                hn::Gt(line.near[2], before)};
        const hn::Mask<D> enter_is_behind[3] = {
            hn::Le(line.far[0], before), hn::Le(line.far[1], before), hn::Le(line.far[2], before)};
        const hn::Mask<D> leave_is_before[3] = {hn::Ge(line.near[0], behind),
                                                hn::Ge(line.near[1], behind),
                                                hn::Ge(line.near[2], behind)};
        const hn::Mask<D> leave_is_behind[3] = {
            hn::Lt(line.far[0], behind), hn::Lt(line.far[1], behind), hn::Lt(line.far[2], behind)};
        const hn::Vec<D> one = hn::Set(d, 1.f);
        const hn::Vec<D> enter = cross(d, line, enter_is_before, enter_is_behind, hn::Neg(one));
        const hn::Vec<D> leave = cross(d, line, leave_is_before, leave_is_behind, one);
        t = first_beyond<D>(ray, hn::Add(shift, enter), hn::Add(shift, leave));
        return hn::And(hn::Gt(t, ray.t_min), hn::Lt(t, hn::Set(d, kInfinity)));
    }
};

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
