// The coordinates of textures at the corners of triangles.
#pragma once

#include <vector>

#include "pipeline/export/textures/texture_place.h"
#include "render/geometry/triangle_mesh.h"
#include "render/scene/scene_description.h"

namespace carom::pipeline {

/// Where a mesh that was made of an object is on the object.
struct MeshOnObject {
    const render::Shape& shape;
    Mat44 object_from_mesh{};    // from the mesh's axes to those of the shape
    Mat44 metres_from_object{};  // to axes in which textures are laid: scaled like the object
};

/// The most places that one mesh may have: three.js reads no more.
inline constexpr std::size_t kMostTexturePlaces = 4;

/// The directions u and v of a texture that is upright when seen from the side `facing` (unit
/// length): with z up, or for the sides that face z, with y up.
struct FlatAxes {
    Vec3 u;
    Vec3 v;
};
[[nodiscard]] FlatAxes flat_axes(const Vec3& facing);

/// For each place one list of coordinates, with v up, one per vertex. Vertices at which a place has
/// several coordinates are divided. `mesh.uv` are the shape's; a mesh without uv has the weights of
/// the second and third corner of each triangle. At most kMostTexturePlaces places.
[[nodiscard]] std::vector<std::vector<Imath::V2f>> texture_coordinates(
    render::TriangleMesh& mesh, const std::vector<TexturePlace>& places, const MeshOnObject& on);

}  // namespace carom::pipeline
