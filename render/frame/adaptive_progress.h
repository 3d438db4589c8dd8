// Progress of an adaptive frame, whose number of samples is only known after its first samples.
#pragma once

#include <mutex>
#include <vector>

#include "core/progress.h"
#include "render/scene/render_settings.h"

namespace carom::render {

/// The fraction of a frame's work, in thread seconds, that is done. The first samples of every tile
/// are timed; the further samples of a tile are assumed to take time in proportion. While first
/// samples are taken, the finished tiles stand for all others: their errors predict the rounds that
/// follow. Nothing is reported before enough tiles are finished. Any thread may call.
class AdaptiveProgress {
  public:
    AdaptiveProgress(const ProgressCallback& callback, const RenderSettings& settings, int tiles);

    /// The tile that takes its first samples as the n-th; early ones are spread over the frame.
    [[nodiscard]] int nth_tile(int n) const;

    /// Reports that the tile's first samples took `seconds`. `errors` of some of its pixels without
    /// denoising (MeasuredError).
    void first_samples_done(int tile, const std::vector<float>& errors, double seconds);

    /// Begins a round. By tile, as multiples of the first samples: those that the round takes, and
    /// those that are expected to be taken from its begin on, in all rounds.
    void begin_round(std::vector<double> now, const std::vector<double>& in_all);

    /// Reports that the tile has the samples of the round.
    void tile_done(int tile);

    /// Reports that no round follows.
    void finish() { report(1); }

  private:
    struct BegunTile {
        double seconds = 0;
        std::vector<float> errors;
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
    double ratio_ = 0;           // expected work after the first samples over theirs
    std::vector<double> round_;  // of each tile
    double work_ = 0;            // s, done
    double all_work_ = 0;        // s, once a round is planned
    double fraction_ = 0;
};

}  // namespace carom::render
