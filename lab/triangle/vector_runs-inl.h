// The common part of vector runs. Included once per instruction set, after kernels-inl.h.
#if defined(CAROM_TRIANGLE_VECTOR_RUNS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_TRIANGLE_VECTOR_RUNS_INL_H
#undef CAROM_TRIANGLE_VECTOR_RUNS_INL_H
#else
#define CAROM_TRIANGLE_VECTOR_RUNS_INL_H
#endif

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "lab/triangle/kernel_run.h"
#include "lab/triangle/kernels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::triangle::HWY_NAMESPACE {

#define CAROM_KERNEL HWY_INLINE
#include "lab/triangle/kernels/forms.h"
#undef CAROM_KERNEL

template <class Input>
using NumberIndices =
    std::make_index_sequence<std::tuple_size_v<decltype(Input::numbers(std::declval<Input&>()))>>;

/// The rays of a set by group, then by coordinate: x, y, z of the origins, x, y, z of the
/// directions.
template <class T>
class RayNumbers {
  public:
    explicit RayNumbers(const TestSet& set)
        : stride_(static_cast<std::size_t>(set.rays_in_group)), numbers_(6 * set.origins.size()) {
        for (std::size_t i = 0; i < set.origins.size(); ++i) {
            T* to = &numbers_[i / stride_ * 6 * stride_ + i % stride_];
            for (int axis = 0; axis < 3; ++axis) {
                to[static_cast<std::size_t>(axis) * stride_] = set.origins[i][axis];
                to[static_cast<std::size_t>(axis + 3) * stride_] = set.directions[i][axis];
            }
        }
    }

    [[nodiscard]] const T* of_group(std::size_t group) const {
        return &numbers_[group * 6 * stride_];
    }
    [[nodiscard]] std::size_t stride() const { return stride_; }

  private:
    std::size_t stride_;
    std::vector<T> numbers_;
};

/// A run of this class template; `count`: 4 or 8.
template <template <class, Input, Division, class, int> class Run>
std::unique_ptr<KernelRun> make_vector_run(const Form& form, Precision precision, int count,
                                           const TestSet& set) {
    const bool is_single = precision == Precision::single_precision;
    if (is_single && count == 4) {
        return make_in_form<Run, float, 4>(form, set);
    }
    if (is_single) {
        return make_in_form<Run, float, 8>(form, set);
    }
    if (count == 4) {
        return make_in_form<Run, double, 4>(form, set);
    }
    return make_in_form<Run, double, 8>(form, set);
}

}  // namespace carom::render::triangle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
