// Points on balls, boxes and meshes in lanes. Included as render/lanes/kernels/vectors.h is.

/// See SurfacePoint.
template <class L>
struct SurfacePointOf {
    Three<typename L::Value> position, geometric_normal, shading_normal;
    Three<typename L::Value> object_position;
    Two<typename L::Value> uv;
    typename L::Value uv_per_metre;
    Two<typename L::Value> uv_metres;
};

/// u is the longitude from +x over +y, v the latitude from -z to +z; both run from 0 to 1.
template <class L>
CAROM_KERNEL Two<typename L::Value> longitude_latitude(const Three<typename L::Value>& p) {
    const auto zero = L::all(0);
    const auto turns = quick_angle<L>(p.x, p.y) * L::all(1 / kTurn);
    const auto cosine = limited<L>(p.z / L::root(dot(p, p)), -1, 1);
    const auto from_top = quick_arccosine<L>(cosine) * L::all(kInversePi);
    return {L::select(L::is_less(turns, zero), turns + L::all(1), turns),
            L::larger(L::all(1) - from_top, zero)};
}

/// The outward normal of a ball around `centre` where a ray hits it at distance t.
template <class L>
CAROM_KERNEL Three<typename L::Value> normal_on_ball(const Three<typename L::Value>& origin,
                                                     const Three<typename L::Value>& direction,
                                                     typename L::Value t,
                                                     const Three<typename L::Value>& centre) {
    return unit<L>((origin - centre) + direction * t);
}

template <class L>
struct FacePointOf {
    Three<typename L::Value> position;
    Three<typename L::Value> normal;
    typename L::Mask is_x, is_z;  // the face's axis, otherwise y
};

/// Where a ray hits the box |p| <= half_size at distance t, moved onto the face: of the three faces
/// through which a ray from outside can enter, or leave from inside, the one that the point lies
/// farthest beyond.
template <class L>
CAROM_KERNEL FacePointOf<L> point_on_box(const Three<typename L::Value>& origin,
                                         const Three<typename L::Value>& direction,
                                         typename L::Value t,
                                         const Three<typename L::Value>& half_size) {
    using V = typename L::Value;
    const V zero = L::all(0);
    const Three<V> p = origin + direction * t;
    const auto leaves = L::both(L::is_less(L::size(origin.x), half_size.x),
                                L::both(L::is_less(L::size(origin.y), half_size.y),
                                        L::is_less(L::size(origin.z), half_size.z)));
    // 1 where the face that the ray can hit lies on the positive side.
    const V turn = L::select(leaves, L::all(1), L::all(-1));
    const auto side_of = [&](V along) CAROM_KERNEL_ATTRIBUTE {
        return L::select(L::is_less(zero, along), turn, L::opposite_sign(turn));
    };
    const Three<V> side{side_of(direction.x), side_of(direction.y), side_of(direction.z)};
    const Three<V> out = side * p - half_size;
    const auto is_x = L::both(L::is_at_most(out.y, out.x), L::is_at_most(out.z, out.x));
    const auto is_z = L::both(L::opposite(is_x), L::is_less(out.y, out.z));
    const auto is_y = L::opposite(L::either(is_x, is_z));
    const auto place = [&](V x, V limit, V sign, typename L::Mask is_face) CAROM_KERNEL_ATTRIBUTE {
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
CAROM_KERNEL Two<typename L::Value> along_face(const FacePointOf<L>& face,
                                               const Three<typename L::Value>& v) {
    return {L::select(face.is_x, v.y, L::select(face.is_z, v.x, v.z)),
            L::select(face.is_x, v.z, L::select(face.is_z, v.y, v.x))};
}

/// Sets uv across the face of a box, and its lengths.
template <class L>
CAROM_KERNEL void set_uv_across(const FacePointOf<L>& face,
                                const Three<typename L::Value>& half_size,
                                SurfacePointOf<L>& point) {
    const Two<typename L::Value> place = along_face<L>(face, face.position);
    const Two<typename L::Value> half = along_face<L>(face, half_size);
    point.uv = {L::all(0.5f) * (place.x / half.x + L::all(1)),
                L::all(0.5f) * (place.y / half.y + L::all(1))};
    point.uv_metres = {L::all(2) * half.x, L::all(2) * half.y};
    point.uv_per_metre = L::all(1) / L::root(point.uv_metres.x * point.uv_metres.y);
}

template <class L>
CAROM_KERNEL Three<typename L::Value> three_at(const float* numbers, typename L::Int index) {
    const auto first = index + index + index;
    return {L::gather(numbers, first), L::gather(numbers, first + L::all_int(1)),
            L::gather(numbers, first + L::all_int(2))};
}
template <class L>
CAROM_KERNEL Two<typename L::Value> two_at(const float* numbers, typename L::Int index) {
    const auto first = index + index;
    return {L::gather(numbers, first), L::gather(numbers, first + L::all_int(1))};
}

/// Where a ray hits a mesh, in the mesh's axes, from the triangle's number and the weights of its
/// second and third corner. `needs_uv`: otherwise uv and its lengths are 0. `object_position` is
/// left to the caller.
template <class L>
CAROM_KERNEL SurfacePointOf<L> point_on_mesh(const MeshArrays& mesh, typename L::Int triangle,
                                             typename L::Value u, typename L::Value v,
                                             bool needs_uv) {
    using V = typename L::Value;
    const V zero = L::all(0);
    const V one = L::all(1);
    const auto first = triangle + triangle + triangle;
    const auto index_a = L::gather_int(mesh.triangles, first);
    const auto index_b = L::gather_int(mesh.triangles, first + L::all_int(1));
    const auto index_c = L::gather_int(mesh.triangles, first + L::all_int(2));
    const Three<V> a = three_at<L>(mesh.vertices, index_a);
    const Three<V> edge_b = three_at<L>(mesh.vertices, index_b) - a;
    const Three<V> edge_c = three_at<L>(mesh.vertices, index_c) - a;
    const V w = one - u - v;
    SurfacePointOf<L> point;
    point.position = a + edge_b * u + edge_c * v;
    const Three<V> across = cross(edge_b, edge_c);
    point.geometric_normal = unit<L>(across);
    point.shading_normal = point.geometric_normal;
    if (mesh.normals != nullptr) {
        const Three<V> mixed = three_at<L>(mesh.normals, index_a) * w +
                               three_at<L>(mesh.normals, index_b) * u +
                               three_at<L>(mesh.normals, index_c) * v;
        const V length2 = dot(mixed, mixed);
        const V cosine = dot(mixed, point.geometric_normal);
        const auto exists =
            L::both(L::is_less(L::all(1e-12f), length2), L::opposite(L::is_equal(cosine, zero)));
        const V scale = L::flip_sign(one, cosine) / L::root(L::select(exists, length2, one));
        point.shading_normal = select<L>(exists, mixed * scale, point.geometric_normal);
    }
    point.object_position = {zero, zero, zero};
    point.uv = {zero, zero};
    point.uv_per_metre = zero;
    point.uv_metres = {zero, zero};
    if (!needs_uv) {
        return point;
    }
    point.uv = {u, v};
    if (mesh.uv != nullptr) {
        const Two<V> uv_a = two_at<L>(mesh.uv, index_a);
        const Two<V> corner_b = two_at<L>(mesh.uv, index_b);
        const Two<V> corner_c = two_at<L>(mesh.uv, index_c);
        const Two<V> uv_b{corner_b.x - uv_a.x, corner_b.y - uv_a.y};
        const Two<V> uv_c{corner_c.x - uv_a.x, corner_c.y - uv_a.y};
        point.uv = {uv_a.x + u * uv_b.x + v * uv_c.x, uv_a.y + u * uv_b.y + v * uv_c.y};
        const V area = L::root(dot(across, across));
        const auto has_area = L::is_less(zero, area);
        const V uv_area = L::size(uv_b.x * uv_c.y - uv_b.y * uv_c.x);
        point.uv_per_metre =
            L::select(has_area, L::root(uv_area / L::select(has_area, area, one)), zero);
        const auto is_known = L::is_less(zero, point.uv_per_metre);
        const V metres =
            L::select(is_known, one / L::select(is_known, point.uv_per_metre, one), zero);
        point.uv_metres = {metres, metres};
    }
    return point;
}

/// Distance by which the next ray must start off the surface, m.
template <class L>
CAROM_KERNEL typename L::Value offset_at(const Three<typename L::Value>& position,
                                         typename L::Value bounding_radius) {
    const auto size =
        L::larger(L::larger(L::size(position.x), L::size(position.y)), L::size(position.z));
    return L::all(kOffsetFraction) * (size + bounding_radius);
}

/// v rotated back by the unit quaternion with the real part r and the vector q.
template <class L>
CAROM_KERNEL Three<typename L::Value> rotated_back(typename L::Value r,
                                                   const Three<typename L::Value>& q,
                                                   const Three<typename L::Value>& v) {
    const Three<typename L::Value> t = cross(v, q) * L::all(2);
    return v + t * r + cross(t, q);
}
