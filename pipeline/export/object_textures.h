// Lays textures on the mesh of an object.
#pragma once

#include "pipeline/export/export_scene.h"

namespace carom::pipeline {

/// Gives the part's mesh, whose uv are those of the object's shape, the coordinates of these
/// textures in place of its uv. `object_from_mesh`: from the axes of the mesh to the shape's.
/// Returns the textures with the lengths of their relief there. Without textures the coordinates
/// are the mesh's uv if `keeps_uv` and if it has them.
[[nodiscard]] MaterialTextures lay_textures(ExportPart& part, MaterialTextures textures,
                                            const render::ObjectDescription& object,
                                            const Mat44& object_from_mesh, bool keeps_uv);

}  // namespace carom::pipeline
