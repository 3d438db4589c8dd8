// The section `solve`.
#pragma once

#include "pipeline/config/map_spec.h"
#include "pipeline/config/shot_file.h"

namespace carom::pipeline::config {

[[nodiscard]] const MapSpec<SolveSection>& solve_spec();

}  // namespace carom::pipeline::config
