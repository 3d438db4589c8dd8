/// Perpendicular planes: Wald's test without an axis, from a Czech thesis of 2008 on the speed of
/// ray-triangle tests. The weights are distances from planes that are perpendicular to the
/// triangle's plane along two edges, with normals scaled so that the opposite corner is at distance
/// 1:
///   n_b = (c - a) x n / |n|^2,  n_c = n x (b - a) / |n|^2
struct PerpendicularPlanes {
    template <class L>
    struct Record {
        using V = typename L::Value;
        static constexpr bool kHasAxis = false;
        Vec3<V> normal;
        V plane;  // normal times a point on it
        Vec3<V> normal_b;
        V b_d;  // weight of b = normal_b.p + b_d
        Vec3<V> normal_c;
        V c_d;

        template <class Self>
        [[nodiscard]] static auto numbers(Self& self) {
            return numbers_in(self.normal, self.plane, self.normal_b, self.b_d, self.normal_c,
                              self.c_d);
        }
    };

    template <class L>
    CAROM_KERNEL static Record<L> prepare(const Corners<L>& corners) {
        const auto normal = normal_of(corners);
        const auto inverse = L::all(1) / dot(normal, normal);
        const auto zero = L::all(0);
        const auto normal_b = cross(corners.c - corners.a, normal) * inverse;
        const auto normal_c = cross(normal, corners.b - corners.a) * inverse;
        return {normal,   dot(normal, corners.a),         normal_b, zero - dot(normal_b, corners.a),
                normal_c, zero - dot(normal_c, corners.a)};
    }

    template <Division kDivision, class L>
    CAROM_KERNEL static HitIn<L> intersect(const RayIn<L>& ray, const Record<L>& triangle) {
        const auto height = triangle.plane - dot(triangle.normal, ray.origin);
        const PlanePoint<kDivision, L> plane(height, dot(triangle.normal, ray.direction));
        auto valid = is_within(ray, plane.below, plane.t);
        if (L::none(valid)) {
            return missed<L>();
        }
        const auto p = plane.point(ray.origin, ray.direction);
        const auto whole = plane.below.whole();
        const auto u = dot(triangle.normal_b, p) + plane.below.times(triangle.b_d);
        valid = L::both(valid, is_weight<L>(u, whole));
        if (L::fails_alone(valid)) {
            return missed<L>();
        }
        const auto v = dot(triangle.normal_c, p) + plane.below.times(triangle.c_d);
        valid = L::both(valid, is_second_weight<L>(u, v, whole));
        return make_hit(ray, plane.below, plane.t, u, v, valid);
    }
};
