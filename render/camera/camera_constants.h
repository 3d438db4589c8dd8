// A camera as plain data, for kernels.
#pragma once

#include "render/geometry/ray.h"
#include "render/sampling/pixel_filter_tables.h"

namespace carom::render {

/// A camera at one time, with axes scaled so that the image plane is at distance 1, and what
/// changes linearly where that does not. World axes, metres.
struct CameraAtTime {
    V3f position;
    V3f forward;               // unit, along the optical axis
    V3f right;                 // unit, to the right in the picture
    V3f up;                    // unit, upwards in the picture
    float pixel_size = 0;      // of a pixel on the plane at distance 1
    float focus_distance = 1;  // m
    float lens_radius = 0;     // m
    float blade_turns = 0;     // rotation of the blades, turns
    V3f axis;                  // from position to target
    V3f upright;               // not perpendicular to the axis
    float roll = 0;            // rad
    float blade_rotation = 0;  // rad
};

/// A LensShape with lengths in pixels.
struct LensShapeConstants {
    float squeeze = 1;
    float distortion = 0;     // 1/pixels^2, see lens_distortion.h
    float cat_eye_ratio = 1;  // in radii of the lens
    float cat_eye_shift = 0;  // in radii of the lens per pixel from the picture's centre
};

/// A ThinLensCamera. Borrows the tables of its filter.
struct CameraConstants {
    CameraAtTime open, close;
    V2f centre;  // of the picture, pixels
    float switch_ratio = 0;
    int blades = 0;
    bool moves = false;
    bool has_lens = false;
    LensShapeConstants shape;
    PixelFilterTables filter;
};

}  // namespace carom::render
