// Every field of a shot as text, so that two can be compared and a difference be seen.
#pragma once

#include <string>

#include "pipeline/shot/shot.h"

namespace carom::pipeline {

/// Doubles with all their bits. The shot's name, resolved text and assets are left out.
[[nodiscard]] std::string shot_text(const Shot& shot);

}  // namespace carom::pipeline
