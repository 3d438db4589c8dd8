// Intersection of rays with blocks of analytic shapes, vectorised for the best instruction set that
// the processor has, up to AVX2 (the bits of a picture must not depend on wider ones).
#pragma once

#include <cstdint>
#include <string_view>

#include "render/acceleration/block_lists.h"
#include "render/geometry/ray.h"

namespace carom::render {

/// The nearest hit found yet: `t` begins as the ray's t_max and `object` as kNoObject. A nearer hit
/// replaces it, or an equally near one of a lower object.
struct Candidate {
    float t = kInfinity;
    std::uint32_t object = kNoObject;

    void offer(float other_t, std::uint32_t other_object) {
        const bool is_tie = other_t == t && object != kNoObject && other_object < object;
        if (other_t < t || is_tie) {
            t = other_t;
            object = other_object;
        }
    }
};

/// Rays must be safe (safe_ray.h). The test of a single shape computes the same bits as that of all
/// shapes.
struct AnalyticKernels {
    void (*closest)(const AnalyticBlocks& blocks, const Ray& ray, Candidate& best);
    bool (*any)(const AnalyticBlocks& blocks, const Ray& ray);
    /// Whether the first hit of shape `index` in the list of the shape type `shape` (kLaneShape) is
    /// nearer than `t`; if so, replaces `t`.
    bool (*one)(const AnalyticBlocks& blocks, std::uint32_t shape, std::uint32_t index,
                const Ray& ray, float& t);

    std::string_view tier;  // "AVX2", "SSE4" ...
};

[[nodiscard]] const AnalyticKernels& best_kernels();

}  // namespace carom::render
