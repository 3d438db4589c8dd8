// The fields of a camera, in the order in which they are hashed (core/fields.h).
#pragma once

#include "core/fields.h"
#include "render/camera/camera_state.h"

namespace carom::render {

constexpr auto fields_of(Describes<CameraState>) {
    using T = CameraState;
    return fields<T>(
        field("position", &T::position), field("target", &T::target), field("up", &T::up),
        field("roll", &T::roll), field("vertical_fov", &T::vertical_fov),
        field("focus_distance", &T::focus_distance), field("lens_radius", &T::lens_radius),
        field("blades", &T::blades), field("blade_rotation", &T::blade_rotation));
}

}  // namespace carom::render
