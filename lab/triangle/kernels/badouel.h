/// Badouel 1990, "An efficient ray-polygon intersection", Graphics Gems: the point in the plane,
/// then its weights, projected along the axis w of the normal's largest component. The two
/// equations for the weights are solved by Cramer's rule, which needs no special case for zero and
/// one division for both.
struct Badouel {
    template <class L>
    struct Record {
        using V = typename L::Value;
        static constexpr bool kHasAxis = true;
        Vec3<V> normal;
        V plane;  // normal times a point on it
        V a_u, a_v;
        V edge_b_u, edge_b_v, edge_c_u, edge_c_v;
        typename L::Axis axis;

        template <class Self>
        [[nodiscard]] static auto numbers(Self& self) {
            return numbers_in(self.normal, self.plane, self.a_u, self.a_v, self.edge_b_u,
                              self.edge_b_v, self.edge_c_u, self.edge_c_v);
        }
    };

    template <class L>
    CAROM_KERNEL static Record<L> prepare(const CornersAndNormal<L>& input) {
        const auto& a = input.corners.a;
        const auto& b = input.corners.b;
        const auto& c = input.corners.c;
        const auto w = L::longest_axis(input.normal);
        Record<L> record;
        record.axis = w;
        record.normal = input.normal;
        record.plane = dot(input.normal, input.corners.a);
        record.a_u = L::after(a, w);
        record.a_v = L::before(a, w);
        record.edge_b_u = L::after(b, w) - record.a_u;
        record.edge_b_v = L::before(b, w) - record.a_v;
        record.edge_c_u = L::after(c, w) - record.a_u;
        record.edge_c_v = L::before(c, w) - record.a_v;
        return record;
    }
    template <class L>
    CAROM_KERNEL static Record<L> prepare(const Corners<L>& corners) {
        return prepare(CornersAndNormal<L>{corners, normal_of(corners)});
    }

    template <Division kDivision, class L>
    CAROM_KERNEL static HitIn<L> intersect(const RayIn<L>& ray, const Record<L>& triangle) {
        const auto height = triangle.plane - dot(triangle.normal, ray.origin);
        const PlanePoint<kDivision, L> plane(height, dot(triangle.normal, ray.direction));
        const auto valid = is_within(ray, plane.below, plane.t);
        if (L::none(valid)) {
            return missed<L>();
        }
        const auto& w = triangle.axis;
        const auto p_u =
            plane.coordinate(L::after(ray.origin, w) - triangle.a_u, L::after(ray.direction, w));
        const auto p_v =
            plane.coordinate(L::before(ray.origin, w) - triangle.a_v, L::before(ray.direction, w));
        const auto area =
            triangle.edge_b_u * triangle.edge_c_v - triangle.edge_c_u * triangle.edge_b_v;
        const auto u = L::flip_sign(p_u * triangle.edge_c_v - triangle.edge_c_u * p_v, area);
        const auto v = L::flip_sign(triangle.edge_b_u * p_v - p_u * triangle.edge_b_v, area);
        return hit_in_plane(ray, plane, u, v, L::size(area), valid);
    }
};
