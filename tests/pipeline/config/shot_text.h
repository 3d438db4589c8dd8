// Every field of a shot as text, so that two shots can be compared.
#pragma once

#include <string>

#include "pipeline/shot/shot.h"

namespace carom::pipeline {

/// The text has all bits of the doubles. The shot's name, resolved text and assets are left out.
[[nodiscard]] std::string shot_text(const Shot& shot);

}  // namespace carom::pipeline
