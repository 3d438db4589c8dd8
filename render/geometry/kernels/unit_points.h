// Points on the unit shapes (render/acceleration/shape_list.h) in lanes. Included as
// render/lanes/kernels/vectors.h is.

/// A ray that hits a unit shape at distance t.
template <class L>
struct UnitHitOf {
    RayOf<L> ray;  // in the axes of the unit shape
    ValueOf<L> t;
    Vec3Of<L> parameters;  // what an affine map cannot produce (shape_list.h)
    Vec3Of<L> half_size;   // lengths of the unit shape's axes, m; only for uv
    bool needs_uv;
};

/// A point on a unit shape. Without `needs_uv`, uv and its lengths are 0.
template <class L>
struct UnitPointOf {
    Vec3Of<L> position;
    Vec3Of<L> normal;  // outwards, of any length
    Vec2Of<L> uv;
    Vec2Of<L> uv_metres;               // lengths over which u and v grow by 1, m
    Vec3Of<L> u_gradient, v_gradient;  // along the surface; in the shape's axes

    CAROM_KERNEL UnitPointOf(const Vec3Of<L>& p, const Vec3Of<L>& n) : position(p), normal(n) {
        const auto zero = L::all(0);
        uv = uv_metres = {zero, zero};
        u_gradient = v_gradient = {zero, zero, zero};
    }
};

template <class L>
CAROM_KERNEL UnitPointOf<L> on_unit_sphere(const UnitHitOf<L>& hit) {
    const Vec3Of<L> n = unit<L>(hit.ray.at(hit.t));
    UnitPointOf<L> point(n, n);
    if (hit.needs_uv) {
        point.uv = longitude_latitude<L>(n);
        point.uv_metres = {hit.half_size.x * L::all(kTurn), hit.half_size.z * L::all(0.5f * kTurn)};
        const LongitudeGradientsOf<L> gradients(n, L::all(1));
        point.u_gradient = gradients.u;
        point.v_gradient = gradients.v;
    }
    return point;
}

template <class L>
CAROM_KERNEL UnitPointOf<L> on_unit_box(const UnitHitOf<L>& hit) {
    const auto one = L::all(1);
    const FacePointOf<L> face = point_on_box<L>(hit.ray, hit.t, {one, one, one});
    UnitPointOf<L> point(face.position, face.normal);
    if (hit.needs_uv) {
        const Vec2Of<L> place = along_face<L>(face, face.position);
        const Vec2Of<L> sides = along_face<L>(face, hit.half_size);
        point.uv = {L::all(0.5f) * (place.x + one), L::all(0.5f) * (place.y + one)};
        point.uv_metres = {sides.x * L::all(2), sides.y * L::all(2)};
        point.u_gradient = first_axis<L>(face, L::all(0.5f));
        point.v_gradient = second_axis<L>(face, L::all(0.5f));
    }
    return point;
}

/// A point of the plane z = 0. `uv_length`: over which u and v grow by 1, in units of the shape.
template <class L>
CAROM_KERNEL UnitPointOf<L> on_flat_shape(const UnitHitOf<L>& hit, ValueOf<L> x, ValueOf<L> y,
                                          const Vec2Of<L>& uv, float uv_length) {
    const auto zero = L::all(0);
    UnitPointOf<L> point({x, y, zero}, {zero, zero, L::all(1)});
    point.uv = uv;
    point.uv_metres = {hit.half_size.x * L::all(uv_length), hit.half_size.y * L::all(uv_length)};
    point.u_gradient.x = point.v_gradient.y = L::all(1 / uv_length);
    return point;
}

/// uv across the square |x|, |y| <= 1.
template <class L>
CAROM_KERNEL Vec2Of<L> across_square(ValueOf<L> x, ValueOf<L> y) {
    return {L::all(0.5f) * (x + L::all(1)), L::all(0.5f) * (y + L::all(1))};
}

template <class L>
CAROM_KERNEL UnitPointOf<L> on_unit_plane(const UnitHitOf<L>& hit) {
    const Vec3Of<L> p = hit.ray.at(hit.t);
    return on_flat_shape<L>(hit, p.x, p.y, {p.x, p.y}, 1);
}

template <class L>
CAROM_KERNEL UnitPointOf<L> on_unit_rectangle(const UnitHitOf<L>& hit) {
    const Vec3Of<L> p = hit.ray.at(hit.t);
    const auto x = limited<L>(p.x, -1, 1);
    const auto y = limited<L>(p.y, -1, 1);
    return on_flat_shape<L>(hit, x, y, across_square<L>(x, y), 2);
}

template <class L>
CAROM_KERNEL UnitPointOf<L> on_unit_triangle(const UnitHitOf<L>& hit) {
    const Vec3Of<L> p = hit.ray.at(hit.t);
    const auto x = limited<L>(p.x, 0, 1);
    const auto y = L::smaller(L::larger(p.y, L::all(0)), L::all(1) - x);
    return on_flat_shape<L>(hit, x, y, {x, y}, 1);
}

template <class L>
CAROM_KERNEL UnitPointOf<L> on_unit_disk(const UnitHitOf<L>& hit) {
    const Vec3Of<L> p = hit.ray.at(hit.t);
    const auto from_centre = L::larger(L::all(1), L::root(p.x * p.x + p.y * p.y));
    const auto x = p.x / from_centre;
    const auto y = p.y / from_centre;
    return on_flat_shape<L>(hit, x, y, across_square<L>(x, y), 2);
}

/// Which faces of the frustum the rays hit: of those that they meet, the one whose distance is
/// nearest to t.
template <class L>
struct FrustumFaceOf {
    MaskOf<L> is_top, is_cap;

    CAROM_KERNEL explicit FrustumFaceOf(const UnitHitOf<L>& hit) {
        using Crossings = FrustumCrossingsOf<L>;
        const Crossings crossings = cross_frustum<L>(hit.ray, hit.parameters.x, hit.parameters.y);
        auto least = L::all(kInfinity);
        const auto is_nearest = [&](int face) CAROM_KERNEL_ATTRIBUTE {
            const auto difference = L::size(crossings.t[face] - hit.t);
            const auto nearest = L::both(crossings.valid[face], L::is_less(difference, least));
            least = L::select(nearest, difference, least);
            return nearest;
        };
        static_cast<void>(is_nearest(Crossings::side_a));
        static_cast<void>(is_nearest(Crossings::side_b));
        const auto is_bottom = is_nearest(Crossings::bottom);
        is_top = is_nearest(Crossings::top);
        is_cap = L::either(is_bottom, is_top);
    }
};

template <class L>
CAROM_KERNEL UnitPointOf<L> on_unit_frustum(const UnitHitOf<L>& hit) {
    using V = ValueOf<L>;
    const V zero = L::all(0);
    const V one = L::all(1);
    const V slope = hit.parameters.y;
    const FrustumFaceOf<L> face(hit);
    const Vec3<V> p = hit.ray.at(hit.t);
    const V from_axis = L::root(p.x * p.x + p.y * p.y);
    const auto off_axis = L::is_less(zero, from_axis);
    const V divisor = L::select(off_axis, from_axis, one);
    const V end = L::select(face.is_top, one, L::all(-1));
    const V z = L::select(face.is_cap, end, limited<L>(p.z, -1, 1));
    const V radius = hit.parameters.x + slope * z;
    const V inwards = L::select(L::is_less(radius, from_axis), radius / divisor, one);
    const V out_x = L::select(off_axis, p.x / divisor, one);
    const V out_y = L::select(off_axis, p.y / divisor, zero);
    UnitPointOf<L> point(
        {L::select(face.is_cap, inwards * p.x, radius * out_x),
         L::select(face.is_cap, inwards * p.y, radius * out_y), z},
        select<L>(face.is_cap, {zero, zero, end}, {out_x, out_y, L::opposite_sign(slope)}));
    if (hit.needs_uv) {
        const Vec2<V> on_cap = across_square<L>(point.position.x, point.position.y);
        const V turns = quick_angle<L>(out_x, out_y) * L::all(0.5f * kInversePi);
        const V longitude = L::select(L::is_less(turns, zero), turns + one, turns);
        const V height = L::all(0.5f) * (z + one);
        point.uv = {L::select(face.is_cap, on_cap.x, longitude),
                    L::select(face.is_cap, on_cap.y, height)};
        point.uv_metres = {hit.half_size.x * L::select(face.is_cap, L::all(2), L::all(kTurn)),
                           L::select(face.is_cap, hit.half_size.y, hit.half_size.z) * L::all(2)};
        const V per_length = L::all(0.5f);
        const V around = L::all(1 / kTurn) / L::larger(radius, L::all(1e-4f));
        point.u_gradient = select<L>(face.is_cap, {per_length, zero, zero},
                                     {L::opposite_sign(out_y) * around, out_x * around, zero});
        point.v_gradient =
            select<L>(face.is_cap, {zero, per_length, zero}, {zero, zero, per_length});
    }
    return point;
}

/// The normal points away from the nearest point of the axis and is continuous. v is the length
/// along the surface from the lower pole to the upper one, over the whole length.
template <class L>
CAROM_KERNEL UnitPointOf<L> on_unit_capsule(const UnitHitOf<L>& hit) {
    using V = ValueOf<L>;
    const V zero = L::all(0);
    const V half_length = hit.parameters.x;
    const Vec3<V> p = hit.ray.at(hit.t);
    const V height = L::smaller(L::larger(p.z, L::opposite_sign(half_length)), half_length);
    const Vec3<V> on_axis{zero, zero, height};
    const Vec3<V> normal = unit<L>(p - on_axis);
    UnitPointOf<L> point(on_axis + normal, normal);
    if (hit.needs_uv) {
        const V pole_to_pole = L::all(2) * half_length + L::all(0.5f * kTurn);
        const Vec2<V> turns = longitude_latitude<L>(normal);
        const V from_pole = height + half_length + L::all(0.5f * kTurn) * turns.y;
        point.uv = {turns.x, from_pole / pole_to_pole};
        point.uv_metres = {hit.half_size.x * L::all(kTurn), hit.half_size.z * pole_to_pole};
        const LongitudeGradientsOf<L> gradients(normal, L::all(1));
        point.u_gradient = gradients.u;
        point.v_gradient = gradients.v * (L::all(0.5f * kTurn) / pole_to_pole);
    }
    return point;
}

/// The normal points away from the nearest point of the core and is continuous. u and v run across
/// the side that the normal faces most.
template <class L>
CAROM_KERNEL UnitPointOf<L> on_unit_rounded_box(const UnitHitOf<L>& hit) {
    using V = ValueOf<L>;
    const V one = L::all(1);
    const Vec3<V>& core = hit.parameters;
    const Vec3<V> p = hit.ray.at(hit.t);
    const auto within = [](V x, V limit) CAROM_KERNEL_ATTRIBUTE {
        return L::smaller(L::larger(x, L::opposite_sign(limit)), limit);
    };
    const Vec3<V> on_core{within(p.x, core.x), within(p.y, core.y), within(p.z, core.z)};
    const Vec3<V> normal = unit<L>(p - on_core);
    UnitPointOf<L> point(on_core + normal, normal);
    if (hit.needs_uv) {
        const Vec3<V> size{L::size(normal.x), L::size(normal.y), L::size(normal.z)};
        FacePointOf<L> face;
        face.is_x = L::both(L::is_at_most(size.y, size.x), L::is_at_most(size.z, size.x));
        face.is_z = L::both(L::opposite(face.is_x), L::is_less(size.y, size.z));
        const Vec2<V> side = along_face<L>(face, core + Vec3<V>{one, one, one});
        const Vec2<V> place = along_face<L>(face, point.position);
        const Vec2<V> sides = along_face<L>(face, hit.half_size);
        point.uv = across_square<L>(place.x / side.x, place.y / side.y);
        point.uv_metres = {sides.x * (L::all(2) * side.x), sides.y * (L::all(2) * side.y)};
        point.u_gradient = first_axis<L>(face, L::all(0.5f) / side.x);
        point.v_gradient = second_axis<L>(face, L::all(0.5f) / side.y);
    }
    return point;
}

/// The point of the ray at distance t, moved onto the surface. `kind`: not a mesh.
template <class L>
CAROM_KERNEL UnitPointOf<L> on_unit_shape(ShapeKind kind, const UnitHitOf<L>& hit) {
    switch (kind) {
        case ShapeKind::sphere:
            return on_unit_sphere<L>(hit);
        case ShapeKind::box:
            return on_unit_box<L>(hit);
        case ShapeKind::rectangle:
            return on_unit_rectangle<L>(hit);
        case ShapeKind::triangle:
            return on_unit_triangle<L>(hit);
        case ShapeKind::disk:
            return on_unit_disk<L>(hit);
        case ShapeKind::frustum:
            return on_unit_frustum<L>(hit);
        case ShapeKind::capsule:
            return on_unit_capsule<L>(hit);
        case ShapeKind::rounded_box:
            return on_unit_rounded_box<L>(hit);
        case ShapeKind::plane:
        case ShapeKind::mesh:
            break;
    }
    return on_unit_plane<L>(hit);
}
