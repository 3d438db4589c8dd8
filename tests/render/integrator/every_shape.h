// All shapes with a texture, at rest along the axes, at rest in any position, or moving.
#pragma once

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

#include "tests/render/scene_builder.h"

namespace carom::test {

enum class Placement { upright, turned, moving };

struct PlacedShape {
    std::string name;
    render::Shape shape;
    Vec3 scale{1, 1, 1};
};

/// A bent sheet with normals and uv.
inline render::MeshShape bent_sheet() {
    render::MeshShape sheet;
    sheet.vertices = {Vec3(-0.15, -0.15, 0), Vec3(0.15, -0.15, 0.06), Vec3(0.15, 0.15, 0),
                      Vec3(-0.15, 0.15, 0.06)};
    sheet.normals = {Vec3(0, 0, 1), Vec3(0.3, 0, 1).normalized(), Vec3(0, 0.2, 1).normalized(),
                     Vec3(0, 0, 1)};
    sheet.uv = {Vec2(0, 0), Vec2(2, 0.1), Vec2(1.9, 1), Vec2(0.1, 1.1)};
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
    return sheet;
}

/// About 0.3 m wide.
inline std::vector<PlacedShape> every_shape() {
    return {{"ball", render::SphereShape{0.12}},
            {"ellipsoid", render::SphereShape{0.12}, Vec3(1.3, 0.6, 1)},
            {"box", render::BoxShape{Vec3(0.2, 0.25, 0.1)}},
            {"rectangle", render::RectangleShape{Vec2(0.25, 0.2)}},
            {"triangle", render::TriangleShape{{{{-0.1, -0.1, 0}, {0.2, -0.1, 0}, {0, 0.2, 0}}}}},
            {"disk", render::DiskShape{0.14}},
            {"cylinder", render::CylinderShape{0.08, 0.2}},
            {"cone", render::ConeShape{0.12, 0.03, 0.2}, Vec3(1, 0.8, 1.1)},
            {"capsule", render::CapsuleShape{0.06, 0.15}},
            {"rounded box", render::RoundedBoxShape{Vec3(0.2, 0.16, 0.12), 0.03}},
            {"sheet", bent_sheet()},
            {"plane", render::PlaneShape{}}};
}

/// In rows above the table; the plane lies below it.
inline Vec3 place_of(std::size_t index, const std::string& name) {
    const double x = 0.3 * static_cast<double>(index % 4) - 0.45;
    const double y = 0.35 * static_cast<double>(index / 4) - 0.6;
    return name == "plane" ? Vec3(0, 0, -0.3) : Vec3(x, y, 0.22);
}

inline Quat rotation_of(std::size_t index, const std::string& name) {
    const double half = name == "plane" ? 0.02 : 0.2 + 0.1 * static_cast<double>(index % 4);
    return {std::cos(half), std::sin(half) * Vec3(0.6, -0.48, 0.64)};
}

inline void add_every_shape(SceneBuilder& builder, Placement placement,
                            const std::string& material) {
    const std::vector<PlacedShape> shapes = every_shape();
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        Mat44 map;
        map.setScale(shapes[i].scale);
        if (placement == Placement::turned) {
            map = map * rotation_of(i, shapes[i].name).toMatrix44();
        }
        if (placement != Placement::moving) {
            map = map * moved_to(place_of(i, shapes[i].name));
        } else if (shapes[i].name == "cylinder") {
            map = map * moved_to(Vec3(0.02, 0, 0.05));  // beside the body's origin
        }
        const std::string track = placement == Placement::moving ? "of " + shapes[i].name : "";
        builder.scene.objects.push_back(
            {"every " + shapes[i].name, shapes[i].shape, map, track, material});
    }
}

/// Translations and rotations during a shutter of that length.
inline std::vector<sim::Track> tracks_of_every_shape(double shutter) {
    std::vector<sim::Track> tracks;
    const std::vector<PlacedShape> shapes = every_shape();
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const Vec3 axis(0.36, 0.48, 0.8);
        constexpr double kTurn = 0.4;  // rad
        sim::Key first;
        first.position = place_of(i, shapes[i].name);
        first.orientation = rotation_of(i, shapes[i].name);
        first.velocity_in = first.velocity_out = Vec3(2, 1, 0.5);
        first.angular_velocity_in = first.angular_velocity_out = kTurn / shutter * axis;
        sim::Key last = first;
        last.time = shutter;
        last.position = first.position + shutter * first.velocity_in;
        last.orientation =
            Quat(std::cos(0.5 * kTurn), std::sin(0.5 * kTurn) * axis) * first.orientation;
        tracks.emplace_back("of " + shapes[i].name, std::vector<sim::Key>{first, last});
    }
    return tracks;
}

/// A small picture, as a file for as long as this object exists.
class PictureFile {
  public:
    PictureFile()
        : path_(std::filesystem::temp_directory_path() /
                ("carom_every_shape_" + std::to_string(getpid()) + ".ppm")) {
        std::ofstream file(path_, std::ios::binary);
        file << "P6 8 8 255\n";
        for (int i = 0; i < 8 * 8 * 3; ++i) {
            file.put(static_cast<char>(40 + 37 * i * i % 200));
        }
    }
    ~PictureFile() { std::filesystem::remove(path_); }
    PictureFile(const PictureFile&) = delete;
    PictureFile& operator=(const PictureFile&) = delete;

    [[nodiscard]] std::string path() const { return path_.string(); }

  private:
    std::filesystem::path path_;
};

}  // namespace carom::test
