// What a camera does by itself: it fits its picture to the table, or shakes as if it were held.
#pragma once

#include "pipeline/camera/camera_rig.h"
#include "pipeline/config/map_spec.h"

namespace carom::pipeline::config {

/// Adds `fov_axis`, after the keys of the field of view.
void add_fov_axis(MapSpec<CameraRig>& spec);

/// Adds `frame`, `frame_margin` and `shake`. The points that `frame` keeps inside the picture are
/// those of the table, which build/film.cpp fills in.
void add_aids(MapSpec<CameraRig>& spec);

}  // namespace carom::pipeline::config
