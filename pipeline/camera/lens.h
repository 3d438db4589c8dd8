// How the lens of a camera differs from a perfect one.
#pragma once

#include "pipeline/camera/lens_look.h"
#include "render/camera/camera_state.h"

namespace carom::pipeline {

struct Lens {
    render::LensShape shape{};
    /// How much the field of view becomes narrower as the focus comes near: 0 is not at all, 1 as
    /// much as that of a lens that is moved as a whole (narrowing).
    double breathing = 0;
    LensLook look{};
};

/// By how much a lens of the focal length (m) shows less of the plane that it is focused on at the
/// distance (m) than it would at infinity. A thin lens that is moved away from the sensor has its
/// image at f d / (d - f) instead of f, so the picture becomes larger by 1 + m with the
/// magnification m = f / (d - f), of which the lens keeps the part `breathing`. Focus nearer than
/// twice the focal length, where m is 1, counts as that.
[[nodiscard]] inline double narrowing(double focal_length, double distance, double breathing) {
    const double magnification =
        distance > 2 * focal_length ? focal_length / (distance - focal_length) : 1;
    return 1 + breathing * magnification;
}

}  // namespace carom::pipeline
