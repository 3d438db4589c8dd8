#include "pipeline/check/view_check.h"

#include <algorithm>
#include <variant>

#include <fmt/core.h>

#include "pipeline/camera/changing_value.h"
#include "pipeline/camera/view_axes.h"
#include "pipeline/check/shape_box.h"

namespace carom::pipeline {

namespace {

/// The object that a path belongs to at all times; empty if there is none.
std::string object_of(const CameraPath& path) {
    if (const auto* follow = std::get_if<FollowPath>(&path)) {
        return follow->object;
    }
    if (const auto* along = std::get_if<AlongPath>(&path)) {
        return along->object;
    }
    return {};
}

}  // namespace

std::map<std::string, double> sizes_of_objects(const Shot& shot) {
    constexpr double kUnknown = 0.1;  // m, of a mesh from a file
    std::map<std::string, double> sizes;
    for (const render::ObjectDescription& object : shot.scene.objects) {
        if (!object.track.empty()) {
            const auto box = box_of(object.shape);
            double& size = sizes[object.track];
            size = std::max(size, box ? box->size().length() / 2 : kUnknown);
        }
    }
    for (const sim::Body& body : shot.world.bodies) {
        if (const auto* sphere = std::get_if<sim::Sphere>(&body.shape)) {
            sizes[body.name] = sphere->radius;
        }
    }
    return sizes;
}

ViewCheck::ViewCheck(const CameraRig& rig, const CameraPath& target,
                     const std::map<std::string, double>& sizes, const sim::Timeline& timeline)
    : rig_(rig), sizes_(sizes), timeline_(timeline), aim_(object_of(target)) {}

void ViewCheck::count(Frames& frames, const std::string& object, const render::CameraState& camera,
                      double scene_time) const {
    const sim::Track* track = timeline_.find(object);
    if (track == nullptr) {
        return;
    }
    const auto size = sizes_.find(object);
    const bool is_seen = is_in_picture(camera, rig_.aspect, track->sample(scene_time).position,
                                       size != sizes_.end() ? size->second : 0);
    ++frames.all;
    frames.without += is_seen ? 0 : 1;
}

void ViewCheck::check_frame(const render::CameraState& camera, Progress progress,
                            double scene_time) {
    if (!aim_.empty()) {
        count(aimed_, aim_, camera, scene_time);
    }
    const Change<Focus> focus = change_at(rig_.focus, rig_, progress);
    const Focus& nearer = focus.progress.done < 0.5 ? focus.from : focus.to;
    if (!nearer.distance && !nearer.object.empty()) {
        count(focused_[nearer.object], nearer.object, camera, scene_time);
    }
}

void ViewCheck::report(const AddViewWarning& add) const {
    const auto report_one = [&](const char* key, const char* verb, const std::string& object,
                                const Frames& frames) {
        if (2 * frames.without > frames.all) {
            add(key, object,
                fmt::format("{} '{}', which is outside of the picture for {} % of that time", verb,
                            object, (200 * frames.without + frames.all) / (2 * frames.all)));
        }
    };
    report_one("target", "aims at", aim_, aimed_);
    for (const auto& [object, frames] : focused_) {
        report_one("focus", "is focused on", object, frames);
    }
}

}  // namespace carom::pipeline
