// The views along a camera's path, near enough to each other to see how the picture turns.
#pragma once

#include <vector>

#include "pipeline/camera/camera_rig.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// The view at a place of a rig's path.
struct ViewNode {
    double done = 0;             // Progress::done
    Vec3 ahead{0, 1, 0};         // unit
    Vec3 up{0, 0, 1};            // unit, as the rig's `up` says
    Vec3 upright{0, 0, 1};       // unit, of a picture whose upper edge follows `up`; zero: none
    bool is_after_jump = false;  // the view jumps between the node before and this one
};

/// The views along the whole path from its start to its end. From one to the next the view turns by
/// at most 10 degrees, and the picture about the view by at most 5 degrees or within 1e-6 s of the
/// film as it was written, where it turns over. Views along the axis of `up` are among them. The
/// rig has no AlongPath. Throws Error if an object is not in the timeline.
[[nodiscard]] std::vector<ViewNode> views_along(const CameraRig& rig,
                                                const sim::Timeline& timeline);

/// The angle between two vectors, rad, [0, pi].
[[nodiscard]] double angle_between(const Vec3& a, const Vec3& b);

[[nodiscard]] inline bool has_upright(const ViewNode& node) {
    return node.upright != Vec3(0, 0, 0);
}

}  // namespace carom::pipeline
