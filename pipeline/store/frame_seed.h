// The seed of a frame's noise.
#pragma once

#include <cstdint>

#include "render/frame/frame.h"

namespace carom::pipeline {

/// The seed of a frame's random numbers. It depends on what the frame shows and when, never on how
/// the frame is computed.
///
/// It depends on `render_seed` (the key `render.seed`), the shutter's interval in scene time, and
/// the camera's values when the shutter opens and when it closes. So the frames of a film differ in
/// their noise as soon as the time or the camera changes. Otherwise a frozen scene that a camera
/// passes would look as if seen through a dirty pane.
///
/// It does not depend on materials, lights and shapes, the picture's size, the number of samples
/// and all other settings, or the shutter's switch ratio. So the same frame with another look, with
/// another acceleration structure or on another instruction set has the same noise, and a picture
/// with more samples begins with the samples of the picture with fewer. A frame that shows the same
/// at another video time has the same interval and camera, and so the same seed.
[[nodiscard]] std::uint64_t frame_seed(std::uint64_t render_seed, const render::FrameInput& frame);

}  // namespace carom::pipeline
