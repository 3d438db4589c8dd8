// Adaptive sampling: which pixels get more samples in the next round.
#pragma once

#include <vector>

#include "render/geometry/ray.h"
#include "render/scene/render_settings.h"

namespace carom::render {

/// What was measured of a frame's error, by pixel: estimates of the mean over the channels of
/// (x - r)^2 / (r^2 + 0.01), where r is the picture without noise.
struct MeasuredError {
    double mean = 0;              // over the frame
    std::vector<float> by_pixel;  // smoothed; those below 0 count as 0
};

/// The estimate for a noisy pixel, from its two halves: their mean is `mean`, half of their
/// difference `difference`.
[[nodiscard]] float error_of_halves(const V3f& mean, const V3f& difference);

/// The same for a noisy picture. `by_pixel` is the mean over the up to 24
/// pixels around each one. It does not contain the pixel itself: otherwise pixels that happened to
/// be too bright would get more samples than those that happened to be too dark, and the picture
/// would become darker.
[[nodiscard]] MeasuredError error_of_halves(const std::vector<V3f>& mean,
                                            const std::vector<V3f>& difference, int width,
                                            int height);

/// The numbers of samples that a pixel can have: `settings.samples`, then those whose halves have
/// 4^k samples, which are distributed best, and at last `settings.max_samples`.
[[nodiscard]] std::vector<int> sample_levels(const RenderSettings& settings);

/// The error of a picture after denoising (denoiser_planes.h).
[[nodiscard]] MeasuredError measured_error(std::vector<float> after_denoising);

/// How the error of a pixel is taken to fall: with this power of its number of samples, if it is
/// raised to the next level. Measured on frames of the examples with 8 and 32 samples
/// (docs/denoising.md).
[[nodiscard]] double error_power(const RenderSettings& settings);

struct SampleRound {
    /// Samples of each pixel after the round; as before if no round is needed.
    std::vector<int> plan;
    /// Those that it is expected to have after all rounds.
    std::vector<int> expected;
    bool is_needed = false;
};

/// Plans the next round of a frame whose pixels have the samples `plan`, each of them a level. No
/// round is needed if the frame's error is at most 5 % larger than `settings.noise`, or if no pixel
/// may get more samples. Otherwise it plans the cheapest way to that error if the errors of pixels
/// fall as expected: a pixel is raised to the next level if that takes away more error per sample
/// than a limit common to all. As this may turn out otherwise, a round raises pixels by one level
/// only; then the error is measured again.
[[nodiscard]] SampleRound next_round(const std::vector<int>& plan, const MeasuredError& error,
                                     const RenderSettings& settings);

}  // namespace carom::render
