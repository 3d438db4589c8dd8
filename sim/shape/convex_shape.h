// A convex solid about its centre of mass, and what of it faces a direction. All in body axes.
#pragma once

#include <optional>
#include <vector>

#include "core/vectors.h"
#include "sim/shape/polyhedron.h"

namespace carom::sim {

/// What of a solid comes first along a direction: a flat side (three or more points,
/// counter-clockwise seen from outside, with its normal), an edge or a line of a curved side (two),
/// or a point.
struct FacingFeature {
    std::vector<Vec3> points;
    Vec3 normal{0, 0, 1};  // of a flat side, unit
    [[nodiscard]] bool is_flat() const { return points.size() >= 3; }
};

class ConvexShape {
  public:
    enum class Kind { box, capsule, cylinder, hull };

    static ConvexShape box(const Vec3& half_size);
    /// The axis of both is z; `half_length`: from the centre to that of a round end, 0 for a ball.
    static ConvexShape capsule(double radius, double half_length);
    static ConvexShape cylinder(double radius, double half_height);
    /// Around the origin, which lies inside; or flat, with the origin on both its sides: a triangle
    /// of a surface.
    static ConvexShape hull(Polyhedron solid);

    [[nodiscard]] Kind kind() const { return kind_; }
    [[nodiscard]] bool is_box() const { return kind_ == Kind::box; }
    [[nodiscard]] const Vec3& half_size() const { return half_size_; }  // of a box
    [[nodiscard]] double radius() const { return radius_; }             // of capsule and cylinder
    [[nodiscard]] double half_length() const { return half_size_.z; }   // of capsule and cylinder
    [[nodiscard]] const Polyhedron& solid() const { return solid_; }    // of a hull

    /// Radius of a sphere around the origin that holds all of it.
    [[nodiscard]] double bounding_radius() const { return reach_; }

    /// The farthest point along `direction` (not zero, of any length).
    [[nodiscard]] Vec3 support(const Vec3& direction) const;
    /// The same of a core: of a capsule its axis; of other shapes with `depth` 0 all of it, with 1
    /// what lies at least a millimetre (of small ones less) inside.
    [[nodiscard]] Vec3 core_support(const Vec3& direction, double depth) const;

    /// By how much the shape reaches beyond its core of depth 0.
    [[nodiscard]] double core_gap() const { return kind_ == Kind::capsule ? radius_ : 0; }

    [[nodiscard]] FacingFeature facing(const Vec3& direction) const;
    /// The outward normal of the flat side nearest to `direction`; empty if the shape has none.
    [[nodiscard]] std::optional<Vec3> facing_normal(const Vec3& direction) const;

    /// All points that may rest on a plane below `down` (a unit direction): corners, or the lowest
    /// points of round edges and ends and others around them.
    void resting_points(const Vec3& down, std::vector<Vec3>& points) const;

  private:
    explicit ConvexShape(Kind kind) : kind_(kind) {}
    [[nodiscard]] const PolyhedronFace& facing_side(const Vec3& direction) const;
    [[nodiscard]] FacingFeature round_cap(const Vec3& direction) const;

    Kind kind_;
    Vec3 half_size_{0, 0, 0};  // round shapes: z only
    double radius_ = 0;
    Polyhedron solid_;  // of boxes, too
    double reach_ = 0;
    double core_skin_ = 0;
    double core_shrinkage_ = 0;  // of hulls: by which share towards the origin
};

/// What of a solid is nearest to a point.
struct Nearest {
    Vec3 point{0, 0, 0};
    Vec3 normal{0, 0, 1};  // unit, from there to the point; inside: outwards
    double distance = 0;   // negative inside
};

[[nodiscard]] Nearest nearest(const ConvexShape& shape, const Vec3& point);

}  // namespace carom::sim
