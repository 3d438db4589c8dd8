// A camera's path and lens during an interval of video time, as the shot describes them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/vectors.h"
#include "pipeline/camera/camera_sound.h"
#include "pipeline/camera/lens.h"
#include "pipeline/camera/rational.h"

namespace carom::pipeline {

/// A point, or an object's position at a scene time, plus an offset in world axes.
struct ControlPoint {
    Vec3 offset{0, 0, 0};
    std::string of;  // object; empty: `offset` is the point itself
    double at = 0;   // scene time, s
};

/// How a value changes from its start to its end: linearly, by the smooth step, or along the cubic
/// Bezier curve (0, 0), (x1, y1), (x2, y2), (1, 1) of value over time, with x1 and x2 in [0, 1].
struct Easing {
    enum Kind { linear, smooth, bezier };
    Kind kind = linear;
    double x1 = 0, y1 = 0, x2 = 1, y2 = 1;  // bezier only

    /// Implicit, so that `Easing::smooth` is an easing.
    constexpr Easing(Kind without_points = linear) : kind(without_points) {}
    constexpr Easing(double ax, double ay, double bx, double by)
        : kind(bezier), x1(ax), y1(ay), x2(bx), y2(by) {}

    bool operator==(const Easing&) const = default;
};

/// A Bezier curve of any degree >= 0 (one point: a fixed position).
struct BezierPath {
    std::vector<ControlPoint> points;
    bool even_pace = false;  // progress by arc length instead of by the curve's parameter
    Easing easing{};         // of the progress
};

/// The smooth curve through all of its points (spline.h); there is at least one.
struct SplinePath {
    std::vector<ControlPoint> points;
    bool even_pace = false;
    Easing easing{};
};

/// A Bezier curve fitted to an object's path during an interval of scene time (path_fit.h), so that
/// the camera does not jolt where the object was struck. If `to` is before `from`, the path runs
/// backwards.
struct AlongPath {
    std::string object;
    double from = 0;  // scene time, s
    double to = 1;
    Vec3 offset{0, 0, 0};
    bool even_pace = false;
    Easing easing{};
};

/// The position of an object at the frame's own scene time.
struct FollowPath {
    std::string object;
    Vec3 offset{0, 0, 0};
    double smoothing = 0;   // s, width of the window over which the path is averaged
    double look_ahead = 0;  // s of scene time by which the position is ahead of the frame
};

/// An arc of an ellipse: centre + cos(angle) a + sin(angle) b, where a and b are `radii` along x
/// and y, both rotated by `turn`. The centre is a fixed point or follows an object.
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

/// A value at one time of the film, in the times of CameraRig::written.
template <class T>
struct ValueKey {
    Rational video_time;  // s
    T value{};
};

/// A value that changes from start to end over the rig's interval of video time, or from key to
/// key. With keys, `start` and `end` are those of the first and the last key: the value is constant
/// before the first key and after the last, and each change between two keys is eased.
template <class T>
struct Eased {
    T start{};
    T end{};
    Easing easing{};
    std::vector<ValueKey<T>> keys{};  // none, or in strictly increasing time
};

/// The plane of focus: at a distance in metres, through an object's centre, or (empty name) through
/// the target. Distances are along the optical axis.
struct Focus {
    std::optional<double> distance;
    std::string object;
};

/// Lens radius in metres, or an f-number (lens radius = focal length / (2 N); if the rig has no
/// focal length, it follows from the field of view and the sensor).
struct Aperture {
    double value = 0;
    bool is_f_number = false;
};

/// Seconds of scene time per second of film, at one time of the film.
struct SpeedKey {
    Rational video_time;  // s
    Rational speed;       // negative: time runs backwards
};

/// Maps video time to scene time. Without speeds the map is linear, from `scene_start` at the rig's
/// start to `scene_end` at its end: a shorter interval is slow motion, equal ends freeze time, and
/// descending ends reverse it. With speeds, scene time starts at `scene_start` and passes at these
/// speeds (`scene_end` is ignored): the speed changes linearly or by the smooth step between two
/// keys, and is constant before the first and after the last.
struct TimeMap {
    Rational scene_start;
    Rational scene_end;
    std::vector<SpeedKey> speeds{};  // in strictly increasing time
    bool is_smooth = false;          // speeds change by the smooth step, else linearly
};

/// Which side of the picture `fov` and the sensor's size belong to; wider: the longer one.
enum class FovAxis { vertical, horizontal, wider };

/// The movement of a camera that a person holds: noise in a band of frequencies, which depends on
/// nothing but the time and the seed (shake.h).
struct Shake {
    double strength = 0.3 * 0.017453292519943295;  // rad, root mean square of pan and of tilt
    double frequency = 1;                          // Hz, of the main movement
    std::uint64_t seed = 1;
};

/// Points that are inside the picture at all times: the camera moves along its axis until it is as
/// near as possible.
struct Framing {
    std::vector<Vec3> points;
    double margin = 0.05;  // part of the picture that is free at each edge, in [0, 0.5)
};

/// An interval of video time, s.
struct FilmInterval {
    Rational start;
    Rational end;
};

/// The picture's up direction at a place of a rig's path.
struct UprightKey {
    double done = 0;        // Progress::done
    Vec3 ahead{0, 1, 0};    // unit, along the view
    Vec3 upright{0, 0, 1};  // unit, at right angles to it
};

/// A part of a rig's path on which the view passes by the axis of `up` (steady_up.h).
struct UpTurn {
    std::vector<UprightKey> keys;  // in order of `done`; at least two
    double roll = 0;               // rad, about the view, from the first key to the last
    bool is_over = false;  // after it, the picture's upper edge follows the opposite of `up`
};

struct CameraRig {
    std::string name;
    Rational video_start;  // s
    Rational video_end;    // s, > video_start
    Rational fade;  // s, >= 0, duration of the cross-fade from the previous rig at the start;
                    // the previous rig must end when the fade ends
    TimeMap time_map;
    CameraPath position;
    CameraPath target;
    Eased<double> fov{0.7, 0.7};                  // rad, of the side that fov_axis names
    std::optional<Eased<double>> focal_length{};  // m, instead of fov
    double sensor_height = 0.024;                 // m, full frame; always of the vertical side
    FovAxis fov_axis = FovAxis::vertical;
    double aspect = 16.0 / 9;  // width / height of the picture, for fov_axis and framing
    Eased<Focus> focus;
    Eased<Aperture> aperture;
    Eased<double> roll{0, 0};  // rad
    Eased<Vec3> up{{0, 0, 1}, {0, 0, 1}};
    Eased<int> blades{0, 0};    // 0: round, else >= 3; rounded while it changes
    double blade_rotation = 0;  // rad
    Lens lens{};
    std::optional<Framing> framing{};
    std::optional<Shake> shake{};
    /// The part of its path that the rig films, as fractions: [0, 1] is the whole path, [1, 0] the
    /// whole path backwards.
    Rational path_start{0};
    Rational path_end{1};
    /// The interval of video time of the whole path, to which keys of values and the shake refer.
    /// Empty: [video_start, video_end]. A rig that was retimed or cut keeps that of the rig from
    /// which it was made, so that its keys and its shake stay with its path.
    std::optional<FilmInterval> written{};
    /// Where the up direction is carried along the path instead of following `up` (steady_up.h).
    /// Empty: not known yet. They belong to the whole path, so a rig that was retimed or cut keeps
    /// them.
    std::optional<std::vector<UpTurn>> up_turns{};
    CameraSound sound{};
};

/// The clock that measures the exposure. video: the time map converts the exposure to scene time,
/// so slow motion has less blur. scene: objects blur as in real time at any speed of the map, and
/// not at all in frozen time; the camera, which moves in video time, blurs for the same number of
/// seconds of video time.
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
