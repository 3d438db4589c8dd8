// The types that all kernels use besides Vec3, dot and cross (render/lanes/kernels). Like the other
// kernel files, this file is included inside a namespace: by scalar_kernels.h once, by
// kernels-inl.h once per instruction set. L is a lane type: ScalarLanes, or vectors whose lanes
// hold several rays or several triangles.

/// Hits count in (t_min, t_max), t_min >= 0. The direction need not have unit length: t is in units
/// of it.
template <class L>
struct RayIn {
    Vec3<typename L::Value> origin;
    Vec3<typename L::Value> direction;
    typename L::Value t_min;
    typename L::Value t_max;
};

/// t, and the weights of the second and third corner. Meaningless where not `valid`.
template <class L>
struct HitIn {
    typename L::Value t;
    typename L::Value u;
    typename L::Value v;
    typename L::Mask valid;
};

template <class L>
CAROM_KERNEL HitIn<L> missed() {
    const auto zero = L::all(0);
    return {zero, zero, zero, L::is_less(zero, zero)};
}

/// The two kinds of input. prepare() makes each kernel's record from one of them, when a scene is
/// set up or at every test. `numbers` lists the stored members of an input, for loading.
template <class L>
struct Corners {
    static constexpr bool kHasAxis = false;
    Vec3<typename L::Value> a, b, c;

    template <class Self>
    [[nodiscard]] static auto numbers(Self& self) {
        return std::tie(self.a.x, self.a.y, self.a.z, self.b.x, self.b.y, self.b.z, self.c.x,
                        self.c.y, self.c.z);
    }
};

template <class L>
struct CornersAndNormal {
    static constexpr bool kHasAxis = false;
    Corners<L> corners;
    Vec3<typename L::Value> normal;  // (b - a) x (c - a), of any length but zero

    template <class Self>
    [[nodiscard]] static auto numbers(Self& self) {
        return std::tuple_cat(Corners<L>::numbers(self.corners),
                              std::tie(self.normal.x, self.normal.y, self.normal.z));
    }
};

template <class L>
CAROM_KERNEL Vec3<typename L::Value> normal_of(const Corners<L>& corners) {
    return cross(corners.b - corners.a, corners.c - corners.a);
}

/// The denominator of distance and weights. `quotient` turns a numerator into the number that is
/// tested: with early division the quotient itself, with deferred division its multiple by the
/// denominator's magnitude, which has the same sign (Shevtsov, Soupikov and Kapustin 2007 avoid the
/// division in this way). `whole` stands for 1.
template <Division kDivision, class L>
class Denominator {
    using V = typename L::Value;

  public:
    CAROM_KERNEL explicit Denominator(V value)
        : value_(kDivision == Division::early ? L::inverse(value) : value),
          whole_(kDivision == Division::early ? L::all(1) : L::size(value)) {}

    [[nodiscard]] CAROM_KERNEL V quotient(V numerator) const {
        if constexpr (kDivision == Division::early) {
            return numerator * value_;
        } else {
            return L::flip_sign(numerator, value_);
        }
    }
    [[nodiscard]] CAROM_KERNEL V whole() const { return whole_; }
    /// `x` times the number that stands for 1.
    [[nodiscard]] CAROM_KERNEL V times(V x) const {
        if constexpr (kDivision == Division::early) {
            return x;
        } else {
            return x * whole_;
        }
    }

  private:
    V value_;
    V whole_;
};

/// Whether the (possibly multiplied) distance is within the ray.
template <class L, Division kDivision>
CAROM_KERNEL typename L::Mask is_within(const RayIn<L>& ray, const Denominator<kDivision, L>& below,
                                        typename L::Value t) {
    return L::both(L::is_less(below.times(ray.t_min), t), L::is_less(t, below.times(ray.t_max)));
}

/// The laboratory has lane types with tests of their own. (Devices have no concepts.)
template <class L, class = void>
inline constexpr bool kComparesNumbers = true;
template <class L>
inline constexpr bool kComparesNumbers<L, std::void_t<decltype(L::kTestsSignBits)>> = false;

template <class L, std::enable_if_t<kComparesNumbers<L>, int> = 0>
CAROM_KERNEL typename L::Mask is_weight(typename L::Value u, typename L::Value whole) {
    return L::both(L::is_at_most(L::all(0), u), L::is_at_most(u, whole));
}
/// v, where u is already a weight.
template <class L, std::enable_if_t<kComparesNumbers<L>, int> = 0>
CAROM_KERNEL typename L::Mask is_second_weight(typename L::Value u, typename L::Value v,
                                               typename L::Value whole) {
    return L::both(L::is_at_most(L::all(0), v), L::is_at_most(u + v, whole));
}

/// Turns the tested numbers into a hit. If the denominator of a degenerate triangle is so small
/// that its inverse is infinite, t is infinite or not a number: no hit.
template <class L, Division kDivision>
CAROM_KERNEL HitIn<L> make_hit(const RayIn<L>& ray, const Denominator<kDivision, L>& below,
                               typename L::Value t, typename L::Value u, typename L::Value v,
                               typename L::Mask valid) {
    if constexpr (kDivision == Division::early) {
        return {t, u, v, valid};
    } else {
        if (L::none(valid)) {
            return missed<L>();
        }
        const auto inverse = L::inverse(below.whole());
        const auto distance = t * inverse;
        const auto is_there =
            L::both(L::is_less(ray.t_min, distance), L::is_less(distance, ray.t_max));
        return {distance, u * inverse, v * inverse, L::both(valid, is_there)};
    }
}
