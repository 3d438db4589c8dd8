// Estimates how much memory the film of a shot will need.
#pragma once

#include <cstdint>
#include <string>

#include "pipeline/shot/shot.h"

namespace carom::pipeline {

/// The expected largest resident size, in bytes, of a process that renders and encodes the whole
/// film to `output` (empty: a film in the shot's own format). It deviates from the measurements of
/// docs/reliability.md by at most a quarter; bench/memory_forecast repeats them. `keeps_sums`: that
/// of FilmJobOptions.
[[nodiscard]] std::uint64_t forecast_memory(const Shot& shot, const std::string& output,
                                            bool keeps_sums = false);

/// "580 MB", "1.2 GB": two or three digits, since the forecast is not more accurate.
[[nodiscard]] std::string memory_text(std::uint64_t bytes);

}  // namespace carom::pipeline
