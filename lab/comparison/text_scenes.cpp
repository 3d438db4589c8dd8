// The scenes of a thesis on acceleration structures ("RayTracer 2"). It states the numbers of
// shapes and lights, the size of the picture and the depth of the recursion; positions, camera and
// rays per pixel are ours, chosen so that the numbers of rays are close to the published ones.
#include <array>
#include <cmath>
#include <vector>

#include "lab/comparison/scene_parts.h"

namespace carom::pipeline {

namespace {

/// One of each pair of opposite directions to a cube's faces, edges and corners: 3 + 6 + 4.
std::vector<Vec3> thirteen_axes() {
    std::vector<Vec3> axes;
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            for (int z = -1; z <= 1; ++z) {
                if (9 * x + 3 * y + z > 0) {
                    axes.emplace_back(x, y, z);
                }
            }
        }
    }
    return axes;
}

void add_colours(LaboratoryScene& scene, double reflectance) {
    add_surface(scene, "red", {0.75, 0.16, 0.12}, reflectance);
    add_surface(scene, "green", {0.2, 0.55, 0.2}, reflectance);
    add_surface(scene, "blue", {0.15, 0.25, 0.7}, reflectance);
    add_surface(scene, "sand", {0.75, 0.65, 0.4}, reflectance);
}

constexpr std::array<const char*, 4> kColours{"red", "green", "blue", "sand"};

}  // namespace

LaboratoryScene sphere_cube() {
    constexpr int kSide = 15;
    LaboratoryScene scene = empty_scene("sphere_cube", {320, 240, 9, 0});
    add_colours(scene, 0);
    const double middle = 0.5 * (kSide - 1);
    for (int x = 0; x < kSide; ++x) {
        for (int y = 0; y < kSide; ++y) {
            for (int z = 0; z < kSide; ++z) {
                const std::size_t colour = static_cast<std::size_t>(x + 2 * y + 3 * z) % 4;
                add_object(scene, render::SphereShape{0.4},
                           moved_to({x - middle, y - middle, z - middle}), kColours[colour]);
            }
        }
    }
    add_point_light(scene, {60, -16, 12}, 2500);
    add_point_light(scene, {8, -60, 9}, 2500);
    set_camera(scene, {18.8, -24.7, 15.3}, {0, 0, 0}, 0.98);
    return scene;
}

LaboratoryScene cylinder_axes() {
    LaboratoryScene scene = empty_scene("cylinder_axes", {640, 360, 25, 1});
    add_colours(scene, 0.3);
    std::size_t colour = 0;
    for (const Vec3& axis : thirteen_axes()) {
        for (int i = -50; i <= 50; ++i) {
            add_object(scene, render::CylinderShape{0.5, 0.8},
                       turned_to(axis, axis.normalized() * (0.9 * i)), kColours[colour % 4]);
        }
        colour += 1;
    }
    add_point_light(scene, {60, -30, 60}, 5000);
    add_point_light(scene, {-20, -60, 30}, 4000);
    set_camera(scene, {9, -14, 7.7}, {0, 0, 0}, 0.5);
    return scene;
}

LaboratoryScene cylinder_walls() {
    constexpr int kSide = 50;
    LaboratoryScene scene = empty_scene("cylinder_walls", {320, 240, 25, 1});
    add_colours(scene, 0.3);
    const std::array<Vec3, 3> normals{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    for (std::size_t wall = 0; wall < 3; ++wall) {
        for (int i = 0; i < kSide; ++i) {
            for (int k = 0; k < kSide; ++k) {
                Vec3 place(0, 0, 0);
                place[static_cast<int>((wall + 1) % 3)] = i + 0.5;
                place[static_cast<int>((wall + 2) % 3)] = k + 0.5;
                add_object(scene, render::CylinderShape{0.42, 1},
                           turned_to(normals[wall], place - normals[wall] * 0.5),
                           kColours[(wall + static_cast<std::size_t>(i / 5 + k / 5)) % 4]);
            }
        }
    }
    add_point_light(scene, {40, 18, 44}, 4000);
    add_point_light(scene, {14, 42, 30}, 2500);
    set_camera(scene, {66, 58, 50}, {14, 13, 11}, 0.6);
    return scene;
}

LaboratoryScene full_view() {
    LaboratoryScene scene = empty_scene("full_view", {640, 360, 5, 0});
    add_surface(scene, "red", {0.75, 0.16, 0.12});
    add_object(scene, render::SphereShape{3}, moved_to({0, 0, 0}), "red");
    add_point_light(scene, {6, -9, 5}, 200);
    set_camera(scene, {0, -4.4, 0}, {0, 0, 0}, 0.7);
    return scene;
}

// The cylinder lies along a diagonal of the view: its box covers nearly all of the view, the
// cylinder itself about a half.
LaboratoryScene partial_view() {
    LaboratoryScene scene = empty_scene("partial_view", {640, 360, 5, 0});
    add_surface(scene, "red", {0.75, 0.16, 0.12});
    add_object(scene, render::CylinderShape{1.2, 6.52}, turned_to({16, 0, 9}, {0, 0, 0}), "red");
    add_point_light(scene, {-6, -12, 9}, 500);
    set_camera(scene, {0, -9, 0}, {0, 0, 0}, 0.5);
    return scene;
}

}  // namespace carom::pipeline
