// What a room costs: set_bench ROOM ALONE [--samples N] [--seeds N] [--width N] [--cache FOLDER].
// Both are shots with the same table and balls; ROOM names a set, ALONE does not. For six views, a
// row each: CPU seconds and relMSE of a frame of each, and how many times the CPU seconds of ALONE
// an equal error takes, over the pixels of the table and the balls, and for the room over all of
// them. Pictures are sampled evenly.
#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "bench/picture.h"
#include "core/cpu_time.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/job/far_light.h"
#include "pipeline/job/film_job.h"
#include "pipeline/job/film_plan.h"
#include "render/frame/frame.h"
#include "sim/bake.h"
#include "tests/render/scene_builder.h"

namespace carom::bench {
namespace {

struct View {
    const char* name;
    Vec3 position, target;
    double fov;  // degrees
};
const std::array<View, 6> kViews{{
    {"rack", Vec3(0.36, -0.40, 0.14), Vec3(0.73, 0.012, 0.018), 34},
    {"pocket", Vec3(0.985, 0.27, 0.135), Vec3(1.130, 0.53, 0.035), 31},
    {"along the rail", Vec3(-1.15, -0.58, 0.10), Vec3(0.6, -0.35, 0.03), 36},
    {"high", Vec3(-0.9, -1.1, 0.95), Vec3(0.2, 0.05, 0), 50},
    {"low", Vec3(-1.9, 0.4, 0.22), Vec3(0.3, 0, 0.05), 40},
    {"wide", Vec3(-2.15, -1.62, 0.66), Vec3(0.12, 0.10, 0.15), 38},
}};

struct Options {
    std::string room, alone, cache;
    int samples = 16, seeds = 4, width = 320;
};

pipeline::Shot load(const std::string& path, const Options& options) {
    pipeline::LoadResult loaded = pipeline::load_shot(path);
    if (!loaded.shot) {
        throw std::runtime_error("'" + path + "' has errors; see carom check");
    }
    render::RenderSettings& settings = loaded.shot->render;
    settings.width = options.width;
    settings.height = options.width * 9 / 16;
    settings.samples = options.samples;
    settings.noise = 0;
    settings.max_bounces = 4;
    settings.for_denoiser = false;
    return std::move(*loaded.shot);
}

bool is_of_table(const render::ObjectDescription& object) {
    return (object.name.starts_with("table/") && object.name != "table/floor") ||
           !object.track.empty();
}

/// A shot at its first frame.
struct Subject {
    explicit Subject(pipeline::Shot of) : shot(std::move(of)) {
        sim::Bake bake;
        bake.timeline = sim::bake(shot.world);
        pipeline::add_keyed_motions(bake, shot);
        inputs = pipeline::FilmSource(shot, bake.timeline).inputs(0);
    }
    pipeline::Shot shot;
    pipeline::FrameInputs inputs;
};

struct Cost {
    double seconds = 0;
    double of_table = 0, of_all = 0;  // relMSE
};

/// Which pixels show the table or what moves: it alone shines.
std::vector<bool> table_in(const render::SceneDescription& scene,
                           const std::vector<sim::Track>& tracks, const render::FrameInput& frame,
                           render::RenderSettings settings) {
    render::SceneDescription shining = scene;
    shining.far.reset();
    shining.lights.clear();
    for (render::MaterialDescription& material : shining.materials) {
        material.surface = {};
        material.phong.reset();
    }
    shining.materials.push_back({"shines", {}});
    shining.materials.back().surface.emission = Vec3(1, 1, 1);
    for (render::ObjectDescription& object : shining.objects) {
        object.material = is_of_table(object) ? "shines" : object.material;
    }
    settings.samples = 4;
    settings.max_bounces = 0;
    const render::Film film =
        render_frame(render::PreparedScene(shining, settings), tracks, frame, settings);
    std::vector<bool> shown;
    for (std::size_t i = 0; i < film.rgba.size(); i += 4) {
        shown.push_back(film.rgba[i] > 0.5F);
    }
    return shown;
}

Cost cost_of(const render::PreparedScene& scene, const std::vector<sim::Track>& tracks,
             render::FrameInput frame, const render::RenderSettings& settings, int seeds,
             const std::vector<bool>& shows_table) {
    std::vector<Picture> pictures, of_table;
    Cost cost;
    for (int seed = 0; seed < seeds; ++seed) {
        frame.seed = static_cast<std::uint64_t>(seed);
        const double begin = process_cpu_seconds();
        const render::Film film = render_frame(scene, tracks, frame, settings);
        cost.seconds += (process_cpu_seconds() - begin) / seeds;
        Picture& picture = pictures.emplace_back();
        Picture& measured = of_table.emplace_back();
        for (std::size_t i = 0; i < film.rgba.size(); i += 4) {
            picture.insert(picture.end(), {film.rgba[i], film.rgba[i + 1], film.rgba[i + 2]});
            if (shows_table[i / 4]) {
                measured.insert(measured.end(), picture.end() - 3, picture.end());
            }
        }
    }
    for (const Error& error : errors_of(pictures, "")) {
        cost.of_all += error.trimmed / seeds;
    }
    for (const Error& error : errors_of(of_table, "")) {
        cost.of_table += error.trimmed / seeds;
    }
    return cost;
}

int run(int argc, char** argv) {
    CLI::App app("What a room costs, compared with the table alone");
    Options options;
    app.add_option("room", options.room, "A shot with a set.")->required();
    app.add_option("alone", options.alone, "The same without.")->required();
    app.add_option("--samples", options.samples, "per pixel")->capture_default_str();
    app.add_option("--seeds", options.seeds, "pictures of each view")->capture_default_str();
    app.add_option("--width", options.width, "pixels")->capture_default_str();
    app.add_option("--cache", options.cache, "where the room's light is kept");
    CLI11_PARSE(app, argc, argv);
    const Subject with(load(options.room, options));
    const Subject without(load(options.alone, options));
    const pipeline::FrameStore store(
        (options.cache.empty() ? pipeline::default_cache_folder() : options.cache) + "/frames");
    const double begin = process_cpu_seconds();
    const auto light = pipeline::far_light(with.shot.scene, &store, {});
    std::printf("light of the room: %zu cells, %.1f MB, %.1f CPU s\n\n",
                light ? light->cells().size() : 0,
                light ? static_cast<double>(render::encoded(*light, "").size()) / 1e6 : 0.0,
                process_cpu_seconds() - begin);
    std::fflush(stdout);
    const render::PreparedScene room(with.shot.scene, with.shot.render, {}, light);
    const render::PreparedScene alone(without.shot.scene, without.shot.render);
    std::printf(
        "| view | room CPU s | relMSE of the table | of all | alone CPU s | relMSE of the "
        "table | table at equal error | all of the room's picture |\n"
        "|---|---|---|---|---|---|---|---|\n");
    for (const View& view : kViews) {
        render::FrameInput frame = with.inputs.frame;
        frame.camera_open = frame.camera_close =
            test::camera(view.position, view.target, view.fov * std::numbers::pi / 180);
        const std::vector<bool> table =
            table_in(with.shot.scene, with.inputs.tracks, frame, with.shot.render);
        const Cost in_room =
            cost_of(room, with.inputs.tracks, frame, with.shot.render, options.seeds, table);
        const Cost by_itself =
            cost_of(alone, without.inputs.tracks, frame, without.shot.render, options.seeds, table);
        const double unit = by_itself.seconds * by_itself.of_table;
        std::printf("| %s | %.2f | %.2e | %.2e | %.2f | %.2e | %.2f times | %.2f times |\n",
                    view.name, in_room.seconds, in_room.of_table, in_room.of_all, by_itself.seconds,
                    by_itself.of_table, in_room.seconds * in_room.of_table / unit,
                    in_room.seconds * in_room.of_all / unit);
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
        std::fprintf(stderr, "set_bench: %s\n", error.what());
        return 1;
    }
}
