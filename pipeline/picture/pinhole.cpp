#include "pipeline/picture/pinhole.h"

#include "render/camera/thin_lens_camera.h"

namespace carom::pipeline {

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
}

SeenPoint Pinhole::project(const Vec3& point) const {
    const Vec3 relative = point - position_;
    const double inverse = 1 / relative.dot(forward_);
    const double scale = inverse / pixel_size_;
    return {centre_ + scale * Vec2(relative.dot(right_), -relative.dot(up_)), inverse};
}

Vec3 Pinhole::direction(const Vec2& place) const {
    const Vec2 off = pixel_size_ * (place - centre_);
    return forward_ + off.x * right_ - off.y * up_;
}

}  // namespace carom::pipeline
