// Estimates, from a few pixels, what it will cost to render and encode a film.
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "pipeline/job/film_job.h"

namespace carom::pipeline {

/// What rendering the missing pictures and encoding the whole film will take. All times are CPU
/// time of the machine that made the forecast, in seconds.
struct FilmForecast {
    std::int64_t frames = 0;         // of the film
    std::int64_t pictures = 0;       // to render
    double seconds_per_picture = 0;  // mean: to render a picture and to store it
    double serial_per_picture = 0;   // the part of it that one thread does while the others wait
    double preparation_seconds = 0;  // once per process: reading the scene and its textures
    double encoding_seconds = 0;     // of the film
    double error = 0;                // of the times, relative: two standard errors

    std::uint64_t memory_bytes = 0;  // of a process that renders and encodes (memory_forecast.h)
    std::uint64_t store_bytes = 0;   // that the missing pictures add to the store
    std::uint64_t film_bytes = 0;    // 0 if no film is written

    double probe_seconds = 0;  // that making the forecast took

    /// Of a single process.
    [[nodiscard]] double cpu_seconds() const {
        return preparation_seconds + static_cast<double>(pictures) * seconds_per_picture +
               encoding_seconds;
    }
    /// Elapsed time if `workers` processes with `threads` threads each share the pictures and a
    /// film is then encoded. With one worker the film is encoded while it renders.
    [[nodiscard]] double elapsed_seconds(int workers, int threads) const;
};

struct ForecastSettings {
    double cpu_limit = 20;    // s, that the forecast may take
    double cpu_at_least = 1;  // s, that it may take however short the film; below the limit
};

/// Renders small blocks of some frames of each camera; nothing is stored. `missing`: the frames to
/// render, as in FilmStatus. If there are none, the times and the store's bytes are 0, and the
/// film's size is not known (0). Of `options` the output, the frames, the chunk, the cache's
/// folder, the threads and the structures are used. Throws Error, Stopped.
[[nodiscard]] FilmForecast forecast_film(const Shot& shot, const sim::Bake& bake,
                                         const std::vector<std::int64_t>& missing,
                                         const FilmJobOptions& options, const std::stop_token& stop,
                                         const ForecastSettings& settings = {});

/// The threads of a process with `threads` as in FilmJobOptions: those of this machine for 0.
[[nodiscard]] int thread_count(int threads);

}  // namespace carom::pipeline
