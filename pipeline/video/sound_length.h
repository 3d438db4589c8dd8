// How many samples of sound a number of frames has.
#pragma once

#include <cstdint>

#include "pipeline/camera/rational.h"

namespace carom::pipeline {

/// The number of the sample with which a frame begins, counted from 0: frame x 48000 / fps, rounded
/// to the nearest, halves upwards. It is also the length of a film of so many frames. `frame` must
/// not be negative, and `fps` must be above 0. Throws Error on overflow.
[[nodiscard]] std::int64_t first_sample(std::int64_t frame, const Rational& fps);

}  // namespace carom::pipeline
