// Boxes around shapes.
#pragma once

#include <optional>

#include <Imath/ImathBox.h>

#include "render/scene/scene_description.h"

namespace carom::pipeline {

/// The box around a shape in its own axes; nothing for the infinite plane and for a mesh from a
/// file, which is not read.
[[nodiscard]] std::optional<Imath::Box3d> box_of(const render::Shape& shape);

}  // namespace carom::pipeline
