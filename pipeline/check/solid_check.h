// Finds objects that contain a camera.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Imath/ImathBox.h>

#include "pipeline/check/whole_mesh.h"
#include "pipeline/shot/shot.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// The closed shapes of a shot. Those that are built around everything, as rooms and skies are, do
/// not count: surfaces that emit light, and shapes of 3 to 40 m that contain the table and all
/// bodies. Nor do those with holes by their opacity.
class SolidCheck {
  public:
    SolidCheck(const Shot& shot, const sim::Timeline& timeline);

    /// The names of the objects that contain a point of the world at that scene time.
    [[nodiscard]] std::vector<std::string> find_around(const Vec3& point, double scene_time);

  private:
    struct Solid {
        const render::ObjectDescription* object = nullptr;
        const sim::Track* track = nullptr;  // null: static
        Mat44 object_from_world;            // with a track: from the axes of the body
        std::optional<Imath::Box3d> box;    // empty for a mesh that has not been read yet
        std::shared_ptr<const render::MeshReading> mesh;
        bool is_known_mesh = false;  // read and examined; without a mesh it does not count
    };

    void add(const render::ObjectDescription& object, const sim::Timeline& timeline);
    [[nodiscard]] bool is_inside(Solid& solid, const Vec3& point);
    void read_mesh(Solid& solid);
    /// `whole`: with its triangles. Each file is looked at once.
    [[nodiscard]] bool is_closed_mesh(const render::MeshShape& shape,
                                      const render::MeshShape& whole);

    const Shot& shot_;
    std::vector<render::ObjectDescription> table_;
    WholeMeshes meshes_;
    std::map<std::string, bool> closed_files_;
    std::vector<Solid> solids_;
    std::size_t work_;  // tests of triangles that may still be made
};

/// Whether a box in the object's axes is like that of a room: 3 to 40 m long, and around the table
/// and all bodies.
[[nodiscard]] bool is_room(const Shot& shot, const render::ObjectDescription& object,
                           const Imath::Box3d& box);

}  // namespace carom::pipeline
