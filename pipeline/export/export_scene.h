// A shot and its timeline as what interchange formats know: triangles, plain materials, keys.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "pipeline/export/linear_keys.h"
#include "pipeline/shot/shot.h"
#include "render/camera/camera_state.h"
#include "render/geometry/triangle_mesh.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// One colour where ours has a texture: a ball's own, a cloth's, the mean of a wood's.
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
};

/// Triangles [first, first + count) of a mesh that have one material.
struct ExportPatch {
    std::size_t first = 0;
    std::size_t count = 0;
    std::size_t material = 0;
};

/// An object. Its mesh is in body axes, in metres, at its real size.
struct ExportPart {
    std::string name;
    render::TriangleMesh mesh;  // normals of unit length, or none
    std::vector<ExportPatch> patches;
    LinearKeys keys;  // one: it stands still there
};

struct ExportCameraKey {
    double video_time = 0;
    double scene_time = 0;
    render::CameraState state;
};

struct ExportCamera {
    std::string name;
    std::vector<ExportCameraKey> keys;  // frame by frame, in order of the film
    double sensor_height = 0.024;       // m

    /// The keys in order of scene time, each time once: what it did on the scene's clock. Where
    /// time stands still only the first instant is left.
    [[nodiscard]] std::vector<ExportCameraKey> by_scene_time() const;
};

struct ExportScene {
    std::string name;
    double start_time = 0;  // scene time, s
    double end_time = 0;
    double fps = 24;
    double aspect = 16.0 / 9;  // width by height of the picture
    std::vector<ExportMaterial> materials;
    std::vector<ExportPart> parts;
    std::vector<ExportPart> lamps;  // lights with an area, as what shines
    std::vector<ExportCamera> cameras;
    std::vector<render::LightDescription> lights;
};

/// Axes of a camera: right, up, backwards; of unit length and at right angles, world axes.
struct CameraAxes {
    Vec3 right, up, back;

    [[nodiscard]] Quat orientation() const;  // that turns x, y, z into them
};
[[nodiscard]] CameraAxes camera_axes(const render::CameraState& state);

/// Throws Error: a mesh file, a camera that makes no picture, more keys than kMostExportKeys.
[[nodiscard]] ExportScene export_scene(const Shot& shot, const sim::Timeline& timeline);

inline constexpr std::size_t kMostExportKeys = 2'000'000;  // of one object

}  // namespace carom::pipeline
