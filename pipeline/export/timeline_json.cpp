#include "pipeline/export/timeline_json.h"

#include <array>
#include <utility>

#include <nlohmann/json.hpp>

#include "pipeline/export/sample_times.h"
#include "sim/timeline/event_fields.h"
#include "sim/timeline/track_fields.h"

namespace carom::pipeline {

constexpr auto fields_of(Describes<ExportMaterial>) {
    using T = ExportMaterial;
    return fields<T>(field("name", &T::name), field("base", &T::base), field("metal", &T::metal),
                     field("roughness", &T::roughness), field("transmission", &T::transmission),
                     field("ior", &T::ior), field("coat", &T::coat),
                     field("coat_roughness", &T::coat_roughness), field("emission", &T::emission),
                     field("specular", &T::specular), field("sheen", &T::sheen),
                     field("opacity", &T::opacity));
}

namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;

Json list(const Vec2& v) {
    return {v.x, v.y};
}
Json list(const Vec3& v) {
    return {v.x + 0, v.y + 0, v.z + 0};  // + 0: no -0
}
Json list(const Quat& q) {
    return {q.r + 0, q.v.x + 0, q.v.y + 0, q.v.z + 0};
}

Json value(double number) {
    return number;
}
Json value(const std::string& text) {
    return text;
}
Json value(sim::EventKind kind) {
    return sim::to_string(kind);
}
template <class Vector>
requires requires(const Vector& v) {
    list(v);
}
Json value(const Vector& v) {
    return list(v);
}
Json value(const std::array<Vec3, 3>& points) {
    return {list(points[0]), list(points[1]), list(points[2])};
}

/// `json` extended by all described fields, in the order of their list.
template <Described T>
Json with_fields(Json json, const T& described) {
    for_each_field(described, [&](const auto& field, const auto& member) {
        json[std::string(field.name)] = value(member);
    });
    return json;
}

template <Described T>
Json json_of(const T& described) {
    return with_fields(Json::object(), described);
}

struct ShapeJson {
    const std::string& folder;  // of the file
    bool with_meshes = true;

    template <class Shape>
    Json operator()(const Shape& shape) const {
        return with_fields({{"kind", shape.kName}}, shape);
    }
    Json operator()(const render::ParallelogramShape& s) const {
        return {{"kind", s.kName},
                {"corner", list(s.corner)},
                {"edges", {list(s.edge_u), list(s.edge_v)}}};
    }
    Json operator()(const render::MeshShape& s) const {
        if (!s.file.empty()) {
            return {{"kind", "mesh"}, {"file", exported_path(s.file, folder)}};
        }
        if (!with_meshes) {
            return {{"kind", "mesh"}};
        }
        Json vertices = Json::array();
        for (const Vec3& vertex : s.vertices) {
            vertices.push_back(list(vertex));
        }
        return {{"kind", "mesh"}, {"vertices", std::move(vertices)}, {"triangles", s.triangles}};
    }
};

Json map_json(const Mat44& map) {
    Json rows = Json::array();
    for (const auto& row : map.x) {
        rows.push_back({row[0] + 0, row[1] + 0, row[2] + 0});
    }
    return rows;
}

Json object_json(const render::ObjectDescription& object, const std::string& folder,
                 bool with_meshes) {
    Json result{{"name", object.name},
                {"shape", std::visit(ShapeJson{folder, with_meshes}, object.shape)},
                {"material", object.material}};
    result["track"] = object.track.empty() ? Json() : Json(object.track);
    result["map"] = map_json(object.world_from_object);
    return result;
}

Json state_json(double time, const MotionState& state) {
    return with_fields({{"time", time}}, state);
}

/// The velocities are those after the key; if they differ before it, those are added.
Json key_json(const sim::Key& key) {
    Json result = state_json(
        key.time, {key.position, key.orientation, key.velocity_out, key.angular_velocity_out});
    if (key.is_break()) {
        result["velocity_before"] = list(key.velocity_in);
        result["angular_velocity_before"] = list(key.angular_velocity_in);
    }
    return result;
}

Json track_json(const sim::Track& track, const sim::Timeline& timeline,
                std::optional<double> rate) {
    Json keys = Json::array();
    if (rate) {
        for (const double time : sample_times(timeline, *rate)) {
            keys.push_back(state_json(time, track.sample(time)));
        }
    } else {
        for (const sim::Key& key : track.keys()) {
            keys.push_back(key_json(key));
        }
    }
    return {{"name", track.name()}, {"keys", std::move(keys)}};
}

Json camera_json(const ExportCamera& camera) {
    Json frames = Json::array();
    for (const ExportCameraKey& key : camera.keys) {
        const render::CameraState& state = key.state;
        frames.push_back({{"video_time", key.video_time},
                          {"scene_time", key.scene_time},
                          {"position", list(state.position)},
                          {"target", list(state.target)},
                          {"orientation", list(camera_axes(state).orientation())},
                          {"vertical_fov", state.vertical_fov},
                          {"focus_distance", state.focus_distance},
                          {"lens_radius", state.lens_radius}});
    }
    return {{"name", camera.name}, {"keys", std::move(frames)}};
}

template <class Range, class Function>
Json all(const Range& values, Function function) {
    Json result = Json::array();
    for (const auto& value : values) {
        result.push_back(function(value));
    }
    return result;
}

/// JSON text with one line per member and per list entry.
std::string lines_of(const Json& document) {
    std::string text;
    for (const auto& [name, value] : document.items()) {
        text += (text.empty() ? "{\n" : ",\n") + Json(name).dump() + ": ";
        if (!value.is_array()) {
            text += value.dump();
            continue;
        }
        const char* separator = "[\n ";
        for (const Json& entry : value) {
            text += separator + entry.dump();
            separator = ",\n ";
        }
        text += value.empty() ? "[]" : "]";
    }
    return text + "}\n";
}

}  // namespace

std::string timeline_json(const Shot& shot, const sim::Timeline& timeline, const ExportScene& scene,
                          std::optional<double> rate, const std::string& folder,
                          const JsonParts& parts) {
    Json document{{"carom_export", kVersion},
                  {"name", shot.name},
                  {"units", "m, s, kg, rad; Z up; quaternions w x y z; colours linear Rec.709"},
                  {"start_time", timeline.start_time},
                  {"end_time", timeline.end_time},
                  {"fps", scene.fps}};
    const auto add = [&document](bool is_wanted, const char* name, const auto& values,
                                 auto function) {
        if (is_wanted) {
            document[name] = all(values, function);
        }
    };
    add(parts.tracks, "tracks", timeline.tracks,
        [&](const sim::Track& track) { return track_json(track, timeline, rate); });
    add(parts.objects, "objects", shot.scene.objects, [&](const render::ObjectDescription& object) {
        return object_json(object, folder, parts.meshes);
    });
    add(parts.materials, "materials", scene.materials, json_of<ExportMaterial>);
    add(parts.events, "events", timeline.events, json_of<sim::Event>);
    add(parts.energy, "energy", timeline.energy, json_of<sim::EnergySample>);
    add(parts.cameras, "cameras", scene.cameras, camera_json);
    add(parts.contacts && !timeline.lasting_contacts.empty(), "lasting_contacts",
        timeline.lasting_contacts, json_of<sim::LastingContact>);
    add(parts.put_backs && !timeline.put_backs.empty(), "put_backs", timeline.put_backs,
        json_of<sim::PutBack>);
    return lines_of(document);
}

}  // namespace carom::pipeline
