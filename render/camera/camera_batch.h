// Camera rays of many samples at once, in vector lanes.
#pragma once

#include <algorithm>
#include <cstdint>

#include "render/camera/thin_lens_camera.h"

namespace carom::render {

/// Which sample of which pixel, for messages.
struct SampleIndex {
    int x = 0, y = 0, sample = 0;
};

/// Samples and their rays as a structure of arrays; vector code may access elements beyond the
/// last.
struct CameraBatch {
    static constexpr int kMost = 512;
    static constexpr int kStorage = kMost + 16;

    int count = 0;
    // Identity of a sample: its pixel and number, and the state of its random numbers (sampler.h).
    alignas(64) std::int32_t x[kStorage] = {};
    alignas(64) std::int32_t y[kStorage] = {};
    alignas(64) std::int32_t sample[kStorage] = {};
    alignas(64) std::int32_t pixel_hash[kStorage] = {};
    alignas(64) std::int32_t reversed_sample[kStorage] = {};
    // The sample's ray.
    alignas(64) float origin[3][kStorage] = {};
    alignas(64) float direction[3][kStorage] = {};
    alignas(64) float time[kStorage] = {};

    /// Appends a sample without its ray.
    void add(const SampleStream& stream, const SampleIndex& index) {
        x[count] = index.x;
        y[count] = index.y;
        sample[count] = index.sample;
        pixel_hash[count] = static_cast<std::int32_t>(stream.pixel_hash());
        reversed_sample[count] = static_cast<std::int32_t>(stream.reversed_sample());
        count += 1;
    }
    [[nodiscard]] SampleIndex index(int i) const { return {x[i], y[i], sample[i]}; }
    [[nodiscard]] SampleStream stream(int i) const {
        return SampleStream::of_state(static_cast<std::uint32_t>(pixel_hash[i]),
                                      static_cast<std::uint32_t>(reversed_sample[i]));
    }
    [[nodiscard]] Ray ray(int i) const {
        return {V3f(origin[0][i], origin[1][i], origin[2][i]),
                V3f(direction[0][i], direction[1][i], direction[2][i]),
                0,
                kInfinity,
                time[i],
                RayKind::primary};
    }
};

/// Some samples of a batch, one after the other. Borrowed.
struct CameraRun {
    const CameraBatch* batch = nullptr;
    int first = 0;
    int count = 0;

    [[nodiscard]] static CameraRun all(const CameraBatch& batch) {
        return {&batch, 0, batch.count};
    }
    /// At most `most` of them from number `from` on.
    [[nodiscard]] CameraRun part(int from, int most) const {
        return {batch, first + from, std::min(most, count - from)};
    }
    [[nodiscard]] SampleIndex index(int i) const { return batch->index(first + i); }
    [[nodiscard]] SampleStream stream(int i) const { return batch->stream(first + i); }
    [[nodiscard]] Ray ray(int i) const { return batch->ray(first + i); }
};

/// The effects that are switched off.
struct CameraFixings {
    bool centred = false;        // every ray passes through its pixel's centre
    bool instantaneous = false;  // every ray is in the middle of the shutter
};

/// Computes ThinLensCamera::ray for each sample.
void make_rays(const ThinLensCamera& camera, const CameraFixings& fixings, CameraBatch& batch);

}  // namespace carom::render
