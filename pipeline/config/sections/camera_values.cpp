#include "pipeline/config/sections/camera_values.h"

#include "pipeline/config/sections/occurrences.h"
#include "pipeline/config/sections/sections.h"

namespace carom::pipeline::config {

namespace {

constexpr double kMostRounds = 100;  // turns of an orbit
constexpr double kTurn = 6.283185307179586;

const MapSpec<ControlPoint>& control_point_spec() {
    static const MapSpec<ControlPoint> spec = [] {
        MapSpec<ControlPoint> s("control point", "The position of an object at a scene time.");
        s.key("of", &ControlPoint::of, name_of(ReferenceKind::moving), "the ball or object")
            .required();
        s.key("at", &ControlPoint::at, scene_time(), "scene time, as a number or a moment")
            .required();
        s.key("offset", &ControlPoint::offset, vector3(Dimension::length),
              "offset that is added to the position, in world axes");
        return s;
    }();
    return spec;
}

ControlPoint fixed_point(const Vec3& point) {
    ControlPoint result;
    result.offset = point;
    return result;
}

ValueType<ControlPoint> control_point() {
    const auto fixed = convert<ControlPoint>(vector3(Dimension::length), fixed_point);
    return any_of<ControlPoint>({{is_list, fixed}, {is_map, record(control_point_spec())}});
}

using Centre = std::variant<ControlPoint, FollowPath>;

/// The centre of an orbit: a point, or an object that the orbit follows.
ValueType<Centre> centre() {
    const auto place =
        convert<Centre>(control_point(), [](const ControlPoint& point) -> Centre { return point; });
    const auto object =
        convert<Centre>(name_of(ReferenceKind::moving), [](std::string name) -> Centre {
            FollowPath follow;
            follow.object = std::move(name);
            return follow;
        });
    return any_of<Centre>({{is_scalar, object}, {is_list, place}, {is_map, place}});
}

/// One radius, or two radii along x and y.
ValueType<Vec2> radii() {
    const auto one =
        convert<Vec2>(length(above_up_to(0, 1000)), [](double r) { return Vec2(r, r); });
    return any_of<Vec2>(
        {{is_scalar, one}, {is_list, vector2(Dimension::length, above_up_to(0, 1000))}});
}

struct Angles {
    double start = 0;
    double end = kTurn;
};

ValueType<Angles> angles() {
    return convert<Angles>(list_of(angle(between(-kMostRounds * kTurn, kMostRounds * kTurn)), 2, 2),
                           [](const std::vector<double>& ends) {
                               return Angles{ends[0], ends[1]};
                           });
}

/// The contents of a path's map.
struct PathKeys {
    std::optional<std::vector<ControlPoint>> bezier;
    std::optional<std::vector<ControlPoint>> spline;
    std::optional<std::string> along;
    std::optional<std::string> follow;
    std::optional<Centre> orbit;
    bool even_pace = false;
    Easing easing;
    double from = 0;
    double to = 0;
    Vec2 radii{1, 1};
    Angles angles;
    Quat turn;
    Vec3 offset{0, 0, 0};
    double smoothing = 0;
    double look_ahead = 0;
};

const MapSpec<PathKeys>& path_spec() {
    static const MapSpec<PathKeys> spec = [] {
        MapSpec<PathKeys> s("path", "The path of a camera or of its target.");
        const std::vector<std::string> curves{"bezier", "spline", "along", "orbit"};
        s.key("bezier", &PathKeys::bezier, list_of(control_point(), 1, 64),
              "control points of a Bezier curve: points, or {of, at, offset}");
        s.key("spline", &PathKeys::spline, list_of(control_point(), 1, 256),
              "points that a smooth curve passes through, written like those of `bezier`");
        s.key("along", &PathKeys::along, name_of(ReferenceKind::moving),
              "a Bezier curve fitted to the path of this ball or object from `from` to `to`");
        s.key("follow", &PathKeys::follow, name_of(ReferenceKind::moving),
              "the position of a ball or object as it moves");
        s.key("orbit", &PathKeys::orbit, centre(),
              "a circle or ellipse around a point, {of, at, offset}, or a ball or object as it "
              "moves");
        s.key("pace", &PathKeys::even_pace, choice<bool>({{"time", false}, {"even", true}}),
              "speed along the curve; `even`: constant speed")
            .goes_with(curves);
        s.key("easing", &PathKeys::easing, easing(),
              "easing of the motion along the curve, as for values that change")
            .goes_with(curves);
        s.key("from", &PathKeys::from, scene_time(),
              "start scene time of `along`, as a number or a moment")
            .needed_by("along");
        s.key("to", &PathKeys::to, scene_time(),
              "end scene time of `along`; if it is before `from`, the path runs backwards")
            .needed_by("along");
        s.key("radius", &PathKeys::radii, radii(),
              "radius of the `orbit`, or two radii along x and y")
            .needed_by("orbit");
        s.key("angles", &PathKeys::angles, angles(),
              "start and end angle of the `orbit`, from x towards y. The default is one revolution")
            .goes_with({"orbit"});
        s.key("turn", &PathKeys::turn, rotation(),
              "rotation of the plane of the `orbit`: angles about x, y and z, or {axis, angle}")
            .goes_with({"orbit"});
        s.key("offset", &PathKeys::offset, vector3(Dimension::length),
              "offset from the object (`follow`, `along`) or from the centre (`orbit`), in world "
              "axes")
            .goes_with({"follow", "along", "orbit"});
        s.key("smoothing", &PathKeys::smoothing, time(between(0, 60)),
              "length of the time window over which the followed path is averaged")
            .goes_with({"follow", "orbit"});
        s.key("look_ahead", &PathKeys::look_ahead, time(between(-60, 60)),
              "scene time by which the position is ahead of the frame")
            .goes_with({"follow", "orbit"});
        s.exactly_one_of({"bezier", "spline", "along", "follow", "orbit"});
        return s;
    }();
    return spec;
}

CameraPath to_orbit(const PathKeys& keys) {
    OrbitPath path;
    path.around = *keys.orbit;
    if (auto* follow = std::get_if<FollowPath>(&path.around)) {
        *follow = {follow->object, keys.offset, keys.smoothing, keys.look_ahead};
    } else {
        std::get<ControlPoint>(path.around).offset += keys.offset;
    }
    path.radii = keys.radii;
    path.start_angle = keys.angles.start;
    path.end_angle = keys.angles.end;
    path.turn = keys.turn;
    path.even_pace = keys.even_pace;
    path.easing = keys.easing;
    return path;
}

CameraPath to_path(const PathKeys& keys) {
    if (keys.follow) {
        return FollowPath{*keys.follow, keys.offset, keys.smoothing, keys.look_ahead};
    }
    if (keys.along) {
        return AlongPath{*keys.along, keys.from, keys.to, keys.offset, keys.even_pace, keys.easing};
    }
    if (keys.orbit) {
        return to_orbit(keys);
    }
    if (keys.spline) {
        return SplinePath{*keys.spline, keys.even_pace, keys.easing};
    }
    return BezierPath{keys.bezier.value_or(std::vector<ControlPoint>{ControlPoint{}}),
                      keys.even_pace, keys.easing};
}

}  // namespace

ValueType<Easing> easing() {
    const auto word = choice<Easing>({{"linear", Easing::linear}, {"smooth", Easing::smooth}});
    const auto curve_type = list_of(number(between(-10, 10)), 4, 4);
    ValueType<Easing> curve;
    curve.info = curve_type.info;
    curve.read = [curve_type](Reader& reader, const Node& node) -> std::optional<Easing> {
        const auto values = curve_type.read(reader, node);
        if (!values) {
            return std::nullopt;
        }
        for (const std::size_t i : {0, 2}) {
            if ((*values)[i] < 0 || (*values)[i] > 1) {
                reader.error(node.items[i].place, "an easing's x1 and x2 must be between 0 and 1");
                return std::nullopt;
            }
        }
        const auto& v = *values;
        return Easing(v[0], v[1], v[2], v[3]);
    };
    return any_of<Easing>({{is_scalar, word}, {is_list, curve}});
}

ValueType<CameraPath> camera_path() {
    const auto fixed =
        convert<CameraPath>(vector3(Dimension::length), [](const Vec3& point) -> CameraPath {
            return BezierPath{{fixed_point(point)}, false, {}};
        });
    return any_of<CameraPath>(
        {{is_map, convert<CameraPath>(record(path_spec()), to_path)}, {is_list, fixed}});
}

}  // namespace carom::pipeline::config
