// What the camera sees of a pixel, as a mean over many rays that end at their first hits.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/camera/camera_batch.h"
#include "render/integrator/integrator.h"
#include "render/integrator/workspace_pool.h"

namespace carom::render {

/// Means over a pixel of what its camera rays see at their first hits and, if these have a coat, of
/// what is seen in it.
struct PixelFeatures {
    V3f albedo{0, 0, 0};  // and the mirrored albedo, as the coat reflects it
    V3f normal{0, 0, 0};
    V3f light{0, 0, 0};  // radiance of lights and the room, seen directly or in a smooth coat

    static constexpr int kCount = 9;
    [[nodiscard]] float operator[](int i) const {
        return i < 3 ? albedo[i] : i < 6 ? normal[i - 3] : light[i - 6];
    }
    void add(const RadianceSample& sample) {
        albedo += sample.albedo + sample.mirrored;
        normal += sample.normal;
        light += sample.light;
    }
    PixelFeatures& operator+=(const PixelFeatures& other) {
        albedo += other.albedo;
        normal += other.normal;
        light += other.light;
        return *this;
    }
    [[nodiscard]] PixelFeatures operator*(float factor) const {
        return {albedo * factor, normal * factor, light * factor};
    }
};

/// Sums over camera rays of a pixel.
struct TracedFeatures {
    PixelFeatures sum{};
    int rays = 0;

    /// The mean over these rays and `samples` samples of the pixel, whose halves have the means
    /// `halves`.
    [[nodiscard]] PixelFeatures with_samples(const PixelFeatures (&halves)[2], int samples) const;
    /// The weight of the samples in it, [0, 1].
    [[nodiscard]] float share_of_samples(int samples) const;
};

/// A pixel whose features are wanted.
struct FeaturePixel {
    int x = 0, y = 0;
    PixelFeatures halves[2];  // means over its two halves of samples
    TracedFeatures traced{};  // result
};

/// Traces 4 rays for each pixel, 16 if these or the samples saw different things there or within
/// two pixels, and 64 if they saw very different ones. Immutable; any thread may call.
class FeatureTracer {
  public:
    /// Everything is borrowed. `seed`: of the frame.
    FeatureTracer(const Integrator& integrator, WorkspacePool& workspaces,
                  const ThinLensCamera& camera, const CameraFixings& fixings, float pixel_spread,
                  std::uint64_t seed);

    /// Sets `traced` of all pixels, which lie in a rectangle and are neighbours of each other.
    void trace(std::span<FeaturePixel> pixels) const;

  private:
    struct Sums;
    class Queue;

    const Integrator& integrator_;
    WorkspacePool& workspaces_;
    const ThinLensCamera& camera_;
    CameraFixings fixings_;
    float pixel_spread_;
    std::uint64_t seed_;
};

}  // namespace carom::render
