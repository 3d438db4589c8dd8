// Collects the triangles of one drawn surface.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "sim/billiards/plan_path.h"
#include "sim/billiards/table.h"
#include "sim/billiards/triangulation.h"

namespace carom::sim::billiards {

struct SurfaceVertex {
    Vec3 position{0, 0, 0};
    Vec3 normal{0, 0, 1};  // unit, out of the material
    Vec2 uv{0, 0};         // m
};

/// One point of a profile that is swept along an outline: how far inside the outline and how high,
/// and the normal, in the profile's plane, towards the open side and upwards.
struct ProfilePoint {
    double inside = 0;
    double z = 0;
    double normal_open = 1;
    double normal_up = 0;
    double length = 0;  // along the profile, m
};

using Profile = std::vector<ProfilePoint>;

class SurfaceBuilder {
  public:
    SurfaceBuilder(std::string name, SurfacePart part);

    std::uint32_t add(const SurfaceVertex& vertex);

    /// Turned so that it faces where its vertices' normals point. Triangles with two equal corners
    /// are left out.
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

    /// A quadrilateral given by its corners in order, cut along its shorter diagonal.
    void add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);

    /// Rows of vertices, all of one length, joined by quadrilaterals.
    void add_grid(std::span<const std::vector<SurfaceVertex>> rows);

    /// A smooth profile swept along an outline, whose sharp corners stay sharp.
    void sweep(const PlanPath& path, const Profile& profile);

    /// A level region at height z, facing up or down; uv are lengths along and across `grain`.
    void add_level(std::span<const Loop> loops, double z, bool faces_up, double spacing,
                   const Vec2& grain = {1, 0});

    /// A plane polygon in space, facing along `normal`; uv are lengths along it.
    void add_polygon(std::span<const Vec3> corners, const Vec3& normal);

    [[nodiscard]] Surface finish() &&;

  private:
    Surface surface_;
};

/// Vertices along an outline at a place of the profile: one per point, two at sharp corners (one
/// for each side). `adjust`, if any, is called on each.
using AdjustVertex = std::function<void(const PathPoint&, SurfaceVertex&)>;
[[nodiscard]] std::vector<SurfaceVertex> row_along(const PlanPath& path, const ProfilePoint& point,
                                                   const AdjustVertex& adjust = {});

/// An outline moved into the material, without repeated points.
[[nodiscard]] Loop inside_outline(const PlanPath& path, double distance);

/// A place in the plane of a profile.
struct ProfilePlace {
    double inside = 0;
    double z = 0;
};

/// A straight piece of a profile. The material lies to the left of its direction for someone who
/// sees `inside` to the right and z upwards: an outer wall runs down, an underside inwards.
[[nodiscard]] Profile straight_profile(ProfilePlace from, ProfilePlace to);

/// A quarter of an ellipse from a vertical wall at `wall` to a level surface at `level`.
[[nodiscard]] Profile round_profile(ProfilePlace wall, ProfilePlace level);

/// The points of profiles, swept along the outline's `point`, in space.
[[nodiscard]] std::vector<Vec3> profile_at(const PathPoint& point,
                                           std::span<const Profile> profiles);

}  // namespace carom::sim::billiards
