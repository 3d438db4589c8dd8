/// A point-in-triangle test attributed to Keidy of the Mr Gamemaker forum in Fauerby 2003,
/// "Improved collision detection and response"; derived in Sunday 2001, "Intersection of rays and
/// triangles", from perpendicular products within the plane. The weights are computed from products
/// of the edges with each other and with the point, without an axis:
///   u = ((b.c)(p.c) - (c.c)(p.b)) / ((b.c)^2 - (b.b)(c.c)),  v likewise with b and c exchanged.
struct Keidy : EdgesAndNormal {
    template <Division kDivision, class L>
    CAROM_KERNEL static HitIn<L> intersect(const RayIn<L>& ray, const Record<L>& triangle) {
        const auto from_a = ray.origin - triangle.a;
        const auto height = dot(triangle.normal, triangle.a - ray.origin);
        const PlanePoint<kDivision, L> plane(height, dot(triangle.normal, ray.direction));
        const auto valid = is_within(ray, plane.below, plane.t);
        if (L::none(valid)) {
            return missed<L>();
        }
        const auto bb = dot(triangle.edge_b, triangle.edge_b);
        const auto bc = dot(triangle.edge_b, triangle.edge_c);
        const auto cc = dot(triangle.edge_c, triangle.edge_c);
        const auto p = plane.point(from_a, ray.direction);
        const auto pb = dot(p, triangle.edge_b);
        const auto pc = dot(p, triangle.edge_c);
        return hit_in_plane(ray, plane, pb * cc - pc * bc, pc * bb - pb * bc, bb * cc - bc * bc,
                            valid);
    }
};
