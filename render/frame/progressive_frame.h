// A frame that is rendered in rounds, each of which adds samples to all pixels.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/progress.h"
#include "render/film/film.h"
#include "render/frame/frame.h"

namespace carom::render {

/// Keeps the sums of all samples between the rounds (tile_sums.h). Once it has all
/// samples, its film is that of render_frame, bit for bit, however many rounds there were and
/// however often they were stopped. For one thread at a time; work runs in the arena of the caller.
class ProgressiveFrame {
  public:
    /// `scene` must outlive it; the other arguments need not. Throws as render_frame does.
    ProgressiveFrame(const PreparedScene& scene, std::span<const sim::Track> tracks,
                     const FrameInput& frame, const RenderSettings& settings);
    ~ProgressiveFrame();
    ProgressiveFrame(ProgressiveFrame&&) noexcept;
    ProgressiveFrame& operator=(ProgressiveFrame&&) noexcept;
    ProgressiveFrame(const ProgressiveFrame&) = delete;
    ProgressiveFrame& operator=(const ProgressiveFrame&) = delete;

    /// Adds samples until each pixel has `up_to_samples`, or all of its own if that is fewer.
    /// Throws Stopped soon after a stop is requested, at the latest after one batch of samples per
    /// thread; the samples that are complete by then stay, and another call goes on there.
    void refine(int up_to_samples, const WorkContext& context = {});

    /// Every pixel has this number of samples, or all of its own.
    [[nodiscard]] int samples() const;
    /// The most that a pixel gets. With adaptive sampling it is the settings' `max_samples` until
    /// the first samples of all pixels are taken, and then what the plan gives.
    [[nodiscard]] int most_samples() const;
    /// Whether every pixel has all of its samples.
    [[nodiscard]] bool finished() const;
    /// The rays of all rounds.
    [[nodiscard]] const RenderStatistics& statistics() const;

    /// The colours of what there is, without other channels. A pixel without a sample is black.
    /// Throws Stopped.
    [[nodiscard]] Film picture(const WorkContext& context = {}) const;
    /// The planes of one AOV (aov_planes.h), whether the settings ask for it or not; a matte must
    /// be one that they ask for. Throws Error if there is no such AOV, Stopped.
    [[nodiscard]] std::vector<Channel> channels(const std::string& aov,
                                                const WorkContext& context = {}) const;
    /// The colours and all channels of the settings, as render_frame returns them. Throws Stopped.
    [[nodiscard]] Film film(const WorkContext& context = {}) const;

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace carom::render
