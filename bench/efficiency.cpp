// efficiency SCENE.json: renders a comparison scene with several seeds and prints CPU seconds,
// rays, relMSE and efficiency = 1 / (relMSE * CPU s), with and without the worst 0.1 % of the
// pixels.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "bench/bumpy_ball.h"
#include "bench/peer_scene.h"
#include "bench/picture.h"
#include "core/cpu_time.h"

namespace carom::bench {
namespace {

struct Run {
    Picture picture;
    double cpu_seconds = 0;
    double rays = 0;
    double camera_rays = 0;
};

Run render_once(const PeerScene& scene, const render::PreparedScene& prepared, int seed) {
    render::FrameInput frame = scene.frame;
    frame.seed = static_cast<std::uint64_t>(seed);
    const double start = process_cpu_seconds();
    const render::Film film = render_frame(prepared, scene.tracks, frame, scene.settings);
    Run run;
    run.cpu_seconds = process_cpu_seconds() - start;
    const render::RenderStatistics& count = film.statistics;
    run.camera_rays = static_cast<double>(count.camera_rays);
    run.rays = static_cast<double>(count.camera_rays + count.scattered_rays + count.shadow_rays);
    for (std::size_t i = 0; i < film.rgba.size(); i += 4) {
        run.picture.insert(run.picture.end(), {film.rgba[i], film.rgba[i + 1], film.rgba[i + 2]});
    }
    return run;
}

std::vector<Picture> pictures_of(const std::vector<Run>& runs) {
    std::vector<Picture> pictures;
    for (const Run& run : runs) {
        pictures.push_back(run.picture);
    }
    return pictures;
}

std::vector<Picture> read_pictures(const std::vector<std::string>& paths) {
    std::vector<Picture> pictures;
    for (const std::string& path : paths) {
        pictures.push_back(read_picture(path));
    }
    return pictures;
}

/// Reports another renderer's pictures of the scene: their error, and their differences from this
/// renderer's pictures by block.
void report_other(const std::vector<Picture>& ours, const std::vector<Picture>& other,
                  const PeerScene& scene) {
    constexpr int kBlock = 8;
    constexpr double kTolerance = 0.01;
    constexpr double kErrors = 3;
    double trimmed = 0;
    double all = 0;
    for (const Error& error : errors_of(other, "")) {
        trimmed += error.trimmed / static_cast<double>(other.size());
        all += error.all / static_cast<double>(other.size());
    }
    std::printf("%zu other pictures: relMSE %.3e trimmed / %.3e all\n", other.size(), trimmed, all);
    const BlockComparison c =
        compare_blocks(ours, other, scene.settings.width, kBlock, kTolerance, kErrors);
    std::printf(
        "blocks of %d x %d: %d, of which %d differ by more than %.0f %% and %.0f standard "
        "errors; worst %.2f %% at (%d, %d); means differ by %.3f %%\n",
        kBlock, kBlock, c.blocks, c.beyond, 100 * kTolerance, kErrors, 100 * c.worst, c.worst_x,
        c.worst_y, 100 * c.mean_difference);
}

void report(const std::vector<Run>& runs, const std::vector<Error>& errors) {
    double cpu = 0;
    double rays = 0;
    double camera_rays = 0;
    double trimmed = 0;
    double all = 0;
    double lowest = errors[0].all;
    double highest = errors[0].all;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        cpu += runs[k].cpu_seconds;
        rays += runs[k].rays;
        camera_rays += runs[k].camera_rays;
        trimmed += errors[k].trimmed;
        all += errors[k].all;
        lowest = std::min(lowest, errors[k].all);
        highest = std::max(highest, errors[k].all);
    }
    const double n = static_cast<double>(runs.size());
    const double pixels = static_cast<double>(runs[0].picture.size()) / 3;
    std::printf(
        "%zu seeds, %.1f samples: %.3f CPU s, %.2f Mrays/s per core, relMSE %.3e trimmed / %.3e "
        "all "
        "(%.2e to %.2e), efficiency %.0f / %.0f\n",
        runs.size(), camera_rays / n / pixels, cpu / n, rays / cpu / 1e6, trimmed / n, all / n,
        lowest, highest, n * n / (trimmed * cpu), n * n / (all * cpu));
}

void add_mesh(PeerScene& scene, int triangles) {
    constexpr double kRadius = 0.12;  // m
    render::ObjectDescription mesh;
    mesh.name = "mesh";
    mesh.shape = bumpy_ball(triangles, kRadius);
    mesh.world_from_object.setTranslation(Vec3(-0.3, 0.1, 1.2 * kRadius));
    mesh.material = scene.scene.objects.front().material;
    scene.scene.objects.push_back(std::move(mesh));
}

int run(int argc, char** argv) {
    CLI::App app("Efficiency of the renderer on a comparison scene");
    std::string scene_path;
    std::string reference;
    std::string output;
    int samples = 16;
    int seeds = 8;
    int first_seed = 1;
    app.add_option("scene", scene_path, "neutral scene, JSON")->required();
    app.add_option("--samples", samples, "per pixel")->capture_default_str();
    double noise = 0;
    app.add_option("--noise", noise,
                   "adaptive sampling down to this noise; then --samples is the minimum");
    app.add_option("--seeds", seeds, "runs")->capture_default_str()->check(CLI::Range(1, 4096));
    app.add_option("--first-seed", first_seed)->capture_default_str();
    app.add_option("--reference", reference, "EXR; without it runs are compared with each other");
    app.add_option("--mean", output, "write the mean of all runs to this EXR");
    int triangles = 0;
    app.add_option("--triangles", triangles,
                   "adds a mesh with this many triangles, a bumpy ball on the table");
    std::vector<std::string> others;
    app.add_option("--others", others,
                   "EXRs of the scene by another renderer: their error, and 8 x 8 block means");
    CLI11_PARSE(app, argc, argv);
    PeerScene scene = read_peer_scene(scene_path);
    scene.settings.samples = samples;
    if (triangles > 0) {
        add_mesh(scene, triangles);
    }
    scene.settings.noise = noise;
    scene.settings.max_samples = 4096;
    const render::PreparedScene prepared(scene.scene, scene.settings);
    std::vector<Run> runs;
    for (int seed = 0; seed < seeds; ++seed) {
        runs.push_back(render_once(scene, prepared, first_seed + seed));
    }
    if (!output.empty()) {
        write_picture(output, mean_of(pictures_of(runs), runs.size()), scene.settings.width);
    }
    if (seeds > 1 || !reference.empty()) {
        report(runs, errors_of(pictures_of(runs), reference));
    }
    if (!others.empty()) {
        report_other(pictures_of(runs), read_pictures(others), scene);
    }
    return 0;
}

}  // namespace
}  // namespace carom::bench

int main(int argc, char** argv) {
    try {
        return carom::bench::run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "efficiency: %s\n", error.what());
        return 1;
    }
}
