/// A point-in-triangle test attributed to Keidy of the Mr Gamemaker forum in Fauerby 2003,
/// "Improved collision detection and response"; derived in Sunday 2001, "Intersection of rays and
/// triangles", from perpendicular products within the plane. The weights are computed from products
/// of the edges with each other and with the point, without an axis:
///   u = ((b.c)(p.c) - (c.c)(p.b)) / ((b.c)^2 - (b.b)(c.c)),  v likewise with b and c exchanged.
struct Keidy {
    template <class L>
    struct Record {
        static constexpr bool kHasAxis = false;
        Vec3<typename L::Value> a, edge_b, edge_c, normal;

        template <class Self>
        [[nodiscard]] static auto numbers(Self& self) {
            return std::tie(self.a.x, self.a.y, self.a.z, self.edge_b.x, self.edge_b.y,
                            self.edge_b.z, self.edge_c.x, self.edge_c.y, self.edge_c.z,
                            self.normal.x, self.normal.y, self.normal.z);
        }
    };

    template <class L>
    CAROM_KERNEL static Record<L> prepare(const Corners<L>& corners) {
        const auto edge_b = corners.b - corners.a;
        const auto edge_c = corners.c - corners.a;
        return {corners.a, edge_b, edge_c, cross(edge_b, edge_c)};
    }
    template <class L>
    CAROM_KERNEL static Record<L> prepare(const CornersAndNormal<L>& input) {
        const Corners<L>& corners = input.corners;
        return {corners.a, corners.b - corners.a, corners.c - corners.a, input.normal};
    }

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
