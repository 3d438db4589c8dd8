// A comparison for people.
#pragma once

#include <string>

#include "lab/comparison/comparison.h"

namespace carom::pipeline {

/// What was rendered, a table of costs, a table of tests per ray by kind of ray.
[[nodiscard]] std::string comparison_text(const Comparison& comparison);

/// "any" or "closest".
[[nodiscard]] const char* name_of(ShadowRays shadow_rays);

}  // namespace carom::pipeline
