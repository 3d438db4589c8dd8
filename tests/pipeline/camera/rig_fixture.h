// A timeline and a rig for tests to modify.
#pragma once

#include <vector>

#include "pipeline/camera/camera_rig.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

inline sim::Key fixture_key(double time, const Vec3& position, const Vec3& in, const Vec3& out) {
    sim::Key key;
    key.time = time;
    key.position = position;
    key.velocity_in = in;
    key.velocity_out = out;
    return key;
}

/// "cue" rolls along x at 2 m/s from the origin, turns sharply at (2, 0, 0) and 1 s, and rolls
/// along y at 1 m/s until 4 s; "one" rests at (3, 1, 0).
inline sim::Timeline fixture_timeline() {
    sim::Timeline timeline;
    timeline.end_time = 4;
    timeline.tracks.emplace_back("cue",
                                 std::vector{fixture_key(0, {0, 0, 0}, {2, 0, 0}, {2, 0, 0}),
                                             fixture_key(1, {2, 0, 0}, {2, 0, 0}, {0, 1, 0}),
                                             fixture_key(4, {2, 3, 0}, {0, 1, 0}, {0, 0, 0})});
    timeline.tracks.emplace_back("one",
                                 std::vector{fixture_key(0, {3, 1, 0}, {0, 0, 0}, {0, 0, 0})});
    return timeline;
}

/// A rig that films the first two seconds from a fixed position.
inline CameraRig fixture_rig() {
    CameraRig rig;
    rig.name = "a";
    rig.video_end = 2;
    rig.time_map.scene_end = 2;
    rig.position = BezierPath{{{{0, -4, 1}, "", 0}}};
    rig.target = BezierPath{{{{0, 0, 0}, "", 0}}};
    rig.focus = {Focus{5.0, ""}, Focus{5.0, ""}};
    return rig;
}

}  // namespace carom::pipeline
