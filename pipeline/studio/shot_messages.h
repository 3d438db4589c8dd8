// What the server says of a shot: its problems, and what the page draws and edits. messages.h says
// how the messages are sent.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/studio/message_values.h"

namespace carom::studio {

struct Problem {
    std::string severity{};  // "error" or "warning"
    TextRange place{};
    std::string key_path{};
    std::string message{};
    std::string suggestion{};  // what was probably meant in the place's stead, or empty
    std::vector<TextRange> included_by{};
};

/// All problems of a version, sorted as `carom check` sorts them. Those of the motion follow after
/// the bake (`complete`).
struct Problems {
    static constexpr const char* kName = "problems";
    std::int64_t v = 0;
    bool complete = false;
    std::vector<Problem> list{};
};

/// Where a value comes from. The plain values in a list have no place of their own: they come from
/// where the list does. The values of repeated objects have none either, apart from those that are
/// given for one of them.
struct ValuePlace {
    KeyPath path{};
    TextRange key{};       // of its key; line 0 in lists
    TextRange value{};     // of the value; of a map or list its first character
    std::string origin{};  // "shot", "include" (a writable file), "config" (a file of carom's),
                           // "set" (an option)
};

/// A ball or an object of the scene.
struct SceneObject {
    std::string name{};
    std::string kind{};                  // "ball", "object", "table"
    KeyPath path{};                      // where it is, or would be, in the shot: ["balls", "nine"]
    std::string shape{};                 // "sphere", "box" ...
    bool moves = false;                  // has a track in the timeline; else it rests at this pose
    std::optional<std::string> track{};  // of the timeline, if it has not the object's name
    Triple position{};                   // at the start, of the origin of its axes
    Turn orientation{1, 0, 0, 0};
    double radius = 0;            // of a ball
    std::optional<int> number{};  // on a ball
    Triple colour{};              // linear, of its material, for outlines and trails
    std::string material{};
};

struct SceneLight {
    std::string name{};
    std::string kind{};  // "point", "spot", "directional", "rectangle", "sphere", "environment"
    KeyPath path{};
    Triple position{};
    Triple facing{};
    Turn orientation{1, 0, 0, 0};  // of a rectangle: its edges along x and y, it shines along z
    Triple colour{};               // linear, its largest component 1
    std::vector<double>
        size;  // rectangle: width, height; sphere: radius; spot: inner and outer half angle
};

/// One point of a path, as a handle to drag.
struct PathPoint {
    KeyPath path{};     // of the point in the shot, or of the offset that moves it
    Triple position{};  // in the world
    std::string of{};   // an object to which the point is relative, or empty
    double at = 0;      // the scene time of that object
    Triple offset{};    // what is written: at `path`, or at its `offset` if the path is that of a
                        // point relative to an object
};

/// The ellipse of an orbit around its one point.
struct Orbit {
    std::array<double, 2> radii{};   // along x and y
    std::array<double, 2> angles{};  // at its start and end, from x towards y
    Turn turn{1, 0, 0, 0};           // of its plane
};

struct PathShape {
    std::string kind{};  // "bezier" (also a fixed point), "spline", "along", "follow", "orbit"
    std::optional<Orbit> orbit{};
    std::vector<PathPoint> points{};
    std::vector<double> curve{};  // x, y, z of points along it, for a polyline
};

struct SpeedPoint {
    KeyPath path{};
    double video_time = 0;
    double speed = 1;
};

/// A value of a camera's lens at a time of the film.
struct LensKey {
    KeyPath path{};  // of the pair of time and value: ["cameras", "0", "fov", "keys", "1"]
    double video_time = 0;
};

struct Camera {
    std::string name{};
    KeyPath path{};
    double video_start = 0;
    double video_end = 0;
    double fade = 0;
    double scene_start = 0;
    double scene_end = 0;
    std::vector<SpeedPoint> speeds{};  // empty: a linear map from scene_start to scene_end
    bool smooth = false;
    PathShape position{};
    PathShape target{};
    double sensor_height = 0.024;
    double fov_scale = 1;  // tangent of half the vertical field of view / that of half of `fov`
    std::vector<LensKey> lens_keys{};  // of all values that are given by keys
};

/// An event as the shot describes it.
struct ShotEvent {
    KeyPath path{};
    std::string kind{};  // "strike", "force", "torque", "impulse", "velocity", "place", "remove"
    std::string object{};
    double time =
        0;  // scene time of its entry; of its start if a trigger starts it (then from the bake)
    bool triggered = false;
    std::optional<double> duration{};
    Triple vector{};   // force ...; of a strike the horizontal aim, a unit vector; of `place`
                       // the place
    double speed = 0;  // of a strike, m/s
    bool ball_speed = false;  // `speed` is the ball's instead of the stick's
    double elevation = 0;
    std::array<double, 2> tip{};  // offset to the right and up, in radii
    double direction = 0;         // of a strike, counter-clockwise from +x
    std::string toward{};         // of a strike: an object, or empty
};

/// When an annotation appears or disappears.
struct AnnotationEnd {
    double time = 0;
    bool is_scene_time = false;  // else a time of the film
    /// Scene time of the moment that the film shows first at `time`.
    std::optional<double> moment{};
};

/// The rectangle of the film's picture that an annotation fills when it appears, in fractions of
/// its width and height from the upper left corner.
struct AnnotationBox {
    std::array<double, 2> centre{};
    std::array<double, 2> size{};
};

/// Graphics that are drawn into the film.
struct ShotAnnotation {
    KeyPath path{};         // ["annotations", "0"]
    std::string kind{};     // its key: "path", "text" ...
    std::string subject{};  // the names of what it is about: "cue", "cue, one"; or empty
    std::string text{};     // of texts, titles and labels, as the shot writes it
    std::optional<AnnotationEnd> from{}, to{};  // none: always
    std::optional<AnnotationBox> box{};         // of one on the picture that draws something
};

/// The straight part of a cushion, on the line that the foremost point of a ball touches. The
/// playing field is on the left of from -> to.
struct CushionNose {
    std::array<double, 2> from{};
    std::array<double, 2> to{};
};

struct TablePocket {
    std::string name{};  // "corner_left_front" ...
    std::array<double, 2> place{};
    double radius = 0;  // of the hole
};

/// A table, for drawing aids: the ghost ball, the first rebound.
struct Table {
    double length = 0;  // between the noses
    double width = 0;
    double cushion_height = 0;
    double ball_radius = 0;
};

struct Film {
    int width = 0;
    int height = 0;
    double fps = 24;
    std::int64_t frames = 0;
    double duration = 0;
    int samples = 0;
};

/// Names to choose from.
struct Names {
    std::vector<std::string> balls{}, objects{}, materials{}, lights{}, cameras{}, surfaces{},
        spots{}, pockets{};
};

/// What the page draws and edits, of one version. Of a version with errors there is none.
struct ShotState {
    static constexpr const char* kName = "shot";
    std::int64_t v = 0;
    bool moves{};  // the motion of this version follows at once, to be shown together with it
    std::string name{};
    Film film{};
    std::optional<Table> table{};
    std::vector<CushionNose> noses{};    // of the table's cushions
    std::vector<TablePocket> pockets{};  // of the table
    std::vector<SceneObject> objects{};
    std::vector<SceneLight> lights{};
    std::vector<Camera> cameras{};
    std::vector<ShotEvent> events{};
    std::vector<ShotAnnotation> annotations{};
    Names names{};
    std::vector<ValuePlace> places{};
};

/// The meshes of a version: GET /scene/HASH.glb. Sent with every version that is shown; the meshes
/// are others only if the hash is. Nodes are named as in
/// ShotState; their transformations are those of the start and replaced by the page.
struct SceneMeshes {
    static constexpr const char* kName = "scene";
    std::int64_t v = 0;
    std::string hash{};
};

/// The motion of this version is not simulated yet.
struct Deferred {
    static constexpr const char* kName = "deferred";
    std::int64_t v = 0;
    std::string reason{};  // "dragging": it follows within a second, or when the drag ends, because
                           // simulating this shot takes long; "limit": only after Simulate
    std::string message{};  // a sentence for the user
};

}  // namespace carom::studio
