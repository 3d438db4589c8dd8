// How many samples each pixel gets, from what a few have shown.
#pragma once

#include <vector>

#include "render/frame/pixel_sums.h"
#include "render/scene/render_settings.h"

namespace carom::render {

/// The squared relative error of the mean of a pixel's first `samples` samples.
[[nodiscard]] double relative_variance(const PixelSums& pixel, int samples);

/// By how much the standard deviation of a pixel's samples is multiplied to give its number of
/// samples, if `deviations` are those of all pixels.
[[nodiscard]] double samples_per_deviation(const std::vector<double>& deviations,
                                           const RenderSettings& settings);

/// Samples of a pixel of the given standard deviation, before rounding.
[[nodiscard]] double wanted_samples(double deviation, double samples_per_deviation,
                                    const RenderSettings& settings);

/// Samples for every pixel, row by row, between `settings.samples`, which `pilot` holds already,
/// and `settings.max_samples`: as few as bring the root mean square of the pixels' relative errors,
///   sqrt(mean over pixels of variance / (luminance^2 + 0.01)),
/// down to `settings.noise`. For a given sum of samples that is least if each pixel's number is in
/// proportion to its standard deviation (Neyman 1934, "On the two different aspects of the
/// representative method", section III.2).
///
/// A pixel's own samples have no say in its number, only those of the up to eight around it (and,
/// by one pixel's share, in the scale common to all): its mean stays unbiased whatever they were.
/// What so few samples miss altogether, small bright reflections, gets no more than its
/// surroundings.
[[nodiscard]] std::vector<int> plan_samples(const std::vector<PixelSums>& pilot,
                                            const RenderSettings& settings);

}  // namespace carom::render
