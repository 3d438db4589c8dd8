#include <cmath>
#include <numbers>

#include "lab/comparison/scene_parts.h"

namespace carom::pipeline {

// "A teapot in a stadium": all detail is concentrated in a small part of the scene.
LaboratoryScene stadium() {
    LaboratoryScene scene = empty_scene("stadium", {160, 120, 4, 1});
    add_surface(scene, "stand", {0.5, 0.5, 0.55});
    add_surface(scene, "pitch", {0.2, 0.5, 0.2});
    add_surface(scene, "pot", {0.7, 0.45, 0.2}, 0.2);
    add_object(scene, render::BoxShape{{220, 160, 1}}, moved_to({0, 0, -0.5}), "pitch");
    constexpr int kSectors = 48;
    constexpr int kTiers = 10;
    for (int tier = 0; tier < kTiers; ++tier) {
        for (int sector = 0; sector < kSectors; ++sector) {
            const double turn = 2 * std::numbers::pi * (sector + 0.5) / kSectors;
            const Vec3 outward(std::cos(turn), std::sin(turn), 0);
            const Vec3 place((70 + 3.0 * tier) * outward.x, (50 + 3.0 * tier) * outward.y,
                             0.5 + tier);
            Mat44 map;
            map.rotate(Vec3(0, 0, turn));
            map[3][0] = place.x;
            map[3][1] = place.y;
            map[3][2] = place.z;
            add_object(scene, render::BoxShape{{2.6, 6, 1 + 2.0 * tier}}, map, "stand");
        }
    }
    add_object(scene, knot_mesh(2'000, 0.25), moved_to({0, 0, 0.16}), "pot");
    add_point_light(scene, {60, -40, 50}, 9000);
    add_point_light(scene, {-30, -60, 50}, 7000);
    set_camera(scene, {0.7, -1.1, 0.55}, {0, 0, 0.14}, 0.6);
    return scene;
}

LaboratoryScene smooth_mesh() {
    LaboratoryScene scene = empty_scene("smooth_mesh", {320, 240, 4, 1});
    add_surface(scene, "floor", {0.6, 0.6, 0.6});
    add_surface(scene, "knot", {0.3, 0.45, 0.75}, 0.3);
    render::MeshShape mesh = knot_mesh(100'000, 1);
    mesh.smooth_angle = std::numbers::pi / 3;
    add_object(scene, std::move(mesh), moved_to({0, 0, 0.45}), "knot");
    add_object(scene, render::BoxShape{{8, 8, 0.2}}, moved_to({0, 0, -0.1}), "floor");
    add_point_light(scene, {3, -3, 4}, 30);
    add_point_light(scene, {-4, -2, 3}, 20);
    set_camera(scene, {1.4, -2.8, 1.8}, {0, 0, 0.35}, 0.6);
    return scene;
}

}  // namespace carom::pipeline
