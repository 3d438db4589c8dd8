// Rays against rounded boxes, in lanes. Included as render/lanes/kernels/vectors.h is.

/// A line against the points within distance 1 of the box |p| <= core. The squared distance from
/// the core (the sum over the axes of the squared distance beyond the core: Ericson 2005,
/// "Real-Time Collision Detection", section 5.1.3) is convex along a line, and quadratic between
/// the at most six points at which the line crosses a plane of the core's faces. The line enters
/// the shape in the piece behind the last of these points at which the squared distance is above 1
/// and falls, and leaves in the piece before the first point at which it is above 1 and rises. In
/// such a piece a face, an edge or a corner of the core is nearest: two, one or no axes drop out.
template <class L>
class RoundedBoxLineOf {
    using V = ValueOf<L>;
    using Mask = MaskOf<L>;

  public:
    /// The line begins near the centre.
    CAROM_KERNEL RoundedBoxLineOf(const RayOf<L>& line, const Vec3<V>& core)
        : line_(line),
          core_(core),
          x_(slab(line.origin.x, line.direction.x, core.x)),
          y_(slab(line.origin.y, line.direction.y, core.y)),
          z_(slab(line.origin.z, line.direction.z, core.z)),
          before_(L::all(-L::kLargest)),
          behind_(L::all(L::kLargest)) {
        pass(x_.near);
        pass(x_.far);
        pass(y_.near);
        pass(y_.far);
        pass(z_.near);
        pass(z_.far);
    }

    /// The distances are infinite if the line misses the shape.
    [[nodiscard]] CAROM_KERNEL V enter() const {
        const auto side = [&](const SlabOf<L>& slab) CAROM_KERNEL_ATTRIBUTE {
            return Side{L::is_less(before_, slab.near), L::is_at_most(slab.far, before_)};
        };
        return cross(side(x_), side(y_), side(z_), L::all(-1));
    }
    [[nodiscard]] CAROM_KERNEL V leave() const {
        const auto side = [&](const SlabOf<L>& slab) CAROM_KERNEL_ATTRIBUTE {
            return Side{L::is_at_most(behind_, slab.near), L::is_less(slab.far, behind_)};
        };
        return cross(side(x_), side(y_), side(z_), L::all(1));
    }

  private:
    /// On which side of the core the line is along one axis. The axis drops out if on neither.
    struct Side {
        Mask is_before, is_behind;
    };

    CAROM_KERNEL static SlabOf<L> slab(V origin, V direction, V core) {
        return cross_slab<L>(origin, finite_reciprocal<L>(direction), L::opposite_sign(core), core);
    }

    /// Narrows the piece of the line in which it enters or leaves.
    CAROM_KERNEL void pass(V t) {
        const auto beyond = [](V x, V core) CAROM_KERNEL_ATTRIBUTE {
            return x - L::smaller(L::larger(x, L::opposite_sign(core)), core);
        };
        const Vec3<V> p = line_.at(t);
        const Vec3<V> out{beyond(p.x, core_.x), beyond(p.y, core_.y), beyond(p.z, core_.z)};
        const V slope = dot(out, line_.direction);
        const Mask is_outside = L::is_less(L::all(1), dot(out, out));
        before_ = L::select(L::both(is_outside, L::is_less(slope, L::all(0))),
                            L::larger(before_, t), before_);
        behind_ = L::select(L::both(is_outside, L::is_less(L::all(0), slope)),
                            L::smaller(behind_, t), behind_);
    }

    /// Crosses the sphere, cylinder or plane of the axes that count. `in_or_out`: -1 or 1.
    [[nodiscard]] CAROM_KERNEL V cross(const Side& x, const Side& y, const Side& z,
                                       V in_or_out) const {
        const V zero = L::all(0);
        const auto from = [&](const Side& side, V p, V direction, V core) CAROM_KERNEL_ATTRIBUTE {
            const V far_face = L::flip_sign(core, direction);
            const V face = L::select(side.is_before, L::opposite_sign(far_face), far_face);
            return L::select(L::either(side.is_before, side.is_behind), p - face, zero);
        };
        const auto along = [&](const Side& side, V direction) CAROM_KERNEL_ATTRIBUTE {
            return L::select(L::either(side.is_before, side.is_behind), direction, zero);
        };
        const Vec3<V>& p = line_.origin;
        const Vec3<V>& d = line_.direction;
        const RayOf<L> counted{
            {from(x, p.x, d.x, core_.x), from(y, p.y, d.y, core_.y), from(z, p.z, d.z, core_.z)},
            {along(x, d.x), along(y, d.y), along(z, d.z)}};
        const V length2 = dot(counted.direction, counted.direction);
        const V middle = nearest_to_centre<L>(counted, length2);
        const Vec3<V> beside = counted.at(middle);
        const V in_sphere = L::all(1) - dot(beside, beside);
        const V half_chord = L::root(L::larger(in_sphere, zero) / length2);
        return L::select(L::is_at_most(zero, in_sphere), middle + in_or_out * half_chord,
                         L::all(kInfinity));
    }

    RayOf<L> line_;
    Vec3<V> core_;
    SlabOf<L> x_, y_, z_;  // where the line crosses the planes of the core's faces
    V before_, behind_;
};

template <class L>
CAROM_KERNEL DistanceOf<L> hit_unit_rounded_box(const RayOf<L>& ray, ValueOf<L> t_min,
                                                const Vec3Of<L>& core) {
    const auto shift = nearest_to_centre<L>(ray, dot(ray.direction, ray.direction));
    const RoundedBoxLineOf<L> line({ray.at(shift), ray.direction}, core);
    const auto near = shift + line.enter();
    const auto t = L::select(L::is_less(t_min, near), near, shift + line.leave());
    return {t, is_finite_beyond<L>(t_min, t)};
}
