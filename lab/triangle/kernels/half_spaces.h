/// Half-spaces: the point in the plane is inside if it is on the same side as the third corner of
/// three planes, each through an edge and perpendicular to the triangle. Perpendicular planes are
/// the same with one plane less, because the weights add up to 1.
struct HalfSpaces {
    template <class L>
    struct Record {
        using V = typename L::Value;
        static constexpr bool kHasAxis = false;
        Vec3<V> normal;
        V plane;  // normal times a point on it
        Vec3<V> normal_a;
        V a_d;  // side of a: normal_a.p + a_d >= 0
        Vec3<V> normal_b;
        V b_d;
        Vec3<V> normal_c;
        V c_d;

        template <class Self>
        [[nodiscard]] static auto numbers(Self& self) {
            return numbers_in(self.normal, self.plane, self.normal_a, self.a_d, self.normal_b,
                              self.b_d, self.normal_c, self.c_d);
        }
    };

    template <class L>
    CAROM_KERNEL static Record<L> prepare(const Corners<L>& corners) {
        return prepare(CornersAndNormal<L>{corners, normal_of(corners)});
    }
    template <class L>
    CAROM_KERNEL static Record<L> prepare(const CornersAndNormal<L>& input) {
        const Corners<L>& corners = input.corners;
        const auto& n = input.normal;
        const auto zero = L::all(0);
        const auto normal_a = cross(n, corners.c - corners.b);
        const auto normal_b = cross(n, corners.a - corners.c);
        const auto normal_c = cross(n, corners.b - corners.a);
        return {n,        dot(n, corners.a),
                normal_a, zero - dot(normal_a, corners.b),
                normal_b, zero - dot(normal_b, corners.c),
                normal_c, zero - dot(normal_c, corners.a)};
    }

    template <Division kDivision, class L>
    CAROM_KERNEL static HitIn<L> intersect(const RayIn<L>& ray, const Record<L>& triangle) {
        const auto height = triangle.plane - dot(triangle.normal, ray.origin);
        const PlanePoint<kDivision, L> plane(height, dot(triangle.normal, ray.direction));
        const auto valid = is_within(ray, plane.below, plane.t);
        if (L::none(valid)) {
            return missed<L>();
        }
        const auto p = plane.point(ray.origin, ray.direction);
        const auto a = dot(triangle.normal_a, p) + plane.below.times(triangle.a_d);
        if (L::fails_alone(L::is_at_most(L::all(0), a))) {
            return missed<L>();
        }
        const auto b = dot(triangle.normal_b, p) + plane.below.times(triangle.b_d);
        const auto c = dot(triangle.normal_c, p) + plane.below.times(triangle.c_d);
        return hit_by_sides(ray, plane, a, b, c, valid);
    }
};
