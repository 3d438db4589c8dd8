// How much memory the film of a shot will take, before it is made.
#pragma once

#include <cstdint>
#include <string>

#include "pipeline/shot/shot.h"

namespace carom::pipeline {

/// The largest resident size, in bytes, to expect of the process that renders and encodes the whole
/// film to `output` (empty: a film of the shot's own format). Within a quarter of what was measured
/// for the cases of docs/reliability.md; bench/memory_forecast measures them again.
[[nodiscard]] std::uint64_t forecast_memory(const Shot& shot, const std::string& output);

/// "580 MB", "1.2 GB": two digits or three, as exact as a forecast is.
[[nodiscard]] std::string memory_text(std::uint64_t bytes);

}  // namespace carom::pipeline
