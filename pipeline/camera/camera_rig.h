// A camera's way over a stretch of video time, as the shot describes it.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/vectors.h"
#include "pipeline/camera/rational.h"

namespace carom::pipeline {

/// A point, or an object's place in the timeline at a scene time, plus an offset in world axes.
struct ControlPoint {
    Vec3 offset{0, 0, 0};
    std::string of;  // object; empty: `offset` is the point itself
    double at = 0;   // scene time, s
};

/// How something changes from its start to its end: evenly, with a gentle start and end, or along
/// the cubic Bezier curve (0, 0), (x1, y1), (x2, y2), (1, 1) of value over time, x1 and x2 in [0,
/// 1].
struct Easing {
    enum Kind { linear, smooth, bezier };
    Kind kind = linear;
    double x1 = 0, y1 = 0, x2 = 1, y2 = 1;  // bezier only

    /// So that `Easing::smooth` is an easing.
    constexpr Easing(Kind without_points = linear) : kind(without_points) {}
    constexpr Easing(double ax, double ay, double bx, double by)
        : kind(bezier), x1(ax), y1(ay), x2(bx), y2(by) {}

    bool operator==(const Easing&) const = default;
};

/// A Bezier curve of any degree >= 0 (one point: a fixed place).
struct BezierPath {
    std::vector<ControlPoint> points;
    bool even_pace = false;  // progress by arc length instead of by the curve's parameter
    Easing easing{};         // of the progress
};

/// The smooth curve through all its points (spline.h), at least one.
struct SplinePath {
    std::vector<ControlPoint> points;
    bool even_pace = false;
    Easing easing{};
};

/// Where an object was during a stretch of scene time: a Bezier curve fitted to its path
/// (path_fit.h), so that the camera does not jolt where the object was struck. `to` before `from`
/// goes backwards.
struct AlongPath {
    std::string object;
    double from = 0;  // scene time, s
    double to = 1;
    Vec3 offset{0, 0, 0};
    bool even_pace = false;
    Easing easing{};
};

/// The place of an object at the frame's own scene time.
struct FollowPath {
    std::string object;
    Vec3 offset{0, 0, 0};
    double smoothing = 0;   // s, width of the window the object's path is averaged over
    double look_ahead = 0;  // s of scene time by which the place is ahead of the frame
};

/// An arc of an ellipse: centre + cos(angle) a + sin(angle) b, where a and b are `radii` along x
/// and y, both turned by `turn`. The centre is a place or follows an object.
struct OrbitPath {
    std::variant<ControlPoint, FollowPath> around;
    Vec2 radii{1, 1};  // m
    double start_angle = 0;
    double end_angle = 6.283185307179586;
    Quat turn;
    bool even_pace = false;
    Easing easing{};
};

using CameraPath = std::variant<BezierPath, SplinePath, AlongPath, FollowPath, OrbitPath>;

/// A value that goes from start to end over the rig's stretch.
template <class T>
struct Eased {
    T start{};
    T end{};
    Easing easing{};
};

/// What the lens is focused on: a distance in metres, the plane through an object's centre, or
/// (empty name) the target. Distances are along the optical axis.
struct Focus {
    std::optional<double> distance;
    std::string object;
};

/// Lens radius in metres, or an f-number (lens radius = focal length / (2 N); where the rig gives
/// no focal length it follows from the field of view and the sensor).
struct Aperture {
    double value = 0;
    bool is_f_number = false;
};

/// The scene's seconds per second of film at a time of the film.
struct SpeedKey {
    Rational video_time;  // s
    Rational speed;       // negative: backwards
};

/// Which scene time each video time shows. Straight from `scene_start` at the rig's start to
/// `scene_end` at its end: a shorter stretch is slow motion, equal ends freeze, descending
/// reverses. Or, with speeds, from `scene_start` on at those (`scene_end` does not count): between
/// two keys the speed changes evenly or gently, before the first and after the last it stays.
struct TimeMap {
    Rational scene_start;
    Rational scene_end;
    std::vector<SpeedKey> speeds{};  // in strictly increasing time
    bool gentle = false;             // speeds follow the smooth step, else they change evenly
};

struct CameraRig {
    std::string name;
    Rational video_start;  // s
    Rational video_end;    // s, > video_start
    Rational fade;         // s, >= 0: over its first seconds it takes the picture over from the rig
                           // before, which must end when these are over
    TimeMap time_map;
    CameraPath position;
    CameraPath target;
    Eased<double> vertical_fov{0.7, 0.7};         // rad
    std::optional<Eased<double>> focal_length{};  // m, instead of vertical_fov
    double sensor_height = 0.024;                 // m, full frame
    Eased<Focus> focus;
    Eased<Aperture> aperture;
    Eased<double> roll{0, 0};  // rad
    Eased<Vec3> up{{0, 0, 1}, {0, 0, 1}};
    Eased<int> blades{0, 0};    // 0: round, else >= 3; between two counts the nearest
    double blade_rotation = 0;  // rad
    /// The part of its way that it films, in shares: [0, 1] is all of it, [1, 0] all of it
    /// backwards.
    Rational way_start{0};
    Rational way_end{1};
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
