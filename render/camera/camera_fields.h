// The fields of a camera, in the order in which they are hashed (core/fields.h).
#pragma once

#include "core/fields.h"
#include "render/camera/camera_state.h"

namespace carom::render {

constexpr auto fields_of(Describes<LensShape>) {
    using T = LensShape;
    return fields<T>(field("cat_eye_ratio", &T::cat_eye_ratio),
                     field("cat_eye_shift", &T::cat_eye_shift), field("squeeze", &T::squeeze),
                     field("distortion", &T::distortion));
}

constexpr auto fields_of(Describes<CameraState>) {
    using T = CameraState;
    return fields<T>(
        field("position", &T::position), field("target", &T::target), field("up", &T::up),
        field("roll", &T::roll), field("vertical_fov", &T::vertical_fov),
        field("focus_distance", &T::focus_distance), field("lens_radius", &T::lens_radius),
        field("blades", &T::blades), field("blade_rotation", &T::blade_rotation),
        field_if_given("lens", &T::lens, "the length of what is hashed says whether it is given"));
}

}  // namespace carom::render
