// Adaptive sampling: the number of samples of each pixel, from its first samples.
#pragma once

#include <vector>

#include "render/frame/pixel_sums.h"
#include "render/frame/splat_moments.h"
#include "render/scene/render_settings.h"

namespace carom::render {

/// The squared relative error of the mean of a pixel's first `samples` samples. `more`: luminance
/// of the pixel that its samples do not contain.
[[nodiscard]] double relative_variance(const PixelSums& pixel, int samples, float more = 0);

/// The factor from the standard deviation of a pixel's samples to its number of samples, given the
/// `deviations` of all pixels. `of_splats`: the mean squared relative error of splats for one
/// sample per pixel; their number grows with the mean number of samples.
[[nodiscard]] double samples_per_deviation(const std::vector<double>& deviations,
                                           const RenderSettings& settings, double of_splats = 0);

/// Number of samples of a pixel with the given standard deviation, before rounding.
[[nodiscard]] double wanted_samples(double deviation, double samples_per_deviation,
                                    const RenderSettings& settings);

/// Samples of every pixel, row by row, between `settings.samples`, which `pilot` already contains,
/// and `settings.max_samples`: the fewest that bring the root mean square of the pixels' relative
/// errors,
///   sqrt(mean over pixels of variance / (luminance^2 + 0.01)),
/// splats included, down to `settings.noise`. For a given total, that error is least if each
/// pixel's number is proportional to its standard deviation (Neyman 1934, "On the two different
/// aspects of the representative method", section III.2). The noise of splats depends on the total
/// alone, so that it changes nothing about that. `splats`: those of as many samples; empty if there
/// are none.
///
/// The number of a pixel depends on the samples of its up to eight neighbours and not on its own
/// (except for its small part in the scale common to all), so that its mean stays unbiased. Small
/// bright reflections that the first samples miss altogether get no more than their surroundings.
[[nodiscard]] std::vector<int> plan_samples(const std::vector<PixelSums>& pilot,
                                            const RenderSettings& settings,
                                            const SplatMoments& splats = {});

}  // namespace carom::render
