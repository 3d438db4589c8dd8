// The visible scene as plain data: shapes, materials, textures, lights. World axes, metres, Z up;
// colour is linear Rec.709, scene-referred. `fields_of` lists the fields of each in the order in
// which they are hashed (core/fields.h).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/fields.h"
#include "core/vectors.h"
#include "render/scene/light_description.h"
#include "render/scene/material_description.h"

namespace carom::render {

// ---- shapes, in the object's own axes --------------------------------------------------------
//
// kName is the shape's key in a shot. Hashes and JSON are made from the lists of fields.

struct SphereShape {
    static constexpr const char* kName = "sphere";
    double radius = 1;  // centre at the origin
};
constexpr auto fields_of(Describes<SphereShape>) {
    return fields<SphereShape>(field("radius", &SphereShape::radius));
}

struct BoxShape {
    static constexpr const char* kName = "box";
    Vec3 size{1, 1, 1};  // full edges, centre at the origin
};
constexpr auto fields_of(Describes<BoxShape>) {
    return fields<BoxShape>(field("size", &BoxShape::size));
}

/// The infinite plane z = 0 with normal +z.
struct PlaneShape {
    static constexpr const char* kName = "plane";
};
constexpr auto fields_of(Describes<PlaneShape>) {
    return fields<PlaneShape>();
}

/// Centre at the origin, normal +z, size x by y.
struct RectangleShape {
    static constexpr const char* kName = "rectangle";
    Vec2 size{1, 1};
};
constexpr auto fields_of(Describes<RectangleShape>) {
    return fields<RectangleShape>(field("size", &RectangleShape::size));
}

/// The front is the side from which the corners run counter-clockwise; uv are the weights of the
/// second and third corner.
struct TriangleShape {
    static constexpr const char* kName = "triangle";
    std::array<Vec3, 3> corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};  // not collinear
};
constexpr auto fields_of(Describes<TriangleShape>) {
    return fields<TriangleShape>(field("corners", &TriangleShape::corners));
}

/// Corners: `corner`, `corner` + `edge_u`, `corner` + `edge_v` and `corner` + `edge_u` + `edge_v`;
/// the front is the side from which the turn from `edge_u` to `edge_v` is counter-clockwise. u and
/// v run along the edges.
struct ParallelogramShape {
    static constexpr const char* kName = "parallelogram";
    Vec3 corner{0, 0, 0};
    Vec3 edge_u{1, 0, 0};  // not parallel to edge_v
    Vec3 edge_v{0, 1, 0};
};
constexpr auto fields_of(Describes<ParallelogramShape>) {
    using T = ParallelogramShape;
    return fields<T>(field("corner", &T::corner), field("edge_u", &T::edge_u),
                     field("edge_v", &T::edge_v));
}

/// Centre at the origin, normal +z.
struct DiskShape {
    static constexpr const char* kName = "disk";
    double radius = 1;
};
constexpr auto fields_of(Describes<DiskShape>) {
    return fields<DiskShape>(field("radius", &DiskShape::radius));
}

/// Solid, about z, from z = -height / 2 to height / 2.
struct CylinderShape {
    static constexpr const char* kName = "cylinder";
    double radius = 1;
    double height = 1;
};
constexpr auto fields_of(Describes<CylinderShape>) {
    using T = CylinderShape;
    return fields<T>(field("radius", &T::radius), field("height", &T::height));
}

/// Solid, about z, from z = -height / 2 to height / 2. One of the radii may be 0 (the tip).
struct ConeShape {
    static constexpr const char* kName = "cone";
    double radius = 1;  // at the bottom
    double top_radius = 0;
    double height = 1;
};
constexpr auto fields_of(Describes<ConeShape>) {
    using T = ConeShape;
    return fields<T>(field("radius", &T::radius), field("top_radius", &T::top_radius),
                     field("height", &T::height));
}

/// A cylinder about z with a hemisphere at each end, centre at the origin.
struct CapsuleShape {
    static constexpr const char* kName = "capsule";
    double radius = 1;
    double length = 1;  // between the centres of its ends
};
constexpr auto fields_of(Describes<CapsuleShape>) {
    using T = CapsuleShape;
    return fields<T>(field("radius", &T::radius), field("length", &T::length));
}

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
constexpr auto fields_of(Describes<RoundedBoxShape>) {
    using T = RoundedBoxShape;
    return fields<T>(field("size", &T::size), field("radius", &T::radius));
}

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
constexpr auto fields_of(Describes<MeshShape>) {
    using T = MeshShape;
    return fields<T>(file_field("file", &T::file), field("smooth_angle", &T::smooth_angle),
                     field("vertices", &T::vertices), field("normals", &T::normals),
                     field("uv", &T::uv), field("triangles", &T::triangles));
}

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
constexpr auto fields_of(Describes<ObjectDescription>) {
    using T = ObjectDescription;
    return fields<T>(
        unhashed("name", &T::name, "only mattes show it: frame_key adds it for them"),
        field("shape", &T::shape), field("world_from_object", &T::world_from_object),
        hashed_elsewhere("track", &T::track, "hash_scene adds whether there is one, frame_key it"),
        hashed_elsewhere("material", &T::material, "hash_scene adds the material of that name"));
}

/// The surroundings of a table whose light is computed once (render/light/far_light.h): the static
/// surfaces farther than `distance` from a box.
struct FarRegion {
    Vec3 low{-1, -1, -1}, high{1, 1, 1};  // the box, m
    double distance = 1.5;                // m
    double cell = 0.03;                   // m, > 0: least side of a cell that has one light
    double cell_growth = 1.0 / 60;        // ... and at least this fraction of its distance, >= 0
    int samples = 128;                    // paths of each cell, >= 1
    std::string file;  // absolute path of the light, which counts if it is this scene's; or empty
};
constexpr auto fields_of(Describes<FarRegion>) {
    using T = FarRegion;
    return fields<T>(field("low", &T::low), field("high", &T::high),
                     field("distance", &T::distance), field("cell", &T::cell),
                     field("cell_growth", &T::cell_growth), field("samples", &T::samples),
                     unhashed("file", &T::file, "it has the light that would be computed"));
}

struct SceneDescription {
    std::vector<ObjectDescription> objects;
    std::vector<MaterialDescription> materials;
    std::vector<LightDescription> lights;  // at most one environment
    std::optional<FarRegion> far{};
};

}  // namespace carom::render
