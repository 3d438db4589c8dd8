// A shot and its timeline in the terms of interchange formats: triangles, simple materials, keys.
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "pipeline/export/linear_keys.h"
#include "pipeline/export/textures/texture_place.h"
#include "pipeline/shot/shot.h"
#include "render/camera/camera_state.h"
#include "render/geometry/triangle_mesh.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// A material of one colour. It replaces a texture by the ball's colour, the cloth's colour or the
/// mean colour of wood; pictures, which MaterialTextures has, by grey.
struct ExportMaterial {
    std::string name;
    Vec3 base{0.8, 0.8, 0.8};  // linear
    double metal = 0;
    double roughness = 0.5;
    double transmission = 0;
    double ior = 1.5;
    double coat = 0;  // weight
    double coat_roughness = 0;
    Vec3 emission{0, 0, 0};
    double specular = 1;  // weight of the highlight; metals have their own
    Vec3 sheen{0, 0, 0};  // its colour times its weight
    double opacity = 1;
};

/// The pictures and flat patterns of a material.
struct MaterialTextures {
    std::shared_ptr<const render::StandardMaterial> surface;  // null: there is none
    std::vector<TexturePlace> places;  // in the order of the coordinates of meshes
    Vec2 relief_lengths{1, 1};         // over which coordinates of the relief grow by 1, m
};

/// The triangles [first, first + count) of a mesh, which have one material.
struct ExportPatch {
    std::size_t first = 0;
    std::size_t count = 0;
    std::size_t material = 0;
};

/// An object. Its mesh is in body axes, in metres, without scaling, less `origin`.
struct ExportPart {
    std::string name;
    /// In body axes, m; not zero for a mesh far from it whose coordinates, as those of maps, would
    /// lose their last digits as floats. Of a static object it is in the position of the key.
    Vec3 origin{0, 0, 0};
    render::TriangleMesh mesh;  // normals of unit length, or none; without uv
    /// Of textures, with v up: one list for each place of its materials, with one entry per vertex.
    /// An object without textures may have its uv.
    std::vector<std::vector<Imath::V2f>> coordinates;
    std::vector<ExportPatch> patches;
    LinearKeys keys;  // a single key: the object is static
};

struct ExportCameraKey {
    double video_time = 0;
    double scene_time = 0;
    render::CameraState state;
};

struct ExportCamera {
    std::string name;
    std::vector<ExportCameraKey> keys;  // one per frame, in order of video time
    double sensor_height = 0.024;       // m

    /// The keys sorted by scene time, without repeated times: the camera's motion in scene time. Of
    /// an interval in which scene time stops only the first key remains.
    [[nodiscard]] std::vector<ExportCameraKey> by_scene_time() const;
};

struct ExportScene {
    std::string name;
    double start_time = 0;  // scene time, s
    double end_time = 0;
    double fps = 24;
    double aspect = 16.0 / 9;  // width divided by height of the picture
    std::vector<ExportMaterial> materials;
    std::vector<MaterialTextures> textures;  // of each material
    std::vector<ExportPart> parts;
    std::vector<ExportPart> lamps;  // area lights, as emitting meshes
    std::vector<ExportCamera> cameras;
    std::vector<render::LightDescription> lights;
};

/// The orthonormal axes of a camera in world coordinates: right, up, backwards.
struct CameraAxes {
    Vec3 right, up, back;

    [[nodiscard]] Quat orientation() const;  // the rotation that maps x, y, z to them
};
[[nodiscard]] CameraAxes camera_axes(const render::CameraState& state);

/// The meshes of the shot without poses, motion, cameras and lights that have no surface, for a
/// viewer that moves them itself: every part is at the origin, unrotated. They stay the same when
/// objects are moved. Only objects with textures have coordinates. Throws Error if a mesh file
/// cannot be read.
[[nodiscard]] ExportScene export_meshes(const Shot& shot);

/// Throws Error if a mesh file cannot be read, a camera is invalid, or an object needs more than
/// kMostExportKeys keys.
[[nodiscard]] ExportScene export_scene(const Shot& shot, const sim::Timeline& timeline);

/// A path relative to the folder of the file in which it is written, with '/' between names, as in
/// "../rooms/hall.exr".
[[nodiscard]] std::string exported_path(const std::string& path, const std::string& folder);

inline constexpr std::size_t kMostExportKeys = 2'000'000;  // of one object

}  // namespace carom::pipeline
