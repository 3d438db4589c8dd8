// Camera samples on their way to an integrator that takes many at a time, and back to their pixels.
#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include "render/camera/camera_batch.h"
#include "render/frame/pixel_sums.h"
#include "render/integrator/integrator.h"

namespace carom::render {

/// Of one thread. Samples are added to their pixel's sums in the order in which they were asked
/// for.
class SampleQueue {
  public:
    /// Everything is borrowed.
    struct Setting {
        const Integrator& integrator;
        const ThinLensCamera& camera;
        CameraFixings fixings;
        float pixel_spread;
        std::size_t traced_at_once;  // samples between two looks whether to stop
        bool counts_objects;         // that samples have met
    };
    SampleQueue(const Setting& setting, std::stop_token stop, RenderStatistics& count);

    /// `sums` stays where it is until `flush`; `group`: of the pixel's sums, or -1.
    void ask(const SampleStream& stream, const SampleIndex& index, PixelSums& sums, int group = -1);

    /// Until all are done, or at once if a stop is requested: then sums are incomplete.
    void flush();

  private:
    /// How many samples wait at most. Camera rays are made for all of them together, even if the
    /// integrator takes one at a time: a vector of lanes costs the same for one ray as for all.
    static constexpr std::size_t kSize = CameraBatch::kMost;

    /// Whether all of `results_` was filled before a stop was requested.
    [[nodiscard]] bool trace();

    struct Pixel {
        PixelSums* sums;
        int group;
    };

    Setting setting_;
    std::stop_token stop_;
    RenderStatistics& count_;
    std::unique_ptr<Integrator::Workspace> workspace_;
    std::unique_ptr<CameraBatch> batch_;
    std::vector<CameraTask> tasks_;
    std::vector<Pixel> pixels_;
    std::vector<RadianceSample> results_;
};

}  // namespace carom::render
