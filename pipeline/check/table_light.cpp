#include "pipeline/check/table_light.h"

#include <algorithm>
#include <cstddef>
#include <numbers>

#include <fmt/core.h>

#include "core/colour.h"
#include "core/error.h"
#include "render/film/film.h"
#include "render/frame/frame.h"
#include "render/light/light_power.h"
#include "render/scene/still_scene.h"

namespace carom::pipeline {

namespace {

constexpr double kDisk = 0.012;   // m, radius of a disk
constexpr double kAbove = 0.003;  // m, above the surface: more than what is proud of it
constexpr double kCamera = 0.02;  // m, above the disk
constexpr double kAlbedo = 0.5;
constexpr int kPixels = 16;   // of the side of a picture of a disk
constexpr int kSamples = 64;  // per pixel
constexpr const char* kMaterial = "table_light/disk";

Vec3 point_of(const sim::billiards::TableMeasures& table, std::size_t row, std::size_t column) {
    const double x = static_cast<double>(column) - 1;
    const double y = 1 - static_cast<double>(row);
    const bool is_on_rail = table.has_cushions && (x != 0 || y != 0);
    const Vec2 outline = sim::billiards::half_outline(table);
    const Vec2 bed(table.length / 2, table.width / 2);
    // Between the nose of the cushion and the edge of the table.
    const Vec2 half = is_on_rail ? (bed + outline) / 2 : bed;
    return {x * half.x, y * half.y, (is_on_rail ? table.rail_height : 0) + kAbove};
}

/// All that is at rest, with a white disk at each point.
render::SceneDescription scene_with_disks(const Shot& shot) {
    render::SceneDescription scene = render::still_scene(shot.scene);
    scene.far.reset();  // nine small pictures need no light that is computed for all of a room
    render::StandardMaterial white;
    white.base = Vec3(kAlbedo, kAlbedo, kAlbedo);
    scene.materials.push_back({kMaterial, white});
    for (std::size_t i = 0; i < 9; ++i) {
        render::ObjectDescription disk;
        disk.name = fmt::format("table_light/{}", i);
        disk.shape = render::DiskShape{kDisk};
        disk.world_from_object.setTranslation(point_of(*shot.world.table, i / 3, i % 3));
        disk.material = kMaterial;
        scene.objects.push_back(disk);
    }
    return scene;
}

render::FrameInput view_of(const Vec3& point) {
    render::CameraState camera;
    camera.position = point + Vec3(0, 0, kCamera);
    camera.target = point;
    camera.up = Vec3(0, 1, 0);
    camera.vertical_fov = std::numbers::pi / 6;  // less than the disk
    camera.focus_distance = kCamera;
    render::FrameInput frame;
    frame.camera_open = frame.camera_close = camera;
    return frame;
}

Vec3 mean_of(const render::Film& film) {
    Vec3 sum(0, 0, 0);
    for (std::size_t i = 0; i < film.rgba.size(); i += 4) {
        sum += Vec3(film.rgba[i], film.rgba[i + 1], film.rgba[i + 2]);
    }
    return sum / (static_cast<double>(film.rgba.size()) / 4);
}

}  // namespace

double TableLight::least() const {
    double result = lux[0][0];
    for (const auto& row : lux) {
        result = std::min(result, *std::ranges::min_element(row));
    }
    return result;
}

double TableLight::greatest() const {
    double result = 0;
    for (const auto& row : lux) {
        result = std::max(result, *std::ranges::max_element(row));
    }
    return result;
}

TableLight light_on_table(const Shot& shot) {
    if (!shot.world.table) {
        throw Error("the shot has no table whose light could be measured");
    }
    render::RenderSettings settings;
    settings.width = kPixels;
    settings.height = kPixels;
    settings.samples = kSamples;
    settings.filter = render::PixelFilter::box;
    settings.filter_width = 1;
    const render::PreparedScene scene(scene_with_disks(shot), settings);
    TableLight result;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            const Vec3 point = point_of(*shot.world.table, row, column);
            const render::Film film = render_frame(scene, {}, view_of(point), settings);
            const double radiance = luminance(mean_of(film));
            result.lux[row][column] =
                render::kLumensPerWatt * std::numbers::pi * radiance / kAlbedo;
        }
    }
    return result;
}

std::string text_of(const TableLight& light) {
    std::string text;
    for (const auto& row : light.lux) {
        text += fmt::format("{:8.0f}{:8.0f}{:8.0f}\n", row[0], row[1], row[2]);
    }
    return text + fmt::format("least {:.0f} lx, greatest {:.0f} lx, ratio {:.2f}\n", light.least(),
                              light.greatest(),
                              light.greatest() > 0 ? light.least() / light.greatest() : 1);
}

}  // namespace carom::pipeline
