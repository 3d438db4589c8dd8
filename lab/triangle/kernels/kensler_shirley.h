/// Kensler and Shirley 2006, "Optimizing ray-triangle intersection via automated search", IEEE
/// Symposium on Interactive Ray Tracing: the arrangement of signed volumes that their search found
/// to be fastest, distance first. The normal depends only on the triangle.
///   n = (b - a) x (a - c),  i = (a - o) x d
///   t, u, v = (n.(a - o), i.(a - c), i.(b - a)) / n.d
struct KenslerShirley {
    template <class L>
    struct Record {
        static constexpr bool kHasAxis = false;
        Vec3<typename L::Value> a, edge_b, from_c, normal;  // from_c = a - c; normal: n above

        template <class Self>
        [[nodiscard]] static auto numbers(Self& self) {
            return numbers_in(self.a, self.edge_b, self.from_c, self.normal);
        }
    };

    template <class L>
    CAROM_KERNEL static Record<L> prepare(const Corners<L>& corners) {
        const auto edge_b = corners.b - corners.a;
        const auto from_c = corners.a - corners.c;
        return {corners.a, edge_b, from_c, cross(edge_b, from_c)};
    }
    /// The normal has the length of the cross product.
    template <class L>
    CAROM_KERNEL static Record<L> prepare(const CornersAndNormal<L>& input) {
        const Corners<L>& corners = input.corners;
        const auto minus = L::all(-1);
        return {corners.a, corners.b - corners.a, corners.a - corners.c, input.normal * minus};
    }

    template <Division kDivision, class L>
    CAROM_KERNEL static HitIn<L> intersect(const RayIn<L>& ray, const Record<L>& triangle) {
        const Denominator<kDivision, L> below(dot(triangle.normal, ray.direction));
        const auto to_a = triangle.a - ray.origin;
        const auto t = below.quotient(dot(triangle.normal, to_a));
        auto valid = is_within(ray, below, t);
        if (L::none(valid)) {
            return missed<L>();
        }
        const auto i = cross(to_a, ray.direction);
        const auto u = below.quotient(dot(i, triangle.from_c));
        const auto v = below.quotient(dot(i, triangle.edge_b));
        valid = L::both(valid, L::both(is_weight<L>(u, below.whole()),
                                       is_second_weight<L>(u, v, below.whole())));
        return make_hit(ray, below, t, u, v, valid);
    }
};
