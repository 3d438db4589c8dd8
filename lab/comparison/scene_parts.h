// Building blocks of the laboratory's scenes.
#pragma once

#include <cstddef>
#include <string>

#include "lab/comparison/laboratory_scene.h"

namespace carom::pipeline {

/// Width and height of the picture, rays per pixel, and number of reflections.
struct PictureSize {
    int width = 320, height = 240;
    int samples = 1;
    int depth = 0;
};

/// A scene without objects, rendered like the oldest ray tracers: the distributed integrator with
/// one shadow ray to each light and one reflected ray.
[[nodiscard]] LaboratoryScene empty_scene(const std::string& name, const PictureSize& size);

void add_surface(LaboratoryScene& scene, const std::string& name, const Vec3& colour,
                 double reflectance = 0);
void add_object(LaboratoryScene& scene, render::Shape shape, const Mat44& place,
                const std::string& surface);
void add_point_light(LaboratoryScene& scene, const Vec3& place, double intensity);
/// A static camera; `fov`: vertical, rad.
void set_camera(LaboratoryScene& scene, const Vec3& place, const Vec3& target, double fov);

[[nodiscard]] Mat44 moved_to(const Vec3& place);
/// A transform that maps the z axis to `axis`.
[[nodiscard]] Mat44 turned_to(const Vec3& axis, const Vec3& place);

/// A torus knot about the origin with the bounding radius `radius`, of about `triangles` triangles.
[[nodiscard]] render::MeshShape knot_mesh(std::size_t triangles, double radius);

// Each is one of laboratory_scene_names().
[[nodiscard]] LaboratoryScene sphere_cube();
[[nodiscard]] LaboratoryScene cylinder_axes();
[[nodiscard]] LaboratoryScene cylinder_walls();
[[nodiscard]] LaboratoryScene full_view();
[[nodiscard]] LaboratoryScene partial_view();
[[nodiscard]] LaboratoryScene stadium();
[[nodiscard]] LaboratoryScene smooth_mesh();

}  // namespace carom::pipeline
