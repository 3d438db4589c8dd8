// Evenly spaced instants of a timeline.
#pragma once

#include <vector>

#include "sim/timeline/timeline.h"

namespace carom::pipeline {

inline constexpr double kHighestRate = 1e6;  // samples/s

/// start_time + n / rate up to and including end_time. Throws Error unless 0 < rate <= kHighestRate
/// and all tracks together are sampled at most ten million times.
[[nodiscard]] std::vector<double> sample_times(const sim::Timeline& timeline, double rate);

}  // namespace carom::pipeline
