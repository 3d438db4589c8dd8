// One ray after another against several triangles. Included once per instruction set, after
// <hwy/highway.h>.
#if defined(CAROM_TRIANGLE_TRIANGLES_RUN_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_TRIANGLE_TRIANGLES_RUN_INL_H
#undef CAROM_TRIANGLE_TRIANGLES_RUN_INL_H
#else
#define CAROM_TRIANGLE_TRIANGLES_RUN_INL_H
#endif

#include <bit>

#include "lab/triangle/number_loads-inl.h"
#include "lab/triangle/one_by_one.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::triangle::HWY_NAMESPACE {

template <class D, class Numbers, class Table, std::size_t... kIndices>
HWY_INLINE void load_numbers(Numbers numbers, const Table& table, std::size_t item,
                             std::index_sequence<kIndices...>) {
    ((std::get<kIndices>(numbers) = load<D>(table, item, kIndices)), ...);
}

template <Variant kVariant>
class TrianglesRun final
    : public OneByOne<TrianglesRun<kVariant>, kVariant, NumberOf<kVariant.precision>> {
    using T = NumberOf<kVariant.precision>;
    using Base = OneByOne<TrianglesRun, kVariant, T>;
    using Best = typename Base::Best;
    static constexpr Form kForm = kVariant.form;
    static constexpr Technique kTechnique = kVariant.technique;
    static constexpr int kCount = kVariant.packing == Packing::four_triangles ? 4 : 8;
    using Kernel = KernelOf<kForm.kernel>;
    using D = hn::CappedTag<T, kCount>;
    using L = LanesOf<kTechnique, TrianglesInLanes<D>>;
    using One = ScalarLanes<T, AxisChoiceOf<kTechnique>>;
    using Single = InputOf<Kernel, kForm.input, One>;
    using Several = InputOf<Kernel, kForm.input, L>;
    using Indices = NumberIndices<Single>;
    static constexpr bool kStoresAxis = Single::kHasAxis && kTechnique != Technique::axis_fixed;
    static constexpr std::size_t kAxis = Indices::size();  // behind the numbers
    using Table = NumberTable<T, Indices::size() + (kStoresAxis ? 1 : 0), kCount, kTechnique>;
    static constexpr int kLanes = static_cast<int>(hn::MaxLanes(D()));

  public:
    explicit TrianglesRun(const TestSet& set)
        : Base(set),
          rays_(table_of_rays<T, 1, Technique::structures>(set)),
          triangles_(set.triangles.size()) {
        for (std::size_t i = 0; i < set.triangles.size(); ++i) {
            const Single triangle = make_input<Kernel, kForm.input, One>(set.triangles[i]);
            store_numbers(Single::numbers(triangle), triangles_, i, Indices());
            if constexpr (kStoresAxis) {
                *triangles_.place(i, kAxis) = static_cast<T>(triangle.axis.w);
            }
        }
    }

    [[nodiscard]] Best nearest(std::size_t ray_index, std::size_t first_triangle) const {
        const D d;
        RayIn<L> ray;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            ray.origin[axis] = hn::Set(d, *rays_.place(ray_index, axis));
            ray.direction[axis] = hn::Set(d, *rays_.place(ray_index, axis + 3));
        }
        ray.t_min = hn::Zero(d);
        ray.t_max = hn::Set(d, T(kInfinity));
        Best best;
        for (int i = 0; i < this->triangles_in_group(); i += kLanes) {
            const auto hit = Kernel::template intersect<kForm.division>(
                ray, record_of<Kernel, L>(load_triangles(first_triangle + unsigned(i))));
            if (L::none(hit.valid)) {
                continue;
            }
            if constexpr (kTechnique == Technique::any_hit) {
                best.triangle = i + static_cast<int>(hn::FindKnownFirstTrue(d, hit.valid));
                return best;
            }
            keep_nearest(hit, i, best);
            ray.t_max = hn::Set(d, best.t);
        }
        return best;
    }

  private:
    HWY_INLINE Several load_triangles(std::size_t item) const {
        Several triangles;
        load_numbers<D>(Several::numbers(triangles), triangles_, item, Indices());
        if constexpr (kStoresAxis) {
            triangles.axis = L::axis_of(load<D>(triangles_, item, kAxis));
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

    NumberTable<T, 6, 1, Technique::structures> rays_;
    Table triangles_;
};

}  // namespace carom::render::triangle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
