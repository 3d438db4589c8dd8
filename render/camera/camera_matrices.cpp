#include "render/camera/camera_matrices.h"

#include "render/camera/thin_lens_camera.h"

namespace carom::render {
namespace {

using M44d = Imath::M44d;

constexpr double kNearest = 1e-3;  // m, where z is 0; the camera itself has no near plane

M44d world_to_camera(const CameraFrame& frame) {
    const Vec3 position(frame.position);
    const Vec3 axes[3] = {Vec3(frame.right), Vec3(frame.up), Vec3(frame.forward)};
    M44d matrix;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            matrix[row][column] = axes[column][row];
        }
        matrix[3][column] = -position.dot(axes[column]);
    }
    return matrix;
}

/// `picture`: the size of the picture at distance 1.
M44d camera_to_ndc(const Vec2& picture) {
    M44d matrix(0.0);
    matrix[0][0] = 1 / picture.x;
    matrix[1][1] = -1 / picture.y;
    matrix[2][0] = matrix[2][1] = 0.5;
    matrix[2][2] = matrix[2][3] = 1;  // w is the distance along the axis
    matrix[3][2] = -kNearest;
    return matrix;
}

}  // namespace

CameraMatrices camera_matrices(const CameraState& open, const CameraState& close, int width,
                               int height) {
    const ThinLensCamera camera(open, close, width, height, 0, PixelFilter::box, 1);
    const CameraFrame frame = camera.frame_at(0.5f);
    const M44d to_camera = world_to_camera(frame);
    const Vec2 picture = static_cast<double>(frame.pixel_size) * Vec2(width, height);
    return {Imath::M44f(to_camera), Imath::M44f(to_camera * camera_to_ndc(picture))};
}

}  // namespace carom::render
