#include "lab/triangle/run_factories.h"

// See rays_runs.cpp.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lab/triangle/triangles_runs.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <bit>

#include <hwy/highway.h>

#include "lab/triangle/vector_runs-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::triangle::HWY_NAMESPACE {

/// kCount triangles, number by number; the last row is for axes.
template <class T, int kNumbers, int kCount>
struct alignas(64) TriangleNumbers {
    T number[kNumbers + 1][kCount];
};

template <class Numbers, class Block, std::size_t... kIndices>
void store_numbers(Numbers numbers, Block& block, int lane, std::index_sequence<kIndices...>) {
    ((block.number[kIndices][lane] = std::get<kIndices>(numbers)), ...);
}

template <class D, class Numbers, class Block, std::size_t... kIndices>
HWY_INLINE void load_numbers(Numbers numbers, const Block& block, int lane,
                             std::index_sequence<kIndices...>) {
    ((std::get<kIndices>(numbers) = hn::Load(D(), block.number[kIndices] + lane)), ...);
}

/// One ray after another against kCount triangles.
template <class Kernel, Input kInput, Division kDivision, class T, int kCount>
class TrianglesRun final : public KernelRun {
    using D = hn::CappedTag<T, kCount>;
    using L = TrianglesInLanes<D>;
    using V = hn::Vec<D>;
    using Single = InputOf<Kernel, kInput, ScalarLanes<T>>;
    using Several = InputOf<Kernel, kInput, L>;
    using Indices = NumberIndices<Single>;
    static constexpr int kNumbers = static_cast<int>(Indices::size());
    using Block = TriangleNumbers<T, kNumbers, kCount>;
    static constexpr int kLanes = static_cast<int>(hn::MaxLanes(D()));

  public:
    explicit TrianglesRun(const TestSet& set)
        : rays_in_group_(set.rays_in_group),
          blocks_in_group_(set.triangles_in_group / kCount),
          rays_(set),
          blocks_(set.triangles.size() / kCount),
          hits_(set.origins.size()) {
        for (std::size_t i = 0; i < set.triangles.size(); ++i) {
            const Single triangle = make_input<Kernel, kInput, T>(set.triangles[i]);
            Block& block = blocks_[i / kCount];
            const int lane = static_cast<int>(i % kCount);
            store_numbers(Single::numbers(triangle), block, lane, Indices());
            if constexpr (Single::kHasAxis) {
                block.number[kNumbers][lane] = static_cast<T>(triangle.axis.w);
            }
        }
    }

    void run() override {
        const std::size_t groups = blocks_.size() / static_cast<unsigned>(blocks_in_group_);
        for (std::size_t group = 0; group < groups; ++group) {
            const Block* blocks = &blocks_[group * static_cast<unsigned>(blocks_in_group_)];
            for (int i = 0; i < rays_in_group_; ++i) {
                hits_[group * static_cast<unsigned>(rays_in_group_) + static_cast<unsigned>(i)] =
                    nearest(rays_.of_group(group) + i, blocks);
            }
        }
    }

    [[nodiscard]] Packing packing() const override {
        return kCount == 4 ? Packing::four_triangles : Packing::eight_triangles;
    }

    [[nodiscard]] std::vector<NearestHit> hits() const override {
        std::vector<NearestHit> hits;
        for (const Best& best : hits_) {
            hits.push_back({static_cast<double>(best.t), static_cast<double>(best.u),
                            static_cast<double>(best.v), best.triangle});
        }
        return hits;
    }

  private:
    struct Best {
        T t = T(kInfinity);
        T u = 0, v = 0;
        std::int32_t triangle = -1;
    };

    Best nearest(const T* numbers, const Block* blocks) const {
        const D d;
        const std::size_t stride = rays_.stride();
        RayIn<L> ray;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            ray.origin.at[axis] = hn::Set(d, numbers[axis * stride]);
            ray.direction.at[axis] = hn::Set(d, numbers[(axis + 3) * stride]);
        }
        ray.t_min = hn::Zero(d);
        ray.t_max = hn::Set(d, T(kInfinity));
        Best best;
        for (int i = 0; i < blocks_in_group_; ++i) {
            for (int lane = 0; lane < kCount; lane += kLanes) {
                const auto hit = Kernel::template intersect<kDivision>(
                    ray, record_of<Kernel, L>(load(blocks[i], lane)));
                if (!L::none(hit.valid)) {
                    keep_nearest(hit, i * kCount + lane, best);
                    ray.t_max = hn::Set(d, best.t);
                }
            }
        }
        return best;
    }

    static HWY_INLINE Several load(const Block& block, int lane) {
        Several triangles;
        load_numbers<D>(Several::numbers(triangles), block, lane, Indices());
        if constexpr (Several::kHasAxis) {
            triangles.axis = L::axis_of(hn::Load(D(), block.number[kNumbers] + lane));
        }
        return triangles;
    }

    static HWY_INLINE void keep_nearest(const HitIn<L>& hit, int first, Best& best) {
        const D d;
        alignas(64) T t[kLanes];
        alignas(64) T u[kLanes];
        alignas(64) T v[kLanes];
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d, hit.valid, bits);
        hn::Store(hit.t, d, t);
        hn::Store(hit.u, d, u);
        hn::Store(hit.v, d, v);
        for (unsigned left = bits[0]; left != 0; left &= left - 1) {
            const int k = std::countr_zero(left);
            if (t[k] < best.t) {
                best = {t[k], u[k], v[k], first + k};
            }
        }
    }

    int rays_in_group_;
    int blocks_in_group_;
    RayNumbers<T> rays_;
    std::vector<Block> blocks_;
    std::vector<Best> hits_;
};

inline std::unique_ptr<KernelRun> make_triangles_run_of_target(const Form& form,
                                                               Precision precision, int count,
                                                               const TestSet& set) {
    return make_vector_run<TrianglesRun>(form, precision, count, set);
}

}  // namespace carom::render::triangle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace carom::render::triangle {

HWY_EXPORT(make_triangles_run_of_target);

std::unique_ptr<KernelRun> make_triangles_run(const Form& form, Precision precision, int count,
                                              const TestSet& set) {
    return HWY_DYNAMIC_DISPATCH(make_triangles_run_of_target)(form, precision, count, set);
}

}  // namespace carom::render::triangle

#endif
