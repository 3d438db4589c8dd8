/// Shevtsov, Soupikov and Kapustin 2007, "Ray-triangle intersection algorithm for modern CPU
/// architectures", GraphiCon: volumes, projected along the axis w of the normal's largest
/// component; the normal is scaled so that its component along w is 1, and the edges are divided by
/// that component.
struct ShevtsovSoupikovKapustin {
    template <class L>
    struct Record {
        using V = typename L::Value;
        static constexpr bool kHasAxis = true;
        V normal_u, normal_v, plane;  // plane: of a point on it, the scaled normal times the point
        V a_u, a_v;
        V edge_b_u, edge_b_v, edge_c_u, edge_c_v;
        typename L::Axis axis;  // w; u and v follow it

        template <class Self>
        [[nodiscard]] static auto numbers(Self& self) {
            return std::tie(self.normal_u, self.normal_v, self.plane, self.a_u, self.a_v,
                            self.edge_b_u, self.edge_b_v, self.edge_c_u, self.edge_c_v);
        }
    };

    template <class L>
    CAROM_KERNEL static Record<L> prepare(const Corners<L>& corners) {
        Record<L> record;
        const auto scale = set_axis_and_plane(corners, record);
        const auto w = record.axis;
        const auto edge_b = corners.b - corners.a;
        const auto edge_c = corners.c - corners.a;
        record.a_u = L::after(corners.a, w);
        record.a_v = L::before(corners.a, w);
        record.edge_b_u = L::after(edge_b, w) * scale;
        record.edge_b_v = L::before(edge_b, w) * scale;
        record.edge_c_u = L::after(edge_c, w) * scale;
        record.edge_c_v = L::before(edge_c, w) * scale;
        return record;
    }

    template <Division kDivision, class L>
    CAROM_KERNEL static HitIn<L> intersect(const RayIn<L>& ray, const Record<L>& triangle) {
        const auto& w = triangle.axis;
        const auto d_u = L::after(ray.direction, w);
        const auto d_v = L::before(ray.direction, w);
        const auto o_u = L::after(ray.origin, w);
        const auto o_v = L::before(ray.origin, w);
        const auto determinant =
            d_u * triangle.normal_u + d_v * triangle.normal_v + L::along(ray.direction, w);
        const Denominator<kDivision, L> below(determinant);
        const auto height = triangle.plane - (o_u * triangle.normal_u + o_v * triangle.normal_v +
                                              L::along(ray.origin, w));
        const auto t = below.quotient(height);
        auto valid = is_within(ray, below, t);
        if (L::none(valid)) {
            return missed<L>();
        }
        // The vector from the corner to the point in the plane, times the determinant.
        const auto from_a_u = d_u * height - determinant * (triangle.a_u - o_u);
        const auto from_a_v = d_v * height - determinant * (triangle.a_v - o_v);
        const auto u = below.quotient(triangle.edge_c_v * from_a_u - triangle.edge_c_u * from_a_v);
        valid = L::both(valid, is_weight<L>(u, below.whole()));
        if (L::fails_alone(valid)) {
            return missed<L>();
        }
        const auto v = below.quotient(triangle.edge_b_u * from_a_v - triangle.edge_b_v * from_a_u);
        valid = L::both(valid, is_second_weight<L>(u, v, below.whole()));
        return make_hit(ray, below, t, u, v, valid);
    }
};
