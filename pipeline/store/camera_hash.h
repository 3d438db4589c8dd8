// A camera's values within a hash.
#pragma once

#include "core/hash.h"
#include "render/camera/camera_state.h"

namespace carom::pipeline {

/// All of `camera`: where it is, where it looks, its lens.
inline void add_camera(Hasher& hasher, const render::CameraState& camera) {
    hasher.add(camera.position).add(camera.target).add(camera.up).add(camera.roll);
    hasher.add(camera.vertical_fov).add(camera.focus_distance).add(camera.lens_radius);
    hasher.add(camera.blades).add(camera.blade_rotation);
}

}  // namespace carom::pipeline
