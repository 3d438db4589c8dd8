// Several rays against one triangle after another. Included once per instruction set, after
// <hwy/highway.h>.
#if defined(CAROM_TRIANGLE_RAYS_RUN_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_TRIANGLE_RAYS_RUN_INL_H
#undef CAROM_TRIANGLE_RAYS_RUN_INL_H
#else
#define CAROM_TRIANGLE_RAYS_RUN_INL_H
#endif

#include <algorithm>
#include <vector>

#include "lab/triangle/kernel_run.h"
#include "lab/triangle/number_loads-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::triangle::HWY_NAMESPACE {

template <class L, class From, class To, std::size_t... kIndices>
HWY_INLINE void broadcast_numbers(From from, To to, std::index_sequence<kIndices...>) {
    ((std::get<kIndices>(to) = L::all(std::get<kIndices>(from))), ...);
}

/// The record of one triangle in all lanes.
template <class L, class To, class From>
HWY_INLINE To broadcast(const From& record) {
    To result;
    broadcast_numbers<L>(From::numbers(record), To::numbers(result), NumberIndices<From>());
    if constexpr (From::kHasAxis) {
        result.axis = record.axis;
    }
    return result;
}

template <Variant kVariant>
class RaysRun final : public KernelRun {
    static constexpr Form kForm = kVariant.form;
    static constexpr Technique kTechnique = kVariant.technique;
    static constexpr int kCount = kVariant.packing == Packing::four_rays ? 4 : 8;
    using T = NumberOf<kVariant.precision>;
    using Kernel = KernelOf<kForm.kernel>;
    using D = hn::CappedTag<T, kCount>;
    using L = LanesOf<kTechnique, RaysInLanes<D>>;
    using V = hn::Vec<D>;
    using One = ScalarLanes<T, AxisChoiceOf<kTechnique>>;
    using Triangle = StoredTriangle<kTechnique, InputOf<Kernel, kForm.input, One>>;
    using Ray = TestedRay<kTechnique, L>;
    static constexpr int kLanes = static_cast<int>(hn::MaxLanes(D()));
    static constexpr int kVectors = kCount / kLanes;
    static constexpr bool kEndsAtAnyHit = kTechnique == Technique::any_hit;

  public:
    explicit RaysRun(const TestSet& set)
        : rays_in_group_(set.rays_in_group),
          triangles_in_group_(set.triangles_in_group),
          rays_(table_of_rays<T, kCount, kTechnique>(set)) {
        for (const TriangleCorners& triangle : set.triangles) {
            triangles_.push_back(stored_triangle<Kernel, kForm.input, kTechnique, One>(triangle));
        }
        for (std::vector<T>* numbers : {&t_, &u_, &v_, &triangle_}) {
            numbers->resize(set.origins.size());
        }
    }

    void run() override {
        const std::size_t groups = triangles_.size() / static_cast<unsigned>(triangles_in_group_);
        for (std::size_t group = 0; group < groups; ++group) {
            const Triangle* triangles =
                &triangles_[group * static_cast<unsigned>(triangles_in_group_)];
            const std::size_t first = group * static_cast<unsigned>(rays_in_group_);
            if constexpr (shares_rays(kTechnique)) {
                intersect_group(first, triangles);
            } else {
                for (int i = 0; i < rays_in_group_; i += kCount) {
                    intersect_all(first + static_cast<unsigned>(i), triangles);
                }
            }
        }
    }

    [[nodiscard]] Packing packing() const override { return kVariant.packing; }

    [[nodiscard]] std::vector<NearestHit> hits() const override {
        std::vector<NearestHit> hits;
        for (std::size_t i = 0; i < t_.size(); ++i) {
            hits.push_back({static_cast<double>(t_[i]), static_cast<double>(u_[i]),
                            static_cast<double>(v_[i]), static_cast<std::int64_t>(triangle_[i])});
        }
        return hits;
    }

  private:
    HWY_INLINE Ray load_ray(std::size_t item) const {
        const D d;
        RayIn<L> ray;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            ray.origin[axis] = load<D>(rays_, item, axis);
            ray.direction[axis] = load<D>(rays_, item, axis + 3);
        }
        ray.t_min = hn::Zero(d);
        ray.t_max = hn::Set(d, T(kInfinity));
        return Ray(ray);
    }

    template <std::size_t... kIndices>
    HWY_INLINE std::array<Ray, sizeof...(kIndices)> load_rays(
        std::size_t first, std::index_sequence<kIndices...>) const {
        return {load_ray(first + kIndices * kLanes)...};
    }

    void intersect_group(std::size_t first, const Triangle* triangles) {
        const D d;
        const auto count = static_cast<unsigned>(rays_in_group_);
        std::fill_n(&t_[first], count, T(kInfinity));
        std::fill_n(&u_[first], count, T(0));
        std::fill_n(&v_[first], count, T(0));
        std::fill_n(&triangle_[first], count, T(-1));
        constexpr bool kOneOrigin = kTechnique == Technique::common_origin;
        // Not in a loop: g++ would copy these numbers through memory, half a vector at a time.
        const auto common_number = [&](std::size_t axis) HWY_ATTR {
            return hn::Set(d, *rays_.place(first, axis + (kOneOrigin ? 0 : 3)));
        };
        const Vec3<V> common{common_number(0), common_number(1), common_number(2)};
        for (int i = 0; i < triangles_in_group_; ++i) {
            const auto record = broadcast<L, typename Kernel::template Record<L>>(
                record_of<Kernel, One>(triangles[i].input));
            for (std::size_t at = first; at < first + count; at += kLanes) {
                const auto own_number = [&](std::size_t axis) HWY_ATTR {
                    return load<D>(rays_, at, axis + (kOneOrigin ? 3 : 0));
                };
                const Vec3<V> own{own_number(0), own_number(1), own_number(2)};
                const RayIn<L> ray{kOneOrigin ? common : own, kOneOrigin ? own : common,
                                   hn::Zero(d), hn::LoadU(d, &t_[at])};
                const auto hit = Kernel::template intersect<kForm.division>(ray, record);
                if (!L::none(hit.valid)) {
                    const auto keep = [&](V number, std::vector<T>& numbers) HWY_ATTR {
                        hn::StoreU(hn::IfThenElse(hit.valid, number, hn::LoadU(d, &numbers[at])), d,
                                   &numbers[at]);
                    };
                    keep(hit.t, t_);
                    keep(hit.u, u_);
                    keep(hit.v, v_);
                    keep(hn::Set(d, static_cast<T>(i)), triangle_);
                }
            }
        }
    }

    void intersect_all(std::size_t first, const Triangle* triangles) {
        const D d;
        auto rays = load_rays(first, std::make_index_sequence<kVectors>());
        V u[kVectors];
        V v[kVectors];
        V triangle[kVectors];
        for (int k = 0; k < kVectors; ++k) {
            u[k] = hn::Zero(d);
            v[k] = hn::Zero(d);
            triangle[k] = hn::Set(d, T(-1));
        }
        for (int i = 0; i < triangles_in_group_; ++i) {
            const auto record = broadcast<L, typename Kernel::template Record<L>>(
                record_of<Kernel, One>(triangles[i].input));
            int open = 0;  // vectors with rays that go on
            for (int k = 0; k < kVectors; ++k) {
                Ray& ray = rays[static_cast<std::size_t>(k)];
                const auto hit =
                    ray.template test<Kernel, kForm.division>(record, triangles[i].first);
                if (!L::none(hit.valid)) {
                    triangle[k] =
                        hn::IfThenElse(hit.valid, hn::Set(d, static_cast<T>(i)), triangle[k]);
                    const auto end = kEndsAtAnyHit ? hn::Set(d, T(-1)) : hit.t;
                    ray.set_t_max(hn::IfThenElse(hit.valid, end, ray.t_max()));
                    if constexpr (!kEndsAtAnyHit) {
                        u[k] = hn::IfThenElse(hit.valid, hit.u, u[k]);
                        v[k] = hn::IfThenElse(hit.valid, hit.v, v[k]);
                    }
                }
                open += kEndsAtAnyHit && hn::AllTrue(d, hn::Lt(ray.t_max(), hn::Zero(d))) ? 0 : 1;
            }
            if (open == 0) {
                break;
            }
        }
        for (int k = 0; k < kVectors; ++k) {
            const std::size_t to = first + static_cast<unsigned>(k * kLanes);
            hn::StoreU(kEndsAtAnyHit ? hn::Set(d, T(kInfinity))
                                     : rays[static_cast<std::size_t>(k)].t_max(),
                       d, &t_[to]);
            hn::StoreU(u[k], d, &u_[to]);
            hn::StoreU(v[k], d, &v_[to]);
            hn::StoreU(triangle[k], d, &triangle_[to]);
        }
    }

    int rays_in_group_;
    int triangles_in_group_;
    NumberTable<T, 6, kCount, kTechnique> rays_;
    std::vector<Triangle> triangles_;
    std::vector<T> t_, u_, v_, triangle_;
};

}  // namespace carom::render::triangle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
