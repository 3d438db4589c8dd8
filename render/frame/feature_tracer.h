// What the camera sees of a pixel, as a mean over many rays that end at their first hits.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "render/camera/camera_batch.h"
#include "render/frame/pixel_features.h"
#include "render/integrator/integrator.h"
#include "render/integrator/workspace_pool.h"

namespace carom::render {

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

/// Traces rays for pixels whose halves of samples saw different things there or within two pixels:
/// 4, then 16 if these saw different things too, and 64 (32 for less than 8 samples,
/// 128 from 32 samples on) if very different ones. Lights count that were seen within two pixels.
/// Immutable; any thread may call.
class FeatureTracer {
  public:
    /// The most pixels on a side of what is traced at once.
    static constexpr int kMostSide = 16;

    /// Everything is borrowed. `samples`: that pixels have or will have; the more, the more exact
    /// the features must be. `seed`: of the frame.
    FeatureTracer(const Integrator& integrator, WorkspacePool& workspaces,
                  const ThinLensCamera& camera, const CameraFixings& fixings, float pixel_spread,
                  int samples, std::uint64_t seed);

    /// Sets `traced` of all pixels, which are those of a rectangle, from the top left.
    void trace(std::span<FeaturePixel> pixels) const;

  private:
    struct Sums;
    class Queue;
    struct Round {
        int rays = 0;          // that pixels have after it
        float negligible = 0;  // range of features up to which it is needless
    };

    const Integrator& integrator_;
    WorkspacePool& workspaces_;
    const ThinLensCamera& camera_;
    CameraFixings fixings_;
    float pixel_spread_;
    std::array<Round, 3> rounds_{};
    std::uint64_t seed_;
};

}  // namespace carom::render
