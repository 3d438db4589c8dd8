// The sizes of a film's files, and the time to write them, from the measured blocks of its
// pictures.
#pragma once

#include <string>

#include "pipeline/job/film_forecast.h"
#include "pipeline/job/film_probe.h"

namespace carom::pipeline {

/// Whether the codec of a film to `output` stores the differences between pictures, so that its
/// size depends on pictures in a row.
[[nodiscard]] bool has_sequences(const Shot& shot, const std::string& output);

/// Bytes of a pixel of a stored picture where none could be measured: what the examples have, and
/// the floats of other channels without compression.
[[nodiscard]] double usual_store_bytes_per_pixel(const Shot& shot);

/// Adds the sizes of the store and of the film, and the times to write them, to a forecast that has
/// the times of rendering. Throws Error.
void add_sizes(const FilmSource& source, const FilmPlan& plan, const FilmProbe& probe,
               const std::string& output, FilmForecast& forecast);

}  // namespace carom::pipeline
