/// Wald 2004, "Realtime ray tracing and interactive global illumination" (dissertation, Saarland
/// University), section 7.1: Badouel's test with everything that does not depend on the ray in a
/// record of nine numbers and an axis. The weights are distances from two lines in the projection
/// along w.
struct Wald {
    template <class L>
    struct Record {
        using V = typename L::Value;
        static constexpr bool kHasAxis = true;
        V normal_u, normal_v, plane;  // scaled so that the normal's component along w is 1
        V b_u, b_v, b_d;              // weight of b = b_u p_u + b_v p_v + b_d
        V c_u, c_v, c_d;
        typename L::Axis axis;

        template <class Self>
        [[nodiscard]] static auto numbers(Self& self) {
            return std::tie(self.normal_u, self.normal_v, self.plane, self.b_u, self.b_v, self.b_d,
                            self.c_u, self.c_v, self.c_d);
        }
    };

    template <class L>
    CAROM_KERNEL static Record<L> prepare(const Corners<L>& corners) {
        Record<L> record;
        const auto scale = set_axis_and_plane(corners, record);
        const auto w = record.axis;
        const auto edge_b = corners.b - corners.a;
        const auto edge_c = corners.c - corners.a;
        const auto a_u = L::after(corners.a, w);
        const auto a_v = L::before(corners.a, w);
        const auto zero = L::all(0);
        record.b_u = L::before(edge_c, w) * scale;
        record.b_v = (zero - L::after(edge_c, w)) * scale;
        record.b_d = zero - (record.b_u * a_u + record.b_v * a_v);
        record.c_u = (zero - L::before(edge_b, w)) * scale;
        record.c_v = L::after(edge_b, w) * scale;
        record.c_d = zero - (record.c_u * a_u + record.c_v * a_v);
        return record;
    }

    template <Division kDivision, class L>
    CAROM_KERNEL static HitIn<L> intersect(const RayIn<L>& ray, const Record<L>& triangle) {
        const auto& w = triangle.axis;
        const auto d_u = L::after(ray.direction, w);
        const auto d_v = L::before(ray.direction, w);
        const auto o_u = L::after(ray.origin, w);
        const auto o_v = L::before(ray.origin, w);
        const auto height = triangle.plane - L::along(ray.origin, w) - triangle.normal_u * o_u -
                            triangle.normal_v * o_v;
        const PlanePoint<kDivision, L> plane(
            height, L::along(ray.direction, w) + triangle.normal_u * d_u + triangle.normal_v * d_v);
        auto valid = is_within(ray, plane.below, plane.t);
        if (L::none(valid)) {
            return missed<L>();
        }
        const auto p_u = plane.coordinate(o_u, d_u);
        const auto p_v = plane.coordinate(o_v, d_v);
        const auto whole = plane.below.whole();
        const auto u = p_u * triangle.b_u + p_v * triangle.b_v + plane.below.times(triangle.b_d);
        valid = L::both(valid, is_weight<L>(u, whole));
        if (L::fails_alone(valid)) {
            return missed<L>();
        }
        const auto v = p_u * triangle.c_u + p_v * triangle.c_v + plane.below.times(triangle.c_d);
        valid = L::both(valid, is_second_weight<L>(u, v, whole));
        return make_hit(ray, plane.below, plane.t, u, v, valid);
    }
};
