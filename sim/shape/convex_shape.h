// A convex solid about its centre of mass, with its support points and facing features in body
// axes.
#pragma once

#include <optional>
#include <vector>

#include "core/vectors.h"
#include "sim/shape/polyhedron.h"

namespace carom::sim {

/// The feature of a solid that faces a direction: a flat side (three or more points,
/// counter-clockwise seen from outside, with its normal), an edge or a line of a curved side (two
/// points), or a point.
struct FacingFeature {
    std::vector<Vec3> points;
    Vec3 normal{0, 0, 1};  // of a flat side, unit
    [[nodiscard]] bool is_flat() const { return points.size() >= 3; }
};

class ConvexShape {
  public:
    enum class Kind { box, capsule, cylinder, hull };

    static ConvexShape box(const Vec3& half_size);
    /// Capsule and cylinder have the axis z. `half_length`: from the capsule's centre to that of a
    /// round end; 0 for a ball.
    static ConvexShape capsule(double radius, double half_length);
    static ConvexShape cylinder(double radius, double half_height);
    /// A hull that contains the origin; or a flat one, with both sides through the origin: a
    /// triangle of a surface.
    static ConvexShape hull(Polyhedron solid);

    [[nodiscard]] Kind kind() const { return kind_; }
    [[nodiscard]] bool is_box() const { return kind_ == Kind::box; }
    [[nodiscard]] const Vec3& half_size() const { return half_size_; }  // of a box
    [[nodiscard]] double radius() const { return radius_; }             // of capsule and cylinder
    [[nodiscard]] double half_length() const { return half_size_.z; }   // of capsule and cylinder
    [[nodiscard]] const Polyhedron& solid() const { return solid_; }    // of a hull

    /// Radius of a sphere around the origin that contains the shape.
    [[nodiscard]] double bounding_radius() const { return bounding_radius_; }

    /// The farthest point along `direction` (not zero, of any length).
    [[nodiscard]] Vec3 support(const Vec3& direction) const;
    /// The farthest point of the core. The core of a capsule is its axis; that of other shapes is
    /// the whole shape for `depth` 0, and for `depth` 1 the part at least a millimetre (less for
    /// small shapes) below the surface.
    [[nodiscard]] Vec3 core_support(const Vec3& direction, double depth) const;

    /// Distance of the surface from the core of depth 0.
    [[nodiscard]] double core_gap() const { return kind_ == Kind::capsule ? radius_ : 0; }

    [[nodiscard]] FacingFeature facing(const Vec3& direction) const;
    /// The outward normal of the flat side nearest to `direction`; empty if the shape has none.
    [[nodiscard]] std::optional<Vec3> facing_normal(const Vec3& direction) const;

    /// All points that may rest on a plane below (`down` is a unit direction): corners, or points
    /// of round edges and ends including the lowest ones.
    void resting_points(const Vec3& down, std::vector<Vec3>& points) const;

  private:
    explicit ConvexShape(Kind kind) : kind_(kind) {}
    [[nodiscard]] const PolyhedronFace& facing_side(const Vec3& direction) const;
    [[nodiscard]] FacingFeature cap_polygon(const Vec3& direction) const;

    Kind kind_;
    Vec3 half_size_{0, 0, 0};  // round shapes: z only
    double radius_ = 0;
    Polyhedron solid_;  // for boxes and hulls
    double bounding_radius_ = 0;
    double core_skin_ = 0;
    double core_shrinkage_ = 0;  // for hulls: shrinkage towards the origin, as a fraction
};

/// The point of a solid's surface that is nearest to a point.
struct NearestPoint {
    Vec3 point{0, 0, 0};
    Vec3 normal{0, 0, 1};  // unit, outwards
    double distance = 0;   // negative inside
};

[[nodiscard]] NearestPoint nearest_point(const ConvexShape& shape, const Vec3& point);

}  // namespace carom::sim
