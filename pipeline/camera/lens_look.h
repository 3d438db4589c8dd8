// What the lens of a camera does to the finished picture.
#pragma once

namespace carom::pipeline {

/// Seen through the view: frames are stored without it (video/lens_view.h).
struct LensLook {
    /// Part of the natural loss of light towards the border, cos^4 of the angle to the optical
    /// axis: 0 is none, 1 all of it.
    double falloff = 0;
    /// Part by which the red picture is larger than the blue one.
    double lateral_colour = 0;

    bool operator==(const LensLook&) const = default;
};

}  // namespace carom::pipeline
