// Camera rays of many samples at once, in vector lanes.
#pragma once

#include <cstdint>

#include "render/camera/thin_lens_camera.h"

namespace carom::render {

/// Samples and their rays as a structure of arrays; vector code may access elements beyond the
/// last.
struct CameraBatch {
    static constexpr int kMost = 512;
    static constexpr int kStorage = kMost + 16;

    int count = 0;
    // Identity of a sample: its pixel, and the state of its random numbers (sampler.h).
    alignas(64) std::int32_t x[kStorage] = {};
    alignas(64) std::int32_t y[kStorage] = {};
    alignas(64) std::int32_t pixel_hash[kStorage] = {};
    alignas(64) std::int32_t reversed_sample[kStorage] = {};
    // The sample's ray.
    alignas(64) float origin[3][kStorage] = {};
    alignas(64) float direction[3][kStorage] = {};
    alignas(64) float time[kStorage] = {};

    [[nodiscard]] Ray ray(int i) const {
        return {V3f(origin[0][i], origin[1][i], origin[2][i]),
                V3f(direction[0][i], direction[1][i], direction[2][i]),
                0,
                kInfinity,
                time[i],
                RayKind::primary};
    }
};

/// The effects that are switched off.
struct CameraFixings {
    bool centred = false;        // every ray passes through its pixel's centre
    bool instantaneous = false;  // every ray is in the middle of the shutter
};

/// Computes ThinLensCamera::ray for each sample.
void make_rays(const ThinLensCamera& camera, const CameraFixings& fixings, CameraBatch& batch);

}  // namespace carom::render
