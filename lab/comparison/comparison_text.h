// A comparison as text.
#pragma once

#include <string>

#include "lab/comparison/comparison.h"

namespace carom::pipeline {

/// The scene, a table of costs, and a table of tests per ray by kind of ray.
[[nodiscard]] std::string comparison_text(const Comparison& comparison);

/// "any" or "closest".
[[nodiscard]] const char* name_of(ShadowRays shadow_rays);

}  // namespace carom::pipeline
