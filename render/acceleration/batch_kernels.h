// Intersection of many rays with a few analytic shapes, one ray per lane, for the best instruction
// set that the processor has.
#pragma once

#include <cstdint>
#include <span>

#include <Imath/ImathBox.h>

#include "render/acceleration/loop_shapes.h"
#include "render/acceleration/ray_batch.h"

namespace carom::render {

struct BatchKernels {
    /// The nearest hit of each ray before t[i], by the rules of AnalyticKernels::closest: replaces
    /// t and object where a hit exists.
    void (*closest)(const LoopBlocks& blocks, const RayBatch& rays, float* t, std::int32_t* object);
    /// Sets t[i] to 0 if ray i hits anything before it.
    void (*occlude)(const LoopBlocks& blocks, const RayBatch& rays, float* t);
    /// For each box a bit for each of at most 64 rays that may hit something in it at up to t[i]:
    /// every ray for which intersect_moving would go on, and a few more.
    void (*meet_boxes)(std::span<const Imath::Box3f> boxes, const RayBatch& rays, const float* t,
                       std::uint64_t* rays_of_box);
    /// The distances beyond 0 at which the rays with these numbers hit a moving shape, which is not
    /// a mesh; infinity for those that miss it. The numbers, of which there may be
    /// RayBatch::kBeyond more, are those of rays in the batch. The bits of intersect_moving.
    void (*hit_moving)(const MovingShape& shape, const RayBatch& rays, const std::int32_t* numbers,
                       int count, float* distances);
};

[[nodiscard]] const BatchKernels& best_batch_kernels();

}  // namespace carom::render
