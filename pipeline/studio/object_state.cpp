// The balls, objects and parts of the table.
#include <algorithm>
#include <utility>
#include <variant>

#include "pipeline/export/export_material.h"
#include "pipeline/export/object_pose.h"
#include "pipeline/studio/shot_state.h"
#include "pipeline/studio/triple.h"

namespace carom::studio {

namespace {

bool has_key(const pipeline::config::Node& root, const char* section, const std::string& name) {
    const pipeline::config::Entry* entry = root.find(section);
    return entry != nullptr && entry->value.find(name) != nullptr;
}

/// The part of a lamp is named after it.
std::string lamp_of(const pipeline::config::Node& root, const std::string& name) {
    const std::string lamp = name.substr(0, name.find('/'));
    return lamp != name && has_key(root, "lights", lamp) ? lamp : "";
}

std::string kind_of(const pipeline::config::Node& root, const std::string& name) {
    if (name.starts_with("table/") || name.starts_with(pipeline::kStickPrefix)) {
        return "table";
    }
    return has_key(root, "objects", name) || !lamp_of(root, name).empty() ? "object" : "ball";
}

KeyPath path_of(const pipeline::config::Node& root, const std::string& kind,
                const std::string& name) {
    if (kind == "table") {
        return {"table"};
    }
    if (const std::string lamp = lamp_of(root, name); !lamp.empty()) {
        return {"lights", lamp};
    }
    return {kind == "ball" ? "balls" : "objects", name};
}

/// The pose at the start: that of the track, that of the body before there is a timeline, or that
/// of an object that never moves.
Pose pose_of(const render::ObjectDescription& object, const pipeline::Shot& shot,
             const sim::Timeline& timeline) {
    if (object.track.empty()) {
        return pipeline::split_pose(object.world_from_object).pose;
    }
    if (const sim::Track* track = timeline.find(object.track)) {
        const MotionState state = track->sample(timeline.start_time);
        return {state.position, state.orientation};
    }
    const auto body = std::ranges::find(shot.world.bodies, object.track, &sim::Body::name);
    return body == shot.world.bodies.end() ? Pose{} : body->pose;
}

void set_look(SceneObject& message, const render::MaterialDescription& material) {
    message.material = material.name;
    message.colour = triple(pipeline::plain_material(material).base);
    const render::BallTexture* paint = pipeline::ball_paint(material);
    if (paint != nullptr && paint->number > 0) {
        message.number = paint->number;
    }
}

}  // namespace

std::vector<SceneObject> object_messages(const pipeline::Shot& shot,
                                         const pipeline::ShotSource& source,
                                         const sim::Timeline& timeline) {
    std::vector<SceneObject> messages;
    for (const render::ObjectDescription& object : shot.scene.objects) {
        SceneObject message;
        message.name = object.name;
        message.kind = kind_of(source.root(), object.name);
        message.path = path_of(source.root(), message.kind, object.name);
        message.shape = std::visit([](const auto& shape) { return shape.kName; }, object.shape);
        message.moves = !object.track.empty() && timeline.find(object.track) != nullptr;
        if (message.moves && object.track != object.name) {
            message.track = object.track;
        }
        const Pose pose = pose_of(object, shot, timeline);
        message.position = triple(pose.position);
        message.orientation = {pose.orientation.r, pose.orientation.v.x, pose.orientation.v.y,
                               pose.orientation.v.z};
        if (const auto* sphere = std::get_if<render::SphereShape>(&object.shape)) {
            message.radius = sphere->radius;
        }
        const auto material = std::ranges::find(shot.scene.materials, object.material,
                                                &render::MaterialDescription::name);
        if (material != shot.scene.materials.end()) {
            set_look(message, *material);
        }
        messages.push_back(std::move(message));
    }
    return messages;
}

}  // namespace carom::studio
