#include "lab/triangle/run_factories.h"

// The targets between gain nothing; those above AVX2 are not used anywhere.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lab/triangle/rays_runs.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "lab/triangle/vector_runs-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::triangle::HWY_NAMESPACE {

template <class L, class From, class To, std::size_t... kIndices>
HWY_INLINE void broadcast_numbers(From from, To to, std::index_sequence<kIndices...>) {
    ((std::get<kIndices>(to) = L::all(std::get<kIndices>(from))), ...);
}

/// The record of one triangle in all lanes.
template <class Kernel, class L, class T>
HWY_INLINE typename Kernel::template Record<L> broadcast(
    const typename Kernel::template Record<ScalarLanes<T>>& record) {
    using From = typename Kernel::template Record<ScalarLanes<T>>;
    using To = typename Kernel::template Record<L>;
    To result;
    broadcast_numbers<L>(From::numbers(record), To::numbers(result), NumberIndices<From>());
    if constexpr (From::kHasAxis) {
        result.axis = record.axis;
    }
    return result;
}

/// kCount rays against one triangle after another.
template <class Kernel, Input kInput, Division kDivision, class T, int kCount>
class RaysRun final : public KernelRun {
    using D = hn::CappedTag<T, kCount>;
    using L = RaysInLanes<D>;
    using V = hn::Vec<D>;
    using Triangle = InputOf<Kernel, kInput, ScalarLanes<T>>;
    static constexpr int kLanes = static_cast<int>(hn::MaxLanes(D()));
    static constexpr int kVectors = kCount / kLanes;

  public:
    explicit RaysRun(const TestSet& set)
        : rays_in_group_(set.rays_in_group),
          triangles_in_group_(set.triangles_in_group),
          rays_(set) {
        for (const TriangleCorners& triangle : set.triangles) {
            triangles_.push_back(make_input<Kernel, kInput, T>(triangle));
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
            const T* rays = rays_.of_group(group);
            for (int i = 0; i < rays_in_group_; i += kCount) {
                const std::size_t first =
                    group * static_cast<unsigned>(rays_in_group_) + static_cast<unsigned>(i);
                intersect_all(rays + i, triangles, first);
            }
        }
    }

    [[nodiscard]] Packing packing() const override {
        return kCount == 4 ? Packing::four_rays : Packing::eight_rays;
    }

    [[nodiscard]] std::vector<NearestHit> hits() const override {
        std::vector<NearestHit> hits;
        for (std::size_t i = 0; i < t_.size(); ++i) {
            hits.push_back({static_cast<double>(t_[i]), static_cast<double>(u_[i]),
                            static_cast<double>(v_[i]), static_cast<std::int64_t>(triangle_[i])});
        }
        return hits;
    }

  private:
    void intersect_all(const T* numbers, const Triangle* triangles, std::size_t first) {
        const D d;
        RayIn<L> ray[kVectors];
        V u[kVectors];
        V v[kVectors];
        V triangle[kVectors];
        for (int k = 0; k < kVectors; ++k) {
            const T* from = numbers + k * kLanes;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                ray[k].origin.at[axis] = hn::LoadU(d, from + axis * rays_.stride());
                ray[k].direction.at[axis] = hn::LoadU(d, from + (axis + 3) * rays_.stride());
            }
            ray[k].t_min = hn::Zero(d);
            ray[k].t_max = hn::Set(d, T(kInfinity));
            u[k] = hn::Zero(d);
            v[k] = hn::Zero(d);
            triangle[k] = hn::Set(d, T(-1));
        }
        for (int i = 0; i < triangles_in_group_; ++i) {
            const auto record =
                broadcast<Kernel, L, T>(record_of<Kernel, ScalarLanes<T>>(triangles[i]));
            for (int k = 0; k < kVectors; ++k) {
                const auto hit = Kernel::template intersect<kDivision>(ray[k], record);
                if (!L::none(hit.valid)) {
                    ray[k].t_max = hn::IfThenElse(hit.valid, hit.t, ray[k].t_max);
                    u[k] = hn::IfThenElse(hit.valid, hit.u, u[k]);
                    v[k] = hn::IfThenElse(hit.valid, hit.v, v[k]);
                    triangle[k] =
                        hn::IfThenElse(hit.valid, hn::Set(d, static_cast<T>(i)), triangle[k]);
                }
            }
        }
        for (int k = 0; k < kVectors; ++k) {
            const std::size_t to = first + static_cast<unsigned>(k * kLanes);
            hn::StoreU(ray[k].t_max, d, &t_[to]);
            hn::StoreU(u[k], d, &u_[to]);
            hn::StoreU(v[k], d, &v_[to]);
            hn::StoreU(triangle[k], d, &triangle_[to]);
        }
    }

    int rays_in_group_;
    int triangles_in_group_;
    RayNumbers<T> rays_;
    std::vector<Triangle> triangles_;
    std::vector<T> t_, u_, v_, triangle_;
};

inline std::unique_ptr<KernelRun> make_rays_run_of_target(const Form& form, Precision precision,
                                                          int count, const TestSet& set) {
    return make_vector_run<RaysRun>(form, precision, count, set);
}

}  // namespace carom::render::triangle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace carom::render::triangle {

HWY_EXPORT(make_rays_run_of_target);

std::unique_ptr<KernelRun> make_rays_run(const Form& form, Precision precision, int count,
                                         const TestSet& set) {
    return HWY_DYNAMIC_DISPATCH(make_rays_run_of_target)(form, precision, count, set);
}

}  // namespace carom::render::triangle

#endif
