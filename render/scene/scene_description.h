// The visible scene as plain data: shapes, materials, textures, lights. World axes, metres, Z up;
// colour is linear Rec.709, scene-referred.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/vectors.h"
#include "render/scene/material_description.h"

namespace carom::render {

// ---- shapes, in the object's own axes --------------------------------------------------------
//
// kName is the shape's key in a shot. Hashes and JSON are made from the lists in scene_fields.h.

struct SphereShape {
    static constexpr const char* kName = "sphere";
    double radius = 1;  // centre at the origin
};

struct BoxShape {
    static constexpr const char* kName = "box";
    Vec3 size{1, 1, 1};  // full edges, centre at the origin
};

/// The infinite plane z = 0 with normal +z.
struct PlaneShape {
    static constexpr const char* kName = "plane";
};

/// Centre at the origin, normal +z, size x by y.
struct RectangleShape {
    static constexpr const char* kName = "rectangle";
    Vec2 size{1, 1};
};

/// The front is the side from which the corners run counter-clockwise; uv are the weights of the
/// second and third corner.
struct TriangleShape {
    static constexpr const char* kName = "triangle";
    std::array<Vec3, 3> corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};  // not collinear
};

/// Corners: `corner`, `corner` + `edge_u`, `corner` + `edge_v` and `corner` + `edge_u` + `edge_v`;
/// the front is the side from which the turn from `edge_u` to `edge_v` is counter-clockwise. u and
/// v run along the edges.
struct ParallelogramShape {
    static constexpr const char* kName = "parallelogram";
    Vec3 corner{0, 0, 0};
    Vec3 edge_u{1, 0, 0};  // not parallel to edge_v
    Vec3 edge_v{0, 1, 0};
};

/// Centre at the origin, normal +z.
struct DiskShape {
    static constexpr const char* kName = "disk";
    double radius = 1;
};

/// Solid, about z, from z = -height / 2 to height / 2.
struct CylinderShape {
    static constexpr const char* kName = "cylinder";
    double radius = 1;
    double height = 1;
};

/// Solid, about z, from z = -height / 2 to height / 2. One of the radii may be 0 (the tip).
struct ConeShape {
    static constexpr const char* kName = "cone";
    double radius = 1;  // at the bottom
    double top_radius = 0;
    double height = 1;
};

/// A cylinder about z with a hemisphere at each end, centre at the origin.
struct CapsuleShape {
    static constexpr const char* kName = "capsule";
    double radius = 1;
    double length = 1;  // between the centres of its ends
};

/// A box with rounded edges and corners, centre at the origin: all points within `radius` of a box
/// that is smaller by `radius` on every side.
struct RoundedBoxShape {
    static constexpr const char* kName = "rounded_box";
    Vec3 size{1, 1, 1};   // full lengths, including the rounding
    double radius = 0.1;  // at most half of the smallest side
    /// Half the size of the box without the rounding.
    [[nodiscard]] Vec3 core() const {
        const Vec3 half = 0.5 * size - Vec3(radius);
        return {std::max(half.x, 0.0), std::max(half.y, 0.0), std::max(half.z, 0.0)};
    }
};

/// Triangles given as arrays (the table's surfaces) or read from an OBJ or PLY file.
struct MeshShape {
    static constexpr const char* kName = "mesh";
    std::string file;  // absolute path; empty: the arrays below
    /// Largest angle between triangles, rad, up to which an edge is smoothed by new normals. 0
    /// keeps the mesh's own normals.
    double smooth_angle = 0;
    std::vector<Vec3> vertices;
    std::vector<Vec3> normals;  // per vertex or empty
    std::vector<Vec2> uv;       // per vertex or empty
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

using Shape = std::variant<SphereShape, BoxShape, PlaneShape, RectangleShape, MeshShape,
                           TriangleShape, ParallelogramShape, DiskShape, CylinderShape, ConeShape,
                           CapsuleShape, RoundedBoxShape>;

/// A visible object. Without a `track` it is static at `world_from_object`, which may scale, shear
/// and mirror it. With a track the same map leads to the axes of the body that the track moves.
struct ObjectDescription {
    std::string name;
    Shape shape;
    Mat44 world_from_object{};  // p_world = p_object * world_from_object; affine, invertible
    std::string track;          // name of a track of the timeline; empty: static
    std::string material;       // name in SceneDescription::materials
};

// ---- lights ---------------------------------------------------------------------------------
// `kKind` is the key that names the kind in shots.

/// How the light of a lamp decreases with distance. `none` is for looks that physics does not
/// allow: the irradiance that a lamp causes does not depend on the distance. A lamp with a surface
/// gives every surface that faces it the irradiance pi x radiance, any other lamp its strength in
/// W/m^2. Cameras and specular reflections see the lamp with its radiance.
enum class Falloff { inverse_square, none };

/// One-sided: radiates from the side of its normal, from which the camera and reflections see it.
struct RectangleLight {
    static constexpr std::string_view kKind = "rectangle";
    Vec3 centre{0, 0, 1};
    Vec3 edge_u{0.5, 0, 0};  // half edges, orthogonal; the light spans centre +- edge_u +- edge_v
    Vec3 edge_v{0, 0.5, 0};
    Vec3 normal{0, 0, -1};   // unit, orthogonal to both
    Vec3 radiance{1, 1, 1};  // W/(m^2 sr)
    Falloff falloff = Falloff::inverse_square;
};

struct SphereLight {
    static constexpr std::string_view kKind = "sphere";
    Vec3 centre{0, 0, 1};
    double radius = 0.05;  // m, > 0
    Vec3 radiance{1, 1, 1};
    Falloff falloff = Falloff::inverse_square;
};

/// The clear sky of Preetham, Shirley and Smits 1999 (render/light/sky.h), without the sun itself.
struct Sky {
    Vec3 sun{1, 0, 1};           // direction to the sun, above the horizon
    double turbidity = 3;        // [2, 10]: 2 very clear, 3 clear, 6 hazy
    Vec3 ground{0.2, 0.2, 0.2};  // albedo of everything below the horizon
};

/// Light from infinitely far away in all directions: constant, an equirectangular image (Z up, its
/// centre column towards +x rotated by `rotation` about z) or a sky.
struct EnvironmentLight {
    static constexpr std::string_view kKind = "environment";
    Vec3 radiance{1, 1, 1};  // multiplies the image or sky
    std::string image;       // absolute path; empty: constant, or a sky
    double rotation = 0;     // rad, counter-clockwise seen from above
    std::optional<Sky> sky{};
};

/// Radiates from one point in all directions. It is invisible, also in reflections.
struct PointLight {
    static constexpr std::string_view kKind = "point";
    Vec3 position{0, 0, 1};
    Vec3 intensity{1, 1, 1};  // W/sr; W/m^2 without falloff
    Falloff falloff = Falloff::inverse_square;
};

/// A point light within a cone: full intensity within the inner angle, none outside the outer one,
/// and a smooth transition between.
struct SpotLight {
    static constexpr std::string_view kKind = "spot";
    Vec3 position{0, 0, 1};
    Vec3 direction{0, 0, -1};  // of the axis
    Vec3 intensity{1, 1, 1};   // W/sr; W/m^2 without falloff
    double inner_angle = 0.3;  // rad, from the axis, [0, outer_angle]
    double outer_angle = 0.4;  // rad, (0, pi]
    Falloff falloff = Falloff::inverse_square;
};

/// Parallel light from infinitely far away. It is invisible.
struct DirectionalLight {
    static constexpr std::string_view kKind = "directional";
    Vec3 direction{0, 0, -1};  // in which the light travels
    Vec3 irradiance{1, 1, 1};  // of a surface that faces it, W/m^2
};

struct LightDescription {
    std::string name;
    std::variant<RectangleLight, SphereLight, EnvironmentLight, PointLight, SpotLight,
                 DirectionalLight>
        light;
};

struct SceneDescription {
    std::vector<ObjectDescription> objects;
    std::vector<MaterialDescription> materials;
    std::vector<LightDescription> lights;  // at most one environment
};

}  // namespace carom::render
