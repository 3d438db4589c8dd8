// Generates random valid shots, for which `check` reports no problem.
#pragma once

#include "tests/pipeline/config/damage/yaml_writer.h"

namespace carom::testing {

/// The shots contain all kinds of values of the format: quantities, points, paths, names, choices,
/// texts.
[[nodiscard]] Yaml random_shot(Dice& dice);

}  // namespace carom::testing
