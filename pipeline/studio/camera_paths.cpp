#include "pipeline/studio/camera_paths.h"

#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "core/error.h"
#include "pipeline/camera/camera_path.h"
#include "pipeline/camera/exposure.h"
#include "pipeline/camera/path_fit.h"
#include "pipeline/camera/rig_state.h"
#include "pipeline/camera/time_map.h"
#include "pipeline/config/quantity.h"
#include "pipeline/studio/triple.h"

namespace carom::studio {

namespace {

using pipeline::config::Entry;
using pipeline::config::Node;

constexpr int kCurvePieces = 64;

KeyPath below(KeyPath path, const std::string& key) {
    path.push_back(key);
    return path;
}

/// The vector that is written at a key of a path; nothing if there is none.
std::optional<Vec3> written_vector(const Node& written, const char* key) {
    const Entry* entry = written.find(key);
    if (entry == nullptr || entry->value.items.size() != 3) {
        return std::nullopt;
    }
    Vec3 vector(0, 0, 0);
    for (int i = 0; i < 3; ++i) {
        const auto parsed =
            pipeline::config::parse_quantity(entry->value.items[static_cast<std::size_t>(i)].text);
        if (const auto* quantity = std::get_if<pipeline::config::Quantity>(&parsed)) {
            vector[i] = quantity->value;
        }
    }
    return vector;
}

/// A path of one camera with its place in the shot.
struct ShapeMaker {
    const pipeline::CameraRig& rig;
    const sim::Timeline& timeline;
    KeyPath path;  // ["cameras", "0", "position"]
    Node written;  // a point or a map

    [[nodiscard]] Vec3 object_at(const std::string& name, double time) const {
        const sim::Track* track = timeline.find(name);
        return track == nullptr ? Vec3(0, 0, 0) : track->sample(time).position;
    }

    [[nodiscard]] PathPoint point(const pipeline::ControlPoint& control, KeyPath key) const {
        const Vec3 base = control.of.empty() ? Vec3(0, 0, 0) : object_at(control.of, control.at);
        return {std::move(key), triple(base + control.offset), control.of, control.at,
                triple(control.offset)};
    }

    /// The point of a path that belongs to an object: its offset at `time`.
    [[nodiscard]] PathPoint offset_point(const std::string& object, const Vec3& offset,
                                         double time) const {
        return {below(path, "offset"), triple(object_at(object, time) + offset), object, time,
                triple(offset)};
    }

    [[nodiscard]] PathShape points(const std::vector<pipeline::ControlPoint>& controls,
                                   const std::string& kind) const {
        PathShape shape;
        shape.kind = kind;
        for (std::size_t i = 0; i < controls.size(); ++i) {
            shape.points.push_back(
                point(controls[i],
                      written.is_sequence() ? path : below(below(path, kind), std::to_string(i))));
        }
        return shape;
    }

    PathShape operator()(const pipeline::BezierPath& bezier) const {
        return points(bezier.points, "bezier");
    }
    PathShape operator()(const pipeline::SplinePath& spline) const {
        return points(spline.points, "spline");
    }
    PathShape operator()(const pipeline::AlongPath& along) const {
        return {"along", {}, {offset_point(along.object, along.offset, along.from)}, {}};
    }
    PathShape operator()(const pipeline::FollowPath& follow) const {
        const double start = rig.time_map.scene_start.to_double() + follow.look_ahead;
        return {"follow", {}, {offset_point(follow.object, follow.offset, start)}, {}};
    }
    PathShape operator()(const pipeline::OrbitPath& orbit) const {
        PathShape shape;
        shape.kind = "orbit";
        shape.orbit = Orbit{{orbit.radii.x, orbit.radii.y},
                            {orbit.start_angle, orbit.end_angle},
                            {orbit.turn.r, orbit.turn.v.x, orbit.turn.v.y, orbit.turn.v.z}};
        if (const auto* fixed = std::get_if<pipeline::ControlPoint>(&orbit.around)) {
            shape.points.push_back(point(*fixed, below(path, "orbit")));
            if (const std::optional<Vec3> offset = written_vector(written, "offset")) {
                shape.points.back().path = below(path, "offset");
                shape.points.back().offset = triple(*offset);
            }
        } else {
            const auto& follow = std::get<pipeline::FollowPath>(orbit.around);
            const double start = rig.time_map.scene_start.to_double() + follow.look_ahead;
            shape.points.push_back(offset_point(follow.object, follow.offset, start));
        }
        return shape;
    }
};

/// Points along a path during the camera's interval; empty if an object is not in the timeline.
/// `place`: the point of the path at an instant.
template <class Place>
std::vector<double> curve_of(const pipeline::CameraRig& rig, const Place& place) {
    std::vector<double> curve;
    const double start = rig.video_start.to_double();
    const double length = rig.video_end.to_double() - start;
    try {
        for (int i = 0; i <= kCurvePieces; ++i) {
            const pipeline::WideRational time(
                pipeline::Rational::nearest(start + length * i / kCurvePieces));
            const double scene_time = pipeline::scene_time_at(rig, time).to_double();
            const Vec3 p = place({pipeline::progress_at(rig, time), scene_time});
            curve.insert(curve.end(), {p.x, p.y, p.z});
        }
    } catch (const Error&) {
        curve.clear();
    }
    return curve;
}

/// The rig with its paths fitted, or as it is if that fails.
pipeline::CameraRig fitted(const pipeline::CameraRig& rig, const sim::Timeline& timeline) {
    try {
        return pipeline::with_fitted_paths(std::span(&rig, 1), timeline).front();
    } catch (const Error&) {
        return rig;
    }
}

Node value_of(const Node& camera, const std::string& key) {
    const Entry* entry = camera.find(key);
    return entry == nullptr ? Node{} : entry->value;
}

/// The keys of all values of the lens that are given by keys.
std::vector<LensKey> lens_keys(const pipeline::CameraRig& rig, const Node& camera,
                               const KeyPath& path) {
    std::vector<LensKey> found;
    const auto add = [&](const char* name, const auto& value) {
        for (std::size_t i = 0; camera.find(name) != nullptr && i < value.keys.size(); ++i) {
            found.push_back({below(below(below(path, name), "keys"), std::to_string(i)),
                             value.keys[i].video_time.to_double()});
        }
    };
    add("fov", rig.fov);
    if (rig.focal_length) {
        add("focal_length", *rig.focal_length);
    }
    add("focus", rig.focus);
    add("aperture", rig.aperture);
    add("f_number", rig.aperture);
    return found;
}

Camera camera_message(const pipeline::CameraRig& rig, const Node& node, const KeyPath& path,
                      const sim::Timeline& timeline) {
    Camera message;
    message.name = rig.name;
    message.path = path;
    message.video_start = rig.video_start.to_double();
    message.video_end = rig.video_end.to_double();
    message.fade = rig.fade.to_double();
    message.scene_start = rig.time_map.scene_start.to_double();
    message.scene_end =
        pipeline::scene_time_at(rig, pipeline::WideRational(rig.video_end)).to_double();
    message.smooth = rig.time_map.is_smooth;
    message.sensor_height = rig.sensor_height;
    message.fov_scale = pipeline::measures_width(rig.fov_axis, rig.aspect) ? 1 / rig.aspect : 1;
    message.lens_keys = lens_keys(rig, node, path);
    for (std::size_t i = 0; i < rig.time_map.speeds.size(); ++i) {
        const pipeline::SpeedKey& speed = rig.time_map.speeds[i];
        message.speeds.push_back({below(below(below(path, "scene"), "speeds"), std::to_string(i)),
                                  speed.video_time.to_double(), speed.speed.to_double()});
    }
    const pipeline::CameraRig drawn = fitted(rig, timeline);
    const auto shape = [&](const char* key, const pipeline::CameraPath& own, bool is_drawn,
                           const auto& place) {
        PathShape result =
            std::visit(ShapeMaker{rig, timeline, below(path, key), value_of(node, key)}, own);
        if (is_drawn || result.kind != "bezier" || result.points.size() > 1) {
            result.curve = curve_of(drawn, place);
        }
        return result;
    };
    const auto on = [&](const pipeline::CameraPath& curve) {
        return [&](const pipeline::RigInstant& instant) {
            return pipeline::path_position(curve, instant, timeline);
        };
    };
    if (rig.framing) {  // the camera is not on the path that is written
        message.position =
            shape("position", rig.position, true, [&](const pipeline::RigInstant& instant) {
                return camera_state(drawn, instant, timeline).position;
            });
    } else {
        message.position = shape("position", rig.position, false, on(drawn.position));
    }
    message.target = shape("target", rig.target, false, on(drawn.target));
    return message;
}

}  // namespace

std::vector<Camera> camera_messages(const pipeline::Shot& shot, const pipeline::ShotSource& source,
                                    const sim::Timeline& timeline) {
    const Entry* cameras = source.root().find("cameras");
    std::vector<Camera> messages;
    for (std::size_t i = 0; i < shot.cameras.size(); ++i) {
        const bool is_known = cameras != nullptr && i < cameras->value.items.size();
        messages.push_back(camera_message(shot.cameras[i],
                                          is_known ? cameras->value.items[i] : Node{},
                                          {"cameras", std::to_string(i)}, timeline));
    }
    return messages;
}

}  // namespace carom::studio
