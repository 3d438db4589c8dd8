// What points on surfaces have in common, and points on the faces of boxes, in lanes. Included as
// render/lanes/kernels/vectors.h is.

/// See SurfacePoint.
template <class L>
struct SurfacePointOf {
    Vec3Of<L> position, geometric_normal, shading_normal;
    Vec3Of<L> object_position;
    Vec2Of<L> uv;
    Vec3Of<L> u_gradient, v_gradient;
    Vec2Of<L> uv_metres;
    Vec3Of<L> x_axis, y_axis, z_axis;  // of the object; set if textures need them
    /// Of a mesh with normals: how far the curved surface that they describe is in front of the
    /// triangle, and behind it, m.
    ValueOf<L> rise, fall;
};

/// Of a surface without a texture.
template <class L>
CAROM_KERNEL void clear_texture_place(SurfacePointOf<L>& point) {
    const auto zero = L::all(0);
    point.object_position = {zero, zero, zero};
    point.uv = {zero, zero};
    point.u_gradient = point.v_gradient = {zero, zero, zero};
    point.uv_metres = {zero, zero};
}

/// u is the longitude from +x over +y, v the latitude from -z to +z; both run from 0 to 1.
template <class L>
CAROM_KERNEL Vec2Of<L> longitude_latitude(const Vec3Of<L>& p) {
    const auto zero = L::all(0);
    const auto turns = quick_angle<L>(p.x, p.y) * L::all(1 / kTurn);
    const auto cosine = limited<L>(p.z / L::root(dot(p, p)), -1, 1);
    const auto from_top = quick_arccosine<L>(cosine) * L::all(kInversePi);
    return {L::select(L::is_less(turns, zero), turns + L::all(1), turns),
            L::larger(L::all(1) - from_top, zero)};
}

/// The gradients of longitude_latitude, for a point at a distance from the origin along the unit
/// vector n. At the poles that of u has no limit; it stays finite.
template <class L>
struct LongitudeGradientsOf {
    Vec3Of<L> u, v;

    CAROM_KERNEL LongitudeGradientsOf(const Vec3Of<L>& n, ValueOf<L> distance) {
        const auto level = L::root(L::larger(n.x * n.x + n.y * n.y, L::all(1e-8f)));
        const auto across = L::all(1 / kTurn) / (distance * level * level);
        const auto up = L::all(kInversePi) / (distance * level);
        u = {L::opposite_sign(n.y) * across, n.x * across, L::all(0)};
        v = {L::opposite_sign(n.x) * n.z * up, L::opposite_sign(n.y) * n.z * up,
             (L::all(1) - n.z * n.z) * up};
    }
};

template <class L>
struct FacePointOf {
    Vec3Of<L> position;
    Vec3Of<L> normal;
    MaskOf<L> is_x, is_z;  // the face's axis, otherwise y
};

/// Where a ray hits the box |p| <= half_size at distance t, moved onto the face: of the three faces
/// through which a ray from outside can enter, or leave from inside, the one that the point lies
/// farthest beyond.
template <class L>
CAROM_KERNEL FacePointOf<L> point_on_box(const RayOf<L>& ray, ValueOf<L> t,
                                         const Vec3Of<L>& half_size) {
    using V = ValueOf<L>;
    const V zero = L::all(0);
    const Vec3<V>& origin = ray.origin;
    const Vec3<V>& direction = ray.direction;
    const Vec3<V> p = ray.at(t);
    const auto leaves = L::both(L::is_less(L::size(origin.x), half_size.x),
                                L::both(L::is_less(L::size(origin.y), half_size.y),
                                        L::is_less(L::size(origin.z), half_size.z)));
    // 1 where the face that the ray can hit lies on the positive side.
    const V turn = L::select(leaves, L::all(1), L::all(-1));
    const auto side_of = [&](V along) CAROM_KERNEL_ATTRIBUTE {
        return L::select(L::is_less(zero, along), turn, L::opposite_sign(turn));
    };
    const Vec3<V> side{side_of(direction.x), side_of(direction.y), side_of(direction.z)};
    const Vec3<V> out = side * p - half_size;
    const auto is_x = L::both(L::is_at_most(out.y, out.x), L::is_at_most(out.z, out.x));
    const auto is_z = L::both(L::opposite(is_x), L::is_less(out.y, out.z));
    const auto is_y = L::opposite(L::either(is_x, is_z));
    const auto place = [&](V x, V limit, V sign, MaskOf<L> is_face) CAROM_KERNEL_ATTRIBUTE {
        return L::select(is_face, sign * limit,
                         L::larger(L::opposite_sign(limit), L::smaller(x, limit)));
    };
    return {{place(p.x, half_size.x, side.x, is_x), place(p.y, half_size.y, side.y, is_y),
             place(p.z, half_size.z, side.z, is_z)},
            {L::select(is_x, side.x, zero), L::select(is_y, side.y, zero),
             L::select(is_z, side.z, zero)},
            is_x,
            is_z};
}

/// Of a vector in the box's axes, the two parts along a face: after x come y and z, after y z and
/// x, after z x and y.
template <class L>
CAROM_KERNEL Vec2Of<L> along_face(const FacePointOf<L>& face, const Vec3Of<L>& v) {
    return {L::select(face.is_x, v.y, L::select(face.is_z, v.x, v.z)),
            L::select(face.is_x, v.z, L::select(face.is_z, v.y, v.x))};
}

/// The inverse of along_face: the axis of the box along which the first part runs, and the second.
template <class L>
CAROM_KERNEL Vec3Of<L> first_axis(const FacePointOf<L>& face, ValueOf<L> length) {
    const auto zero = L::all(0);
    return {L::select(face.is_z, length, zero), L::select(face.is_x, length, zero),
            L::select(L::either(face.is_x, face.is_z), zero, length)};
}
template <class L>
CAROM_KERNEL Vec3Of<L> second_axis(const FacePointOf<L>& face, ValueOf<L> length) {
    const auto zero = L::all(0);
    return {L::select(L::either(face.is_x, face.is_z), zero, length),
            L::select(face.is_z, length, zero), L::select(face.is_x, length, zero)};
}

/// Distance by which the next ray must start off the surface, m.
template <class L>
CAROM_KERNEL ValueOf<L> offset_at(const Vec3Of<L>& position, ValueOf<L> bounding_radius) {
    const auto size =
        L::larger(L::larger(L::size(position.x), L::size(position.y)), L::size(position.z));
    return L::all(kOffsetFraction) * (size + bounding_radius);
}
