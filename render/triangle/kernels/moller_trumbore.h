/// Möller and Trumbore 1997, "Fast, minimum storage ray/triangle intersection", Journal of Graphics
/// Tools 2(1): weights first, then the distance. The record keeps the edges.
struct MollerTrumbore {
    template <class L>
    struct Record {
        static constexpr bool kHasAxis = false;
        Vec3<typename L::Value> a, edge_b, edge_c;

        template <class Self>
        [[nodiscard]] static auto numbers(Self& self) {
            return std::tie(self.a.x, self.a.y, self.a.z, self.edge_b.x, self.edge_b.y,
                            self.edge_b.z, self.edge_c.x, self.edge_c.y, self.edge_c.z);
        }
    };

    template <class L>
    CAROM_KERNEL static Record<L> prepare(const Corners<L>& corners) {
        return {corners.a, corners.b - corners.a, corners.c - corners.a};
    }

    template <Division kDivision, class L>
    CAROM_KERNEL static HitIn<L> intersect(const RayIn<L>& ray, const Record<L>& triangle) {
        const auto p = cross(ray.direction, triangle.edge_c);
        const Denominator<kDivision, L> below(dot(triangle.edge_b, p));
        const auto from_a = ray.origin - triangle.a;
        const auto u = below.quotient(dot(from_a, p));
        auto valid = is_weight<L>(u, below.whole());
        if (L::fails_alone(valid)) {
            return missed<L>();
        }
        const auto q = cross(from_a, triangle.edge_b);
        const auto v = below.quotient(dot(ray.direction, q));
        valid = L::both(valid, is_second_weight<L>(u, v, below.whole()));
        if (L::none(valid)) {
            return missed<L>();
        }
        const auto t = below.quotient(dot(triangle.edge_c, q));
        return make_hit(ray, below, t, u, v, L::both(valid, is_within(ray, below, t)));
    }
};
