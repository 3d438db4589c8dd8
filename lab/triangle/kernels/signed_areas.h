/// Signed areas, as in many introductions: the point p in the plane is inside if it is on the same
/// side of all three edges, that is, if the areas of its triangles with the edges have the same
/// sign: n.((b - a) x (p - a)), n.((c - b) x (p - b)), n.((a - c) x (p - c)).
struct SignedAreas : EdgesAndNormal {
    template <Division kDivision, class L>
    CAROM_KERNEL static HitIn<L> intersect(const RayIn<L>& ray, const Record<L>& triangle) {
        const auto& normal = triangle.normal;
        const PlanePoint<kDivision, L> plane(dot(normal, triangle.a - ray.origin),
                                             dot(normal, ray.direction));
        const auto valid = is_within(ray, plane.below, plane.t);
        if (L::none(valid)) {
            return missed<L>();
        }
        const auto from_a = plane.point(ray.origin - triangle.a, ray.direction);
        const auto weight_c = dot(normal, cross(triangle.edge_b, from_a));
        if (L::fails_alone(L::is_at_most(L::all(0), weight_c))) {
            return missed<L>();
        }
        const auto whole = plane.below.whole();
        const auto from_b = from_a - triangle.edge_b * whole;
        const auto from_c = from_a - triangle.edge_c * whole;
        const auto weight_a = dot(normal, cross(triangle.edge_c - triangle.edge_b, from_b));
        const auto weight_b = dot(normal, cross(from_c, triangle.edge_c));
        return hit_by_sides(ray, plane, weight_a, weight_b, weight_c, valid);
    }
};
