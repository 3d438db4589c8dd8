// Camera samples on their way to an integrator that takes many at a time, and back to their pixels.
#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include "render/frame/pixel_sums.h"
#include "render/integrator/integrator.h"

namespace carom::render {

/// Of one thread. Samples are added to their pixel's sums in the order in which they were asked
/// for.
class SampleQueue {
  public:
    /// `size`: how many wait at most. Everything is borrowed.
    SampleQueue(const Integrator& integrator, float pixel_spread, std::size_t size,
                bool counts_objects, std::stop_token stop, RenderStatistics& count);

    /// `sums` stays where it is until `flush`; `group`: of the pixel's sums, or -1.
    void ask(const CameraTask& task, PixelSums& sums, int group = -1);

    /// Until all are done, or at once if a stop is requested: then sums are incomplete.
    void flush();

  private:
    struct Pixel {
        PixelSums* sums;
        int group;
    };

    const Integrator& integrator_;
    float pixel_spread_;
    std::size_t size_;
    bool counts_objects_;
    std::stop_token stop_;
    RenderStatistics& count_;
    std::unique_ptr<Integrator::Workspace> workspace_;
    std::vector<CameraTask> tasks_;
    std::vector<Pixel> pixels_;
    std::vector<RadianceSample> results_;
};

}  // namespace carom::render
