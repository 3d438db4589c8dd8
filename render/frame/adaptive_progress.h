// How far an adaptive frame has come, although how many samples it needs shows only on the way.
#pragma once

#include <mutex>
#include <vector>

#include "core/progress.h"
#include "render/scene/render_settings.h"

namespace carom::render {

/// The share of a frame's work, in seconds of a thread, that is done. The first samples of every
/// tile are timed, and its further samples take so much longer as they are more. While the first
/// samples are taken, the tiles that have theirs stand for all others: the noise that they show
/// says what the plan is going to be. Nothing is reported before they are enough. Any thread may
/// call.
class AdaptiveProgress {
  public:
    AdaptiveProgress(const ProgressCallback& callback, const RenderSettings& settings, int tiles);

    /// The tile that is to be the n-th to get its first samples: early ones lie all over the frame.
    [[nodiscard]] int nth_tile(int n) const;

    /// The tile's first samples took `seconds`; `deviations` of some of its pixels, as
    /// samples_per_deviation wants them.
    void first_samples_done(int tile, const std::vector<double>& deviations, double seconds);

    /// How many further samples each tile gets, as a multiple of its first ones.
    void set_plan(std::vector<double> further);

    /// The tile has its further samples.
    void tile_done(int tile);

  private:
    struct BegunTile {
        double seconds = 0;
        std::vector<double> deviations;
    };

    [[nodiscard]] double expected_ratio() const;
    void report(double share);

    const ProgressCallback& callback_;
    RenderSettings settings_;
    int tiles_;
    int stride_;
    std::mutex mutex_;
    std::vector<BegunTile> begun_;  // all tiles, by their index
    int begun_count_ = 0;
    int done_count_ = 0;
    double ratio_ = 0;             // of the work after the first samples to theirs, expected
    std::vector<double> further_;  // of each tile
    double work_ = 0;              // s, so far
    double all_work_ = 0;          // s, once there is a plan
    double share_ = 0;
};

}  // namespace carom::render
