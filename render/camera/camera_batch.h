// Camera rays of many samples at once, in vector lanes.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "render/camera/thin_lens_camera.h"

namespace carom::render {

/// Which sample of which pixel, for messages.
struct SampleIndex {
    int x = 0, y = 0, sample = 0;
};

/// Samples and their rays as a structure of arrays; vector code may access elements beyond the
/// last.
struct CameraBatch {
    /// As many as processors' caches like.
    static constexpr int kUsual = 512;
    static constexpr int kBeyond = 16;

    /// With room for so many samples.
    explicit CameraBatch(int room = kUsual)
        : capacity(room),
          words_(5 * (static_cast<std::size_t>(room) + kBeyond)),
          numbers_(8 * (static_cast<std::size_t>(room) + kBeyond)) {
        const std::ptrdiff_t size = std::ptrdiff_t{room} + kBeyond;
        std::int32_t* word = words_.data();
        for (std::int32_t** array : {&x, &y, &sample, &pixel_hash, &reversed_sample}) {
            *array = std::exchange(word, word + size);
        }
        float* number = numbers_.data();
        for (float** array : {&origin[0], &origin[1], &origin[2], &direction[0], &direction[1],
                              &direction[2], &time, &weight}) {
            *array = std::exchange(number, number + size);
        }
    }
    CameraBatch(const CameraBatch&) = delete;
    CameraBatch& operator=(const CameraBatch&) = delete;
    CameraBatch(CameraBatch&&) noexcept = default;
    CameraBatch& operator=(CameraBatch&&) noexcept = default;
    ~CameraBatch() = default;

    int capacity;
    int count = 0;
    // Identity of a sample: its pixel and number, and the state of its random numbers (sampler.h).
    std::int32_t *x, *y, *sample, *pixel_hash, *reversed_sample;
    // The sample's ray.
    std::array<float*, 3> origin, direction;
    float* time;
    float* weight;  // of its light (ThinLensCamera::weight)

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

  private:
    std::vector<std::int32_t> words_;
    std::vector<float> numbers_;
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
