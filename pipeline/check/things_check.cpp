#include "pipeline/check/things_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>

#include "core/elementary.h"
#include "pipeline/camera/view_axes.h"
#include "pipeline/check/shape_box.h"
#include "pipeline/check/solid_check.h"
#include "sim/billiards/table.h"

namespace carom::pipeline {
namespace {

constexpr std::uintmax_t kLargestMesh = 16U << 20U;  // bytes

bool is_part_of_table(const render::ObjectDescription& object) {
    return object.name.starts_with("table/");
}

std::array<Vec3, 8> corners_of(const Imath::Box3d& box) {
    std::array<Vec3, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        corners.at(i) =
            Vec3((i & 1U) != 0 ? box.max.x : box.min.x, (i & 2U) != 0 ? box.max.y : box.min.y,
                 (i & 4U) != 0 ? box.max.z : box.min.z);
    }
    return corners;
}

/// Whether none of the planes that bound what a camera sees has all points on its outer side.
bool may_be_in_picture(const render::CameraState& camera, double aspect,
                       const std::array<Vec3, 8>& points) {
    const ViewAxes axes = view_axes(camera);
    const Vec2 half = outermost(camera, aspect);
    const std::array<Vec3, 5> inwards{axes.ahead, half.x * axes.ahead - axes.right,
                                      half.x * axes.ahead + axes.right,
                                      half.y * axes.ahead - axes.up, half.y * axes.ahead + axes.up};
    return std::ranges::all_of(inwards, [&](const Vec3& normal) {
        return std::ranges::any_of(
            points, [&](const Vec3& point) { return normal.dot(point - camera.position) > 0; });
    });
}

}  // namespace

ThingsCheck::ThingsCheck(const Shot& shot, const sim::Timeline& timeline)
    : shot_(shot),
      aspect_(static_cast<double>(shot.render.width) / shot.render.height),
      meshes_(kLargestMesh) {
    add_table();
    for (const render::ObjectDescription& object : shot.scene.objects) {
        if (!is_part_of_table(object)) {
            add_object(object, timeline);
        }
    }
    for (const render::LightDescription& light : shot.scene.lights) {
        add_light(light);
    }
}

void ThingsCheck::add_table() {
    if (!shot_.world.table || !shot_.draws_table) {
        return;
    }
    const sim::billiards::TableMeasures& table = *shot_.world.table;
    const Vec2 half = sim::billiards::half_outline(table);
    const double bottom = table.has_cushions ? -table.height : 0;
    const double top = table.has_cushions ? table.rail_height : 0;
    things_.push_back({.box = Imath::Box3d({-half.x, -half.y, bottom}, {half.x, half.y, top})});
}

void ThingsCheck::add_object(const render::ObjectDescription& object,
                             const sim::Timeline& timeline) {
    Thing thing{object.track.empty() ? nullptr : timeline.find(object.track),
                object.world_from_object, box_of(object.shape)};
    if (const auto* mesh = std::get_if<render::MeshShape>(&object.shape); !thing.box) {
        thing.unread = mesh;
    }
    const bool has_end = thing.box || thing.unread != nullptr;
    if (has_end && !(thing.box && is_room(shot_, object, *thing.box))) {
        things_.push_back(std::move(thing));
    }
}

void ThingsCheck::add_light(const render::LightDescription& light) {
    Imath::Box3d box;
    if (const auto* sphere = std::get_if<render::SphereLight>(&light.light)) {
        box = {sphere->centre - Vec3(sphere->radius), sphere->centre + Vec3(sphere->radius)};
    } else if (const auto* flat = std::get_if<render::RectangleLight>(&light.light)) {
        for (const Vec3& half : {flat->edge_u + flat->edge_v, flat->edge_u - flat->edge_v}) {
            box.extendBy(flat->centre + half);
            box.extendBy(flat->centre - half);
        }
    } else if (const auto* disk = std::get_if<render::DiskLight>(&light.light)) {
        box = {disk->centre - Vec3(disk->radius), disk->centre + Vec3(disk->radius)};
    } else {
        return;  // a shade is an object too
    }
    things_.push_back({.box = box});
}

void ThingsCheck::read_box(Thing& thing) {
    if (const auto reading = meshes_.find(*std::exchange(thing.unread, nullptr))) {
        thing.box.emplace();
        for (const Vec3& vertex : reading->mesh.vertices) {
            thing.box->extendBy(vertex);
        }
    }
}

bool ThingsCheck::may_show(Thing& thing, const render::CameraState& camera, double scene_time) {
    if (thing.unread != nullptr) {
        read_box(thing);
    }
    if (!thing.box) {
        return true;
    }
    std::array<Vec3, 8> corners = corners_of(*thing.box);
    for (Vec3& corner : corners) {
        corner = corner * thing.world_from_object;
    }
    if (thing.track != nullptr) {
        const MotionState state = thing.track->sample(scene_time);
        for (Vec3& corner : corners) {
            corner = state.position + state.orientation.rotateVector(corner);
        }
    }
    return may_be_in_picture(camera, aspect_, corners);
}

bool ThingsCheck::may_be_seen(const render::CameraState& camera, double scene_time) {
    const auto seen = std::ranges::find_if(
        things_, [&](Thing& thing) { return may_show(thing, camera, scene_time); });
    if (seen == things_.end()) {
        return things_.empty();
    }
    std::iter_swap(things_.begin(), seen);
    return true;
}

std::string ThingsCheck::place_under_table(const Vec3& point) const {
    if (!shot_.world.table || !shot_.draws_table || point.z >= 0) {
        return "";
    }
    const sim::billiards::TableMeasures& table = *shot_.world.table;
    if (table.has_cushions && point.z < -table.height) {
        return "under the floor";
    }
    const Vec2 half = sim::billiards::half_outline(table);
    const bool is_in_pocket =
        std::ranges::any_of(shot_.scene.objects, [&](const render::ObjectDescription& object) {
            const bool is_pocket = object.name.starts_with("table/pocket_liner_") ||
                                   object.name.starts_with("table/net_");
            const auto box = is_pocket ? box_of(object.shape) : std::nullopt;
            return box && box->intersects(point);
        });
    const bool is_under = std::abs(point.x) < half.x && std::abs(point.y) < half.y && !is_in_pocket;
    return is_under ? "under the cloth" : "";
}

}  // namespace carom::pipeline
