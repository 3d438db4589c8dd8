// A camera as two matrices, as image files store them.
#pragma once

#include <Imath/ImathMatrix.h>

#include "render/camera/camera_state.h"

namespace carom::render {

/// By the conventions of OpenEXR ("Standard Attributes", openexr.com), which are RenderMan's.
/// Points are row vectors to the left of the matrix, as in Imath.
struct CameraMatrices {
    /// Camera space, metres: x to the right in the picture, y up, z ahead (left-handed).
    Imath::M44f world_to_camera;
    /// After division by w: x from 0 at the left edge of the picture to 1 at the right edge, y from
    /// 0 at the top edge to 1 at the bottom edge; z from 0 at 1 mm from the camera to 1 at
    /// infinity.
    Imath::M44f world_to_ndc;
};

/// For the centre of the lens in the middle of the shutter, as for depth, motion and ids
/// (render/frame/aov_planes.h). `width` and `height` in pixels. Throws Error if a state is invalid.
[[nodiscard]] CameraMatrices camera_matrices(const CameraState& open, const CameraState& close,
                                             int width, int height);

}  // namespace carom::render
