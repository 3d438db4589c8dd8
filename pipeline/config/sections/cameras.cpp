#include <algorithm>
#include <numbers>

#include "pipeline/config/sections/camera_aids.h"
#include "pipeline/config/sections/camera_sound.h"
#include "pipeline/config/sections/camera_values.h"
#include "pipeline/config/sections/lens.h"
#include "pipeline/config/sections/occurrences.h"
#include "pipeline/config/sections/sections.h"
#include "pipeline/config/show_quantity.h"
#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace {

constexpr double kLongest = 3600;  // s

ValueType<Focus> focus() {
    const auto distance = convert<Focus>(length(above_up_to(0, 1e6)), [](double value) {
        Focus result;
        result.distance = value;
        return result;
    });
    const auto on_target =
        convert<Focus>(choice<bool>({{"auto", true}}), [](bool) { return Focus{}; });
    const auto on_object = convert<Focus>(name_of(ReferenceKind::moving), [](std::string name) {
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

/// Reports a lens radius without a unit, which is probably an f-number. False for other values.
bool report_radius_without_unit(Reader& reader, const Node& node) {
    const auto parsed = parse_quantity(node.text);
    const auto* value = std::get_if<Quantity>(&parsed);
    if (!node.is_scalar() || value == nullptr || value->has_unit || value->value == 0) {
        return false;
    }
    reader.error(node.place,
                 reader.value_name() + " is the radius of the lens and needs a unit; write " +
                     quote(node.text + " mm") + " (an f-number is given as 'f_number')");
    return true;
}

ValueType<Aperture> lens_radius() {
    ValueType<Aperture> result = convert<Aperture>(lens_length(between(0, 10)), [](double value) {
        return Aperture{value, false};
    });
    result.read = [read = result.read](Reader& reader,
                                       const Node& node) -> std::optional<Aperture> {
        return report_radius_without_unit(reader, node) ? std::nullopt : read(reader, node);
    };
    result.show = [](const Aperture& value) { return show(value.value, Dimension::length); };
    return result;
}

ValueType<Aperture> f_number() {
    return convert<Aperture>(number(between(0.1, 1000)), [](double value) {
        return Aperture{value, true};
    });
}

struct TimeRange {
    Rational start;
    Rational end;
};

ValueType<TimeRange> range_of(const ValueType<Rational>& time) {
    return convert<TimeRange>(list_of(time, 2, 2), [](const std::vector<Rational>& ends) {
        return TimeRange{ends[0], ends[1]};
    });
}

ValueType<TimeMap> linear_map() {
    return convert<TimeMap>(range_of(exact_scene_time()), [](const TimeRange& ends) {
        return TimeMap{ends.start, ends.end};
    });
}

/// A pair of film time and speed.
ValueType<SpeedKey> speed_key() {
    return convert<SpeedKey>(value_key(exact(Dimension::none, between(-1000, 1000))),
                             [](const ValueKey<Rational>& key) {
                                 return SpeedKey{key.video_time, key.value};
                             });
}

void check_ramp(Reader& reader, const Node& node, TimeMap& map) {
    for (std::size_t i = 1; i < map.speeds.size(); ++i) {
        if (!(map.speeds[i - 1].video_time < map.speeds[i].video_time)) {
            reader.error(node.find("speeds")->value.items[i].place,
                         "the times of 'speeds' must be in increasing order");
        }
    }
}

const MapSpec<TimeMap>& ramp_spec() {
    static const MapSpec<TimeMap> spec = [] {
        MapSpec<TimeMap> s("speeds", "Scene time that is shown at a changing speed.");
        s.key("from", &TimeMap::scene_start, exact_scene_time(), "scene time at the camera's start")
            .required();
        s.key("speeds", &TimeMap::speeds, list_of(speed_key(), 1, 256),
              "list of [film time, seconds of the scene per second of film]: 1 is real time, 0 "
              "stands still, a negative speed runs backwards")
            .required();
        s.key("easing", &TimeMap::is_smooth, choice<bool>({{"linear", false}, {"smooth", true}}),
              "how the speed changes from one value to the next");
        s.check(check_ramp);
        return s;
    }();
    return spec;
}

/// Two scene times, one scene time at which time stands still, or speeds.
ValueType<TimeMap> time_map() {
    const auto freeze = convert<TimeMap>(exact_scene_time(), [](const Rational& t) {
        return TimeMap{t, t};
    });
    const auto is_one_time = [](const Node& node) { return node.is_scalar() || is_moment(node); };
    return any_of<TimeMap>(
        {{is_list, linear_map()}, {is_one_time, freeze}, {is_map, record(ramp_spec())}});
}

void add_time(MapSpec<CameraRig>& s) {
    // This key is removed before the sections are read (gather.h); it is here for the reference.
    s.set(
        "include", text("the name of a file"), [](CameraRig&, const auto&) {},
        "a file with one camera, such as `rigs/orbit.yaml`, whose keys this camera inherits and "
        "may replace");
    s.key("name", &CameraRig::name, text("a camera's name"),
          "name for messages and for the metadata of frames");
    s.set(
         "video", range_of(exact(Dimension::time, between(0, kLongest))),
         [](CameraRig& rig, const TimeRange& value) {
             rig.video_start = value.start;
             rig.video_end = value.end;
         },
         "interval of the film: start and end in video time")
        .required();
    s.key("scene", &CameraRig::time_map, time_map(),
          "scene times at the start and at the end, as numbers or moments. If the second is before "
          "the first, time runs backwards. One time stands still. Speeds at film times are a speed "
          "ramp")
        .required();
    s.key("fade", &CameraRig::fade, exact(Dimension::time, between(0, kLongest)),
          "duration of the fade-in at the start; the previous camera ends when the fade ends");
}

void add_lens(MapSpec<CameraRig>& s) {
    s.key("fov", &CameraRig::fov, eased("fov", angle(inside(0, std::numbers::pi))),
          "field of view of the picture's height (see `fov_axis`): one value, [start, end], {from, "
          "to, easing} or, at times of the film, {keys, easing}");
    s.key("focal_length", &CameraRig::focal_length,
          eased("focal_length", lens_length(inside(0, 10))),
          "focal length, instead of `fov`; like fov");
    s.key("sensor", &CameraRig::sensor_height, lens_length(inside(0, 10)),
          "height of the camera's sensor (see `fov_axis`), for `focal_length` and `f_number`");
    add_fov_axis(s);
    s.key("focus", &CameraRig::focus, eased("focus", focus()),
          "distance of the plane in focus: a length, `auto` (the target) or a ball or object; like "
          "fov");
    s.key("aperture", &CameraRig::aperture, eased("aperture", lens_radius()),
          "radius of the lens; 0: everything is sharp; like fov");
    s.set(
        "f_number", eased("f_number", f_number()),
        [](CameraRig& rig, const Eased<Aperture>& value) { rig.aperture = value; },
        "instead of `aperture`: focal length / (2 radius)");
    s.key("blades", &CameraRig::blades, eased("blades", integer(0, 64)),
          "number of blades of the iris: 0 (round) or at least 3; like fov, in whole numbers");
    s.key("blade_rotation", &CameraRig::blade_rotation, angle(), "rotation of the iris");
    s.key("lens", &CameraRig::lens, lens(),
          "`clean`, a lens without faults; `prime`, a good modern one; `vintage`; `anamorphic`, "
          "with oval bokeh; `broadcast_zoom`, for sports; or a map of numbers");
    s.at_most_one_of({"aperture", "f_number"});
    s.at_most_one_of({"fov", "focal_length"});
}

/// The values between which a value changes.
template <class V>
std::vector<V> all_values(const Eased<V>& value) {
    std::vector<V> values{value.start, value.end};
    for (const ValueKey<V>& key : value.keys) {
        values.push_back(key.value);
    }
    return values;
}

void check_blades(Reader& reader, const Node& node, const CameraRig& rig) {
    const std::vector<int> blades = all_values(rig.blades);
    const auto is_no_iris = [](int number) { return number != 0 && number < 3; };
    const auto is_other_kind = [&](int number) { return (number == 0) != (blades[0] == 0); };
    if (std::any_of(blades.begin(), blades.end(), is_no_iris)) {
        reader.error(node.find("blades")->value.place, "'blades' must be 0 (round) or at least 3");
    } else if (std::any_of(blades.begin(), blades.end(), is_other_kind)) {
        reader.error(node.find("blades")->value.place,
                     "'blades' cannot change between 0 (a round iris) and a number of blades");
    }
}

/// Warns of keys of values outside of the camera's interval of the film.
void check_key_times(Reader& reader, const Node& node, const CameraRig& rig) {
    const auto check = [&](const char* key, const auto& value) {
        warn_about_unreached_keys(reader, node, rig, key, times_of(value.keys));
    };
    check("fov", rig.fov);
    if (rig.focal_length) {
        check("focal_length", *rig.focal_length);
    }
    check("focus", rig.focus);
    check("aperture", rig.aperture);
    check("f_number", rig.aperture);
    check("blades", rig.blades);
    check("roll", rig.roll);
    check("up", rig.up);
}

void check_camera(Reader& reader, const Node& node, CameraRig& rig) {
    if (const Entry* video = node.find("video")) {
        if (!(rig.video_start < rig.video_end) && video->value.items.size() == 2) {
            reader.error(video->value.place,
                         "'video' must end after it starts in " + reader.label());
        }
    }
    check_blades(reader, node, rig);
    const std::vector<Vec3> ups = all_values(rig.up);
    if (std::any_of(ups.begin(), ups.end(), [](const Vec3& up) { return up.length() < 1e-9; })) {
        reader.error(node.find("up")->value.place, "'up' must not be the zero vector");
    }
    check_key_times(reader, node, rig);
}

}  // namespace

const MapSpec<CameraRig>& camera_spec() {
    static const MapSpec<CameraRig> spec = [] {
        MapSpec<CameraRig> s("camera", "A camera, and its path during an interval of the film.");
        add_time(s);
        s.key("position", &CameraRig::position, camera_path(),
              "position of the camera: a point or a path")
            .required();
        s.key("target", &CameraRig::target, camera_path(),
              "point that the camera looks at: a point or a path")
            .required();
        add_lens(s);
        s.key("roll", &CameraRig::roll, eased("roll", angle()),
              "rotation about the viewing axis; like fov");
        s.key(
            "up", &CameraRig::up, eased("up", vector3(Dimension::none)),
            "direction that is up in the picture; like fov. Where the camera passes over or under "
            "its target, the picture stays the same way up");
        add_aids(s);
        s.key("sound", &CameraRig::sound, camera_sound(),
              "`none`, or what differs from the film's own `sound` while this camera films");
        s.check(check_camera);
        return s;
    }();
    return spec;
}

}  // namespace carom::pipeline::config
