// The fields of a frame's input, in the order in which they are hashed (core/fields.h).
#pragma once

#include "core/fields.h"
#include "render/camera/camera_fields.h"
#include "render/frame/frame.h"

namespace carom::render {

constexpr auto fields_of(Describes<FrameInput>) {
    using T = FrameInput;
    return fields<T>(field("camera_open", &T::camera_open), field("camera_close", &T::camera_close),
                     field("scene_open", &T::scene_open), field("scene_close", &T::scene_close),
                     field("switch_ratio", &T::switch_ratio),
                     unhashed("seed", &T::seed, "follows from the others and the settings' seed"));
}

}  // namespace carom::render
