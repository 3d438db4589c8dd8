// A camera's way over a stretch of video time, as the shot describes it.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "pipeline/camera/rational.h"
#include "sim/timeline/vocabulary.h"

namespace carom::pipeline {

/// A point, or an object's place in the timeline at a scene time, plus an offset in world axes.
struct ControlPoint {
    Vec3 offset{0, 0, 0};
    std::string of;  // object; empty: `offset` is the point itself
    double at = 0;   // scene time, s
};

/// A Bezier curve of any degree >= 0 (one point: a fixed place).
struct BezierPath {
    std::vector<ControlPoint> points;
    bool even_pace = false;  // progress by arc length instead of by the curve's parameter
};

/// The place of an object at the frame's own scene time.
struct FollowPath {
    std::string object;
    Vec3 offset{0, 0, 0};
    double smoothing = 0;  // s, width of the window the object's path is averaged over
};

using CameraPath = std::variant<BezierPath, FollowPath>;

enum class Easing { linear, smooth };

/// A value that goes from start to end over the rig's stretch.
template <class T>
struct Eased {
    T start{};
    T end{};
    Easing easing = Easing::linear;
};

/// What the lens is focused on: a distance in metres, the plane through an object's centre, or
/// (empty name) the target. Distances are along the optical axis.
struct Focus {
    std::optional<double> distance;
    std::string object;
};

/// Lens radius in metres, or an f-number (lens radius = focal length / (2 N); the focal length
/// follows from the field of view and a sensor 24 mm high).
struct Aperture {
    double value = 0;
    bool is_f_number = false;
};

/// Which scene time each video time shows: straight from `scene_start` at the rig's start to
/// `scene_end` at its end. A shorter stretch is slow motion, equal ends freeze, descending
/// reverses.
struct TimeMap {
    Rational scene_start;
    Rational scene_end;
};

struct CameraRig {
    std::string name;
    Rational video_start;  // s
    Rational video_end;    // s, > video_start
    TimeMap time_map;
    CameraPath position;
    CameraPath target;
    Eased<double> vertical_fov{0.7, 0.7};  // rad
    Eased<Focus> focus;
    Eased<Aperture> aperture;
    Eased<double> roll{0, 0};  // rad
    Vec3 up{0, 0, 1};
    int blades = 0;
    double blade_rotation = 0;  // rad
};

/// Whose seconds the exposure is measured in. video: the map carries the exposure to scene time, so
/// slow motion has less blur. scene: objects blur as in real time whatever the map's speed, and not
/// at all in frozen time; the camera, which lives on video time, blurs for the same number of
/// seconds of that.
enum class ShutterClock { video, scene };
enum class ShutterPosition { start, centre, end };

/// How long each frame is exposed.
struct Shutter {
    Rational exposure{1, 48};  // s of the clock's time (angle / 360 / fps), >= 0
    ShutterClock clock = ShutterClock::video;
    ShutterPosition position = ShutterPosition::centre;
    double switch_ratio = 0.2;  // [0, 1]
};

struct FilmTiming {
    Rational fps{24};
    Shutter shutter;
};

}  // namespace carom::pipeline
