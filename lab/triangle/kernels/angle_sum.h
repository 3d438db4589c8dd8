/// Sum of angles, as in many introductions: seen from a point inside, the three edges span a full
/// turn; from any other point of the plane, less. Angles near a half turn are inaccurate, because
/// the cosine is flat there; the sum must therefore be allowed to be too small, so that points
/// close outside an edge count as inside.
struct AngleSum : EdgesAndNormal {
    template <Division kDivision, class L>
    CAROM_KERNEL static HitIn<L> intersect(const RayIn<L>& ray, const Record<L>& triangle) {
        const PlanePoint<kDivision, L> plane(dot(triangle.normal, triangle.a - ray.origin),
                                             dot(triangle.normal, ray.direction));
        auto valid = is_within(ray, plane.below, plane.t);
        if (L::none(valid)) {
            return missed<L>();
        }
        // With deferred division, all are multiples, which have the same angles.
        const auto whole = plane.below.whole();
        const auto from_a = plane.point(ray.origin - triangle.a, ray.direction);
        const auto from_b = from_a - triangle.edge_b * whole;
        const auto from_c = from_a - triangle.edge_c * whole;
        const auto sum =
            angle<L>(from_a, from_b) + angle<L>(from_b, from_c) + angle<L>(from_c, from_a);
        valid = L::both(valid, L::is_at_most(L::all(kLeastSum<typename L::Number>), sum));
        if (L::none(valid)) {
            return missed<L>();
        }
        // Twice the areas between the point and the edges, which are positive on both sides.
        return hit_by_sides(ray, plane, length<L>(cross(from_b, from_c)),
                            length<L>(cross(from_c, from_a)), length<L>(cross(from_a, from_b)),
                            valid);
    }

  private:
    /// A full turn less the error of an angle near a half turn whose cosine is wrong by eight
    /// roundings.
    template <class T>
    static constexpr T kLeastSum = static_cast<T>(2 * std::numbers::pi) -
                                   (sizeof(T) == sizeof(float) ? T(1.4e-3)
                                                               : T(6e-8));  // 4 sqrt(epsilon)

    /// At a corner, a half turn.
    template <class L>
    CAROM_KERNEL static typename L::Value angle(const Vec3<typename L::Value>& a,
                                                const Vec3<typename L::Value>& b) {
        const auto lengths = L::root(dot(a, a) * dot(b, b));
        const auto is_corner = L::is_equal(lengths, L::all(0));
        return arc_cosine<L>(L::select(is_corner, L::all(-1), dot(a, b) / lengths));
    }
    template <class L>
    CAROM_KERNEL static typename L::Value length(const Vec3<typename L::Value>& v) {
        return L::root(dot(v, v));
    }
};
