// Finds cameras that show nothing, or that are where nothing can be seen.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Imath/ImathBox.h>

#include "pipeline/check/whole_mesh.h"
#include "pipeline/shot/shot.h"
#include "render/camera/camera_state.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// The balls, objects, lights with a surface and the table of a shot. Grounds without an end and
/// rooms (solid_check.h) do not count.
class ThingsCheck {
  public:
    ThingsCheck(const Shot& shot, const sim::Timeline& timeline);

    /// Whether one of them may be in the camera's picture: false only if all are outside of it, and
    /// there are some. A mesh file is read when nothing else is in the picture; one of more than
    /// 16 MiB may be anywhere.
    [[nodiscard]] bool may_be_seen(const render::CameraState& camera, double scene_time);

    /// Where a point is, if it is in or under the table: "under the cloth", "under the floor";
    /// empty if it is not. Pockets are holes in the cloth.
    [[nodiscard]] std::string place_under_table(const Vec3& point) const;

  private:
    struct Thing {
        const sim::Track* track = nullptr;          // null: static
        Mat44 world_from_object{};                  // with a track: to the axes of the body
        std::optional<Imath::Box3d> box{};          // in the object's axes
        const render::MeshShape* unread = nullptr;  // whose box is not known yet
    };

    void add_table();
    void add_object(const render::ObjectDescription& object, const sim::Timeline& timeline);
    void add_light(const render::LightDescription& light);
    void read_box(Thing& thing);
    [[nodiscard]] bool may_show(Thing& thing, const render::CameraState& camera, double scene_time);

    const Shot& shot_;
    double aspect_;
    WholeMeshes meshes_;
    std::vector<Thing> things_;  // what was seen last is the first
};

}  // namespace carom::pipeline
