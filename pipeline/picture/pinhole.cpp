#include "pipeline/picture/pinhole.h"

#include "render/camera/lens_distortion.h"
#include "render/camera/thin_lens_camera.h"

namespace carom::pipeline {

Vec2 PictureBend::bent(const Vec2& place) const {
    return k == 0 ? place : centre + render::distorted(place - centre, k);
}

Vec2 PictureBend::straight(const Vec2& place) const {
    return k == 0 ? place : centre + render::undistorted(place - centre, k);
}

Pinhole::Pinhole(const PlannedFrame& frame, int width, int height)
    : centre_(0.5 * width, 0.5 * height) {
    const render::ThinLensCamera camera(frame.camera_open, frame.camera_close, width, height, 0,
                                        render::PixelFilter::box, 1);
    const render::CameraFrame middle = camera.frame_at(0.5F);
    position_ = Vec3(middle.position);
    forward_ = Vec3(middle.forward);
    right_ = Vec3(middle.right);
    up_ = Vec3(middle.up);
    pixel_size_ = static_cast<double>(middle.pixel_size);
    bend_.centre = centre_;
    if (frame.camera_open.lens) {
        bend_.k = render::distortion_per_pixel2(frame.camera_open.lens->distortion, width, height);
    }
}

SeenPoint Pinhole::project(const Vec3& point) const {
    const SeenPoint straight = project_straight(point);
    return {bend_.bent(straight.place), straight.inverse_depth};
}

Vec3 Pinhole::direction(const Vec2& place) const {
    return straight_direction(bend_.straight(place));
}

SeenPoint Pinhole::project_straight(const Vec3& point) const {
    const Vec3 relative = point - position_;
    const double inverse = 1 / relative.dot(forward_);
    const double scale = inverse / pixel_size_;
    return {centre_ + scale * Vec2(relative.dot(right_), -relative.dot(up_)), inverse};
}

Vec3 Pinhole::straight_direction(const Vec2& place) const {
    const Vec2 off = pixel_size_ * (place - centre_);
    return forward_ + off.x * right_ - off.y * up_;
}

}  // namespace carom::pipeline
