// The key `lens` of a camera.
#pragma once

#include "pipeline/camera/lens.h"
#include "pipeline/config/map_spec.h"

namespace carom::pipeline::config {

/// The name of a kind of lens, or a map of numbers.
[[nodiscard]] ValueType<Lens> lens();

}  // namespace carom::pipeline::config
