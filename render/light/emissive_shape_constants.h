// Emissive curved shapes, as plain data.
#pragma once

#include <cstdint>

#include "render/geometry/affine.h"
#include "render/light/area_light.h"

namespace carom::render {

/// What is needed to choose among emissive objects by importance.
struct ObjectImportance {
    V3f centre{0, 0, 0};  // of its bounds, body axes
    float bounding_radius = 0;
    float strength = 0;  // luminance times mean projected area
};

/// See EmissiveShape. Lengths and directions are in the axes of the object's body, or in the
/// world's for an object that follows no track.
struct EmissiveShapeConstants {
    /// A round ball, a ball under an affine map, a disk, a frustum, a rounded box or capsule.
    enum class Kind : std::uint8_t { sphere, ellipsoid, disk, frustum, rounded };
    static constexpr int kMostParts = 7;

    Kind kind = Kind::sphere;
    SphereConstants sphere;  // of a round ball
    Affine unit_from_body, body_from_unit;
    float volume_scale = 1;  // |determinant| of body_from_unit
    V3f profile{0, 0, 0};    // of the unit shape (shape_list.h); of a capsule its core (0, 0, h)
    V3f radiance{0, 0, 0};
    /// Of each part of the surface: the sum of the probabilities up to it, and the density of the
    /// samples that face the receiver, per area of the unit shape.
    float part_end[kMostParts] = {1, 1, 1, 1, 1, 1, 1};
    float part_density[kMostParts] = {};
    /// Whether the shape is symmetric about its centre. A point of such a convex shape that faces
    /// away is replaced by the opposite one, which mostly does not.
    bool is_symmetric = false;
    ObjectImportance importance;
};

}  // namespace carom::render
