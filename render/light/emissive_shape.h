// An emissive disk, sphere, cylinder, cone, capsule or rounded box.
#pragma once

#include <optional>

#include "render/geometry/shape_kind.h"
#include "render/light/light_constants.h"
#include "render/light/light_tree.h"

namespace carom::render {

/// A convex curved shape that emits the same radiance everywhere from its front (a disk) or
/// outside. Spheres are sampled uniformly over the cone that they subtend; ellipsoids likewise in
/// the axes in which they are round; the others uniformly by area, on the side that faces the
/// receiver where the shape is symmetric. All lengths and directions are in the axes of the shape's
/// body, or in the world's for a shape that follows no track.
class EmissiveShape {
  public:
    /// What the constructor needs to know about the shape.
    struct Description {
        ShapeKind kind = ShapeKind::sphere;
        bool is_round = false;      // a sphere with three equal radii
        float radius = 1;           // of a round sphere, m
        Affine unit_from_body;      // the unit shape is described in shape_list.h
        Affine body_from_unit;      // its inverse
        V3f parameters{0, 0, 0};    // of the unit shape
        float bounding_radius = 1;  // largest distance of the surface from the body's origin, m
    };

    /// Empty if shapes of the kind are not sampled here: those with flat faces only
    /// (EmissiveSurface), and planes.
    [[nodiscard]] static std::optional<EmissiveShape> make(const Description& shape,
                                                           const V3f& radiance);

    [[nodiscard]] bool is_black() const;
    [[nodiscard]] bool is_round() const {
        return shape_.kind == EmissiveShapeConstants::Kind::sphere;
    }

    [[nodiscard]] const V3f& radiance() const { return shape_.radiance; }
    /// In the axes of the body.
    [[nodiscard]] LightBounds bounds() const;
    /// For kernels.
    [[nodiscard]] const EmissiveShapeConstants& constants() const { return shape_; }

  private:
    EmissiveShapeConstants shape_;
};

}  // namespace carom::render
