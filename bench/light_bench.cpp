// What many lights cost: light_bench [--samples N] [--seeds N] [--width N]. A floor with balls is
// lit from above by four lamps side by side, by four disks and by four of them in shades, by a
// board of 5,000 light-emitting diodes as large as the lamps are together (a mesh of 10,000
// triangles), and by 1,000 small spheres scattered around, at rest and moving. For each it prints a
// row: CPU seconds, millions of rays, relMSE of the pixels that do not show a light, and how many
// times the CPU seconds of the four lamps an equal error takes: seconds times relMSE, over that of
// the lamps.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "bench/picture.h"
#include "core/cpu_time.h"
#include "tests/render/scene_builder.h"
#include "tests/render/statistics.h"

namespace carom::bench {
namespace {

constexpr double kShutter = 1.0 / 48;  // s

struct LitScene {
    std::string name;
    test::SceneBuilder builder;
    std::vector<sim::Track> tracks = {};
};

/// The floor and twelve balls with a highlight.
LitScene unlit(const std::string& name) {
    LitScene scene{name, {}};
    render::StandardMaterial floor;
    floor.base = Vec3(0.5, 0.5, 0.48);
    scene.builder.material("floor", floor);
    scene.builder.object("floor", render::PlaneShape{}, Vec3(0, 0, 0), "floor");
    for (int i = 0; i < 12; ++i) {
        const std::string ball = fmt::format("ball {}", i);
        render::StandardMaterial surface;
        surface.base =
            Vec3(i % 3 == 0 ? 0.7 : 0.2, i % 3 == 1 ? 0.6 : 0.2, i % 3 == 2 ? 0.6 : 0.15);
        surface.specular = 1;
        surface.roughness = 0.4;
        scene.builder.material(ball, surface);
        scene.builder.object(ball, render::SphereShape{0.12},
                             Vec3(-0.75 + 0.5 * (i % 4), -0.5 + 0.5 * (i / 4), 0.12), ball);
    }
    return scene;
}

LitScene with_lamps() {
    LitScene scene = unlit("4 lamps");
    for (int i = 0; i < 4; ++i) {
        render::RectangleLight lamp;
        lamp.centre = Vec3(i % 2 == 0 ? -0.5 : 0.5, i < 2 ? -0.25 : 0.25, 1.5);
        lamp.edge_u = Vec3(0.5, 0, 0);
        lamp.edge_v = Vec3(0, 0.25, 0);
        lamp.normal = Vec3(0, 0, -1);
        lamp.radiance = Vec3(4, 4, 4);
        scene.builder.scene.lights.push_back({fmt::format("lamp {}", i), lamp});
    }
    return scene;
}

/// `shades`: with a white inside, which opens as wide as the disk that it stands for.
LitScene with_disks(bool shades) {
    LitScene scene = unlit(shades ? "4 shades" : "4 disks");
    for (int i = 0; i < 4; ++i) {
        const std::string name = fmt::format("lamp {}", i);
        const Vec3 place(-0.9 + 0.6 * i, 0, 1.0);
        if (!shades) {
            render::DiskLight lamp;
            lamp.centre = place;
            lamp.radius = 0.2;
            lamp.radiance = Vec3(12, 12, 12);
            scene.builder.scene.lights.push_back({name, lamp});
            continue;
        }
        render::ShadeLight lamp;
        lamp.centre = place;
        lamp.shape = {0.2, 0.06, 0.22, 0};
        lamp.disk_radius = 0.1;
        lamp.depth = 0.1;
        lamp.radiance = Vec3(30, 30, 30);
        scene.builder.scene.lights.push_back({name, lamp});
        scene.builder.object(name, render::ConeShape{0.202, 0.06, 0.22}, place + Vec3(0, 0, 0.111),
                             "floor");
    }
    return scene;
}

LitScene with_board() {
    LitScene scene = unlit("board of 10,000 triangles");
    render::MeshShape board;
    const auto add = [&](double x, double y) {
        constexpr double kHalf = 0.002;  // m
        const auto first = static_cast<std::uint32_t>(board.vertices.size());
        for (const auto& [u, v] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
            board.vertices.emplace_back(x + u * kHalf, y - v * kHalf, 1.5);
        }
        board.triangles.push_back({first, first + 1, first + 2});
        board.triangles.push_back({first, first + 2, first + 3});
    };
    for (int i = 0; i < 100; ++i) {
        for (int j = 0; j < 50; ++j) {
            add(-1 + 0.02 * (i + 0.5), -0.5 + 0.02 * (j + 0.5));
        }
    }
    render::StandardMaterial light;
    light.base = Vec3(0, 0, 0);
    light.emission = Vec3(100, 100, 100);
    scene.builder.material("light", light);
    scene.builder.object("board", board, Vec3(0, 0, 0), "light");
    return scene;
}

/// Adds 1,000 small spheres scattered around.
void scatter_spheres(const render::StandardMaterial& surface, bool moving, LitScene& scene) {
    scene.builder.material("light", surface);
    test::TestRandom random(5);
    const auto within = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random.unit());
    };
    for (int i = 0; i < 1000; ++i) {
        const std::string name = fmt::format("light {}", i);
        const Vec3 at(within(-1.5, 1.5), within(-1.2, 1.5), within(0.02, 1));
        if (moving) {
            const Vec3 by(within(-0.04, 0.04), within(-0.04, 0.04), within(0, 0.04));
            scene.builder.object(name, render::SphereShape{0.008}, Vec3(0, 0, 0), "light");
            scene.builder.scene.objects.back().track = name;
            scene.tracks.push_back(test::straight_track(name, at, at + by, 0, kShutter));
        } else {
            scene.builder.object(name, render::SphereShape{0.008}, at, "light");
        }
    }
}

LitScene with_spheres(bool moving) {
    LitScene scene = unlit(moving ? "1,000 moving spheres" : "1,000 spheres");
    render::StandardMaterial light;
    light.base = Vec3(0, 0, 0);
    light.emission = Vec3(40, 40, 40);
    scatter_spheres(light, moving, scene);
    return scene;
}

/// What the spheres cost that do not shine: rays among them, and their shadows.
LitScene with_lamps_among_spheres() {
    LitScene scene = with_lamps();
    scene.name = "4 lamps among 1,000 black spheres";
    render::StandardMaterial black;
    black.base = Vec3(0, 0, 0);
    scatter_spheres(black, false, scene);
    return scene;
}

render::Film render_once(const LitScene& scene, const render::PreparedScene& prepared,
                         const render::RenderSettings& settings, int seed) {
    render::FrameInput frame = test::static_frame(
        test::camera(Vec3(0, -2.6, 1.3), Vec3(0, 0.1, 0.2), 42 * std::numbers::pi / 180));
    frame.scene_close = kShutter;
    frame.seed = static_cast<std::uint64_t>(seed);
    return render_frame(prepared, scene.tracks, frame, settings);
}

/// Which pixels show a light: all else is black.
std::vector<bool> lights_in(LitScene scene, render::RenderSettings settings) {
    for (render::MaterialDescription& material : scene.builder.scene.materials) {
        material.surface.base = Vec3(0, 0, 0);
        material.surface.specular = 0;
    }
    settings.samples = 64;
    settings.max_bounces = 0;
    const render::PreparedScene prepared(scene.builder.scene, settings);
    const render::Film film = render_once(scene, prepared, settings, 0);
    std::vector<bool> lit(film.rgba.size() / 4);
    constexpr int kAround = 3;  // pixels: the filter, and what few samples miss
    for (int y = 0; y < settings.height; ++y) {
        for (int x = 0; x < settings.width; ++x) {
            for (int v = std::max(0, y - kAround); v < std::min(settings.height, y + kAround + 1);
                 ++v) {
                for (int u = std::max(0, x - kAround);
                     u < std::min(settings.width, x + kAround + 1); ++u) {
                    if (test::pixel(film, u, v, 0) > 0) {
                        lit[static_cast<std::size_t>(y * settings.width + x)] = true;
                    }
                }
            }
        }
    }
    return lit;
}

struct Cost {
    double cpu_seconds = 0, rays = 0, error = 0;
};

Cost cost_of(const LitScene& scene, const render::RenderSettings& settings, int seeds,
             const std::string& folder) {
    const render::PreparedScene prepared(scene.builder.scene, settings);
    const std::vector<bool> shows_light = lights_in(scene, settings);
    std::vector<Picture> pictures, without_lights;
    Cost cost;
    for (int seed = 0; seed < seeds; ++seed) {
        const double start = process_cpu_seconds();
        const render::Film film = render_once(scene, prepared, settings, seed);
        cost.cpu_seconds += (process_cpu_seconds() - start) / seeds;
        const render::RenderStatistics& count = film.statistics;
        cost.rays +=
            static_cast<double>(count.camera_rays + count.scattered_rays + count.shadow_rays) /
            seeds;
        Picture& picture = pictures.emplace_back();
        Picture& measured = without_lights.emplace_back();
        for (std::size_t i = 0; i < film.rgba.size(); i += 4) {
            picture.insert(picture.end(), {film.rgba[i], film.rgba[i + 1], film.rgba[i + 2]});
            if (!shows_light[i / 4]) {
                measured.insert(measured.end(), picture.end() - 3, picture.end());
            }
        }
    }
    for (const Error& error : errors_of(without_lights, "")) {
        cost.error += error.trimmed / seeds;
    }
    if (!folder.empty()) {
        write_picture(folder + "/" + scene.name + ".exr", mean_of(pictures, pictures.size()),
                      settings.width);
    }
    return cost;
}

int run(int argc, char** argv) {
    CLI::App app("What many lights cost, compared with four lamps");
    int samples = 16;
    int seeds = 4;
    int width = 320;
    int bounces = 4;
    std::string folder;
    app.add_option("--samples", samples, "per pixel")->capture_default_str();
    app.add_option("--seeds", seeds, "pictures of each scene")->capture_default_str();
    app.add_option("--width", width, "pixels")->capture_default_str();
    app.add_option("--bounces", bounces, "of paths")->capture_default_str();
    std::string only;
    app.add_option("--only", only, "the row with this beginning");
    app.add_option("--pictures", folder, "a folder for the means of the pictures, EXR");
    CLI11_PARSE(app, argc, argv);
    render::RenderSettings settings = test::small_settings(width, width * 9 / 16, samples);
    settings.max_bounces = bounces;
    std::printf(
        "| lit by | CPU s | Mrays | relMSE | CPU s at equal error |\n|---|---|---|---|---|\n");
    double lamps = 0;
    for (const LitScene& scene :
         {with_lamps(), with_disks(false), with_disks(true), with_board(),
          with_lamps_among_spheres(), with_spheres(false), with_spheres(true)}) {
        if (!scene.name.starts_with(only)) {
            continue;
        }
        const Cost cost = cost_of(scene, settings, seeds, folder);
        const double product = cost.cpu_seconds * cost.error;
        lamps = lamps > 0 ? lamps : product;
        std::printf("| %s | %.2f | %.1f | %.2e | %.1f times |\n", scene.name.c_str(),
                    cost.cpu_seconds, cost.rays / 1e6, cost.error, product / lamps);
        std::fflush(stdout);
    }
    return 0;
}

}  // namespace
}  // namespace carom::bench

int main(int argc, char** argv) {
    try {
        return carom::bench::run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "light_bench: %s\n", error.what());
        return 1;
    }
}
