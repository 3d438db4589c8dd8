#include "render/denoise/denoise_kernels.h"

#include <utility>

#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)  // bring nothing here
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/denoise/denoise_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "render/lanes/kernels-inl.h"

#define CAROM_KERNELS "render/denoise/kernels/all.h"
#include "render/lanes/include_vector-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

static_assert(sizeof(Lanes::Value) <= kChunk * sizeof(float));

/// Calls `kKernel` for all pixels of a row.
template <class Row, void (*kKernel)(const Row&, int)>
HWY_ATTR void in_row(const Row& row) {
    for (int x = 0; x < row.chunks * kChunk; x += Lanes::count()) {
        kKernel(row, x);
    }
}

inline HWY_ATTR void box_mean(const BoxRow& row) {
    for (int x = -kChunk; x < (row.chunks + 1) * kChunk; x += Lanes::count()) {
        sum_columns<Lanes>(row, x);
    }
    in_row<BoxRow, mean_of_sums<Lanes>>(row);
}

inline HWY_ATTR bool is_constant(const float* first_neighbour) {
    constexpr int kCount = kChunk + 2 * kWindow;
    const int last = kCount - Lanes::count();
    auto equal = repeats_first<Lanes>(first_neighbour, last);
    for (int at = 0; at < last; at += Lanes::count()) {
        equal = Lanes::both(equal, repeats_first<Lanes>(first_neighbour, at));
    }
    return Lanes::none(Lanes::opposite(equal));
}

template <int kFeatures>
HWY_ATTR void in_chunk(const RegressionChunk& chunk) {
    for (int lane = 0; lane < kChunk; lane += Lanes::count()) {
        regress<Lanes, kFeatures>(chunk, lane);
    }
}

inline const DenoiseKernels& denoise_kernels_of_target() {
    static constexpr DenoiseKernels kKernels = {
        in_row<SquareRow, square<Lanes>>,
        box_mean,
        in_row<VarianceRow, join_variance<Lanes>>,
        in_row<NoiseRow, judge_noise<Lanes>>,
        is_constant,
        in_row<DistanceRow, measure_distances<Lanes>>,
        in_row<WeightRow, weigh<Lanes>>,
        {in_chunk<0>, in_chunk<3>, in_chunk<6>, in_chunk<9>},
        in_row<ErrorRow, estimate_errors<Lanes>>,
        in_row<LimitRow, limit<Lanes>>};
    return kKernels;
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace carom::render {

HWY_EXPORT(denoise_kernels_of_target);

const DenoiseKernels& best_denoise_kernels() {
    return HWY_DYNAMIC_DISPATCH(denoise_kernels_of_target)();
}

}  // namespace carom::render

#endif
