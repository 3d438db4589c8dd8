// Sizes of structures that can be varied.
#pragma once

#include "lab/structures/acceleration_names.h"
#include "lab/structures/structure_options.h"

namespace carom::render {

enum class VariedSize { leaf_capacity, node_capacity, grid_density };

/// Whether the structure depends on this size.
[[nodiscard]] bool depends_on(AccelerationKind kind, VariedSize size);

/// All other sizes are the structures' own.
[[nodiscard]] StructureSizes with_size(VariedSize size, double value);

}  // namespace carom::render
