/// The lane type of a technique, made from that of the plain variant.
template <Technique kTechnique, class Plain>
struct LanesChoice {
    using Type = typename Plain::template With<AxisChoiceOf<kTechnique>>;
};
template <class Plain>
struct LanesChoice<Technique::newton, Plain> {
    using Type = NewtonLanes<Plain>;
};
template <class Plain>
struct LanesChoice<Technique::sign_bits, Plain> {
    using Type = SignBitLanes<Plain>;
};
template <Technique kTechnique, class Plain>
using LanesOf = typename LanesChoice<kTechnique, Plain>::Type;

/// A triangle in memory. `first`: the axis with which its coordinates begin.
template <Technique kTechnique, class Stored>
struct StoredTriangle {
    Stored input;
    static constexpr std::uint32_t first = 0;
};
template <class Stored>
struct StoredTriangle<Technique::axis_by_order, Stored> {
    Stored input;
    std::uint32_t first;
};

/// Coordinates from `first` on.
template <class V>
CAROM_KERNEL Vec3<V> in_order(const Vec3<V>& v, unsigned first) {
    return {v[first], v[(first + 1) % 3], v[(first + 2) % 3]};
}
inline V3f in_order(const V3f& v, unsigned first) {
    return {v[static_cast<int>(first)], v[static_cast<int>((first + 1) % 3)],
            v[static_cast<int>((first + 2) % 3)]};
}

template <class Kernel, Input kInput, Technique kTechnique, class L>
StoredTriangle<kTechnique, InputOf<Kernel, kInput, L>> stored_triangle(const TriangleCorners& t) {
    if constexpr (kTechnique == Technique::axis_by_order) {
        using T = typename L::Number;
        const Corners<L> corners{triple<T>(t.a), triple<T>(t.b), triple<T>(t.c)};
        const unsigned first = L::longest(normal_of(corners));
        return {make_input<Kernel, kInput, L>(
                    {in_order(t.a, first), in_order(t.b, first), in_order(t.c, first)}),
                first};
    } else {
        return {make_input<Kernel, kInput, L>(t)};
    }
}

/// Rays in lanes, ready for tests.
template <Technique kTechnique, class L>
class TestedRay {
  public:
    CAROM_KERNEL explicit TestedRay(const RayIn<L>& ray) : ray_(ray) {}

    template <class Kernel, Division kDivision>
    [[nodiscard]] CAROM_KERNEL HitIn<L> test(const typename Kernel::template Record<L>& record,
                                             std::uint32_t /*first*/) const {
        return Kernel::template intersect<kDivision>(ray_, record);
    }
    [[nodiscard]] CAROM_KERNEL typename L::Value t_max() const { return ray_.t_max; }
    CAROM_KERNEL void set_t_max(typename L::Value t_max) { ray_.t_max = t_max; }

  protected:
    RayIn<L> ray_;
};

template <class L>
class TestedRay<Technique::axis_by_versions, L> : public TestedRay<Technique::plain, L> {
  public:
    CAROM_KERNEL explicit TestedRay(const RayIn<L>& ray) : TestedRay<Technique::plain, L>(ray) {}

    template <class Kernel, Division kDivision>
    [[nodiscard]] CAROM_KERNEL HitIn<L> test(const typename Kernel::template Record<L>& record,
                                             std::uint32_t /*first*/) const {
        switch (record.axis.w) {
            case 0:
                return along<Kernel, kDivision, 0>(record);
            case 1:
                return along<Kernel, kDivision, 1>(record);
            default:
                return along<Kernel, kDivision, 2>(record);
        }
    }

  private:
    template <class Kernel, Division kDivision, unsigned kW>
    [[nodiscard]] CAROM_KERNEL HitIn<L> along(
        const typename Kernel::template Record<L>& record) const {
        using Along = typename L::template With<FixedAxis<kW>>;
        typename Kernel::template Record<Along> fixed;
        copy(Kernel::template Record<L>::numbers(record), decltype(fixed)::numbers(fixed),
             NumberIndices<decltype(fixed)>());
        const RayIn<L>& own = this->ray_;
        const RayIn<Along> ray{own.origin, own.direction, own.t_min, own.t_max};
        const HitIn<Along> hit = Kernel::template intersect<kDivision>(ray, fixed);
        return {hit.t, hit.u, hit.v, hit.valid};
    }
    template <class From, class To, std::size_t... kIndices>
    CAROM_KERNEL static void copy(From from, To to, std::index_sequence<kIndices...>) {
        ((std::get<kIndices>(to) = std::get<kIndices>(from)), ...);
    }
};

template <class L>
class TestedRay<Technique::axis_by_order, L> {
  public:
    CAROM_KERNEL explicit TestedRay(const RayIn<L>& ray)
        : rays_{turned(ray, 0), turned(ray, 1), turned(ray, 2)} {}

    template <class Kernel, Division kDivision>
    [[nodiscard]] CAROM_KERNEL HitIn<L> test(const typename Kernel::template Record<L>& record,
                                             std::uint32_t first) const {
        return Kernel::template intersect<kDivision>(rays_[first], record);
    }
    [[nodiscard]] CAROM_KERNEL typename L::Value t_max() const { return rays_[0].t_max; }
    CAROM_KERNEL void set_t_max(typename L::Value t_max) {
        for (RayIn<L>& ray : rays_) {
            ray.t_max = t_max;
        }
    }

  private:
    CAROM_KERNEL static RayIn<L> turned(const RayIn<L>& ray, unsigned first) {
        return {in_order(ray.origin, first), in_order(ray.direction, first), ray.t_min, ray.t_max};
    }

    RayIn<L> rays_[3];
};
