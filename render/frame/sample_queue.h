// A queue of camera samples for an integrator that takes many at once.
#pragma once

#include <memory>
#include <stop_token>
#include <utility>
#include <vector>

#include "render/camera/camera_batch.h"
#include "render/frame/tile_sums.h"
#include "render/integrator/integrator.h"
#include "render/integrator/workspace_pool.h"

namespace carom::render {

/// For one thread. Samples are added to their pixel's sums in the order of the requests, and only
/// the rays of added samples are counted. A sample that is negative or not finite is counted, too,
/// and added as black.
class SampleQueue {
  public:
    /// Everything is borrowed.
    struct Setting {
        const Integrator& integrator;
        WorkspacePool& workspaces;  // of the integrator
        const ThinLensCamera& camera;
        CameraFixings fixings;
        float pixel_spread;
        int traced_at_once;  // samples between two checks for a stop request
    };
    SampleQueue(const Setting& setting, std::stop_token stop, RenderStatistics& count);

    /// `sums`, in which the pixel has that number, must stay in place until `flush`.
    void add(const SampleStream& stream, const SampleIndex& index, TileSums& sums,
             std::size_t pixel);

    /// Returns when all samples are added. Once a stop is requested, it returns soon, and the
    /// remaining samples are forgotten.
    void flush();

  private:
    /// Returns how many of `results_` were computed before a stop was requested.
    [[nodiscard]] int trace();

    Setting setting_;
    std::stop_token stop_;
    RenderStatistics& count_;
    WorkspacePool::Loan workspace_;
    /// Camera rays are made for all samples together even if the integrator takes one at a time,
    /// because vector code takes as long for one ray as for a full vector.
    CameraBatch batch_;
    std::vector<std::pair<TileSums*, std::size_t>> pixels_;
    std::vector<RadianceSample> results_;
};

}  // namespace carom::render
