// Points on triangle meshes in lanes. Included as render/lanes/kernels/vectors.h is.

template <class L>
CAROM_KERNEL Vec3Of<L> three_at(const float* numbers, IntOf<L> index) {
    const auto first = index + index + index;
    const auto x_and_y = L::gather_pair(numbers, first);
    return {x_and_y.first, x_and_y.second, L::gather(numbers, first + L::all_int(2))};
}
template <class L>
CAROM_KERNEL Vec2Of<L> two_at(const float* numbers, IntOf<L> index) {
    const auto both = L::gather_pair(numbers, index + index);
    return {both.first, both.second};
}

/// Where a ray hits a mesh, in the mesh's own axes, from the triangle's number and the weights of
/// its second and third corner. `needs_uv`: otherwise uv and its lengths are 0. `object_position`
/// is left to the caller.
template <class L>
CAROM_KERNEL SurfacePointOf<L> point_on_mesh(const MeshArrays& mesh, IntOf<L> triangle,
                                             ValueOf<L> u, ValueOf<L> v, bool needs_uv) {
    using V = ValueOf<L>;
    const V zero = L::all(0);
    const V one = L::all(1);
    const auto first = triangle + triangle + triangle;
    const auto twofold = first + first;
    const auto corners = L::gather_bytes_pair(mesh.triangles.data(), twofold + twofold);
    const auto index_a = L::from_word(corners.first);
    const auto index_b = L::from_word(corners.second);
    const auto index_c = L::gather_int(mesh.triangles.data(), first + L::all_int(2));
    const Vec3<V> a = three_at<L>(mesh.vertices.data(), index_a);
    const Vec3<V> edge_b = three_at<L>(mesh.vertices.data(), index_b) - a;
    const Vec3<V> edge_c = three_at<L>(mesh.vertices.data(), index_c) - a;
    const V w = one - u - v;
    SurfacePointOf<L> point;
    point.position = a + edge_b * u + edge_c * v;
    const Vec3<V> across = cross(edge_b, edge_c);
    point.geometric_normal = unit<L>(across);
    point.shading_normal = point.geometric_normal;
    if (mesh.normals.exists()) {
        const Vec3<V> mixed = three_at<L>(mesh.normals.data(), index_a) * w +
                              three_at<L>(mesh.normals.data(), index_b) * u +
                              three_at<L>(mesh.normals.data(), index_c) * v;
        const V length2 = dot(mixed, mixed);
        const V cosine = dot(mixed, point.geometric_normal);
        const auto exists =
            L::both(L::is_less(L::all(1e-12f), length2), L::opposite(L::is_equal(cosine, zero)));
        const V scale = L::flip_sign(one, cosine) / L::root(L::select(exists, length2, one));
        point.shading_normal = select<L>(exists, mixed * scale, point.geometric_normal);
    }
    clear_texture_place<L>(point);
    if (!needs_uv) {
        return point;
    }
    point.uv = {u, v};
    // The gradients of the weights u and v.
    const V area2 = dot(across, across);
    const auto has_area = L::is_less(zero, area2);
    const V scale = L::select(has_area, one / L::select(has_area, area2, one), zero);
    const Vec3<V> of_u = cross(edge_c, across) * scale;
    const Vec3<V> of_v = cross(across, edge_b) * scale;
    point.u_gradient = of_u;
    point.v_gradient = of_v;
    if (mesh.uv.exists()) {
        const Vec2<V> uv_a = two_at<L>(mesh.uv.data(), index_a);
        const Vec2<V> corner_b = two_at<L>(mesh.uv.data(), index_b);
        const Vec2<V> corner_c = two_at<L>(mesh.uv.data(), index_c);
        const Vec2<V> uv_b{corner_b.x - uv_a.x, corner_b.y - uv_a.y};
        const Vec2<V> uv_c{corner_c.x - uv_a.x, corner_c.y - uv_a.y};
        point.uv = {uv_a.x + u * uv_b.x + v * uv_c.x, uv_a.y + u * uv_b.y + v * uv_c.y};
        point.u_gradient = of_u * uv_b.x + of_v * uv_c.x;
        point.v_gradient = of_u * uv_b.y + of_v * uv_c.y;
        const V area = L::root(area2);
        const V uv_area = L::size(uv_b.x * uv_c.y - uv_b.y * uv_c.x);
        const V per_metre =
            L::select(has_area, L::root(uv_area / L::select(has_area, area, one)), zero);
        const auto is_known = L::is_less(zero, per_metre);
        const V metres = L::select(is_known, one / L::select(is_known, per_metre, one), zero);
        point.uv_metres = {metres, metres};
    }
    return point;
}
