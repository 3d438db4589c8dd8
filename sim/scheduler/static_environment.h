// Everything that does not move.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/billiards/table.h"
#include "sim/ode/box_collider.h"
#include "sim/scheduler/contact_table.h"
#include "sim/solid_shape.h"
#include "sim/spatial/rim.h"
#include "sim/spatial/static_mesh.h"
#include "sim/world.h"

namespace carom::sim {

/// A level surface that balls slide and roll on in closed form.
enum class Ground { none, cloth, floor };

/// Height of the slate's underside (m), as deep as the cloth is drawn around a pocket's edge.
inline constexpr double kSlateUnderside = -0.025;

/// What a triangle surface is called in the event log and which physical material it has.
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
    bool has_mesh = false;  // flat sides: balls meet them as triangles of the scenery
};

/// A fixed mesh as moving boxes see it.
struct BoxObstacle {
    SurfaceInfo info;
    std::uint32_t number = 0;  // its index in StaticEnvironment::surfaces
    ode::TriangleSurface surface;
    Aabb bounds;
};

struct StaticEnvironment {
    explicit StaticEnvironment(const WorldDescription& world);

    Vec3 gravity;
    /// Gravity pulls straight down at this rate; 0 if it does not, and nothing rolls in closed
    /// form.
    double downward_gravity = 0;
    ContactLaw law;
    ContactTable contacts;  // the same for pairs of materials
    bool has_cloth = false;
    bool has_cushions = false;
    Vec2 cloth_half_extent{0, 0};  // the cloth lies under |x|, |y| up to these
    double nose_height = 0;
    billiards::TableGeometry table;
    std::vector<Rim> rims;  // of the pockets' holes, in their order
    std::optional<double> floor_height;

    // Triangle surfaces for balls: of the table (a ball on the cloth has no need of them) and of
    // other fixed bodies. Their `surface` numbers are indices into `surfaces`.
    StaticMesh table_mesh;
    StaticMesh scenery_mesh;
    std::vector<SurfaceInfo> surfaces;
    std::vector<FixedSphere> spheres;
    std::vector<FixedSolid> solids;
    // Meshes for moving boxes; empty if there are none.
    std::vector<BoxObstacle> box_obstacles;

    [[nodiscard]] bool is_over_cloth(const Vec3& centre) const;
    /// The pocket whose hole lies below `centre`, or -1.
    [[nodiscard]] int pocket_below(const Vec3& centre) const;

  private:
    void add_table(const WorldDescription& world, bool has_boxes);
    void add_fixed_bodies(const WorldDescription& world, bool has_boxes);
};

}  // namespace carom::sim
