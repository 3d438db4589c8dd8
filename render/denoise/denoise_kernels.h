// The vector code of the denoiser. Each function works on whole chunks of pixels in a row; lanes
// run over pixels, so that a pixel's bits do not depend on the vector width. Internal to this
// folder.
#pragma once

#include "render/denoise/kernel_rows.h"

namespace carom::render {

struct DenoiseKernels {
    void (*square)(const SquareRow& row);
    void (*box_mean)(const BoxRow& row);
    void (*join_variance)(const VarianceRow& row);
    void (*judge_noise)(const NoiseRow& row);
    /// Whether a chunk and its neighbours in the row have one value.
    bool (*is_constant)(const float* first_neighbour);
    void (*measure_distances)(const DistanceRow& row);
    void (*weigh)(const WeightRow& row);
    /// By the number of features in threes.
    void (*regress[kMostRegressors / 3 + 1])(const RegressionChunk& chunk);
    void (*estimate_errors)(const ErrorRow& row);
    void (*limit)(const LimitRow& row);
};

/// The kernels of the best instruction set of this processor.
[[nodiscard]] const DenoiseKernels& best_denoise_kernels();

}  // namespace carom::render
