// Prints what a film will cost.
#pragma once

#include <string>

#include "pipeline/cli/terminal/console.h"
#include "pipeline/job/film_forecast.h"

namespace carom::cli {

/// "about 3 h 20 min of processor time (give or take 15 %), 1 h 40 min on 2 processors; 1.2 GB of
/// memory, 2.3 GB in the cache, a film of 12 MB". `threads` render at the same time.
[[nodiscard]] std::string forecast_text(const pipeline::FilmForecast& forecast, int threads);

/// Prints the text, or an event `forecast`.
void report_forecast(const pipeline::FilmForecast& forecast, int threads, Console& console);

}  // namespace carom::cli
