// Evenly spaced instants of a timeline.
#pragma once

#include <vector>

#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// start_time + n / rate up to and including end_time. Throws Error unless 0 < rate <= 1e6 Hz and
/// all tracks together are sampled at most ten million times.
[[nodiscard]] std::vector<double> sample_times(const sim::Timeline& timeline, double rate);

}  // namespace carom::pipeline
