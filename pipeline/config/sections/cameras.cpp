#include <memory>

#include "pipeline/config/sections/sections.h"

namespace carom::pipeline::config {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kLongest = 3600;  // s

const MapSpec<ControlPoint>& control_point_spec() {
    static const MapSpec<ControlPoint> spec = [] {
        MapSpec<ControlPoint> s("control point", "An object's place at a scene time.");
        s.key("of", &ControlPoint::of, name_of(ReferenceKind::body), "the ball or object")
            .required();
        s.key("at", &ControlPoint::at, time(between(0, kLongest)), "scene time").required();
        s.key("offset", &ControlPoint::offset, vector3(Dimension::length),
              "added to the place, world axes");
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

/// What a path's map says.
struct PathKeys {
    std::optional<std::vector<ControlPoint>> bezier;
    bool even_pace = false;
    std::optional<std::string> follow;
    Vec3 offset{0, 0, 0};
    double smoothing = 0;
};

void check_path(Reader& reader, const Node& node, PathKeys& /*keys*/) {
    const auto refuse = [&](const char* key, const char* needed) {
        if (node.find(key) != nullptr && node.find(needed) == nullptr) {
            reader.error(node.find(key)->key_place,
                         std::string("'") + key + "' has no meaning without '" + needed + "'");
        }
    };
    refuse("pace", "bezier");
    refuse("offset", "follow");
    refuse("smoothing", "follow");
}

const MapSpec<PathKeys>& path_spec() {
    static const MapSpec<PathKeys> spec = [] {
        MapSpec<PathKeys> s("path", "Where a camera or its target goes.");
        s.key("bezier", &PathKeys::bezier, list_of(control_point(), 1, 64),
              "control points of a Bezier curve: points, or {of, at, offset}");
        s.key("pace", &PathKeys::even_pace, choice<bool>({{"time", false}, {"even", true}}),
              "`even`: at constant speed along the curve");
        s.key("follow", &PathKeys::follow, name_of(ReferenceKind::body),
              "stay with a ball or object instead");
        s.key("offset", &PathKeys::offset, vector3(Dimension::length),
              "from the followed object, world axes");
        s.key("smoothing", &PathKeys::smoothing, time(between(0, 60)),
              "width of the window that its path is averaged over");
        s.exactly_one_of({"bezier", "follow"});
        s.check(check_path);
        return s;
    }();
    return spec;
}

CameraPath to_path(const PathKeys& keys) {
    if (keys.follow) {
        return FollowPath{*keys.follow, keys.offset, keys.smoothing};
    }
    return BezierPath{keys.bezier.value_or(std::vector<ControlPoint>{ControlPoint{}}),
                      keys.even_pace};
}

/// A map, or one fixed point.
ValueType<CameraPath> path() {
    const auto fixed =
        convert<CameraPath>(vector3(Dimension::length), [](const Vec3& point) -> CameraPath {
            return BezierPath{{fixed_point(point)}, false};
        });
    return any_of<CameraPath>(
        {{is_map, convert<CameraPath>(record(path_spec()), to_path)}, {is_list, fixed}});
}

/// One value, [start, end], or {from, to, easing}.
template <class V>
ValueType<Eased<V>> eased(const std::string& key, ValueType<V> single) {
    const auto spec = std::make_shared<MapSpec<Eased<V>>>(
        "changing " + key, "A value that changes over the camera's stretch of the film.");
    spec->key("from", &Eased<V>::start, single, "at the start").required();
    spec->key("to", &Eased<V>::end, single, "at the end").required();
    spec->key("easing", &Eased<V>::easing,
              choice<Easing>({{"linear", Easing::linear}, {"smooth", Easing::smooth}}),
              "`smooth` starts and ends gently");
    const auto constant = convert<Eased<V>>(single, [](const V& value) {
        return Eased<V>{value, value, Easing::linear};
    });
    const auto pair = convert<Eased<V>>(list_of(single, 2, 2), [](const std::vector<V>& values) {
        return Eased<V>{values[0], values[1], Easing::linear};
    });
    ValueType<Eased<V>> map;
    map.info.kind = TypeInfo::Kind::map;
    map.info.map = &spec->info();
    map.read = [spec](Reader& reader, const Node& node) -> std::optional<Eased<V>> {
        Eased<V> value;
        spec->read(reader, node, value);
        return value;
    };
    ValueType<Eased<V>> result =
        any_of<Eased<V>>({{is_scalar, constant}, {is_list, pair}, {is_map, map}});
    result.info.noun = "changing";
    result.show = [single](const Eased<V>& value) {
        return single.show ? single.show(value.start) : std::string();
    };
    return result;
}

ValueType<Focus> focus() {
    const auto distance = convert<Focus>(length(above_up_to(0, 1e6)), [](double value) {
        Focus result;
        result.distance = value;
        return result;
    });
    const auto on_target =
        convert<Focus>(choice<bool>({{"auto", true}}), [](bool) { return Focus{}; });
    const auto on_object = convert<Focus>(name_of(ReferenceKind::body), [](std::string name) {
        Focus result;
        result.object = std::move(name);
        return result;
    });
    const auto is_auto = [](const Node& node) { return node.is_scalar() && node.text == "auto"; };
    ValueType<Focus> result =
        any_of<Focus>({{is_number, distance}, {is_auto, on_target}, {is_scalar, on_object}});
    result.show = [](const Focus&) { return std::string("auto"); };
    return result;
}

ValueType<Aperture> lens_radius() {
    ValueType<Aperture> result = convert<Aperture>(length(between(0, 10)), [](double value) {
        return Aperture{value, false};
    });
    result.show = [](const Aperture& value) { return show(value.value, Dimension::length); };
    return result;
}

ValueType<Aperture> f_number() {
    return convert<Aperture>(number(between(0.1, 1000)), [](double value) {
        return Aperture{value, true};
    });
}

struct Stretch {
    Rational start;
    Rational end;
};

ValueType<Stretch> stretch() {
    return convert<Stretch>(list_of(exact(Dimension::time, between(0, kLongest)), 2, 2),
                            [](const std::vector<Rational>& ends) {
                                return Stretch{ends[0], ends[1]};
                            });
}

/// Two scene times, or one at which time stands still.
ValueType<Stretch> scene_stretch() {
    const auto freeze =
        convert<Stretch>(exact(Dimension::time, between(0, kLongest)), [](const Rational& t) {
            return Stretch{t, t};
        });
    return any_of<Stretch>({{is_list, stretch()}, {is_scalar, freeze}});
}

void add_time(MapSpec<CameraRig>& s) {
    s.key("name", &CameraRig::name, text("a camera's name"), "for messages and frames' metadata");
    s.set(
         "video", stretch(),
         [](CameraRig& rig, const Stretch& value) {
             rig.video_start = value.start;
             rig.video_end = value.end;
         },
         "its stretch of the film: start and end in video time")
        .required();
    s.set(
         "scene", scene_stretch(),
         [](CameraRig& rig, const Stretch& value) {
             rig.time_map = {value.start, value.end};
         },
         "scene times shown at its start and end; the second before the first is reverse; one "
         "time is a freeze")
        .required();
}

void add_lens(MapSpec<CameraRig>& s) {
    s.key("fov", &CameraRig::vertical_fov, eased("fov", angle(inside(0, kPi))),
          "vertical field of view: one value, [start, end] or {from, to, easing}");
    s.key("focus", &CameraRig::focus, eased("focus", focus()),
          "a distance, `auto` (the target) or a ball or object; like fov");
    s.key("aperture", &CameraRig::aperture, eased("aperture", lens_radius()),
          "radius of the lens; 0: everything is sharp; like fov");
    s.set(
        "f_number", eased("f_number", f_number()),
        [](CameraRig& rig, const Eased<Aperture>& value) { rig.aperture = value; },
        "instead of `aperture`: focal length / (2 radius) on a sensor 24 mm high");
    s.key("blades", &CameraRig::blades, integer(0, 64), "of the iris: 0 (round) or at least 3");
    s.key("blade_rotation", &CameraRig::blade_rotation, angle(), "turn of the iris");
    s.at_most_one_of({"aperture", "f_number"});
}

void check_camera(Reader& reader, const Node& node, CameraRig& rig) {
    if (const Entry* video = node.find("video")) {
        if (!(rig.video_start < rig.video_end) && video->value.items.size() == 2) {
            reader.error(video->value.place,
                         "'video' must end after it starts in " + reader.label());
        }
    }
    if (rig.blades == 1 || rig.blades == 2) {
        reader.error(node.find("blades")->value.place, "'blades' must be 0 (round) or at least 3");
    }
    if (rig.up.length() < 1e-9) {
        reader.error(node.find("up")->value.place, "'up' must have a length");
    }
}

}  // namespace

const MapSpec<CameraRig>& camera_spec() {
    static const MapSpec<CameraRig> spec = [] {
        MapSpec<CameraRig> s("camera", "A camera's way over a stretch of the film.");
        add_time(s);
        s.key("position", &CameraRig::position, path(), "where it stands: a point or a path")
            .required();
        s.key("target", &CameraRig::target, path(), "what it looks at: a point or a path")
            .required();
        add_lens(s);
        s.key("roll", &CameraRig::roll, eased("roll", angle()), "turn about its axis; like fov");
        s.key("up", &CameraRig::up, vector3(Dimension::none), "which way is up in the picture");
        s.check(check_camera);
        return s;
    }();
    return spec;
}

}  // namespace carom::pipeline::config
