// Which noise a frame has.
#pragma once

#include <cstdint>

#include "render/frame/frame.h"

namespace carom::pipeline {

/// The seed of a frame's random numbers: a function of what the frame shows when, never of how it
/// is computed.
///
/// In it: `render_seed` (the key `render.seed`), the shutter's interval in scene time, and the
/// camera's values when the shutter opens and when it closes. So frames of a film differ in their
/// noise as soon as time or camera move on; a frozen scene that a camera passes does not look as if
/// seen through a dirty pane.
///
/// Not in it: materials, lights and shapes, the picture's size, the number of samples and all other
/// settings, and the shutter's switch ratio. So the same frame in another look, with another
/// acceleration structure or on another instruction set has the same noise, and a picture with more
/// samples begins with those of the one with fewer. A frame that shows the same at another video
/// time has the same interval and camera, and so the same seed.
[[nodiscard]] std::uint64_t frame_seed(std::uint64_t render_seed, const render::FrameInput& frame);

}  // namespace carom::pipeline
