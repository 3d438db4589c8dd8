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

/// The number of the triangle that a ray hits, and the weights of its second and third corner.
template <class L>
struct MeshHitOf {
    IntOf<L> triangle;
    ValueOf<L> u, v;
};

/// Where a mesh is that has axes of its own.
template <class L>
struct MeshPlaceOf {
    AffineOf<L> body_from_mesh, mesh_from_body;

    /// A normal of any length, of unit length in the axes of the body; 0 remains 0.
    [[nodiscard]] CAROM_KERNEL Vec3Of<L> normal(const Vec3Of<L>& of_mesh) const {
        const Vec3Of<L> n = mesh_from_body.inverse_normal(of_mesh);
        const auto length2 = dot(n, n);
        const auto one = L::all(1);
        return n * (one / L::root(L::select(L::is_less(L::all(0), length2), length2, one)));
    }
    /// 1, or -1 if the map mirrors.
    [[nodiscard]] CAROM_KERNEL ValueOf<L> side() const {
        const Vec3Of<L>(&rows)[3] = body_from_mesh.rows;
        return L::flip_sign(L::all(1), dot(cross(rows[0], rows[1]), rows[2]));
    }
};

/// Sets the normal of the surface that three corners' normals describe, and where it is. Normals
/// that are zero are missing; those that point to the back of the triangle count as far as they run
/// along it, unless their mean does: then the mesh is inside out. `corners`: relative to the first;
/// `weights` of the corners at the point.
///
/// Rays that start at the flat triangle are stopped by its neighbours where the curved surface
/// would see the light: a saw-tooth edge between light and shadow. Each normal stands for the plane
/// on which it is upright in its corner; the surface rises to the mean of the point's projections
/// on these planes (Hanika 2021, "Hacking the shadow terminator", Ray Tracing Gems II, ch. 4), at
/// most by a quarter of the triangle's size. (Chiang, Li and Burley 2019, "Taming the shadow
/// terminator", darken the light instead, so that the triangles stay visible.)
template <class L>
CAROM_KERNEL void set_smooth_normal(Vec3Of<L> (&normals)[3], const Vec3Of<L> (&corners)[3],
                                    const ValueOf<L> (&weights)[3], ValueOf<L> area,
                                    SurfacePointOf<L>& point) {
    const auto zero = L::all(0);
    const auto one = L::all(1);
    const Vec3Of<L>& flat = point.geometric_normal;
    const auto mean =
        dot(normals[0] * weights[0] + normals[1] * weights[1] + normals[2] * weights[2], flat);
    const auto front = L::flip_sign(one, mean);
    Vec3Of<L> mixed{zero, zero, zero};
    for (int k = 0; k < 3; ++k) {
        const auto height = dot(normals[k], flat) * front;
        const auto behind = L::smaller(height, zero);
        normals[k] = normals[k] * front - flat * behind;
        mixed = mixed + normals[k] * weights[k];
    }
    const auto length2 = dot(mixed, mixed);
    const auto exists =
        L::both(L::is_less(L::all(1e-12f), length2), L::is_less(zero, dot(mixed, flat)));
    point.shading_normal =
        select<L>(exists, mixed * (one / L::root(L::select(exists, length2, one))), flat);
    const Vec3Of<L> place =
        corners[0] * weights[0] + corners[1] * weights[1] + corners[2] * weights[2];
    for (int k = 0; k < 3; ++k) {
        const auto above = dot(place - corners[k], normals[k]);
        const auto slope = dot(normals[k], flat) * weights[k];
        point.rise = point.rise + L::larger(L::opposite_sign(above), zero) * slope;
        point.fall = point.fall + L::larger(above, zero) * slope;
    }
    const auto most = L::root(area) * L::all(0.25f);
    point.rise = L::select(exists, L::smaller(point.rise, most), zero);
    point.fall = L::select(exists, L::smaller(point.fall, most), zero);
}

/// Where a ray hits a mesh, in the axes of the body. `place`: null if these are the mesh's own.
/// `needs_uv`: otherwise uv and its lengths are 0. `object_position` is left to the caller.
template <class L>
CAROM_KERNEL SurfacePointOf<L> point_on_mesh(const MeshArrays& mesh, const MeshHitOf<L>& hit,
                                             const MeshPlaceOf<L>* place, bool needs_uv) {
    using V = ValueOf<L>;
    const V u = hit.u;
    const V v = hit.v;
    const V zero = L::all(0);
    const V one = L::all(1);
    const auto first = hit.triangle + hit.triangle + hit.triangle;
    const auto twofold = first + first;
    const auto corners = L::gather_bytes_pair(mesh.triangles.data(), twofold + twofold);
    const auto index_a = L::from_word(corners.first);
    const auto index_b = L::from_word(corners.second);
    const auto index_c = L::gather_int(mesh.triangles.data(), first + L::all_int(2));
    Vec3<V> a = three_at<L>(mesh.vertices.data(), index_a);
    Vec3<V> edge_b = three_at<L>(mesh.vertices.data(), index_b) - a;
    Vec3<V> edge_c = three_at<L>(mesh.vertices.data(), index_c) - a;
    V side = one;
    if (place != nullptr) {
        a = place->body_from_mesh.point(a);
        edge_b = place->body_from_mesh.vector(edge_b);
        edge_c = place->body_from_mesh.vector(edge_c);
        side = place->side();
    }
    const V w = one - u - v;
    SurfacePointOf<L> point;
    point.position = a + edge_b * u + edge_c * v;
    const Vec3<V> across = cross(edge_b, edge_c) * side;
    point.geometric_normal = unit<L>(across);
    point.shading_normal = point.geometric_normal;
    point.rise = point.fall = zero;
    if (mesh.normals.exists()) {
        const auto normal_at = [&](IntOf<L> index) CAROM_KERNEL_ATTRIBUTE {
            Vec3<V> normal = three_at<L>(mesh.normals.data(), index);
            if (place != nullptr) {
                normal = place->normal(normal);
            }
            return normal;
        };
        Vec3<V> normals[3] = {normal_at(index_a), normal_at(index_b), normal_at(index_c)};
        const Vec3<V> edges[3] = {{zero, zero, zero}, edge_b, edge_c};
        set_smooth_normal<L>(normals, edges, {w, u, v}, L::root(dot(across, across)), point);
    }
    clear_texture_place<L>(point);
    if (!needs_uv) {
        return point;
    }
    point.uv = {u, v};
    // The gradients of the weights u and v.
    const V area2 = dot(across, across);
    const auto has_area = L::is_less(zero, area2);
    const V scale = L::select(has_area, side / L::select(has_area, area2, one), zero);
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
