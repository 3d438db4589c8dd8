// Random shots that are right in every respect: `check` has nothing to say about them.
#pragma once

#include "tests/pipeline/config/damage/yaml_writer.h"

namespace carom::testing {

/// With values of every kind that the format has: quantities, points, paths, names, choices, texts.
[[nodiscard]] Yaml random_shot(Dice& dice);

}  // namespace carom::testing
