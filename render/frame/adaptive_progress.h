// Progress of an adaptive frame, whose number of samples is only known after its first samples.
#pragma once

#include <mutex>
#include <vector>

#include "core/progress.h"
#include "render/scene/render_settings.h"

namespace carom::render {

/// The fraction of a frame's work, in thread seconds, that is done. The first samples of every tile
/// are timed; the further samples of a tile are assumed to take time in proportion. While first
/// samples are taken, the finished tiles stand for all others: their noise predicts the plan.
/// Nothing is reported before enough tiles are finished. Any thread may call.
class AdaptiveProgress {
  public:
    AdaptiveProgress(const ProgressCallback& callback, const RenderSettings& settings, int tiles);

    /// The tile that takes its first samples as the n-th; early ones are spread over the frame.
    [[nodiscard]] int nth_tile(int n) const;

    /// Reports that the tile's first samples took `seconds`; `deviations` of some of its pixels,
    /// for samples_per_deviation().
    void first_samples_done(int tile, const std::vector<double>& deviations, double seconds);

    /// Sets the number of further samples of each tile, as a multiple of its first ones.
    void set_plan(std::vector<double> further);

    /// Reports that the tile has its further samples.
    void tile_done(int tile);

  private:
    struct BegunTile {
        double seconds = 0;
        std::vector<double> deviations;
    };

    [[nodiscard]] double expected_ratio() const;
    void report(double fraction);

    const ProgressCallback& callback_;
    RenderSettings settings_;
    int tiles_;
    int stride_;
    std::mutex mutex_;
    std::vector<BegunTile> begun_;  // all tiles, by their index
    int begun_count_ = 0;
    int done_count_ = 0;
    double ratio_ = 0;             // expected work after the first samples over theirs
    std::vector<double> further_;  // of each tile
    double work_ = 0;              // s, done
    double all_work_ = 0;          // s, once a plan exists
    double fraction_ = 0;
};

}  // namespace carom::render
