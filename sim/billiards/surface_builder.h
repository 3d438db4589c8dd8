// Builds the triangles of one surface.
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

/// One point of a profile that is swept along an outline: its distance inside the outline, its
/// height, and the components of its normal towards the open side and upwards.
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

    /// Adds a triangle, oriented like the normals of its vertices. Triangles with two equal corners
    /// are omitted.
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

    /// Adds a quadrilateral by its corners in order, divided along its shorter diagonal.
    void add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);

    /// Adds rows of vertices, all of the same length, joined by quadrilaterals.
    void add_grid(std::span<const std::vector<SurfaceVertex>> rows);

    /// Sweeps a smooth profile along an outline, whose sharp corners remain sharp.
    void sweep(const PlanPath& path, const Profile& profile);

    /// Adds a horizontal region at height z, facing up or down; uv are lengths along and across
    /// `grain`.
    void add_level(std::span<const Loop> loops, double z, bool faces_up, double spacing,
                   const Vec2& grain = {1, 0});

    /// Adds a planar polygon in space, facing along `normal`; uv are lengths in its plane.
    void add_polygon(std::span<const Vec3> corners, const Vec3& normal);

    [[nodiscard]] Surface finish() &&;

  private:
    Surface surface_;
};

/// Vertices along an outline at a point of the profile: one per point, two at sharp corners (one
/// for each side). `adjust`, if any, is called for each.
using AdjustVertex = std::function<void(const PathPoint&, SurfaceVertex&)>;
[[nodiscard]] std::vector<SurfaceVertex> row_along(const PlanPath& path, const ProfilePoint& point,
                                                   const AdjustVertex& adjust = {});

/// An outline offset into the material, without repeated points.
[[nodiscard]] Loop inside_outline(const PlanPath& path, double distance);

/// A position in the plane of a profile.
struct ProfilePosition {
    double inside = 0;
    double z = 0;
};

/// A straight piece of a profile. With `inside` to the right and z upwards, the material is on the
/// left of its direction: an outer wall runs down, an underside inwards.
[[nodiscard]] Profile straight_profile(ProfilePosition from, ProfilePosition to);

/// A quarter of an ellipse from a vertical wall at `wall` to a horizontal surface at `level`.
[[nodiscard]] Profile round_profile(ProfilePosition wall, ProfilePosition level);

/// The points of the profiles in space, at one point of the outline.
[[nodiscard]] std::vector<Vec3> profile_at(const PathPoint& point,
                                           std::span<const Profile> profiles);

}  // namespace carom::sim::billiards
