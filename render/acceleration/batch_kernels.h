// Many rays against a few analytic shapes, a ray in every lane, for the best instruction set that
// the processor has.
#pragma once

#include "render/acceleration/block_lists.h"
#include "render/acceleration/ray_batch.h"

namespace carom::render {

struct BatchKernels {
    /// The nearest hit of each ray before t[i], as analytic_kernels.h's `closest`: t and object are
    /// replaced where there is one.
    void (*closest)(const AnalyticBlocks& blocks, const RayBatch& rays, float* t,
                    std::int32_t* object);
    /// Sets t[i] to 0 where ray i meets something before it.
    void (*block)(const AnalyticBlocks& blocks, const RayBatch& rays, float* t);
};

[[nodiscard]] const BatchKernels& best_batch_kernels();

}  // namespace carom::render
