// Lights as plain data, for kernels.
#pragma once

#include <cstdint>

#include "render/geometry/affine.h"
#include "render/geometry/shape_kind.h"
#include "render/light/environment_picture.h"

namespace carom::render {

/// Lower bound on the cosine at the surface in importance estimates of a light that crosses the
/// surface's horizon, so that such a light is still chosen sometimes.
inline constexpr float kLeastHorizonCosine = 0.1f;

/// What is seen through the opening of a lamp's shade, for kernels: a body of revolution behind the
/// light's disk, closed by a ceiling with an opal disk in its middle. Radiances in W/(m^2 sr).
struct ShadeConstants {
    static constexpr int kNodes = 8;

    float depth = 0;       // m, of the ceiling behind the opening; 0: no shade
    V3f squares{0, 0, 0};  // the square of its radius at height z is x + y z + z z^2
    float disk_radius = 0;
    float disk2 = 0;        // its square
    float edge2 = 0;        // the square of the ceiling's
    float disk_chance = 0;  // that a sample is one of the disk, below 1
    V3f disk{0, 0, 0}, ceiling{0, 0, 0};
    /// Of the wall, at equal steps of height from the opening to the ceiling; linear between.
    V3f wall[kNodes] = {};
};
/// How much further than the radius squared, relatively, points still count as in the opening.
inline constexpr float kOpeningMargin = 1.0001f;

/// A light with a surface, for kernels. Its shape is a unit shape (shape_list.h) under an affine
/// map.
struct AreaLightConstants {
    ShapeKind kind = ShapeKind::sphere;
    bool is_one_sided = false;
    bool is_round = false;  // sampled over the cone that a sphere subtends
    bool has_falloff = true;
    V3f centre{0, 0, 0};
    V3f edge_u{1, 0, 0}, edge_v{0, 1, 0};  // half sides; of a disk two radii
    V3f normal{0, 0, 1};
    V3f parameters{0, 0, 0};  // of the unit shape
    V3f radiance{0, 0,
                 0};       // W/(m^2 sr), on the side that shines; that of a matt light of its power
    float beam = 0;        // of a flat light: its radiance ~ cosine^beam
    ShadeConstants shade;  // of a disk
    float area = 0;        // m^2
    float radius = 1;      // of a sphere around the centre that contains the light, m
    float intensity = 0;   // luminous power per steradian straight ahead
};

/// A DeltaLight as plain data, for kernels.
struct DeltaLightConstants {
    bool is_parallel = false;
    bool has_falloff = true;  // inverse square; never for directional lights
    V3f position{0, 0, 0};
    V3f direction{0, 0, -1};     // in which the light shines
    V3f power{0, 0, 0};          // W/sr, or W/m^2 for a light without falloff
    float inner_cosine = -2.0f;  // a point light shines everywhere
    float outer_cosine = -2.0f;
};

/// 1/sr; a power of two, so that multiplying and dividing by it is exact.
inline constexpr float kDeltaPdf = 0x1p60f;

/// What is needed to choose among emissive objects by importance.
struct ObjectImportance {
    V3f centre{0, 0, 0};  // of its bounds, body axes
    float bounding_radius = 0;
    float strength = 0;  // luminance times mean projected area
};

/// See EmissiveShape. Lengths and directions are in the axes of the object's body, or in the
/// world's for an object that follows no track.
struct EmissiveShapeConstants {
    /// A round sphere, a sphere under an affine map, a disk, a frustum, a rounded box or capsule.
    enum class Kind : std::uint8_t { sphere, ellipsoid, disk, frustum, rounded };
    static constexpr int kMostParts = 7;

    Kind kind = Kind::sphere;
    AreaLightConstants sphere;  // of a round sphere
    Affine unit_from_body, body_from_unit;
    float volume_scale = 1;   // |determinant| of body_from_unit
    V3f parameters{0, 0, 0};  // of the unit shape (shape_list.h); of a capsule its core (0, 0, h)
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

/// A LightTree. Borrows its arrays. Node 0 is the root; the children of a node lie side by side.
struct LightTreeData {
    /// Centre and radius of a ball around it, strength, axis, cosine and sine of the spread, and
    /// cosine of the reach (LightBounds).
    static constexpr int kNumbers = 11;
    static constexpr int kMostOfRoot = 32;  // children
    static constexpr int kMostOfNode = 8;

    List<float> numbers;               // by node
    List<std::int32_t> first_child;    // by node; of a leaf -1
    List<std::int32_t> children;       // by node: their number
    List<std::int32_t> first_light;    // by node: where its lights begin in the tree's order
    List<std::int32_t> last_light;     // by node: where they end
    List<std::int32_t> parents;        // by node; of the root -1
    List<std::int32_t> lights;         // in the tree's order
    List<float> strength_before;       // in the tree's order, and that of all
    List<std::int32_t> leaf_of_light;  // its node, or -1
    bool shines_all_around = false;    // no light has an axis

    [[nodiscard]] bool exists() const { return numbers.exists(); }
    /// The root's children; one that has none stands for itself.
    [[nodiscard]] int choices_of_root() const { return children[0] > 0 ? children[0] : 1; }
    [[nodiscard]] std::int32_t first_choice() const { return children[0] > 0 ? first_child[0] : 0; }

    template <class Visit>
    void each_list(const Visit& visit) {
        visit(numbers, first_child, children, first_light, last_light, parents, lights,
              strength_before, leaf_of_light);
    }
};

/// An EmissiveSurface. Borrows its arrays.
struct EmissiveSurfaceConstants {
    List<float> corners;   // nine numbers for each triangle; at least one
    List<float> area_cdf;  // by triangle: the areas up to its end, over that of all
    float area = 0;        // m^2
    V3f radiance{0, 0, 0};
    ObjectImportance importance;
    LightTreeData tree;  // of many faces; its lights are the faces that hits name

    template <class Visit>
    void each_list(const Visit& visit) {
        visit(corners, area_cdf);
        tree.each_list(visit);
    }
};

}  // namespace carom::render
