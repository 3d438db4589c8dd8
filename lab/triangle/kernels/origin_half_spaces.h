/// Half-spaces of planes through the ray's origin and each edge: the direction must point to the
/// inner side of all three. That is the sign of the ray's Plücker product with the edge: for the
/// corners p and q relative to the origin, d.(p x q) = d.((p + q) x (q - p)) / 2. Of two triangles
/// with a common edge, one has q - p where the other has p - q, so that the two products are
/// exactly opposite and no ray passes between the triangles, whatever is rounded. (Plücker
/// products: Jones 2000, "Intersecting a ray and a triangle with Plücker coordinates", Ray Tracing
/// News 13(1).)
struct OriginHalfSpaces {
    template <class L>
    struct Record {
        static constexpr bool kHasAxis = false;
        CornersAndNormal<L> input;

        template <class Self>
        [[nodiscard]] static auto numbers(Self& self) {
            return CornersAndNormal<L>::numbers(self.input);
        }
    };

    template <class L>
    CAROM_KERNEL static Record<L> prepare(const Corners<L>& corners) {
        return {{corners, normal_of(corners)}};
    }
    template <class L>
    CAROM_KERNEL static Record<L> prepare(const CornersAndNormal<L>& input) {
        return {input};
    }

    template <Division kDivision, class L>
    CAROM_KERNEL static HitIn<L> intersect(const RayIn<L>& ray, const Record<L>& triangle) {
        const Corners<L>& corners = triangle.input.corners;
        const auto to_a = corners.a - ray.origin;
        const auto to_b = corners.b - ray.origin;
        const auto to_c = corners.c - ray.origin;
        const auto a = dot(ray.direction, cross(to_b + to_c, corners.c - corners.b));
        const auto b = dot(ray.direction, cross(to_c + to_a, corners.a - corners.c));
        if (L::fails_alone(is_same_side<L>(a, b))) {
            return missed<L>();
        }
        const auto c = dot(ray.direction, cross(to_a + to_b, corners.b - corners.a));
        const auto valid =
            L::both(is_same_side<L>(a, b), L::both(is_same_side<L>(b, c), is_same_side<L>(a, c)));
        if (L::none(valid)) {
            return missed<L>();
        }
        // The products are twice the volumes whose sum is normal.d.
        const Denominator<kDivision, L> below(a + b + c);
        const auto height = dot(triangle.input.normal, to_a);
        const auto t = below.quotient(height + height);
        // For a ray in the triangle's plane, the sum is 0, and t is not within.
        return make_hit(ray, below, t, below.quotient(b), below.quotient(c),
                        L::both(valid, is_within(ray, below, t)));
    }

  private:
    template <class L>
    CAROM_KERNEL static typename L::Mask is_same_side(typename L::Value a, typename L::Value b) {
        const auto zero = L::all(0);
        return L::either(L::both(L::is_at_most(zero, a), L::is_at_most(zero, b)),
                         L::both(L::is_at_most(a, zero), L::is_at_most(b, zero)));
    }
};
