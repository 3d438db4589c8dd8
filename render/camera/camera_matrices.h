// A camera as two matrices, in the form in which picture files name them.
#pragma once

#include <Imath/ImathMatrix.h>

#include "render/camera/camera_state.h"

namespace carom::render {

/// In the conventions of OpenEXR ("Standard Attributes", openexr.com), which are RenderMan's.
/// Points are rows and stand to the left of the matrix, as Imath multiplies them.
struct CameraMatrices {
    /// Camera space, metres: x to the right in the picture, y upwards, z ahead (left-handed).
    Imath::M44f world_to_camera;
    /// After division by w: x from 0 to 1 from the left edge of the picture to the right one, y
    /// from 0 to 1 from the top edge to the bottom one; z from 0 at 1 mm from the camera to 1 at
    /// infinity.
    Imath::M44f world_to_ndc;
};

/// Of the centre of the lens in the middle of the shutter, to which depth, motion and ids belong
/// (render/frame/aov_planes.h). `width` and `height` in pixels. Throws Error if a state is
/// unusable.
[[nodiscard]] CameraMatrices camera_matrices(const CameraState& open, const CameraState& close,
                                             int width, int height);

}  // namespace carom::render
