// The static environment: the table, the floor and all fixed bodies.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/ode/box_collider.h"
#include "sim/scheduler/collided_table.h"
#include "sim/scheduler/contact_table.h"
#include "sim/solid_shape.h"
#include "sim/spatial/static_mesh.h"
#include "sim/world.h"

namespace carom::sim {

/// A level surface on which balls slide and roll in closed form.
enum class SupportPlane { none, cloth, floor };

/// Height of the slate's underside (m); the cloth is drawn down to it around a pocket's edge.
inline constexpr double kSlateUnderside = -0.025;

/// Name of a triangle surface in the event log, and its physical material.
struct SurfaceInfo {
    std::string name;
    MaterialId material = MaterialId::other;
};

struct FixedSphere {
    SurfaceInfo info;
    Vec3 centre{0, 0, 0};
    double radius = 0;
};

/// A fixed box, capsule, cylinder or hull.
struct FixedSolid {
    SurfaceInfo info;
    std::uint32_t surface = 0;  // its index in StaticEnvironment::surfaces
    std::shared_ptr<const ConvexShape> shape;
    Pose pose;  // of the shape's axes
    Aabb bounds;
    bool has_mesh = false;  // flat sides: for balls they are triangles of the scenery's mesh
};

/// A fixed mesh in the form in which boxes collide with it.
struct BoxObstacle {
    SurfaceInfo info;
    std::uint32_t number = 0;  // its index in StaticEnvironment::surfaces
    ode::TriangleSurface surface;
    Aabb bounds;
};

struct StaticEnvironment {
    explicit StaticEnvironment(const WorldDescription& world);

    Vec3 gravity;
    /// The vertical part of gravity (m/s^2). If it does not pull down it is 0, and no ball rolls in
    /// closed form.
    double downward_gravity = 0;
    Vec3 pull{0, 0, 0};  // its horizontal part then: not zero if the table is off level
    ContactLaw law;
    BallCushion jaw;        // for the straight parts of the pockets' jaws
    ContactTable contacts;  // the law of each pair of materials
    bool has_cloth = false;
    bool has_cushions = false;
    bool has_ball_return = false;
    Vec2 cloth_half_extent{0, 0};  // the cloth lies under |x|, |y| up to these
    double nose_height = 0;
    std::shared_ptr<const CollidedTable> collided;  // without any part if there are no cushions
    std::optional<double> floor_height;

    // Triangle surfaces for balls, beside those of the table, which are not used for balls on the
    // cloth. The `surface` numbers of both are indices into `surfaces`.
    StaticMesh scenery_mesh;
    std::vector<SurfaceInfo> surfaces;
    std::vector<FixedSphere> spheres;
    std::vector<FixedSolid> solids;
    // Meshes for moving boxes; empty if no box moves.
    std::vector<BoxObstacle> box_obstacles;

    [[nodiscard]] const billiards::TableGeometry& table() const { return collided->geometry; }
    /// Whether there are fixed bodies.
    [[nodiscard]] bool has_obstacles() const {
        return !spheres.empty() || !solids.empty() || !scenery_mesh.empty();
    }
    [[nodiscard]] bool is_over_cloth(const Vec3& centre) const;
    /// Index of the pocket whose hole lies below `centre`, or -1.
    [[nodiscard]] int pocket_below(const Vec3& centre) const;

  private:
    void add_table(const WorldDescription& world, bool has_boxes);
    void add_fixed_bodies(const WorldDescription& world, bool has_boxes);
};

}  // namespace carom::sim
