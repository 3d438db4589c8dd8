// Tests of lamps: what their keys make of light and of what is seen around it.
#include <algorithm>
#include <numbers>

#include <gmock/gmock.h>

#include "core/colour.h"
#include "render/light/light_power.h"
#include "tests/pipeline/config/load.h"

namespace carom::pipeline {
namespace {

constexpr double kPi = std::numbers::pi;

const render::ObjectDescription& object(const Shot& shot, const std::string& name) {
    return *std::ranges::find(shot.scene.objects, name, &render::ObjectDescription::name);
}

template <class Light>
const Light& light(const Shot& shot, std::size_t number = 0) {
    return std::get<Light>(shot.scene.lights.at(number).light);
}

double lumens_of(const Shot& shot) {
    return render::kLumensPerWatt * luminance(*render::power_of(shot.scene.lights.at(0)));
}

TEST(Lamps, Disk_FillsItsFields) {
    const Shot shot = load_sections(
        "lights: {lamp: {disk: 15 cm, at: [1, 2, 3], facing: [0, 3, 0], radiance: 20, strength: 2, "
        "beam: 3}}\n");
    const auto& disk = light<render::DiskLight>(shot);
    EXPECT_EQ(disk.radius, 0.15);
    EXPECT_EQ(disk.centre, Vec3(1, 2, 3));
    EXPECT_EQ(disk.normal, Vec3(0, 1, 0));
    EXPECT_EQ(disk.radiance, Vec3(40));
    EXPECT_EQ(disk.beam, 3);
}

TEST(Lamps, Panel_IsARectangleInAHousing) {
    const Shot shot = load_sections("lights: {lamp: {panel: [2, 1], at: [0, 0, 1.6]}}\n");
    const auto& panel = light<render::RectangleLight>(shot);
    EXPECT_EQ(panel.edge_u, Vec3(1, 0, 0));
    EXPECT_EQ(panel.beam, 1);
    const render::ObjectDescription& housing = object(shot, "lamp/housing");
    EXPECT_EQ(housing.material, "lamp_housing");
    const Vec3 size = std::get<render::BoxShape>(housing.shape).size;
    EXPECT_GT(size.x, 2);
    EXPECT_LT(size.x, 2.05);
    // All of it lies behind the light.
    EXPECT_GT((Vec3(0, 0, -size.z / 2) * housing.world_from_object).z - 1.6, 0);
    EXPECT_EQ(shot.scene.materials.size(), 1U);
}

TEST(Lamps, Tube_IsAnObjectThatShines) {
    const Shot shot = load_sections(
        "lights: {lamp: {tube: {length: 1.2, radius: 13 mm, along: [0, 1, 0]}, at: [0, 0, 2], "
        "radiance: 30}}\n");
    const render::ObjectDescription& tube = object(shot, "lamp/tube");
    EXPECT_EQ(std::get<render::CapsuleShape>(tube.shape).length, 1.2);
    EXPECT_NEAR((Vec3(0, 0, 0.6) * tube.world_from_object - Vec3(0, 0.6, 2)).length(), 0, 1e-12);
    EXPECT_EQ(tube.material, "lamp/tube");
    ASSERT_EQ(shot.scene.materials.size(), 1U);
    EXPECT_EQ(std::get<Vec3>(shot.scene.materials[0].surface.emission), Vec3(30));
    EXPECT_TRUE(shot.scene.lights.empty());
}

TEST(Lamps, Shade_IsALightWithItsOutside) {
    const Shot shot = load_sections(
        "materials: {brass: {standard: {base: 0.4, metal: 1}}}\n"
        "lights: {lamp: {shade: {radius: 20 cm, top_radius: 5 cm, height: 24 cm, bulge: 0.5, disk: "
        "15 cm, depth: 4 cm, albedo: 0.7, material: brass}, at: [0, 0, 1.1], radiance: 30}}\n");
    const auto& shade = light<render::ShadeLight>(shot);
    EXPECT_EQ(shade.shape.squares(), (render::ShadeShape{0.2, 0.05, 0.24, 0.5}.squares()));
    EXPECT_EQ(shade.disk_radius, 0.15);
    EXPECT_EQ(shade.depth, 0.04);
    EXPECT_EQ(shade.albedo, Vec3(0.7));
    EXPECT_EQ(shade.radiance, Vec3(30));
    const render::ObjectDescription& outside = object(shot, "lamp/shade");
    EXPECT_EQ(outside.material, "brass");
    const auto& mesh = std::get<render::MeshShape>(outside.shape);
    double widest = 0;
    for (const Vec3& vertex : mesh.vertices) {
        const Vec3 place = vertex * outside.world_from_object;
        EXPECT_GE(place.z, 1.1 - 1e-12);
        EXPECT_LE(place.z, 1.34 + 1e-12);
        widest = std::max(widest, Vec2(place.x, place.y).length());
    }
    EXPECT_NEAR(widest, 0.202, 1e-12);
}

/// Its triangles enclose the volume of the body of revolution, with the front outside. The ring of
/// the rim and the cap at the top belong to it; the opening is closed by the point where it lies.
TEST(Lamps, OutsideOfAShade_FacesOutwards) {
    const Shot shot = load_sections(
        "lights: {lamp: {shade: {radius: 20 cm, top_radius: 10 cm, height: 30 cm}, at: [0, 0, 0]}}"
        "\n");
    const auto& mesh = std::get<render::MeshShape>(object(shot, "lamp/shade").shape);
    double volume = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        volume += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c])) / 6;
        const Vec3 face =
            (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
        EXPECT_GT(face.dot(mesh.normals[a]), 0);
    }
    const double r = 0.202;
    const double s = 0.102;
    EXPECT_NEAR(volume, kPi / 3 * 0.299 * (r * r + r * s + s * s), 2e-4);
}

TEST(Lamps, Lumens_DecideTheRadiance) {
    const std::string sizes[] = {
        "disk: 0.2", "rectangle: [2, 1]", "panel: [2, 1]", "sphere: 0.1",
        "shade: {radius: 0.2, top_radius: 0.1, height: 0.2, disk: 0.05, depth: 0.15}"};
    for (const std::string& size : sizes) {
        const Shot shot =
            load_sections("lights: {lamp: {" + size + ", lumens: 4500, radiance: [3, 2, 1]}}\n");
        EXPECT_NEAR(lumens_of(shot), 4500, 1e-3) << size;
        EXPECT_NEAR(lumens_of(load_sections("lights: {lamp: {" + size +
                                            ", lumens: 4500, strength: 0.5}}\n")),
                    2250, 1e-3)
            << size;
    }
    const Vec3 colour = light<render::DiskLight>(
                            load_sections("lights: {lamp: {disk: 1, lumens: 9, radiance: [3, 2, "
                                          "1]}}\n"))
                            .radiance;
    EXPECT_NEAR(colour.x / colour.z, 3, 1e-12);
    const Shot tube =
        load_sections("lights: {lamp: {tube: {length: 1, radius: 1 cm}, lumens: 1790}}\n");
    const Vec3 radiance = std::get<Vec3>(tube.scene.materials.at(0).surface.emission);
    EXPECT_NEAR(radiance.x, 10 / (kPi * 2 * kPi * 0.01 * 1.02), 1e-5);
}

TEST(Lamps, DiskOfAShade_FillsNineTenthsByDefault) {
    const Shot shot = load_sections(
        "lights: {lamp: {shade: {radius: 20 cm, top_radius: 20 cm, height: 20 cm}}}\n");
    EXPECT_NEAR(light<render::ShadeLight>(shot).disk_radius, 0.18, 1e-12);
}

}  // namespace
}  // namespace carom::pipeline
